//! `result.json` of measuring a skiving tool, with units in the key names. Teeth count from 0, tracks from 1.

use super::programs::ToolProgramResult;
use super::resharpening::{BrokenEdge, WithoutBroken};
use crate::wear::WearTrend;
use run::DrawingResult;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use verdict::{Remark, Verdict};

/// The whole document.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SkivingResult {
    /// Name of the job.
    pub job: String,
    /// Process.
    pub process: &'static str,
    /// Version of flankwright.
    pub version: &'static str,
    /// Status, reason and scope.
    #[serde(flatten)]
    pub verdict: Verdict,
    /// Tolerance of the workpiece's profile.
    pub tolerance_um: f64,
    /// Warnings.
    pub warnings: Vec<Remark>,
    /// Tooth thickness and class of the workpiece's drawing, which nothing here judges.
    pub drawing: DrawingResult,
    /// How tool and workpiece stand while they skive.
    pub settings: SkivingSettings,
    /// The workpiece to come, by flank.
    pub flanks: BTreeMap<&'static str, SkivedFlankResult>,
    /// Tracks and poses, by flank.
    pub tracks: BTreeMap<&'static str, Vec<TrackResult>>,
    /// Time of the measurement, s.
    pub measuring_time_s: f64,
    /// The measured tool; absent where nothing was measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measurement: Option<MeasurementResult>,
    /// The run-out of the tool answered by a law over its turn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub runout: Option<RunoutResult>,
    /// The machined workpiece under a probe.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub probe: Option<ProbeResult>,
    /// The usual way beside it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub conventional: Vec<ConventionalResult>,
    /// The scan of a stylus.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scan: Option<ScanResult>,
    /// The beam by a mandrel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub calibration: Option<CalibrationResult>,
    /// Measurements of the tool since it was ground.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub history: Option<HistoryResult>,
    /// How results scatter.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub monte_carlo: Option<MonteCarloResult>,
    /// Measuring programs and what was proven of them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub programs: Vec<ToolProgramResult>,
    /// Seconds per stage; the only part that differs between two runs.
    pub timing_s: BTreeMap<&'static str, f64>,
}

/// The setting of the machine and what follows from it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SkivingSettings {
    /// d, < 0 for an internal gear.
    pub centre_distance_mm: f64,
    /// gamma.
    pub crossed_axes_angle_deg: f64,
    /// z_V1.
    pub tool_shift_mm: f64,
    /// i_21.
    pub ratio: f64,
    /// r_1.
    pub tool_pitch_radius_mm: f64,
    /// h_c: depth of the rounding's centres below the rake face.
    pub rounding_depth_mm: f64,
    /// Sense in which the tool must turn to cut, +1 or -1; of a shaping cutter the sense of its stroke along its own axis.
    pub cutting_sense: f64,
}

/// A flank of the workpiece at the tracks' lengths of roll; [profile][helix] with one place along the tooth, since every section is the
/// same.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SkivedFlankResult {
    /// Lengths of roll.
    pub w_mm: Vec<f64>,
    /// Face positions: 0.
    pub z_mm: Vec<f64>,
    /// Wanted, normal.
    pub target_um: Vec<Vec<f64>>,
    /// Predicted from the measurement, for the mean tooth.
    pub planned_um: Vec<Vec<f64>>,
    /// Under the referee, for the mean tooth; of a real tool the edges are those that its deviations tell.
    pub simulated_um: Vec<Vec<f64>>,
    /// Least and greatest over the teeth of what is predicted.
    pub teeth_um: Vec<[f64; 2]>,
    /// Predicted after the correction of the setting.
    pub corrected_um: Vec<f64>,
    /// The same under the referee.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corrected_simulated_um: Option<Vec<f64>>,
    /// Largest deviation of the referee's flank from the target.
    pub max_deviation_um: f64,
    /// Root mean square of the same.
    pub rms_deviation_um: f64,
    /// Largest difference between prediction and referee, of the mean tooth and of any tooth; of a simulated tool without the noise of
    /// its readings.
    pub model_difference_um: [f64; 2],
}

