//! `[output]` of measuring a skiving tool.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::exchange::job::{Program, Table};

/// What to write beside result and report; all lists may be empty.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SkivingOutput {
    /// Controls for which measuring programs are written; they need `[machine]`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("uniqueItems" = true))]
    pub programs: Vec<Program>,
    /// Formats of tables.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("uniqueItems" = true))]
    pub tables: Vec<Table>,
}
