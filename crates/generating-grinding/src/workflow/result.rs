//! `result.json`: what a plan or a simulation came to, with units in the key names (`README.md`).

use super::conditions::ConditionResult;
use super::drawn_values::TraceResult;
use super::gear_root::GearRootResult;
use super::line_dressing::LineDressingResult;
use super::measured_worm::MeasuredWormResult;
use super::partition::Partition;
use super::removal::RemovalResult;
use super::spared_worms::SparedWormsResult;
use super::stroke_plan::StrokePlan;
use super::wanted_worm::WormFlankResult;
use crate::job::Settings;
use crate::workflow::control::result::ControlResult;
use crate::workflow::programs::result::ProgramsResult;
use foundation::geometry::Sides;
use generating::{Candidate, LeastDeviation};
use run::{CharacteristicsUm, DrawingResult, FlankMaps};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
pub use verdict::Status;
use verdict::{Remark, Verdict};

/// One flank.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FlankResult {
    /// Lengths of roll of the grid.
    pub w_mm: Vec<f64>,
    /// Axial positions of the grid.
    pub z_mm: Vec<f64>,
    /// Target, normal, `[profile][helix]`.
    pub target_um: Vec<Vec<f64>>,
    /// Exact contact with the worm as dressed, normal.
    pub planned_um: Vec<Vec<f64>>,
    /// What the referee's rays left, normal.
    pub simulated_um: Vec<Vec<f64>>,
    /// Largest |simulated - target|.
    pub max_deviation_um: f64,
    /// Largest |simulated - target| over the tolerance at its place; plus what the lines of a disc in point contact leave of the
    /// worm, over the tightest tolerance. The target is met up to 1.
    pub tolerance_share: f64,
    /// Root mean square of simulated - target.
    pub rms_deviation_um: f64,
    /// Largest |planned - simulated|.
    pub model_difference_um: f64,
    /// Bound of the referee's own error.
    pub referee_error_um: f64,
    /// Height of the true feed marks over the envelope (sample of rays); absent without a feed per revolution.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub feed_mark_um: Option<f64>,
    /// How the worm flank is written line by line; absent for every other tool.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line_dressing: Option<LineDressingResult>,
    /// Characteristics of the target.
    pub target_characteristics: CharacteristicsUm,
    /// Characteristics of the simulated flank.
    pub simulated_characteristics: CharacteristicsUm,
    /// Traces where the drawing has them, evaluated as those of a measured gear; absent for tangential dressing.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub traces: Vec<TraceResult>,
    /// Largest part of the target outside the producible class, normal.
    pub outside_class_um: f64,
    /// Largest |planned - target| inside the cells of the grid, where reliefs or waves stand on the tool's lines.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub planned_between_um: Option<f64>,
    /// Least det J / det J_0.
    pub least_determinant_ratio: f64,
}

impl FlankResult {
    /// Its values over the grid.
    pub fn maps(&self, name: &'static str) -> FlankMaps<'_> {
        FlankMaps {
            name,
            w_mm: &self.w_mm,
            z_mm: &self.z_mm,
            target_um: &self.target_um,
            planned_um: &self.planned_um,
            simulated_um: &self.simulated_um,
        }
    }
}

/// One candidate of the diagonal ratio.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CandidateResult {
    /// K.
    pub diagonal_ratio: f64,
    /// Place of the profile crowning.
    pub profile_crowning_by: &'static str,
    /// Largest share of an axis limit.
    pub score: f64,
    /// Worm length used.
    pub worm_occupation_mm: f64,
    /// Travel of the feed without overrun.
    pub feed_travel_mm: f64,
    /// Largest error of the ideal worm.
    pub ideal_error_um: f64,
    /// Why it is not allowed, if so.
    pub refused: Option<String>,
}

impl CandidateResult {
    /// Of a candidate that planning judged.
    pub fn of(candidate: &Candidate) -> Self {
        Self {
            diagonal_ratio: candidate.ratio,
            profile_crowning_by: candidate.place.name(),
            score: candidate.score(),
            worm_occupation_mm: candidate.occupation,
            feed_travel_mm: candidate.feed_travel,
            ideal_error_um: candidate.error * 1e3,
            refused: candidate.refusal.as_ref().map(ToString::to_string),
        }
    }
}

