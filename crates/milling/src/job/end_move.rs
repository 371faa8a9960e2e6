//! `machine.end_position`: where the axes go at the end of a program.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A rapid move of one axis, the others stay.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EndMove {
    /// Name of the axis in the machine description.
    #[schemars(extend("minLength" = 1, "x-way-out" = "give the name of a linear or rotary axis of the machine, e.g. \"Z\""))]
    pub axis: String,
    /// Where it goes, as the machine description counts it: mm, of a rotary axis degrees. An axis that turns without end goes there in its
    /// nearest turn.
    #[schemars(extend("minimum" = -100_000, "maximum" = 100_000,
        "x-way-out" = "give a position within the travel of the axis, in mm or degrees"))]
    pub position: f64,
}
