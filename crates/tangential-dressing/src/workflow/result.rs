//! `result.json` of tangential dressing, with units in the key names. Flanks have the keys of every process and some of their own.

use super::plan::PassPlan;
use crate::job::TangentialSettings;
use generating_grinding::workflow::control::result::ControlResult;
use generating_grinding::workflow::programs::result::ProgramsResult;
use generating_grinding::workflow::result::FlankResult;
use run::DrawingResult;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use verdict::{Remark, Verdict};

/// The whole document.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TangentialResult {
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
    pub flanks: BTreeMap<&'static str, TangentialFlankResult>,
    /// The passes in their order.
    pub passes: Vec<PassResult>,
    /// Tooth thickness and class of the drawing, which nothing here judges.
    pub drawing: DrawingResult,
    /// What gearbox and servo leave; absent unless the job describes its control.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub control: Option<ControlResult>,
    /// NC programs with their proof; absent without a machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub programs: Option<ProgramsResult>,
    /// Derivatives of the unmodified flank by design variables.
    pub sensitivities: Vec<SensitivityResult>,
    /// Seconds per stage; the only part that differs between two runs.
    pub timing_s: BTreeMap<&'static str, f64>,
}

/// Settings with what follows from the bodies.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SettingsResult {
    /// The settings that `simulate` takes.
    #[serde(flatten)]
    pub settings: TangentialSettings,
    /// Centre distance of worm and gear.
    pub centre_distance_mm: f64,
    /// Crossed-axes angle of worm and gear.
    pub crossed_axes_angle_deg: f64,
    /// Nominal centre distance of dresser and worm.
    pub dressing_centre_distance_mm: f64,
    /// Nominal crossing angle of dresser and worm.
    pub dressing_crossing_angle_deg: f64,
    /// Screw parameter of the worm, mm/rad; < 0 left-handed.
    pub screw_parameter_mm: f64,
    /// Scale along the worm, b_w.
    pub shift_width_mm: f64,
    /// kappa without the part that a variable adds.
    pub shift_ratio: f64,
    /// kappa_0; absent for a spur gear, and where the flanks have different ones.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub neutral_shift_ratio: Option<f64>,
    /// kappa_0 of each flank where they differ.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub neutral_shift_ratio_by_flank: BTreeMap<&'static str, f64>,
    /// FT0* per flank.
    pub contact_shift_offset_mm: BTreeMap<&'static str, f64>,
    /// Pitch diameter of the worm.
    pub worm_pitch_diameter_mm: f64,
    /// Pitch diameter of the dresser.
    pub dresser_pitch_diameter_mm: f64,
    /// Worm length needed if the worm is dressed once for all passes, each in a zone of its own.
    pub worm_length_side_by_side_mm: f64,
    /// Worm length needed if the worm is dressed again before every pass.
    pub worm_length_one_after_the_other_mm: f64,
}

/// One flank.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TangentialFlankResult {
    /// What every process tells of a flank.
    #[serde(flatten)]
    pub flank: FlankResult,
    /// x_D at which the evaluated flank is dressed.
    pub dresser_position_mm: [f64; 2],
    /// x_D of the dressing stroke.
    pub dressing_stroke_mm: [f64; 2],
    /// z_V2 of the grinding stroke.
    pub feed_stroke_mm: [f64; 2],
    /// Axial positions on the worm that are used.
    pub worm_occupation_mm: [f64; 2],
    /// Largest |planned - rays| on a sample where the rays ask the dresser itself, without a surface between the stages.
    pub sample_difference_um: f64,
    /// Bound of the sample's own error.
    pub sample_error_um: f64,
    /// Conventional grinding by radial feed; absent if the job does not ask.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radial_feed: Option<RadialFeedResult>,
}

/// What radial feed makes of the same target.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RadialFeedResult {
    /// Helix crowning, normal, material removed.
    pub lead_crowning_normal_um: f64,
    /// Twist S that it leaves, normal, material removed; closed form of first order.
    pub closed_twist_normal_um: f64,
    /// The same by the exact contact of a plain worm; absent where the flank is undercut.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub twist_normal_um: Option<f64>,
    /// Largest |m - f| with the profile in the dresser and the best parabola of the centre distance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_deviation_um: Option<f64>,
    /// m - f on the grid of the result.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviation_um: Option<Vec<Vec<f64>>>,
    /// Why there is no flank, if so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<Remark>,
}

