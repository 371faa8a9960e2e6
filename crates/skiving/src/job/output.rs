//! `[output]` of measuring a skiving tool.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::tables::{Language, Program, Table};

/// What to write beside result and report; all lists may be empty.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SkivingOutput {
    /// Language of the report; default English.
    #[serde(skip_serializing_if = "Language::is_default")]
    pub language: Language,
    /// Controls for which measuring programs are written; they need `[machine]`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("uniqueItems" = true))]
    pub programs: Vec<Program>,
    /// Whether measuring programs are written although the ideal edge misses the profile, so that their poses are in doubt; default false.
    /// The verdict on a measured tool does not hold them back: it stands in their first lines.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub programs_of_missed: bool,
    /// Formats of tables.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("uniqueItems" = true))]
    pub tables: Vec<Table>,
}
