//! `machine.work_offset`: the origin that a control holds and that programs count from.

use super::pair_schema;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

/// A work offset of the control. Without it programs count from the origins of machine and table.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorkOffset {
    /// Its number: 1 is G54. LinuxCNC has 1 to 9 (G54 to G59.3), Siemens 1 to 99 (G54 to G57, G505 to G599), Fanuc 1 to 306 (G54 to G59,
    /// G54.1 P1 to P300).
    #[schemars(extend("minimum" = 1, "maximum" = 306, "x-way-out" = "give the number of a work offset; 1 is G54"))]
    pub number: u16,
    /// What the control holds there for X, Y and Z; default the place of the workpiece's origin on the table.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "position_schema")]
    pub position: Option<[f64; 3]>,
    /// Whether the control holds the clocking angle of the workpiece there, as a value of the rotary axis that turns it; the program is
    /// then the same for every angle.
    #[serde(default)]
    pub clocking: bool,
}

fn position_schema(_: &mut SchemaGenerator) -> Schema {
    let mut schema = pair_schema(-10_000.0, 10_000.0, "give the values of X, Y and Z in mm");
    schema.insert("minItems".into(), 3.into());
    schema.insert("maxItems".into(), 3.into());
    schema
}