/// Settings, with how the diagonal ratio was found.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SettingsResult {
    /// The settings that `simulate` takes.
    #[serde(flatten)]
    pub settings: Settings,
    /// Why this diagonal ratio; absent for a simulation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub diagonal_ratio_reason: Option<String>,
    /// Ratio at which the worm needs no part linear in w, per flank.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lead_correction_ratio: Option<Sides<Option<f64>>>,
    /// Place of the profile crowning.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub profile_crowning_by: Option<&'static str>,
    /// Candidates judged.
    pub candidates: Vec<CandidateResult>,
    /// Centre distance of worm and workpiece.
    pub centre_distance_mm: f64,
    /// Crossed-axes angle of worm and workpiece.
    pub crossed_axes_angle_deg: f64,
    /// Feed stroke z_V2, overrun included.
    pub feed_stroke_mm: [f64; 2],
    /// Areas on the tool; absent for conical bodies.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub partition: Option<Partition>,
    /// Strokes of a pass, where threads are inactive.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub index_strokes: Option<StrokePlan>,
    /// Part of the worm that is used, z_1.
    pub worm_occupation_mm: [f64; 2],
    /// Length of that part.
    pub worm_length_mm: f64,
    /// Pitch diameter of the worm.
    pub worm_pitch_diameter_mm: f64,
    /// Root diameter of the worm.
    pub worm_root_diameter_mm: f64,
    /// Nominal centre distance of dresser and worm; absent for a tool that is not dressed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dressing_centre_distance_mm: Option<f64>,
    /// Widest tip land of the dresser that clears the other flank while the left or right one is dressed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub largest_tip_land_mm: Option<Sides<Option<f64>>>,
    /// Nominal crossing angle of dresser and worm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dressing_crossing_angle_deg: Option<f64>,
    /// Conditions of dressing with what the motion leaves of them; absent where all of them are met exactly.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub dressing_conditions: Vec<ConditionResult>,
    /// Ratios that lay the tool's lines onto reliefs and waves of the target, per flank; absent where there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub demanded_ratios: Option<Sides<Vec<f64>>>,
}

/// How near any flank of the class of best fits comes to a target that is missed, over all diagonal ratios that the worm is wide enough for;
/// normal.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LeastDeviationResult {
    /// Ratio at which least is left.
    pub diagonal_ratio: f64,
    /// What is left there at least within the limits of axes and envelope, to first order.
    pub first_order_um: f64,
    /// How far the planned flank lies from the class: the higher order that the bound neglects.
    pub beyond_class_um: f64,
    /// The bound: the first less the second.
    pub bound_um: f64,
    /// What the plan leaves.
    pub planned_um: f64,
    /// What is left at that ratio without the limits of the axes, to first order.
    pub without_axis_limits_um: f64,
    /// What is left at that ratio without the limit of the envelope, to first order.
    pub without_envelope_limit_um: f64,
    /// Whether the bound is above the tolerance and the plan next to the bound.
    pub proven: bool,
}

impl LeastDeviationResult {
    /// Of a plan that leaves `planned_um` of a target with a tolerance.
    pub fn of(least: &LeastDeviation, planned_um: f64, tolerance_um: f64) -> Self {
        let bound_um = least.bound() * 1e3;
        Self {
            diagonal_ratio: least.ratio,
            first_order_um: least.first_order * 1e3,
            beyond_class_um: least.beyond_class * 1e3,
            bound_um,
            planned_um,
            without_axis_limits_um: least.without_axes * 1e3,
            without_envelope_limit_um: least.without_envelope * 1e3,
            proven: bound_um > tolerance_um
                && planned_um - bound_um <= NEXT_TO_BOUND_UM.max(NEXT_TO_BOUND * tolerance_um),
        }
    }
}

/// A change of the job that was planned because its plan misses the target.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ChangeResult {
    /// Keys with their new values, as a job file has them: of one job, or of one for each flank.
    pub jobs: Vec<Vec<KeyChange>>,
    /// What the change costs.
    pub cost: &'static str,
    /// Whether the target is met with it by plan and simulation; null where no plan was found.
    pub status: Option<Status>,
    /// Largest deviation that is left, normal; null where no plan was found.
    pub deviation_um: Option<f64>,
    /// Why it is not met.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// A key with its new value.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct KeyChange {
    /// The key, from the root of the job.
    pub key: String,
    /// Its value as TOML has it.
    pub value: String,
}