/// A track with its pose.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TrackResult {
    /// Number, from 1.
    pub track: usize,
    /// x along the edge.
    pub place: f64,
    /// Length of roll that it makes.
    pub w_mm: f64,
    /// phi_1 of the contact.
    pub tool_angle_deg: f64,
    /// m: contact point in tool coordinates.
    pub point_mm: [f64; 3],
    /// n_m: its normal.
    pub normal: [f64; 3],
    /// R.
    pub radius_mm: f64,
    /// Z.
    pub height_mm: f64,
    /// theta: where on the rounding it touches.
    pub contact_angle_deg: f64,
    /// Where the rounding begins and ends.
    pub rounding_deg: [f64; 2],
    /// L: way of the normal per turn.
    pub lever_mm_per_rad: f64,
    /// A.
    pub a_deg: f64,
    /// B: nominal angle of tooth 0.
    pub b_deg: f64,
    /// X, Y, Z.
    pub position_mm: [f64; 3],
    /// eta: angle between beam and helix of the flank.
    pub off_flank_deg: f64,
    /// What comes nearest to the beam besides the edge.
    pub other_flank_gap_mm: f64,
    /// Standard deviation of one reading.
    pub single_sigma_um: f64,
}

/// The measured tool.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MeasurementResult {
    /// Readings in all.
    pub readings: usize,
    /// Of which each deviation is the mean.
    pub readings_each: usize,
    /// Standard deviation of a deviation, by flank and track, as barrier and encoder scatter.
    pub sigma_um: BTreeMap<&'static str, Vec<f64>>,
    /// f: deviations normal to the flank, [track][tooth], > 0 = material beyond the nominal edge; null where a tooth did not switch.
    pub deviation_um: BTreeMap<&'static str, Vec<Vec<Option<f64>>>>,
    /// f_r: the same without clocking and mounting.
    pub remaining_um: BTreeMap<&'static str, Vec<Vec<Option<f64>>>>,
    /// Switches that are not there; absent where all are.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<MissingResult>,
    /// f(-) - f(+) of every track, where both senses were measured: delay and hysteresis of the barrier.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sense_difference_um: Option<BTreeMap<&'static str, Vec<f64>>>,
    /// Clocking of the tool.
    pub clocking_deg: f64,
    /// Pitch at the middle track.
    pub pitch: PitchResult,
    /// Mounting error.
    pub mounting: MountingResult,
    /// Profile, bands, wear.
    pub profile: ProfileResult,
    /// Correction of the setting.
    pub correction: CorrectionResult,
    /// What grinding it again has to take off; every tooth stands in resharpening.json.
    pub resharpening: ResharpeningResult,
}

/// A switch that is not there.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MissingResult {
    /// Flank.
    pub flank: &'static str,
    /// Track.
    pub track: usize,
    /// Tooth.
    pub tooth: usize,
}

/// Pitch, thickness, tooth centres; null for teeth without a switch.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PitchResult {
    /// f_p,k of every tooth.
    pub single_um: Vec<Option<f64>>,
    /// F_p,k of every tooth.
    pub cumulative_um: Vec<Option<f64>>,
    /// f_p,max; as F_p and the first harmonic without outlier teeth.
    pub largest_single_um: f64,
    /// F_p.
    pub total_um: f64,
    /// First harmonic of the tooth centres: amplitude.
    pub first_harmonic_um: f64,
    /// And where it is greatest.
    pub first_harmonic_deg: f64,
    /// Deviation of every tooth's thickness.
    pub thickness_um: Vec<Option<f64>>,
    /// Centre of every tooth at the middle track.
    pub centre_deg: Vec<Option<f64>>,
}

/// Eccentricity and wobble, with standard deviations.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MountingResult {
    /// e_x, e_y.
    pub eccentricity_um: [f64; 2],
    /// Their standard deviations from how the teeth scatter; absent where the measurement does not tell.
    pub eccentricity_sigma_um: Option<[f64; 2]>,
    /// om_x, om_y.
    pub wobble_urad: [f64; 2],
    /// Their standard deviations; absent where the measurement does not tell.
    pub wobble_sigma_urad: Option<[f64; 2]>,
    /// Outlier teeth: left out of clocking, means, mounting and correction.
    pub left_out: Vec<usize>,
}

/// Profile of the edges.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProfileResult {
    /// Mean of every track over the whole teeth, by flank.
    pub track_mean_um: BTreeMap<&'static str, Vec<f64>>,
    /// Compensation curve: coefficients of 1, x, x^2, ...
    pub curve_um: BTreeMap<&'static str, Vec<f64>>,
    /// D.
    pub band_um: f64,
    /// Teeth outside the band.
    pub out_of_band: Vec<ToothOnFlank>,
    /// Limit of wear.
    pub wear_limit_um: f64,
    /// Whether a flank is worn.
    pub worn: BTreeMap<&'static str, bool>,
}

