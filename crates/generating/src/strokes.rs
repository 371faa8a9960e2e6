//! Inactive threads: how many strokes a pass takes when only some threads of the worm grind
//! (`docs/mathematics/planning.md#choice-of-the-ratio`).

use super::GeneratingError;
use super::curve_law::number;
use std::collections::BTreeSet;

/// Threads up to which the smallest set of strokes is searched; no grinding worm has as many.
const MOST_THREADS: usize = 24;

/// A pass with some of the threads.
#[derive(Clone, Debug, PartialEq)]
pub struct Strokes {
    /// Greatest common divisor G of threads and teeth: thread a meets the gaps j = a mod G and no others.
    pub common_divisor: usize,
    /// Index offsets of the workpiece, one a stroke, in pitches.
    pub index_pitches: Vec<usize>,
    /// Share of the full axial feed at which a gap is met as often as with all threads.
    pub feed_factor: f64,
}

impl Strokes {
    /// Strokes for `threads` threads of which `active` (numbers from 0; named twice counts once) grind `teeth` teeth.
    ///
    /// # Errors
    /// `InvalidNumber` for no teeth, no threads or more than 24, and an active thread that the worm does not have;
    /// `NoActiveThread`.
    pub fn new(threads: usize, teeth: usize, active: &[usize]) -> Result<Self, GeneratingError> {
        number("threads", threads as f64, (1..=MOST_THREADS).contains(&threads), "1 .. 24")?;
        number("teeth", teeth as f64, teeth > 0, "at least 1")?;
        let active: BTreeSet<usize> = active.iter().copied().collect();
        if let Some(&thread) = active.iter().find(|&&a| a >= threads) {
            number("active_thread", thread as f64, false, "a thread of the worm, numbered from 0")?;
        }
        if active.is_empty() {
            return Err(GeneratingError::NoActiveThread { threads });
        }
        let g = gcd(threads, teeth);
        let mut met = vec![0usize; g];
        for a in &active {
            met[a % g] += 1;
        }
        let least = met.iter().copied().filter(|&n| n > 0).min().unwrap_or(0);
        let feed_factor = least as f64 / (threads / g) as f64;
        Ok(Self { common_divisor: g, index_pitches: offsets(&met), feed_factor })
    }

    /// Strokes per pass.
    pub fn per_pass(&self) -> usize {
        self.index_pitches.len()
    }
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The smallest set of offsets that brings every residue to a thread; among those of equal size the one whose bits, read as a
/// binary number, are least.
fn offsets(met: &[usize]) -> Vec<usize> {
    let g = met.len();
    let all = (1u32 << g) - 1;
    let residues = (0..g).filter(|&r| met[r] > 0).fold(0u32, |set, r| set | 1 << r);
    let turned = |o: usize| ((residues << o) | (residues >> (g - o))) & all;
    let members = |set: u32| (0..g).filter(move |o| set >> o & 1 == 1);
    let least = g.div_ceil(residues.count_ones() as usize);
    for size in least..g {
        // All sets of this size in rising order (Gosper).
        let mut set = (1u32 << size) - 1;
        while set <= all {
            if members(set).fold(0, |covered, o| covered | turned(o)) == all {
                return members(set).collect();
            }
            let low = set & set.wrapping_neg();
            let next = set + low;
            set = next | (((set ^ next) / low) >> 2);
        }
    }
    // All offsets together cover everything, because one residue is met.
    (0..g).collect()
}
