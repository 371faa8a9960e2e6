//! Whether the dresser spares the counter flank while it dresses, and how wide its tip land may be (spec 28 section 2, spec 30
//! section 13).

use super::execution::Execution;
use super::finding::{Remark, RunFailure};
use super::prepare::Prepared;
use crate::exchange::job::{DressingFlanks, Job};
use crate::geometry::{Flank, Sides};
use crate::process::generating::{GeneratingError, largest_tip_land};

/// The largest tip lands by flank, mm: absent where no flank is dressed alone.
pub(super) struct TipLands {
    pub largest: Sides<Option<f64>>,
    pub warnings: Vec<Remark>,
}

/// Threads that are left out behind an active one at least.
fn left_out(job: &Job) -> u32 {
    let Some(active) = &job.grinding.active_threads else { return 0 };
    let mut sorted = active.clone();
    sorted.sort_unstable();
    let next = sorted.iter().skip(1).copied().chain(sorted.first().map(|first| first + job.worm.threads));
    sorted.iter().zip(next).map(|(here, next)| next - here - 1).min().unwrap_or(0)
}

impl TipLands {
    /// Of a process with all its settings. A plan whose dresser cuts into the counter flank is refused; of given settings it is
    /// said.
    ///
    /// # Errors
    /// [`GeneratingError::CounterFlankCut`] for a plan.
    pub fn of_execution(
        job: &Job,
        prepared: &Prepared,
        execution: &Execution,
        planned: bool,
    ) -> Result<Self, RunFailure> {
        let mut found = Self { largest: Sides { left: None, right: None }, warnings: Vec::new() };
        // Both flanks at once: the flank across the space is dressed as well.
        let (Some(dresser), DressingFlanks::One) = (&execution.dresser, job.dressing.flanks) else {
            return Ok(found);
        };
        let given = job.dresser.as_ref().and_then(|d| d.tip_land);
        let left_out = left_out(job);
        for flank in Flank::BOTH {
            let Some(dressing) = execution.flanks[flank].as_ref().and_then(|f| f.dressing()) else {
                continue;
            };
            match largest_tip_land(&prepared.setup, dresser, flank, &dressing.corrections, left_out) {
                Ok(largest) if largest.is_some_and(|largest| given.is_none_or(|land| land <= largest)) => {
                    found.largest[flank] = largest;
                }
                Ok(largest) => {
                    let cut = GeneratingError::CounterFlankCut { flank, land: given, largest };
                    if planned {
                        return Err(RunFailure::on_field(&cut, "dresser.tip_land"));
                    }
                    found.largest[flank] = largest;
                    found.warnings.push(Remark {
                        code: cut.code(),
                        text: cut.to_string(),
                        way_out: cut.way_out(),
                    });
                }
                Err(error) => found.warnings.push(Remark {
                    code: "tip-land-unknown",
                    text: format!("the clearance of the {} flank is not known: {error}", flank.other()),
                    way_out: error.way_out(),
                }),
            }
        }
        Ok(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exchange::job::Process;
    use crate::exchange::{Source, job_template, parse_job};

    #[test]
    fn the_narrowest_gap_between_active_threads_counts() {
        let text = job_template(Process::GeneratingGrinding);
        let mut job = parse_job(Source::new("job.toml", text)).unwrap().job;
        job.worm.threads = 7;
        for (active, expected) in [
            (None, 0),
            (Some(vec![0, 1, 3]), 0),
            (Some(vec![0, 2, 4]), 1),
            (Some(vec![5, 2]), 2),
            (Some(vec![3]), 6),
        ] {
            job.grinding.active_threads = active;
            assert_eq!(left_out(&job), expected);
        }
    }
}