impl ChangeResult {
    /// The keys with their new values, of all jobs.
    pub fn keys(&self) -> String {
        let of_key = |change: &KeyChange| format!("`{} = {}`", change.key, change.value);
        self.jobs.iter().flatten().map(of_key).collect::<Vec<_>>().join("; ")
    }
}

/// What the planned settings leave with the axes of `[deviations]` off, by the referee.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DeviatedResult {
    /// Flanks that are ground.
    pub flanks: BTreeMap<&'static str, DeviatedFlank>,
}

/// A flank ground with axes that are off; normal, um.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DeviatedFlank {
    /// Largest deviation of the form from the target.
    pub max_deviation_um: f64,
    /// The same over the tolerance at its place; above 1 the target would be missed.
    pub tolerance_share: f64,
    /// Largest change of the form against the flank without deviations.
    pub largest_change_um: f64,
    /// Material left everywhere: what the thickness of the tooth changes by on this flank.
    pub stock_um: f64,
    /// Characteristics of the flank.
    pub characteristics: CharacteristicsUm,
    /// Change of the form against the flank without deviations, `[w][z]` on the grid of the result.
    pub change_um: Vec<Vec<f64>>,
}

/// A plan that leaves no more than this beyond the bound, or this share of the tolerance, is next to it.
const NEXT_TO_BOUND_UM: f64 = 0.2;
const NEXT_TO_BOUND: f64 = 0.1;

/// The whole document.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JobResult {
    /// Name of the job.
    pub job: String,
    /// Process.
    pub process: String,
    /// Version of flankwright.
    pub version: &'static str,
    /// Status, reason and scope.
    #[serde(flatten)]
    pub verdict: Verdict,
    /// Tolerance of the job.
    pub tolerance_um: f64,
    /// Warnings.
    pub warnings: Vec<Remark>,
    /// Settings.
    pub settings: SettingsResult,
    /// Flanks that are ground.
    pub flanks: BTreeMap<&'static str, FlankResult>,
    /// The worm as wanted and as dressed, per flank; absent unless the job wants a worm topography.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub worm: BTreeMap<&'static str, WormFlankResult>,
    /// How near any flank could come; absent unless a plan misses its target and best fits know its bodies.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub least_deviation: Option<LeastDeviationResult>,
    /// Changes of the job that were planned because its flank is missed, in order; the last one meets the target if one does.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub changes: Vec<ChangeResult>,
    /// What the settings leave with axes that are off; absent without `[deviations]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviated: Option<DeviatedResult>,
    /// What a measured worm says of the dressing axes; absent without `[measured_worm]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured_worm: Option<MeasuredWormResult>,
    /// Smaller worms that today's dressing leaves whole; absent where no single dresser works on a cylindrical worm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spared_worms: Option<SparedWormsResult>,
    /// The root of the gear; absent unless the worm's tip grinds it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gear_root: Option<GearRootResult>,
    /// What gearbox and servo leave; absent unless the job describes its control.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub control: Option<ControlResult>,
    /// Tooth thickness and class of the drawing, which nothing here judges.
    pub drawing: DrawingResult,
    /// Stock, removal, load of the worm, time and cost; absent without stock.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub removal: Option<RemovalResult>,
    /// NC programs with their proof; absent without a machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub programs: Option<ProgramsResult>,
    /// Largest error of the ideal worm by round of precompensation, per flank.
    pub ideal_error_by_round_um: Sides<Vec<f64>>,
    /// Seconds per stage; the only part that differs between two runs.
    pub timing_s: BTreeMap<&'static str, f64>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_miss_is_proven_by_a_bound_above_the_tolerance_and_a_plan_next_to_it() {
        let least = |first_order, beyond_class| LeastDeviation {
            ratio: -1.8,
            first_order,
            beyond_class,
            without_axes: 0.9 * first_order,
            without_envelope: 0.5 * first_order,
        };
        let proven = |least: &LeastDeviation, planned_um| LeastDeviationResult::of(least, planned_um, 2.0);
        let near = proven(&least(2.6e-3, 0.1e-3), 2.6);
        assert!(near.proven && (near.bound_um - 2.5).abs() < 1e-9, "{near:?}");
        // A plan farther from its bound, a bound within the tolerance, and more neglected than found.
        assert!(!proven(&least(2.6e-3, 0.1e-3), 2.8).proven);
        assert!(!proven(&least(2.05e-3, 0.1e-3), 2.1).proven);
        assert_eq!(proven(&least(0.2e-3, 0.5e-3), 2.1).bound_um, 0.0);
    }
}