/// What grinding the tool again has to take off.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ResharpeningResult {
    /// Depth off the rake faces along their normal: for worn and broken edges.
    pub depth_mm: f64,
    /// The same along the tool's axis.
    pub axial_depth_mm: f64,
    /// The same without the broken edges, whose chips then stay.
    pub without_broken: WithoutBroken,
    /// Broken edges, each with the depth that takes its chip away.
    pub broken: Vec<BrokenEdge>,
    /// Teeth that lack a switch: how deep they are broken is not known, and the depth does not count them.
    pub not_covered: Vec<usize>,
}

/// A tooth's flank.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ToothOnFlank {
    /// Flank.
    pub flank: &'static str,
    /// Tooth.
    pub tooth: usize,
    /// Largest distance from the compensation curve.
    pub off_um: f64,
}

/// Change of the machine's setting.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct CorrectionResult {
    /// Of d; negative makes |d| of an internal gear larger.
    pub centre_distance_um: f64,
    /// Of gamma.
    pub crossed_axes_angle_deg: f64,
    /// Of z_V1.
    pub tool_shift_um: f64,
    /// Of phi_1 against the coupling.
    pub tool_angle_deg: f64,
    /// Settings that it may change.
    pub settings: Vec<&'static str>,
    /// Settings that ended at their limits.
    pub at_limit: Vec<&'static str>,
    /// Root mean square of the profile's deviation before and after.
    pub rms_um: [f64; 2],
    /// Largest deviation before and after.
    pub largest_um: [f64; 2],
}

/// The machined workpiece under a probe in the tool spindle.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct ProbeResult {
    /// Whether the measurement is simulated; else its values were read.
    pub simulated: bool,
    /// Profiles, by flank.
    pub flanks: BTreeMap<&'static str, ProbedFlankResult>,
    /// Change of the setting beside the one that the tool asked for.
    pub correction: CorrectionResult,
    /// Greatest difference between what the change promises and what it does under the referee, without the noise of the probe.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model_difference_um: Option<f64>,
}

/// Profiles of one flank.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ProbedFlankResult {
    /// Of every tooth space: length of roll, deviation from the target, and what the correction leaves of it, mm and um.
    pub gaps: BTreeMap<String, Vec<[f64; 3]>>,
    /// Largest deviation from the target.
    pub largest_um: f64,
    /// The same as the correction leaves it.
    pub corrected_largest_um: f64,
    /// The same under the referee; absent for a real workpiece.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corrected_simulated_um: Option<f64>,
}

/// A law over the turn of the tool that answers its run-out, by cosine and sine of each order of phi_1, which is 0 where tooth 0 stands
/// on the common normal.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RunoutResult {
    /// Added to the centre distance; empty where it stays.
    pub centre_distance_um: Vec<[f64; 2]>,
    /// Added to the angle of the workpiece; empty where the coupling stays.
    pub work_angle_deg: Vec<[f64; 2]>,
    /// Greatest change of the centre distance.
    pub centre_distance_amplitude_um: f64,
    /// Greatest change of the workpiece's angle.
    pub work_angle_amplitude_deg: f64,
    /// Greatest range of what the teeth leave on a track, without and with the law, as predicted.
    pub spread_um: [f64; 2],
    /// The same under the referee.
    pub simulated_spread_um: [f64; 2],
    /// Greatest difference between prediction and referee of any tooth with law and correction, without the noise of readings.
    pub model_difference_um: f64,
}

/// A track measured the usual way.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ConventionalResult {
    /// Flank.
    pub flank: &'static str,
    /// Track.
    pub track: usize,
    /// What it would report of an ideal tool: its own error.
    pub ideal_um: Option<f64>,
    /// Angle on the rounding at which its beam touches the ideal tool.
    pub touch_deg: Option<f64>,
    /// Why it reports nothing: the code of the error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rests_on: Option<&'static str>,
    /// What it would report of this tool, mean over the teeth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reported_um: Option<f64>,
    /// What the measurement on contact points found, mean over the teeth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured_um: Option<f64>,
}

/// The scan of a stylus.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ScanResult {
    /// Teeth that are scanned.
    pub teeth: Vec<usize>,
    /// Places.
    pub places: Vec<ScanPlaceResult>,
}

