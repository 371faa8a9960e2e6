//! `[output]` of five-axis milling.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::tables::{Language, Mesh, Program, Table};

/// What to write beside result and report; all lists may be empty.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MillingOutput {
    /// Language of the report; default English.
    #[serde(default, skip_serializing_if = "Language::is_default")]
    pub language: Language,
    /// Controls for which programs are written; they need `[machine]`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("uniqueItems" = true))]
    pub programs: Vec<Program>,
    /// Whether programs are written although the target is missed or could not be judged; their first lines say so. Default false.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub programs_of_missed: bool,
    /// Formats of bodies and flanks.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("uniqueItems" = true))]
    pub meshes: Vec<Mesh>,
    /// Formats of tables.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("uniqueItems" = true))]
    pub tables: Vec<Table>,
    /// Whether cutter locations are written: tip and axis for every point, for any postprocessor.
    #[serde(default = "yes")]
    pub cl: bool,
}

impl Default for MillingOutput {
    fn default() -> Self {
        Self {
            language: Language::default(),
            programs: Vec::new(),
            programs_of_missed: false,
            meshes: Vec::new(),
            tables: Vec::new(),
            cl: yes(),
        }
    }
}

fn yes() -> bool {
    true
}
