//! `result.json` of the electronic gearbox, with units in the key names.

use job::control::{InterpolationMode, RotationRate};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use verdict::{Remark, Verdict};

/// The whole document.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct GearboxResult {
    /// Name of the job.
    pub job: String,
    /// Process.
    pub process: String,
    /// Version of flankwright.
    pub version: &'static str,
    /// Status, reason and scope.
    #[serde(flatten)]
    pub verdict: Verdict,
    /// Tolerance of the job; absent where it gives none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance_um: Option<f64>,
    /// Warnings, alarms of the interpolator among them.
    pub warnings: Vec<Remark>,
    /// Settings, as given or by default.
    pub settings: GearboxSettingsResult,
    /// What the lead asks for and what the coupling makes of it.
    pub coupling: CouplingResult,
    /// Counters.
    pub pulses: PulseFigures,
    /// Error budget at the greatest speed of the motion; absent for a train of pulses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub budget: Option<BudgetResult>,
    /// Pulse position less slide; absent for a train of pulses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub along_feed: Option<AlongFeedResult>,
    /// Additional rotation less that of the lead; absent for a train of pulses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle: Option<AngleResult>,
    /// What is measured wrongly; absent without `[errors]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub errors: Option<MeasuringResult>,
    /// Rotation that is added, in the order of the job.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub corrections: Vec<CorrectionResult>,
    /// Whole pulses and voltage; absent without `[split]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub split: Option<SplitResult>,
    /// How the workpiece comes into the gap; absent without `[engagement]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub engagement: Option<EngagementResult>,
    /// The interpolator and older multipliers on the same motion; empty without `[compare]`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub compare: Vec<ComparedResult>,
    /// The servo; absent without `[servo]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub servo: Option<ServoResult>,
    /// Set-ups to choose from; absent without `[explore]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub explore: Option<ExploreResult>,
    /// Seconds per stage; the only part that differs between two runs.
    pub timing_s: BTreeMap<&'static str, f64>,
}

/// Settings of the interpolator and of what follows it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct GearboxSettingsResult {
    /// Reference pulses per metre of feed.
    pub pulses_per_metre: f64,
    /// Distance of reference pulses.
    pub pitch_mm: f64,
    /// Clock.
    pub clock_hz: f64,
    /// P.
    pub pulses_per_interval: u32,
    /// Rule of corrections.
    pub mode: InterpolationMode,
    /// Content at which the period counter stops.
    pub counter_limit: u32,
    /// Workpiece pulses per revolution.
    pub workpiece_pulses_per_revolution: u32,
    /// How pulses become rotation.
    pub rate: RotationRate,
    /// Whether the machine counts the other way.
    pub reversed: bool,
    /// Speed from which on pulses come late, f1 p/P.
    pub greatest_speed_mm_per_min: f64,
    /// Tick at which the run ended.
    pub last_tick: u64,
    /// The same as a time.
    pub duration_s: f64,
}

/// The coupling of the workpiece to the slide.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CouplingResult {
    /// Lead, > 0 right-hand; absent for a spur gear.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lead_mm: Option<f64>,
    /// b, workpiece pulses per reference pulse.
    pub coefficient: f64,
    /// B = round(b 2^18), the word of a rate multiplier; absent if b is too large for one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coefficient_word: Option<u32>,
    /// B/2^18/b - 1; absent as `coefficient_word`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coefficient_relative_error: Option<f64>,
    /// What the rounding of the ratio in use costs over the feed, at the flank.
    pub rotation_error_um_per_m: f64,
    /// Movement of the flank, normal, for one workpiece pulse.
    pub flank_um_per_workpiece_pulse: f64,
    /// Movement of the flank, normal, per error along the feed, s_ax.
    pub flank_um_per_feed_um: f64,
    /// Movement of the flank, normal, per angle of the workpiece, s_rot.
    pub flank_um_per_rad: f64,
}

/// Counters at the end of the run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PulseFigures {
    /// All pulses of the interpolator.
    pub pulses: u64,
    /// Of the scale (R).
    pub references: u64,
    /// Inserted at the spacing of the interval before (Z).
    pub intermediates: u64,
    /// Inserted at the clock's pace (K).
    pub corrections: u64,
    /// Sum of the signs of all.
    pub net_pulses: i64,
    /// Sum of the signs of those of the scale.
    pub net_references: i64,
    /// Corrections still owed at the end, with their sign.
    pub pending_corrections: i64,
    /// Alarm: intervals that ended, with their own sense, while corrections were still owed.
    pub overruns: u64,
    /// Alarm: intervals of one sense with fewer ticks than pulses.
    pub too_fast: u64,
    /// Parts of rotation turned, either way.
    pub parts_turned: u64,
    /// Additional rotation in whole workpiece pulses, rounded down.
    pub rotation_workpiece_pulses: i64,
    /// The rest of it in parts 1/P of a workpiece pulse, 0 to P - 1.
    pub rotation_rest_parts: i64,
    /// Additional rotation as an angle.
    pub rotation_deg: f64,
}

