//! `[compensation]`: what a job asks for beyond its target, so that a machine with the deviations that were measured makes the target.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use job::tables::Modification;

/// Written by `inspect`. Plans make target plus compensation; measurements are judged by the target alone.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Compensation {
    /// What is added to the target; amounts as there.
    pub modifications: Vec<Modification>,
    /// Sum of all corrections by setting, in the unit of its name.
    #[serde(default)]
    #[schemars(extend("maxProperties" = 100))]
    pub settings: BTreeMap<String, f64>,
    /// Measurements that it comes from.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the number of measurements that the compensation comes from"))]
    pub rounds: u32,
}
