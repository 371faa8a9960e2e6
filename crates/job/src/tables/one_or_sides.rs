//! A value for both flanks, or one for each: `17.5` or `{ left = 17.5, right = 22.5 }`.

use schemars::{Schema, json_schema};
use serde::{Deserialize, Serialize};

use foundation::geometry::Sides;

/// One value for both flanks or one for each.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum OneOrSides<T> {
    /// The same on both flanks.
    Both(T),
    /// Left and right differ.
    Each {
        /// Value of the left flank.
        left: T,
        /// Value of the right flank.
        right: T,
    },
}

impl<T: Clone> OneOrSides<T> {
    /// The values by flank.
    pub fn sides(&self) -> Sides<T> {
        match self {
            OneOrSides::Both(value) => Sides::both(value.clone()),
            OneOrSides::Each { left, right } => Sides { left: left.clone(), right: right.clone() },
        }
    }
}

/// The schema of both forms, so that the range holds for the single value and for each flank's.
pub fn one_or_sides_schema(value: Schema) -> Schema {
    json_schema!({
        "anyOf": [value, {
            "type": "object",
            "properties": { "left": value, "right": value },
            "required": ["left", "right"],
            "additionalProperties": false
        }]
    })
}

/// Normal pressure angle in degrees: outside this range neither worm nor dresser can be made.
pub fn pressure_angle_schema(_: &mut schemars::SchemaGenerator) -> Schema {
    one_or_sides_schema(json_schema!({
        "type": "number",
        "minimum": 5,
        "maximum": 45,
        "x-way-out": "give the normal pressure angle of the drawing in degrees, e.g. 20.0"
    }))
}
