//! `[compensation]`: what is added to the target while paths are planned, as an answer to a measurement.

use job::tables::Modification;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What paths are planned with beside the target of a cylindrical gear or a bevel gear. Measurements are judged by the target alone.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MillingCompensation {
    /// Modifications that are added to those of the target; `flankwright inspect` writes them.
    pub modifications: Vec<Modification>,
}
