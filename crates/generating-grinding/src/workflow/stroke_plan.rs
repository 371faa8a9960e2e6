//! The strokes of a pass of a worm some of whose threads are left out
//! (`docs/mathematics/planning.md#choice-of-the-ratio`).

use generating::Strokes;
use job::Diagnostic;
use run::RunFailure;
use schemars::JsonSchema;
use serde::Serialize;

/// The strokes of a pass with some of the threads left out.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StrokePlan {
    /// Threads that grind, counted from 0.
    pub active_threads: Vec<u32>,
    /// Strokes of one pass.
    pub strokes_per_pass: usize,
    /// Index offsets of the workpiece, one a stroke, in pitches.
    pub index_pitches: Vec<u32>,
    /// Share of the full axial feed at which a tooth space is met as often as with all threads.
    pub feed_factor: f64,
}

impl StrokePlan {
    /// The strokes of a worm of this many threads on a gear of this many teeth; `None` where every thread is active.
    ///
    /// # Errors
    /// A finding on `grinding.active_threads`.
    pub fn of_active(threads: usize, teeth: usize, active: &[u32]) -> Result<Option<Self>, RunFailure> {
        if active.len() == threads {
            return Ok(None);
        }
        let numbers: Vec<usize> = active.iter().map(|&a| a as usize).collect();
        let strokes = Strokes::new(threads, teeth, &numbers)
            .map_err(|e| RunFailure::bad_input(Diagnostic::of(&e).field("grinding.active_threads")))?;
        Ok(Some(Self {
            active_threads: active.to_vec(),
            strokes_per_pass: strokes.per_pass(),
            index_pitches: strokes.index_pitches.iter().map(|&o| o as u32).collect(),
            feed_factor: strokes.feed_factor,
        }))
    }

    /// Threads that are left out behind an active one at least.
    pub fn left_out(&self, threads: u32) -> u32 {
        let mut sorted = self.active_threads.clone();
        sorted.sort_unstable();
        let next = sorted.iter().skip(1).copied().chain(sorted.first().map(|first| first + threads));
        sorted.iter().zip(next).map(|(here, next)| next - here - 1).min().unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::StrokePlan;

    #[test]
    fn the_narrowest_gap_between_active_threads_counts() {
        assert!(StrokePlan::of_active(3, 41, &[0, 1, 2]).unwrap().is_none());
        for (active, expected) in [(vec![0, 1, 3], 0), (vec![0, 2, 4], 1), (vec![5, 2], 2), (vec![3], 6)] {
            let plan = StrokePlan::of_active(7, 41, &active).unwrap().unwrap();
            assert_eq!(plan.left_out(7), expected, "{active:?}");
        }
    }
}
