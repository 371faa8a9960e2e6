//! `[target]`: the wanted flank, how far it may be off, and what a best fit of it makes small.

use job::tables::{Modification, default_tolerance};
use job::{Diagnostic, Problem};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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
    /// How the drawing judges the flank.
    #[serde(default, skip_serializing_if = "Judged::is_default")]
    pub judged: Judged,
    /// Which traces are judged, with `judged = "traces"`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub traces: Option<JudgedTraces>,
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

impl Target {
    /// A target says which flank is wanted, and says it once.
    pub(super) fn check(&self, findings: &mut Vec<Diagnostic>) {
        let allowed = "either `modifications = [ ... ]` or `file = \"grid.csv\"`";
        match (&self.modifications, &self.file) {
            (None, None) => findings.push(
                Diagnostic::new(Problem::MissingKey, "`target` does not say which flank is wanted")
                    .field("target.modifications")
                    .allowed(allowed)
                    .way_out("add `modifications`; an empty list asks for the pure involute"),
            ),
            (Some(_), Some(file)) => findings.push(
                Diagnostic::new(Problem::InvalidJob, "the target is given twice")
                    .field("target.file")
                    .value(format!("{file:?}"))
                    .allowed(allowed)
                    .way_out("keep one of them; a grid can also be an entry of the list (kind = \"grid\")"),
            ),
            _ => {}
        }
        let traces = self.judged == Judged::Traces;
        if self.traces.is_some() && !traces {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "traces are given, but the whole field is judged")
                    .field("target.traces")
                    .value("a table")
                    .allowed("no table, or judged = \"traces\"")
                    .way_out("add judged = \"traces\", or leave `traces` out"),
            );
        }
        if self.tolerance_map.is_some() && traces {
            findings.push(
                Diagnostic::new(
                    Problem::InvalidJob,
                    "a tolerance for every place and traces are two ways to judge",
                )
                .field("target.judged")
                .value("\"traces\"")
                .allowed("\"field\" with tolerance_map")
                .way_out("leave `judged` out, or give `tolerance_um` in place of the map"),
            );
        }
    }
}

/// How a drawing judges a flank.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Judged {
    /// The tolerance holds at every place.
    #[default]
    Field,
    /// It holds on helix and profile traces; beside them a wider band.
    Traces,
}

impl Judged {
    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// Traces that a drawing judges. Places next to them on the result grid are judged as they are.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JudgedTraces {
    /// Lengths of roll of the helix traces, mm; default the middle of the evaluated profile.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minItems" = 1, "maxItems" = 100))]
    pub helix_w_mm: Option<Vec<f64>>,
    /// Face positions of the profile traces, mm; default the middle of the evaluated face.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minItems" = 1, "maxItems" = 100))]
    pub profile_z_mm: Option<Vec<f64>>,
    /// Largest deviation allowed beside the traces, normal to the flank, um; default three times `tolerance_um`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10000,
        "x-way-out" = "give the band in micrometres, e.g. 6.0"))]
    pub beside_um: Option<f64>,
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