/// A place of a scan.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ScanPlaceResult {
    /// Flank.
    pub flank: &'static str,
    /// x along the edge.
    pub place: f64,
    /// Length of roll.
    pub w_mm: f64,
    /// A.
    pub a_deg: f64,
    /// B.
    pub b_deg: f64,
    /// X, Y, Z.
    pub position_mm: [f64; 3],
    /// Angle between stylus and helix of the flank.
    pub off_flank_deg: f64,
    /// What it finds on each tooth; empty without a simulated tool.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub deviation_um: Vec<f64>,
}

/// The beam by a mandrel.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CalibrationResult {
    /// Whether switches were given; otherwise they are those to be expected.
    pub measured: bool,
    /// The beam's point at the height of `light_barrier.point`.
    pub point_mm: [f64; 3],
    /// delta.
    pub tilt_x_deg: f64,
    /// eps.
    pub tilt_y_deg: f64,
    /// r_L.
    pub radius_mm: f64,
    /// Standard deviations of x and y there.
    pub point_sigma_um: [f64; 2],
    /// Of delta and eps.
    pub tilt_sigma_deg: [f64; 2],
    /// Of r_L.
    pub radius_sigma_um: f64,
    /// What is left at the switches.
    pub residual_um: f64,
    /// Places of the mandrel at which the beam switches.
    pub switches: Vec<MandrelSwitchResult>,
}

/// A switch of the mandrel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MandrelSwitchResult {
    /// Axis along which it moves.
    pub along: &'static str,
    /// X and Y of its axis, Z of its lower face.
    pub place_mm: [f64; 3],
}

/// How results scatter over repeated measurements.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MonteCarloResult {
    /// Repetitions.
    pub measurements: usize,
    /// Every result.
    pub results: Vec<ScatterResult>,
}

/// A result that scatters.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ScatterResult {
    /// What.
    pub name: String,
    /// Unit.
    pub unit: &'static str,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub sigma: f64,
    /// The prediction from the readings' own standard deviation; absent where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stated_sigma: Option<f64>,
    /// 95 % of the repetitions lie between these.
    pub interval: [f64; 2],
}

/// Measurements of the tool since it was ground.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct HistoryResult {
    /// The tool.
    pub tool: String,
    /// Measurements since it was ground.
    pub measurements: usize,
    /// Workpieces cut until now.
    pub parts: f64,
    /// How often it has been ground again.
    pub resharpened: u32,
    /// Wear by flank.
    pub flanks: BTreeMap<&'static str, FlankTrendResult>,
}

/// Wear of a flank over the workpieces.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FlankTrendResult {
    /// Wear now: what is missing on the deepest track in the mean.
    pub wear_um: f64,
    /// Wear per thousand workpieces; absent with measurements at one count only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate_um_per_1000: Option<f64>,
    /// Its standard deviation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate_sigma_um_per_1000: Option<f64>,
    /// Workpieces at which the limit of wear is reached.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit_at_parts: Option<f64>,
    /// Between these with a probability of 95 %; the upper end is absent where the rate may be 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit_interval: Option<[Option<f64>; 2]>,
    /// Workpieces that are left; negative beyond the limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub remaining_parts: Option<f64>,
    /// Why there is no forecast.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_forecast: Option<String>,
}

impl FlankTrendResult {
    pub(super) fn new(wear_um: f64, trend: Option<&WearTrend>) -> Self {
        let Some(trend) = trend else {
            return Self {
                wear_um,
                rate_um_per_1000: None,
                rate_sigma_um_per_1000: None,
                limit_at_parts: None,
                limit_interval: None,
                remaining_parts: None,
                no_forecast: Some("a trend needs measurements at two counts of workpieces".into()),
            };
        };
        let forecast = trend.forecast.as_ref();
        // mm per workpiece, um per thousand.
        const PER_THOUSAND: f64 = 1e6;
        Self {
            wear_um,
            rate_um_per_1000: Some(PER_THOUSAND * trend.rate),
            rate_sigma_um_per_1000: Some(PER_THOUSAND * trend.covariance[1][1].sqrt()),
            limit_at_parts: forecast.ok().map(|f| f.parts),
            limit_interval: forecast.ok().map(|f| f.interval.map(|end| Some(end).filter(|x| x.is_finite()))),
            remaining_parts: forecast.ok().map(|f| f.remaining),
            no_forecast: forecast.err().map(ToString::to_string),
        }
    }
}