/// Least and greatest of an error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RangeUm {
    /// Least.
    pub least_um: f64,
    /// Greatest.
    pub greatest_um: f64,
}

/// The budget of `docs/mathematics/gearbox.md#error-budget`. Along the feed, unless the key says `flank`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BudgetResult {
    /// Greatest speed of the motion.
    pub speed_mm_per_min: f64,
    /// Greatest acceleration of the motion.
    pub acceleration_mm_per_s2: f64,
    /// Staircase p/P.
    pub quantisation_um: f64,
    /// The period memory holds whole counts.
    pub truncation_um: f64,
    /// Reference pulses are seen up to one tick late.
    pub synchronisation_um: f64,
    /// The speed of the interval before is not that of the running one, at the greatest speed.
    pub acceleration_um: f64,
    /// Sum of the four, at the flank.
    pub flank_um: f64,
    /// P beyond which more pulses no longer help at this speed; absent at standstill.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub best_pulses_per_interval: Option<f64>,
}

/// Pulse position less slide.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AlongFeedResult {
    /// From the second reference pulse to the end; absent with fewer pulses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub whole: Option<RangeUm>,
    /// The same at constant speed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub steady: Option<RangeUm>,
    /// Limits that `whole` never leaves; absent above the greatest speed and in mode `literal`, which have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound: Option<RangeUm>,
    /// Limits that `steady` never leaves; absent as `bound`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub steady_bound: Option<RangeUm>,
    /// Whether `whole` and `steady` keep to their limits.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub within_bound: Option<bool>,
    /// Mean error at constant speed upwards.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean_up_um: Option<f64>,
    /// The same downwards.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean_down_um: Option<f64>,
    /// Mean downwards less mean upwards: how far both senses differ at one place of the slide.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction_offset_um: Option<f64>,
    /// The same at the flank.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction_offset_flank_um: Option<f64>,
}

/// Additional rotation less that of the lead.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AngleResult {
    /// Least, rad.
    pub least_rad: f64,
    /// Greatest, rad.
    pub greatest_rad: f64,
    /// The same at the flank, normal.
    pub flank: RangeUm,
    /// Limits at the flank: those along the feed, the counting and the rounding of the ratio; absent as those along the feed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound: Option<RangeUm>,
    /// Whether `flank` keeps to them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub within_bound: Option<bool>,
}

/// Errors of scale, ball screw and encoder, each as far as it can be off over the motion.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MeasuringResult {
    /// Part by part.
    pub parts: Vec<MeasuringPart>,
    /// Their sum at the flank.
    pub sum_flank_um: f64,
    /// What the encoder leaves on the teeth; absent without `errors.encoder`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub encoder: Option<EncoderResult>,
}

/// A part of the errors of what is measured.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MeasuringPart {
    /// What it is.
    pub name: &'static str,
    /// Along the feed, against the place where the motion begins; absent for the encoder.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub along_feed_um: Option<f64>,
    /// At the flank.
    pub flank_um: f64,
}

/// What the encoder of the workpiece leaves on the teeth.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderResult {
    /// Greatest error either way.
    pub greatest_um: f64,
    /// Least and greatest error of a tooth space, normal to the flank.
    pub teeth: RangeUm,
    /// Greatest difference of neighbours: single pitch deviation.
    pub single_pitch_um: f64,
    /// Greatest difference of any two: cumulative pitch deviation.
    pub cumulative_pitch_um: f64,
}

/// Rotation that is added.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CorrectionResult {
    /// The axis that it depends on.
    pub axis: &'static str,
    /// Least and greatest over the motion, at the flank.
    pub flank: RangeUm,
    /// Greatest speed that it adds.
    pub greatest_speed_deg_per_s: f64,
    /// By how much the speed of the workpiece jumps at an end of the table, at the greatest speed of the feed.
    pub speed_jump_deg_per_s: f64,
    /// Half a part of a workpiece pulse, to which it is rounded, at the flank.
    pub rounding_um: f64,
}

/// The rotation as whole pulses and a voltage.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SplitResult {
    /// Whole workpiece pulses that went out forward.
    pub forward_pulses: u64,
    /// The same backward.
    pub backward_pulses: u64,
    /// Whole workpiece pulses at the end, rounded down.
    pub whole_pulses: i64,
    /// Parts 1/P at the end.
    pub part: u32,
    /// Their voltage.
    pub voltage_v: f64,
    /// One part at the flank.
    pub step_um: f64,
    /// Voltage less part over the run, at the flank.
    pub error: RangeUm,
    /// Limits of it over all parts.
    pub limits: RangeUm,
    /// What reading pulses and voltage at different instants costs at most: a whole workpiece pulse.
    pub read_apart_um: f64,
}

