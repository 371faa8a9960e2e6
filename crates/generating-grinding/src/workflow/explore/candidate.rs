//! One combination of a study and its place in the ranking.

use super::refused::Refused;
use super::variant::Variant;
use crate::job::Job;
use crate::workflow::prepare::Prepared;
use foundation::geometry::{Flank, Sides};
use generating::Candidate;
use schemars::JsonSchema;
use serde::Serialize;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// What the ideal tool misses on one flank, normal to the flank.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FlankFigures {
    /// Largest |target - ground| on the planning grid.
    pub max_residual_um: f64,
    /// Its root mean square.
    pub rms_residual_um: f64,
    /// Largest part of the target that is best-fitted only.
    pub outside_class_um: f64,
}

/// One combination. Figures are absent where it could not be evaluated.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ExploreCandidate {
    /// Place in the ranking, from 1.
    pub rank: usize,
    /// Cone angle of the worm.
    pub worm_cone_angle_deg: f64,
    /// Crossed-axes angle of worm and gear; absent where the job's worm is impossible.
    pub crossed_axes_angle_deg: Option<f64>,
    /// Pitch diameter of the worm.
    pub worm_pitch_diameter_mm: Option<f64>,
    /// Diagonal ratio; absent where the rule of the job found none.
    pub diagonal_ratio: Option<f64>,
    /// Place of the profile crowning.
    pub profile_crowning_by: Option<&'static str>,
    /// Whether the rule of planning allows it.
    pub allowed: bool,
    /// Whether residual and parts outside the class are within the tolerance.
    pub within_tolerance: bool,
    /// Largest residual of all flanks.
    pub residual_um: Option<f64>,
    /// Largest share of an axis limit.
    pub score: Option<f64>,
    /// Length of the worm that is used.
    pub worm_occupation_mm: Option<f64>,
    /// Least det J / det J_0.
    pub least_determinant_ratio: Option<f64>,
    /// |K_left - K_right| of the ratios that directed parts of the target ask for; absent unless both flanks ask.
    pub demanded_ratio_difference: Option<f64>,
    /// Figures per flank that is ground.
    pub flanks: BTreeMap<&'static str, FlankFigures>,
    /// Why it is not allowed, if so.
    pub refused: Option<Refused>,
}

impl ExploreCandidate {
    /// A worm that does not exist, or that does not grind this gear.
    pub fn failed(job: &Job, variant: Variant, ratio: Option<f64>, refusal: Refused) -> Self {
        let cone_angle_deg = variant.cone_angle_deg.unwrap_or(job.worm.cone_angle_deg);
        let without = Self::without_figures(cone_angle_deg, variant.crossed_axes_angle_deg, ratio);
        Self { refused: Some(refusal), ..without }
    }

    fn without_figures(
        worm_cone_angle_deg: f64,
        crossed_axes_angle_deg: Option<f64>,
        diagonal_ratio: Option<f64>,
    ) -> Self {
        Self {
            rank: 0,
            worm_cone_angle_deg,
            crossed_axes_angle_deg,
            worm_pitch_diameter_mm: None,
            diagonal_ratio,
            profile_crowning_by: None,
            allowed: false,
            within_tolerance: false,
            residual_um: None,
            score: None,
            worm_occupation_mm: None,
            least_determinant_ratio: None,
            demanded_ratio_difference: None,
            flanks: BTreeMap::new(),
            refused: None,
        }
    }

    /// A ratio of a worm that exists.
    pub fn judged(
        ready: &Prepared,
        demanded: &Sides<Vec<f64>>,
        ratio: Option<f64>,
        judged: Result<Candidate, Refused>,
    ) -> Self {
        let setup = &ready.setup;
        let differences =
            demanded.left.iter().flat_map(|l| demanded.right.iter().map(move |r| (l - r).abs()));
        let body = Self {
            worm_pitch_diameter_mm: Some(2.0 * setup.worm_pitch_radius),
            demanded_ratio_difference: differences.max_by(f64::total_cmp),
            ..Self::without_figures(
                setup.input.worm.cone_angle.to_degrees(),
                Some(setup.pair.chain.crossed_axes_angle.to_degrees()),
                ratio,
            )
        };
        let candidate = match judged {
            Ok(candidate) => candidate,
            Err(refusal) => return Self { refused: Some(refusal), ..body },
        };
        let mut flanks = BTreeMap::new();
        for flank in Flank::BOTH {
            if let Some(r) = candidate.residuals[flank] {
                let figures = FlankFigures {
                    max_residual_um: r.largest * 1e3,
                    rms_residual_um: r.rms * 1e3,
                    outside_class_um: r.outside * 1e3,
                };
                flanks.insert(flank.name(), figures);
            }
        }
        let tolerance = ready.tolerance.tightest() * 1e3;
        let within = |f: &FlankFigures| f.max_residual_um <= tolerance && f.outside_class_um <= tolerance;
        Self {
            diagonal_ratio: Some(candidate.ratio),
            profile_crowning_by: Some(candidate.place.name()),
            allowed: candidate.refusal.is_none(),
            within_tolerance: !flanks.is_empty() && flanks.values().all(within),
            residual_um: Some(candidate.error * 1e3),
            score: Some(candidate.score()),
            worm_occupation_mm: Some(candidate.occupation),
            least_determinant_ratio: Some(candidate.determinant),
            flanks,
            refused: candidate.refusal.as_ref().map(Refused::from),
            ..body
        }
    }

    /// Whether nothing but the residual forbids it: it can be made, outside the tolerance.
    pub fn is_only_inexact(&self) -> bool {
        self.refused.as_ref().is_some_and(|r| r.code == "model-error")
    }

    /// Allowed, refused, failed; each within the tolerance first.
    fn class(&self) -> u8 {
        match (self.allowed, self.residual_um.is_some(), self.within_tolerance) {
            (true, _, true) => 0,
            (true, _, false) => 1,
            (false, true, true) => 2,
            (false, true, false) => 3,
            (false, false, _) => 4,
        }
    }

    fn compare(&self, other: &Self) -> Ordering {
        let by = |a: Option<f64>, b: Option<f64>| a.unwrap_or(f64::MAX).total_cmp(&b.unwrap_or(f64::MAX));
        let score = || by(self.score, other.score);
        let occupation = || by(self.worm_occupation_mm, other.worm_occupation_mm);
        let residual = || by(self.residual_um, other.residual_um);
        self.class().cmp(&other.class()).then_with(|| {
            if self.within_tolerance {
                score().then_with(occupation).then_with(residual)
            } else {
                residual().then_with(score).then_with(occupation)
            }
        })
    }
}

/// Sorts by [`super::RANKING`] and numbers; equal ones keep their order.
pub fn rank(candidates: &mut [ExploreCandidate]) {
    candidates.sort_by(ExploreCandidate::compare);
    for (place, candidate) in candidates.iter_mut().enumerate() {
        candidate.rank = place + 1;
    }
}
