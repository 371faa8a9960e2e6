//! `[machine]`: which machine.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Machine {
    /// Machine description (TOML), beside the job file.
    #[schemars(extend("minLength" = 1))]
    pub file: String,
}
