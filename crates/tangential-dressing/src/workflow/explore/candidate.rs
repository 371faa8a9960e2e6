//! One combination of a study and its place in the ranking.

use crate::job::TangentialJob;
use crate::workflow::TangentialPrepared;
use generating_grinding::workflow::explore::Refused;
use schemars::JsonSchema;
use serde::Serialize;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// What a combination makes of one flank.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ExploredFlank {
    /// Largest |target - planned| on the grid of the result, normal.
    pub max_deviation_um: f64,
    /// Least determinant ratio: 1 unmodified, 0 where the envelope folds.
    pub least_determinant_ratio: f64,
    /// Largest modification of the worm where it touches the gear, normal.
    pub worm_modification_um: f64,
}

/// One combination. Figures are absent where it cannot be made.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TangentialCandidate {
    /// Place in the ranking, from 1.
    pub rank: usize,
    /// Threads of the worm.
    pub worm_threads: u32,
    /// Tip diameter of the worm; absent where the bodies of the job do not stand and it gives none.
    pub worm_tip_diameter_mm: Option<f64>,
    /// Tip diameter of the dresser.
    pub dresser_tip_diameter_mm: f64,
    /// Tool shift per feed; absent where the bodies do not stand and the job names a rule.
    pub shift_ratio: Option<f64>,
    /// Whether all flanks are within the tolerance.
    pub met: bool,
    /// Largest deviation of all flanks.
    pub max_deviation_um: Option<f64>,
    /// Variables that the plan uses in all passes.
    pub variables: Option<usize>,
    /// Worm length needed if the worm is dressed again before every pass.
    pub worm_length_mm: Option<f64>,
    /// Figures per flank that is ground.
    pub flanks: BTreeMap<&'static str, ExploredFlank>,
    /// Why it cannot be made, if so.
    pub refused: Option<Refused>,
}

impl TangentialCandidate {
    /// A combination that a plan refuses.
    pub(super) fn failed(job: &TangentialJob, refused: Refused) -> Self {
        let ratio = match job.grinding.shift_ratio {
            crate::job::ShiftRatio::Number(ratio) => Some(ratio),
            crate::job::ShiftRatio::Rule(_) => None,
        };
        Self {
            rank: 0,
            worm_threads: job.worm.threads,
            worm_tip_diameter_mm: job.worm.tip_diameter,
            dresser_tip_diameter_mm: job.dresser.tip_diameter,
            shift_ratio: ratio,
            met: false,
            max_deviation_um: None,
            variables: None,
            worm_length_mm: None,
            flanks: BTreeMap::new(),
            refused: Some(refused),
        }
    }

    /// A combination with its plan.
    pub(super) fn planned(
        ready: &TangentialPrepared,
        flanks: BTreeMap<&'static str, ExploredFlank>,
        variables: usize,
        worm_length: f64,
    ) -> Self {
        let largest = flanks.values().map(|f| f.max_deviation_um).fold(0.0, f64::max);
        let too_short = ready.worm_width.filter(|&width| width < worm_length).map(|width| Refused {
            code: "worm-too-short",
            text: format!("a pass needs {worm_length:.2} mm of the worm, which has {width} mm"),
            way_out: "take a longer worm, or a smaller shift ratio".into(),
        });
        Self {
            rank: 0,
            worm_threads: ready.model.pair.worm.data().teeth.unsigned_abs(),
            worm_tip_diameter_mm: Some(2.0 * ready.worm_tip_radius),
            dresser_tip_diameter_mm: ready.dresser_tip_diameter,
            shift_ratio: Some(ready.model.shift_ratio),
            met: largest <= ready.tolerance_um && too_short.is_none(),
            max_deviation_um: Some(largest),
            variables: Some(variables),
            worm_length_mm: Some(worm_length),
            flanks,
            refused: too_short,
        }
    }

    /// Smallest determinant ratio of its flanks.
    pub fn least_determinant_ratio(&self) -> Option<f64> {
        self.flanks.values().map(|f| f.least_determinant_ratio).reduce(f64::min)
    }

    /// In a word: whether it meets the tolerance, or the code of its refusal.
    pub fn verdict(&self) -> &'static str {
        match &self.refused {
            Some(refused) => refused.code,
            None if self.met => "met",
            None => "missed",
        }
    }

    fn compare(&self, other: &Self) -> Ordering {
        let by = |a: Option<f64>, b: Option<f64>| a.unwrap_or(f64::MAX).total_cmp(&b.unwrap_or(f64::MAX));
        let length = || by(self.worm_length_mm, other.worm_length_mm);
        let deviation = || by(self.max_deviation_um, other.max_deviation_um);
        let class = |c: &Self| (!c.met, c.refused.is_some());
        class(self).cmp(&class(other)).then_with(|| {
            if self.met { length().then_with(deviation) } else { deviation().then_with(length) }
        })
    }
}

/// Sorts by [`super::RANKING`] and numbers; equal ones keep their order.
pub(super) fn rank(candidates: &mut [TangentialCandidate]) {
    candidates.sort_by(TangentialCandidate::compare);
    for (place, candidate) in candidates.iter_mut().enumerate() {
        candidate.rank = place + 1;
    }
}
