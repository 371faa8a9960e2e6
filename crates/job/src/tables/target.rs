//! `[target]`: the wanted flank.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use foundation::modification::ModificationSpec;

/// One entry of `modifications`: a table with `kind` and the keys of that kind.
pub type Modification = ModificationSpec;

/// The wanted flank: modifications of the involute, or a grid of values from a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Target {
    /// Largest deviation allowed between target and simulated flank, in um, normal to the flank.
    #[serde(default = "default_tolerance")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000,
        "x-way-out" = "give the tolerance in micrometres, e.g. 1.0"))]
    pub tolerance_um: f64,
    /// Deviation allowed from place to place, instead of `tolerance_um`: a CSV file (columns w_mm, z_mm, tolerance_um)
    /// beside the job file, or a table. Bilinear between the places of its grid; beyond the grid its border continues.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tolerance_map: Option<ToleranceMapSource>,
    /// What the best fit of a target that the tool's lines cannot carry makes small.
    #[serde(default, skip_serializing_if = "Fit::is_default")]
    pub fit: Fit,
    /// Modifications that add up; amounts are transverse, positive = material removed. An empty list asks for
    /// the pure involute.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("maxItems" = 500))]
    pub modifications: Option<Vec<Modification>>,
    /// Table of values (CSV with the columns w_mm, z_mm, f_um), beside the job file: a full grid, or scattered points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minLength" = 1))]
    pub file: Option<String>,
}

/// Where the tolerances stand.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum ToleranceMapSource {
    /// In a file.
    File(#[schemars(extend("minLength" = 1))] String),
    /// Here.
    Table(ToleranceTable),
}

/// Tolerances on a grid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToleranceTable {
    /// Lengths of roll, ascending, mm.
    #[schemars(extend("minItems" = 1, "maxItems" = 1000))]
    pub w_mm: Vec<f64>,
    /// Face positions, ascending, mm.
    #[schemars(extend("minItems" = 1, "maxItems" = 1000))]
    pub z_mm: Vec<f64>,
    /// Largest deviation allowed, normal to the flank, `[w][z]`, um; each above 0.
    #[schemars(extend("minItems" = 1, "maxItems" = 1000))]
    pub tolerance_um: Vec<Vec<f64>>,
}

/// Tolerance of a job that gives none, um.
pub fn default_tolerance() -> f64 {
    1.0
}

/// What a best fit makes small.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Fit {
    /// The sum of squares of the deviations over the tolerance.
    #[default]
    LeastSquares,
    /// The largest deviation over the tolerance.
    Largest,
}

impl Fit {
    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}