/// How the workpiece came into the gap.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EngagementResult {
    /// Time until it runs along.
    pub ramp_s: f64,
    /// Way that it went meanwhile.
    pub ramp_way_deg: f64,
    /// Move into the gap.
    pub phase_move_deg: f64,
    /// Time until it is in phase.
    pub coupled_after_s: f64,
    /// Greatest speed of the workpiece.
    pub greatest_speed_deg_per_s: f64,
    /// Greatest acceleration of it.
    pub greatest_acceleration_deg_per_s2: f64,
    /// Workpiece less gap while coupled, at the flank: counts of the worm.
    pub miss: RangeUm,
    /// Greatest way of the counter of the worm in a cycle.
    pub counts_a_cycle: i64,
    /// How often that counter wrapped.
    pub counter_wraps: u64,
    /// How much of half its range it used; from 100 % on its way is not known.
    pub counter_used_percent: f64,
    /// Speed of the worm up to which it is known.
    pub greatest_worm_speed_rpm: f64,
}

/// A multiplier on the motion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ComparedResult {
    /// How it multiplies.
    pub multiplier: &'static str,
    /// Shown position less slide, over the motion.
    pub whole: RangeUm,
    /// The same at constant speed; absent without such a stretch.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub steady: Option<RangeUm>,
    /// Largest of the motion at the flank.
    pub flank_um: f64,
    /// Half the range at constant speed, at the flank: what a constant lag is not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub steady_flank_um: Option<f64>,
}

/// What the servo leaves.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ServoResult {
    /// Time for which the loop settled before the motion, the worm turning and the slide at rest; in none of the figures.
    pub settling_s: f64,
    /// Samples in the figures.
    pub samples: u64,
    /// Setpoint of the gearbox less ideal angle, at the flank.
    pub setpoint: ServoErrorResult,
    /// Workpiece less ideal angle, at the flank.
    pub workpiece: ServoErrorResult,
    /// Greatest torque of the motor.
    pub greatest_torque_n_m: f64,
    /// Share of samples with the torque at its limit.
    pub torque_limited_share: f64,
    /// Largest modulus of the poles of the loop, below 1.
    pub largest_pole: f64,
    /// Answer to disturbing torques.
    pub disturbance_response: Vec<FlankResponseResult>,
}

/// An error over time, its mean removed as centring in the machine does.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ServoErrorResult {
    /// The mean that was removed.
    pub mean_um: f64,
    /// Root of the mean square.
    pub rms_um: f64,
    /// Largest amount.
    pub peak_um: f64,
}

/// Amplitude of the flank per amplitude of a torque, linear.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FlankResponseResult {
    /// Frequency of the torque.
    pub frequency_hz: f64,
    /// Flank, normal, per torque.
    pub um_per_n_m: f64,
}

/// Set-ups side by side.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ExploreResult {
    /// Error that is wanted at most.
    pub wanted_um: f64,
    /// Speed of the feed.
    pub speed_mm_per_min: f64,
    /// Acceleration of the feed.
    pub acceleration_mm_per_s2: f64,
    /// Set-ups that are accurate enough.
    pub feasible: usize,
    /// Rule of the ranking, in words.
    pub ranking: &'static str,
    /// The cheapest that is accurate enough, simulated; absent if there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub best: Option<BestSetUpResult>,
    /// All, ranked.
    pub set_ups: Vec<SetUpResult>,
}

/// The cheapest set-up that is accurate enough.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BestSetUpResult {
    /// The set-up with its budget.
    #[serde(flatten)]
    pub set_up: SetUpResult,
    /// Largest error along the feed at constant speed, at the flank; absent without a motion or without constant speed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured_steady_um: Option<f64>,
    /// Largest error of the angle at the flank over the whole motion, starts and stops among it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured_whole_um: Option<f64>,
}

/// Scale, clock, interpolation and encoder.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SetUpResult {
    /// Place in the ranking, from 1.
    pub rank: usize,
    /// Scale of the feed slide.
    pub pulses_per_metre: f64,
    /// Clock.
    pub clock_hz: f64,
    /// P.
    pub pulses_per_interval: u32,
    /// Encoder of the workpiece.
    pub pulses_per_revolution: u32,
    /// What it costs.
    pub cost: f64,
    /// Staircase of the interpolator, at the flank.
    pub quantisation_um: f64,
    /// Clock: period memory and synchroniser, at the flank.
    pub clock_um: f64,
    /// Acceleration, at the flank.
    pub acceleration_um: f64,
    /// Half a part of a workpiece pulse, at the flank.
    pub resolution_um: f64,
    /// Counting and rounding of the rotation, at the flank; absent if the coupling cannot be made.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rounding_um: Option<f64>,
    /// Errors of what is measured, at the flank; 0 without `[errors]`.
    pub measuring_um: f64,
    /// Sum of all parts; absent as `rounding_um`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flank_um: Option<f64>,
    /// Greatest speed.
    pub greatest_speed_mm_per_min: f64,
    /// Whether it is accurate and fast enough.
    pub feasible: bool,
    /// Why not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<&'static str>,
}
