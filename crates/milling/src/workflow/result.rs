//! The document of a milling job's `result.json`, with units in the key names.

use super::orientation_result::OrientationResult;
use super::program_result::ProgramResult;
use contact::ContactPattern;
use foundation::geometry::CutterShape;
use run::DrawingResult;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use verdict::{Remark, Verdict};

/// The whole document.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MillingResult {
    /// Name of the job.
    pub job: String,
    /// Process.
    pub process: &'static str,
    /// Version of flankwright.
    pub version: &'static str,
    /// Status, reason and scope.
    #[serde(flatten)]
    pub verdict: Verdict,
    /// Tolerance of the job.
    pub tolerance_um: f64,
    /// Warnings.
    pub warnings: Vec<Remark>,
    /// Tooth thickness and class of the drawing, which nothing here judges; absent of bevel gears and blades.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub drawing: Option<DrawingResult>,
    /// Spaces of the workpiece, and how many of them are milled.
    pub spaces: [usize; 2],
    /// The cutter of the flanks.
    pub cutter: CutterResult,
    /// Operations in their order, for one space.
    pub operations: Vec<OperationResult>,
    /// Flanks that are milled.
    pub flanks: BTreeMap<&'static str, FlankResult>,
    /// Deviations of the root from its drawn section, part by part (`left_fillet`, `right_fillet`, `bottom`); absent without a pass of the
    /// root.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub root: BTreeMap<String, RootDeviationResult>,
    /// Contact with the mate; absent without one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mate: Option<MateResult>,
    /// NC programs, every one read back and proven; empty without a machine.
    pub programs: Vec<ProgramResult>,
    /// Seconds per stage; the only part that differs between two runs.
    pub timing_s: BTreeMap<&'static str, f64>,
}

/// A cutter. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CutterResult {
    /// "conical" (end mill, ball, torus, cone) or "barrel".
    pub profile: &'static str,
    /// Diameter at the tip plane, of a barrel the largest.
    pub diameter: f64,
    /// Radius of the corner, of a barrel that of the profile.
    pub profile_radius: f64,
    /// Half angle of a cone.
    pub half_angle_deg: f64,
    /// Height of the edges.
    pub cutting_length: f64,
}

impl CutterResult {
    /// The figures of a cutting part.
    pub fn new(shape: &CutterShape, cutting_length: f64) -> Self {
        match *shape {
            CutterShape::Conical { radius, half_angle, corner_radius } => Self {
                profile: "conical",
                diameter: 2.0 * radius,
                profile_radius: corner_radius,
                half_angle_deg: half_angle.to_degrees(),
                cutting_length,
            },
            CutterShape::Barrel { radius, profile_radius, .. } => Self {
                profile: "barrel",
                diameter: 2.0 * radius,
                profile_radius,
                half_angle_deg: 0.0,
                cutting_length,
            },
        }
    }
}

/// One operation in one space.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OperationResult {
    /// What it does.
    pub name: String,
    /// Paths.
    pub paths: usize,
    /// Cutter locations.
    pub places: usize,
    /// Way of the tip in the material.
    pub way_mm: f64,
    /// Feed of the contact for each cutting edge; absent where the job does not tell their number.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub feed_per_tooth_mm: Option<f64>,
}

/// One flank. Arrays over rays are row-major [height][length].
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FlankResult {
    /// Unit of the height parameter: "mm" (length of roll), "rad" (roll angle), "1" (fraction).
    pub height_unit: &'static str,
    /// Unit of the length parameter: "mm" (axial position, distance from the apex) or "1".
    pub length_unit: &'static str,
    /// Height parameters of the rays, root to tip.
    pub height: Vec<f64>,
    /// Length parameters of the rays.
    pub length: Vec<f64>,
    /// Prediction for the deviation: scallop and straight blocks; null where no row lies beside.
    pub planned_um: Vec<Option<f64>>,
    /// Deviation that the referee's rays found, > 0 stock; null where no cutter comes by or the flank is out of reach.
    pub simulated_um: Vec<Option<f64>>,
    /// Rays that no cutter meets, by reason.
    pub unmilled: BTreeMap<String, usize>,
    /// How many of them because a cutter digs in deeper than the ray begins.
    pub gouged: usize,
    /// What the other half of a double-helical gear keeps the cutter from; absent where there is nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub out_of_reach: Option<OutOfReachResult>,
    /// Largest absolute deviation of the rays.
    pub max_deviation_um: f64,
    /// Lowest and highest deviation of the rays.
    pub stock_um: [f64; 2],
    /// Root mean square of them.
    pub rms_deviation_um: f64,
    /// Largest difference of prediction and rays.
    pub model_difference_um: f64,
    /// Bound of the rays' own error.
    pub referee_error_um: f64,
    /// Lead parameters between which the flank lies, without overrun.
    pub lead_range: [f64; 2],
    /// Columns of the path before the flank begins (and after it ends).
    pub overrun_columns: usize,
    /// Distances between columns, along rows.
    pub along_rows: DistancesResult,
    /// Distances between rows, along columns.
    pub along_columns: DistancesResult,
    /// Rows, root to tip.
    pub rows: Vec<RowResult>,
    /// Wear along the edge; absent for cutters whose contact is not chosen.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wear: Option<WearResult>,
    /// The root below the flank, at its middle column.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub root: Option<RootResult>,
    /// The rotary motion beside that of other systems, where the job wants it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orientation: Option<OrientationResult>,
}

