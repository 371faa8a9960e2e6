//! The figures of tangential dressing, as the report takes them. Plain numbers with their units in the names.

use report::charts::Topography;
use report::data::Quantity;

/// What tangential dressing adds to a grinding report.
#[derive(Clone, Debug, PartialEq)]
pub struct TangentialReport {
    /// The passes in their order.
    pub passes: Vec<PassReport>,
    /// Conventional grinding beside it, per flank.
    pub radial_feed: Vec<RadialFeedReport>,
    /// Derivatives of the unmodified flank.
    pub sensitivities: Vec<SensitivityMap>,
    /// Worm length, passes, strokes.
    pub worm_length: Vec<Quantity>,
    /// What passes mean for the flanks, in words.
    pub remarks: Vec<String>,
}

/// A pass.
#[derive(Clone, Debug, PartialEq)]
pub struct PassReport {
    /// Flanks, in words.
    pub name: String,
    /// The variables.
    pub variables: Vec<VariableRow>,
    /// How they were chosen; empty where the job names them.
    pub selection: Vec<SelectionRow>,
    /// The fit.
    pub fit: Option<FitRecord>,
    /// Methods beside each other; empty unless asked for.
    pub compared: Vec<ComparedMethod>,
}

/// A variable with its value.
#[derive(Clone, Debug, PartialEq)]
pub struct VariableRow {
    /// Name.
    pub name: String,
    /// What moves.
    pub meaning: String,
    /// Value.
    pub value: f64,
    /// Unit.
    pub unit: String,
}

/// A step of the choice.
#[derive(Clone, Debug, PartialEq)]
pub struct SelectionRow {
    /// The variable.
    pub variable: String,
    /// Taken in, or left out.
    pub taken: bool,
    /// Variables after the step.
    pub count: usize,
    /// Largest |m - f| after it, um.
    pub largest_um: f64,
}

/// How the values were found.
#[derive(Clone, Debug, PartialEq)]
pub struct FitRecord {
    /// Method.
    pub method: String,
    /// Parts in which the target was stepped up.
    pub steps: usize,
    /// Rounds of all parts.
    pub rounds: usize,
    /// Whether it settled.
    pub converged: bool,
    /// Weighted root mean square at the end, um.
    pub weighted_rms_um: f64,
    /// The same before each round of the last part, um.
    pub by_round_um: Vec<f64>,
}

/// A method beside others.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedMethod {
    /// Method.
    pub method: String,
    /// Parts in which the target was stepped up.
    pub steps: usize,
    /// Rounds, weighted rms and largest |m - f| (um), settled; or why there is none.
    pub outcome: Result<(usize, f64, f64, bool), String>,
}

/// Radial feed on one flank.
#[derive(Clone, Debug, PartialEq)]
pub struct RadialFeedReport {
    /// Flank, in words.
    pub flank: String,
    /// Helix crowning, normal, um.
    pub crowning_um: f64,
    /// Twist that it leaves, closed form, normal, um.
    pub closed_twist_um: f64,
    /// The same by contact, um.
    pub twist_um: Option<f64>,
    /// Twist of the flank as planned by tangential dressing, less that of the target, um.
    pub tangential_twist_um: f64,
    /// Largest deviation of the best radial feed, um.
    pub largest_um: Option<f64>,
    /// Largest deviation of tangential dressing, um.
    pub tangential_largest_um: f64,
    /// Deviation of radial feed and of tangential dressing.
    pub maps: Option<(Topography, Topography)>,
    /// Why radial feed fails, if it does.
    pub refused: Option<String>,
}

/// Derivatives by one variable.
#[derive(Clone, Debug, PartialEq)]
pub struct SensitivityMap {
    /// Flank, in words.
    pub flank: String,
    /// Variable.
    pub variable: String,
    /// Channel, for one chart a channel.
    pub channel: String,
    /// Unit of the derivative; empty for a number.
    pub unit: String,
    /// dm/dc.
    pub map: Topography,
}
