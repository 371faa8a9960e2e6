//! `series.json`: parts in the order of their making, figures of every characteristic. Units stand beside the figures.

use super::super::files::LeftOutFile;
use schemars::JsonSchema;
use serde::Serialize;
use verdict::{Remark, Verdict};

/// The whole document.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct InspectionSeriesResult {
    /// Process.
    pub process: &'static str,
    /// Version of flankwright.
    pub version: &'static str,
    /// Whether every part reaches the class, or keeps the limits that it was imported with; without them nothing is judged.
    #[serde(flatten)]
    pub verdict: Verdict,
    /// Class of ISO 1328-1:2013 that gives the limits.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance_class: Option<i32>,
    /// Parts that belong together, by name.
    pub groups: Vec<SeriesGroupResult>,
    /// Files that were not evaluated, in the order of the paths.
    pub refused: Vec<RefusedFile>,
    /// What the folder holds beside its measurements.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub left_out: Vec<LeftOutFile>,
    /// What the user stated about all measurements.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub stated: Vec<String>,
}

/// Parts of one drawing.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SeriesGroupResult {
    /// The drawing, else the name of the gear, else teeth and module.
    pub series: String,
    /// What the parts are ordered by: `time` or `name`.
    pub ordered_by: &'static str,
    /// Parts in their order.
    pub parts: Vec<SeriesPartResult>,
    /// Characteristics.
    pub characteristics: Vec<SeriesCharacteristic>,
}

/// A part.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SeriesPartResult {
    /// Its number in the series, from 1.
    pub number: usize,
    /// Its number or name.
    pub part: String,
    /// Its file.
    pub file: String,
    /// When it was measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time: Option<String>,
    /// Path of its sheet below the directory of the series.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sheet: Option<String>,
    /// Class of ISO 1328-1 that it reaches.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub class: Option<i32>,
    /// Characteristics beyond their limits.
    pub exceeded: Vec<String>,
    /// What the class needs and the file does not hold.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_judged: Vec<String>,
    /// Doubts of reading and evaluation.
    pub warnings: Vec<Remark>,
}

/// A file that was not evaluated.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct RefusedFile {
    /// The file.
    pub file: String,
    /// Code of the error.
    pub code: String,
    /// The error.
    pub message: String,
    /// What can be done.
    pub way_out: String,
}

/// A characteristic over the parts that have it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SeriesCharacteristic {
    /// What it is: `fHa.left.mean`.
    pub key: String,
    /// Unit of all its figures.
    pub unit: String,
    /// Lower limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lower_limit: Option<f64>,
    /// Upper limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub upper_limit: Option<f64>,
    /// Parts that have it.
    pub n: usize,
    /// Numbers of these parts.
    pub parts: Vec<usize>,
    /// Their values.
    pub values: Vec<f64>,
    /// Figures; absent where there are none.
    #[serde(flatten)]
    pub figures: Option<SeriesFigures>,
    /// Why there are no figures, or no capability; what was left out; what to know.
    pub remarks: Vec<String>,
}

/// Figures of a characteristic of at least two parts.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SeriesFigures {
    /// Mean.
    pub mean: f64,
    /// With 95 percent certainty the mean of the process lies between these.
    pub mean_interval_95: [f64; 2],
    /// Standard deviation.
    pub s: f64,
    /// With 95 percent certainty that of the process lies between these.
    pub s_interval_95: [f64; 2],
    /// Least value.
    pub min: f64,
    /// Greatest value.
    pub max: f64,
    /// Greatest less least.
    pub range: f64,
    /// Standard deviation by the distances of neighbouring parts.
    #[serde(rename = "sigma_MR")]
    pub sigma_mr: f64,
    /// Control limits of individual values.
    pub control_limits: [f64; 2],
    /// Mean distance of neighbouring parts, and its upper control limit.
    pub moving_range: [f64; 2],
    /// Capability; absent without limits, or where all parts are equal.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub capability: Option<SeriesCapability>,
    /// Trend; absent for fewer than three parts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub trend: Option<SeriesTrend>,
    /// What the rules for special causes find.
    pub special_causes: Vec<SeriesFinding>,
}

/// Capability indices.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SeriesCapability {
    /// By s of all parts (Pp where the process is not in control).
    #[serde(rename = "Cp", skip_serializing_if = "Option::is_none")]
    pub cp: Option<f64>,
    /// 95 percent.
    #[serde(rename = "Cp_interval_95", skip_serializing_if = "Option::is_none")]
    pub cp_interval_95: Option<[f64; 2]>,
    /// By s of all parts (Ppk where the process is not in control).
    #[serde(rename = "Cpk")]
    pub cpk: f64,
    /// 95 percent.
    #[serde(rename = "Cpk_interval_95", skip_serializing_if = "Option::is_none")]
    pub cpk_interval_95: Option<[f64; 2]>,
    /// Lower bound of 95 percent.
    #[serde(rename = "Cpk_lower_95", skip_serializing_if = "Option::is_none")]
    pub cpk_lower_95: Option<f64>,
    /// By sigma_MR: without drifts and jumps.
    #[serde(rename = "Cp_MR", skip_serializing_if = "Option::is_none")]
    pub cp_mr: Option<f64>,
    /// By sigma_MR.
    #[serde(rename = "Cpk_MR", skip_serializing_if = "Option::is_none")]
    pub cpk_mr: Option<f64>,
    /// Share of parts outside the limits for a normal law, ppm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outside_ppm: Option<f64>,
    /// Only one limit: the index of its side.
    pub one_sided: bool,
}

/// The straight course over the number of the part.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SeriesTrend {
    /// Change from part to part.
    pub per_part: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// 95 percent.
    pub interval_95: [f64; 2],
    /// Value of the line at part number 0.
    pub start: f64,
    /// Probability of such a slope by chance; absent where all parts are equal.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub p: Option<f64>,
}

/// A stretch of parts that a rule has found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct SeriesFinding {
    /// Code of the rule.
    pub rule: &'static str,
    /// What it says, with its source.
    pub meaning: &'static str,
    /// Number of the first part.
    pub first: usize,
    /// Number of the last part.
    pub last: usize,
}