/// The part of a flank towards the middle of a double-helical gear that the cutter does not reach.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OutOfReachResult {
    /// Its greatest length along the axis.
    pub length_mm: f64,
    /// The row that it is found on.
    pub row: usize,
    /// Rays in it; they are not judged.
    pub rays: usize,
}

/// Distances of neighbours, mm; a mean is that of one line.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DistancesResult {
    /// Least distance.
    pub min_mm: f64,
    /// Greatest distance.
    pub max_mm: f64,
    /// Least mean of a line.
    pub min_mean_mm: f64,
    /// Greatest mean of a line.
    pub max_mean_mm: f64,
}

/// One row.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RowResult {
    /// Number, 0 at the root.
    pub row: usize,
    /// Contact height above the cutter's tip.
    pub contact_height_mm: f64,
    /// Heights that root, edge and opposite flank allow.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub allowed_mm: Option<[f64; 2]>,
    /// Scallop to the next row; absent above the last one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scallop_um: Option<f64>,
    /// What straight blocks leave in their middle, < 0 gouge.
    pub chord_um: f64,
    /// Greatest angle of the normals out of their column planes.
    pub out_of_plane_deg: f64,
    /// Greatest angle of the cutter's axis out of its column plane.
    pub axis_out_of_plane_deg: f64,
    /// Least curvature of the gap between cutter and flank.
    pub opening_per_mm: f64,
    /// What the row leaves along the axis because of the other half of a double-helical gear; absent where it leaves nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unmilled_mm: Option<f64>,
}

/// Load along the cutting edge.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WearResult {
    /// Length of a bin.
    pub bin_mm: f64,
    /// Metres of path per mm of edge, bin by bin from the tip.
    pub load_m_per_mm: Vec<f64>,
    /// The highest load over that of one contact height for all rows.
    pub peak_over_fixed: f64,
    /// Length of the edge that is loaded.
    pub spread_mm: f64,
}

/// The root section at one column.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RootResult {
    /// Lean of the axis.
    pub lean_deg: f64,
    /// Straight piece between active flank and fillet.
    pub straight_mm: f64,
    /// Contact height of the pass.
    pub contact_height_mm: f64,
    /// Half distance of the lowest points of both fillets.
    pub half_width_mm: f64,
}

/// A part of the root under rays on its drawn section; > 0 stock, null where no ray is met.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RootDeviationResult {
    /// Rays.
    pub rays: usize,
    /// Rays at which a cutter digs into the drawn root, deeper than the drawn section is off what is swept.
    pub gouged: usize,
    /// Rays that no cutter reaches.
    pub not_reached: usize,
    /// Deepest place below the drawn section (or least stock).
    pub min_um: Option<f64>,
    /// Highest stock: the roof between passes.
    pub max_um: Option<f64>,
    /// Root mean square.
    pub rms_um: Option<f64>,
    /// Least and greatest prediction: what the passes of the root sweep beside the drawn section.
    pub planned_um: Option<[f64; 2]>,
    /// Largest difference of prediction and rays.
    pub model_difference_um: Option<f64>,
    /// Rays that no cutter meets, by reason.
    pub unmilled: BTreeMap<String, usize>,
}

/// A bevel gear rolled against its conjugate mate, both with the flanks that are wanted.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MateResult {
    /// Teeth of the mate.
    pub teeth: u32,
    /// Its pitch cone angle.
    pub pitch_cone_angle_deg: f64,
    /// Angle between both axes.
    pub shaft_angle_deg: f64,
    /// Radius of its pitch cone in the middle of the face; transmission errors in um are ways there.
    pub mean_pitch_radius_mm: f64,
    /// Gaps up to here show contact.
    pub marking_um: f64,
    /// Where the milled flank begins and where the mate needs it to.
    pub start_of_flank: MateStartResult,
    /// Flanks that are milled.
    pub flanks: BTreeMap<&'static str, MateFlankResult>,
}

/// Polar angles of the flank, degrees.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MateStartResult {
    /// Where the flank that is milled begins.
    pub active_deg: f64,
    /// Where the tip of the mate engages; absent where it reaches below the base cone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub needed_deg: Option<f64>,
    /// Whether all that the mate needs is milled.
    pub covered: bool,
}

/// Contact on one flank of the gear, without load.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MateFlankResult {
    /// Pattern that rolling leaves; absent if nothing is marked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rolled: Option<PatternResult>,
    /// Pattern that both ease-offs say.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ease_off: Option<PatternResult>,
    /// Common area of both patterns over the area that either covers.
    pub overlap_percent: f64,
    /// Peak to peak of a mesh period, as turn of the mate.
    pub transmission_error_arcsec: f64,
    /// The same at the mate's mean pitch radius.
    pub transmission_error_um: f64,
    /// What both ease-offs say for it.
    pub transmission_error_ease_off_um: f64,
}

/// A contact pattern on the active flank: 0 % at root and toe, 100 % at tip and heel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PatternResult {
    /// Covered share of the flank.
    pub area_percent: f64,
    /// Centre along the tooth.
    pub centre_length_percent: f64,
    /// Centre over the height.
    pub centre_height_percent: f64,
    /// From where to where along the tooth.
    pub length_percent: [f64; 2],
    /// From where to where over the height.
    pub height_percent: [f64; 2],
}

impl PatternResult {
    /// In percent.
    pub fn new(pattern: &ContactPattern) -> Self {
        let [height, length] = pattern.ends.map(|ends| ends.map(|share| 100.0 * share));
        Self {
            area_percent: 100.0 * pattern.area,
            centre_length_percent: 100.0 * pattern.centre[1],
            centre_height_percent: 100.0 * pattern.centre[0],
            length_percent: length,
            height_percent: height,
        }
    }
}
