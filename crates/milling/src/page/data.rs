//! What the page of five-axis milling shows, as data.

use super::{MateView, OrientationView, ProgramsView};
use report::charts::Drawing;
use report::data::Quantity;
use report::head::ReportHead;
use verdict::Verdict;

/// The whole page.
#[derive(Clone, Debug, PartialEq)]
pub struct MillingReport {
    /// The answer, warnings and files.
    pub head: ReportHead,
    /// What was judged, and what was not.
    pub verdict: Verdict,
    /// Largest deviation allowed, um.
    pub tolerance_um: f64,
    /// Workpiece and cutter.
    pub bodies: Vec<Quantity>,
    /// The space with cutter and paths, view by view.
    pub views: Vec<SpaceView>,
    /// Flanks that are milled.
    pub flanks: Vec<FlankView>,
    /// The root in a column plane.
    pub root: Option<Titled>,
    /// Contact of a bevel gear with its mate.
    pub mate: Option<MateView>,
    /// Operations in their order, for one space.
    pub operations: Vec<OperationRow>,
    /// The rotary motion beside that of other systems, flank by flank.
    pub orientations: Vec<OrientationView>,
    /// Programs and the motion of the axes.
    pub programs: Option<ProgramsView>,
}

/// The space from one side.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceView {
    /// By which programs find it.
    pub id: &'static str,
    /// The drawing.
    pub drawing: Drawing,
}

/// A drawing with its figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Titled {
    /// The drawing.
    pub drawing: Drawing,
    /// What is to be seen in it.
    pub caption: String,
    /// Its figures.
    pub quantities: Vec<Quantity>,
}

/// A flank.
#[derive(Clone, Debug, PartialEq)]
pub struct FlankView {
    /// Heading, for example `Left flank`.
    pub name: String,
    /// Height parameter and its unit, for example `length of roll w [mm]`.
    pub height_title: String,
    /// Length parameter and its unit.
    pub length_title: String,
    /// Heights of the rays, root to tip.
    pub height: Vec<f64>,
    /// Length parameters of the rays.
    pub length: Vec<f64>,
    /// Prediction, um, row-major [height][length]; none where no row lies beside.
    pub planned_um: Vec<Option<f64>>,
    /// What the rays found, um, > 0 stock; none where no cutter comes by.
    pub simulated_um: Vec<Option<f64>>,
    /// Figures of the deviation.
    pub figures: FlankFigures,
    /// Rays that are not milled: reason and number.
    pub unmilled: Vec<(String, usize)>,
    /// Rows, root to tip.
    pub rows: Vec<RowView>,
    /// Wear along the edge.
    pub wear: Option<WearView>,
    /// Distances of neighbours.
    pub density: Vec<DensityRow>,
}

/// Deviations of a flank, um.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankFigures {
    /// Largest absolute deviation.
    pub max_um: f64,
    /// Root mean square.
    pub rms_um: f64,
    /// Deepest gouge (or least stock).
    pub least_um: f64,
    /// Highest stock.
    pub greatest_um: f64,
    /// Largest difference of prediction and rays.
    pub model_difference_um: f64,
    /// Bound of the rays' own error.
    pub referee_error_um: f64,
}

/// A row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowView {
    /// Scallop to the next row, um.
    pub scallop_um: Option<f64>,
    /// What straight blocks leave, um.
    pub chord_um: f64,
    /// eps: greatest angle of the normals out of their column planes, deg.
    pub out_of_plane_deg: f64,
    /// Greatest angle of the axis out of its column plane, deg.
    pub axis_out_of_plane_deg: f64,
    /// Contact height above the cutter's tip, mm.
    pub contact_height_mm: f64,
    /// Heights that root, edge and opposite flank allow, mm.
    pub allowed_mm: Option<[f64; 2]>,
}

/// Load along the cutting edge.
#[derive(Clone, Debug, PartialEq)]
pub struct WearView {
    /// Length of a bin, mm.
    pub bin_mm: f64,
    /// Load bin by bin from the tip, m of path per mm of edge.
    pub load_m_per_mm: Vec<f64>,
    /// The same if all rows touched at the height of the first.
    pub fixed_m_per_mm: Vec<f64>,
    /// The highest load over that of one height.
    pub peak_over_fixed: f64,
    /// Length of the edge that is loaded, mm.
    pub spread_mm: f64,
}

/// A figure of the density.
#[derive(Clone, Debug, PartialEq)]
pub struct DensityRow {
    /// What it is: `along rows, greatest`.
    pub name: String,
    /// Distance, mm.
    pub measured_mm: f64,
    /// The limit, mm.
    pub limit_mm: Option<f64>,
    /// Whether no grid of this law keeps the limit together with the upper ones.
    pub violated: bool,
}

/// An operation in one space.
#[derive(Clone, Debug, PartialEq)]
pub struct OperationRow {
    /// What it does.
    pub name: String,
    /// Its cutter in words.
    pub cutter: String,
    /// Paths.
    pub paths: usize,
    /// Cutter locations.
    pub places: usize,
    /// Way of the tip in the material, mm.
    pub way_mm: f64,
}
