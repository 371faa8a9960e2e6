//! Rounds of measuring and correcting: what was applied so far, with which gain, and when to stop.

use super::{Column, Correction, CorrectionError, CorrectionTask};

/// Settings under correction over several rounds.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedLoop {
    bounds: Vec<[f64; 2]>,
    gain: f64,
    applied: Vec<f64>,
    /// Rounds so far.
    pub rounds: usize,
}

/// Why no further round is worth it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoopEnd {
    /// What was measured is hardly more than what these settings cannot remove.
    NothingRemovable,
    /// The correction is zero: everything was dropped or held by bounds.
    NothingToTurn,
}

/// Gain for a first-order model that has been verified and teeth that were averaged.
const VERIFIED: f64 = 1.0;
/// Gain otherwise.
const CAUTIOUS: f64 = 0.8;
/// Deviations within this factor of the unremovable part end the loop.
const ENOUGH: f64 = 1.1;

/// Whether a loop of gain `kappa` settles when the model's effects are `g` times the true ones.
pub fn gain_is_stable(kappa: f64, g: f64) -> bool {
    (1.0 - kappa / g).abs() < 1.0
}

impl ClosedLoop {
    /// For settings with these bounds of the sum of all corrections; `verified` says whether the model was checked against grinding
    /// and the deviations are means over teeth.
    pub fn new(bounds: Vec<[f64; 2]>, verified: bool) -> Self {
        let applied = vec![0.0; bounds.len()];
        Self { bounds, gain: if verified { VERIFIED } else { CAUTIOUS }, applied, rounds: 0 }
    }

    /// Share of a correction that is applied.
    pub fn gain(&self) -> f64 {
        self.gain
    }

    /// Sum of what was applied, in the units of the settings.
    pub fn applied(&self) -> &[f64] {
        &self.applied
    }

    /// The task of the next round.
    pub fn task(&self, deviations: Vec<f64>, columns: Vec<Column>) -> CorrectionTask {
        CorrectionTask {
            bounds: self.bounds.clone(),
            applied: self.applied.clone(),
            ..CorrectionTask::new(deviations, columns)
        }
    }

    /// Takes a correction over, times the gain; returns what is added to every setting.
    ///
    /// # Errors
    /// [`CorrectionError::OtherShape`] for a correction of other settings.
    pub fn apply(&mut self, correction: &Correction) -> Result<Vec<f64>, CorrectionError> {
        let (found, wanted) = (correction.settings.len(), self.applied.len());
        if found != wanted {
            return Err(CorrectionError::OtherShape { name: "settings of the correction", found, wanted });
        }
        let step: Vec<f64> = correction.settings.iter().map(|s| self.gain * s.value).collect();
        self.applied.iter_mut().zip(&step).for_each(|(sum, step)| *sum += step);
        self.rounds += 1;
        Ok(step)
    }

    /// Whether the loop ends before this correction is applied.
    pub fn end(correction: &Correction) -> Option<LoopEnd> {
        if correction.rms_before < ENOUGH * correction.rms_unremovable {
            return Some(LoopEnd::NothingRemovable);
        }
        correction.settings.iter().all(|s| s.value == 0.0).then_some(LoopEnd::NothingToTurn)
    }
}