/// A pass.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PassResult {
    /// Flanks ground together.
    pub flanks: Vec<&'static str>,
    /// The free variables with their values, mm (gA: rad).
    pub variables: Vec<VariableValue>,
    /// Method whose values were taken.
    pub method: &'static str,
    /// Parts in which the target was stepped up.
    pub steps: usize,
    /// Rounds of all parts.
    pub rounds: usize,
    /// Whether the fit settled.
    pub converged: bool,
    /// Weighted root mean square of m - f on the grid of the fit.
    pub weighted_rms_um: f64,
    /// Largest |m - f| on it.
    pub largest_um: f64,
    /// Record of the rounds, weighted rms before each.
    pub weighted_rms_by_round_um: Vec<f64>,
    /// Singular values of the equilibrated matrix, first and last round.
    pub singular_values: Vec<Vec<f64>>,
    /// Steps of the choice; empty where the job names the variables.
    pub choice: Vec<ChoiceStep>,
    /// Methods beside each other; empty unless the job asks.
    pub compared: Vec<MethodResult>,
}

/// A variable with its value.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct VariableValue {
    /// Name.
    pub name: String,
    /// Value in its unit.
    pub value: f64,
    /// Unit.
    pub unit: &'static str,
    /// What moves.
    pub meaning: &'static str,
}

/// A step of the choice of variables.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ChoiceStep {
    /// The variable.
    pub variable: String,
    /// Taken in, or left out.
    pub taken: bool,
    /// Largest |m - f| after it.
    pub largest_um: f64,
    /// Variables after it.
    pub count: usize,
}

/// A method beside others.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MethodResult {
    /// Method.
    pub method: &'static str,
    /// Parts in which the target was stepped up.
    pub steps: usize,
    /// Rounds of all parts.
    pub rounds: Option<usize>,
    /// Whether it settled.
    pub converged: Option<bool>,
    /// Weighted root mean square on the grid of the fit.
    pub weighted_rms_um: Option<f64>,
    /// Largest |m - f| on the grid of the result.
    pub largest_um: Option<f64>,
    /// Why there is none, if so.
    pub refused: Option<Remark>,
}

/// Derivatives by one variable.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SensitivityResult {
    /// Flank.
    pub flank: &'static str,
    /// Variable.
    pub variable: String,
    /// Unit of the values: `um/um`, or `um/mrad` for gA.
    pub unit: &'static str,
    /// Lengths of roll.
    pub w_mm: Vec<f64>,
    /// Axial positions.
    pub z_mm: Vec<f64>,
    /// dm/dc, `[profile][helix]`.
    pub values: Vec<Vec<f64>>,
}

impl From<&PassPlan> for PassResult {
    fn from(plan: &PassPlan) -> Self {
        let um = |x: f64| x * 1e3;
        let ends = [plan.fit.rounds.first(), plan.fit.rounds.last()];
        Self {
            flanks: plan.flanks.iter().map(|f| f.name()).collect(),
            variables: plan
                .free
                .iter()
                .zip(&plan.fit.values)
                .map(|(v, &value)| VariableValue {
                    name: v.to_string(),
                    value,
                    unit: v.channel.unit(),
                    meaning: v.channel.meaning(),
                })
                .collect(),
            method: plan.fit.method.name(),
            steps: plan.fit.steps,
            rounds: plan.fit.rounds_in_all,
            converged: plan.fit.converged,
            weighted_rms_um: um(plan.fit.weighted_rms),
            largest_um: um(plan.fit.largest),
            weighted_rms_by_round_um: plan.fit.rounds.iter().map(|r| um(r.weighted_rms)).collect(),
            singular_values: ends.into_iter().flatten().map(|r| r.singular_values.clone()).collect(),
            choice: plan
                .selection
                .iter()
                .flat_map(|s| &s.steps)
                .map(|s| ChoiceStep {
                    variable: s.variable.to_string(),
                    taken: s.taken,
                    largest_um: um(s.largest),
                    count: s.count,
                })
                .collect(),
            compared: plan
                .compared
                .iter()
                .map(|tried| {
                    let fit = tried.outcome.as_ref().ok();
                    MethodResult {
                        method: tried.method.name(),
                        steps: tried.steps,
                        rounds: fit.map(|(f, _)| f.rounds_in_all),
                        converged: fit.map(|(f, _)| f.converged),
                        weighted_rms_um: fit.map(|(f, _)| um(f.weighted_rms)),
                        largest_um: fit.map(|(_, largest)| um(*largest)),
                        refused: tried.outcome.as_ref().err().map(|e| Remark {
                            code: e.code(),
                            text: e.to_string(),
                            way_out: e.way_out().into(),
                        }),
                    }
                })
                .collect(),
        }
    }
}
