//! The document of a milling job's `result.json`, with units in the key names.

use super::mate_result::MateResult;
use super::orientation_result::OrientationResult;
use super::program_result::ProgramResult;
use super::stock::StockResult;
use super::tool_result::{ClockingResult, ToolResult, WorkOffsetResult};
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
    /// Tools by their first use.
    pub tools: Vec<ToolResult>,
    /// What the control has to hold as work offset; absent where programs count from the origins of machine and table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub work_offset: Option<WorkOffsetResult>,
    /// Operations in their order, for one space.
    pub operations: Vec<OperationResult>,
    /// Flanks that are milled.
    pub flanks: BTreeMap<&'static str, FlankResult>,
    /// Stock on them before they are finished: what roughing leaves, or the allowance of a pre-cut part; absent where neither is known.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub stock: BTreeMap<&'static str, StockResult>,
    /// Deviations of the root from its drawn section, part by part (`left_fillet`, `right_fillet`, `bottom`); absent without a pass of the
    /// root.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub root: BTreeMap<String, RootDeviationResult>,
    /// Contact with the mate; absent without one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mate: Option<MateResult>,
    /// NC programs, every one read back and proven; empty without a machine.
    pub programs: Vec<ProgramResult>,
    /// Programs that find the clocking angle of a part whose teeth are cut already, proven by the referee's rays; empty without a probe.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub clocking_programs: Vec<ClockingResult>,
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
    /// How the cutter is engaged while it clears the space in layers; absent of other operations and of a single layer.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub engagement: Option<EngagementResult>,
}

/// Engagement of the cutter that clears a space, as its layers and passes lie.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EngagementResult {
    /// Layers.
    pub layers: usize,
    /// Greatest depth of a layer.
    pub depth_mm: f64,
    /// Passes that cut with the whole diameter somewhere.
    pub full_width_passes: usize,
    /// Greatest width of the others, from the pass before.
    pub width_mm: f64,
    /// Arc of the circumference that is engaged with that width.
    pub arc_deg: f64,
    /// Greatest thickness of their chips; absent where the job does not tell the number of edges.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub chip_thickness_mm: Option<f64>,
    /// Material removed with that width.
    pub removal_cm3_per_min: f64,
    /// Material removed with the whole diameter.
    pub full_width_removal_cm3_per_min: f64,
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
    /// Its greatest length along the axis, or along the pitch cone.
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
    /// What the row leaves along the axis, or the pitch cone, because of the other half of a double-helical gear; absent where it leaves nothing.
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
