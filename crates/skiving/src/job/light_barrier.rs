//! `[light_barrier]`: where the beam is and how the barrier reads.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use super::list_schema;

/// The light barrier, in machine coordinates: X along the common normal, Z along the workpiece's axis. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LightBarrier {
    /// M: the point of the beam at whose height contacts are laid; of a beam with a direction in the plane across it.
    #[schemars(schema_with = "point_schema")]
    pub point: [f64; 3],
    /// delta: tilt of the beam in the X-Z plane, degrees.
    #[serde(default)]
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90, "x-way-out" = "give the tilt in degrees, 0 for an upright beam; one that lies down has a `direction` instead"))]
    pub tilt_x_deg: f64,
    /// eps: tilt of the beam in the Y-Z plane, degrees.
    #[serde(default)]
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90, "x-way-out" = "give the tilt in degrees, 0 for an upright beam; one that lies down has a `direction` instead"))]
    pub tilt_y_deg: f64,
    /// l: direction of the beam instead of its tilts, of any length: where the rake face looks while it is measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "direction_schema")]
    pub direction: Option<[f64; 3]>,
    /// r_L: effective radius of the beam.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 5, "x-way-out" = "give the radius of the beam in mm, e.g. 0.05"))]
    pub radius: f64,
    /// How much deeper the beam must be shaded to switch to dark than to stay so, um.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the hysteresis in micrometres, 0 for none"))]
    pub hysteresis_um: f64,
    /// From the switch to the reading, us.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1e6, "x-way-out" = "give the delay in microseconds, 0 for none"))]
    pub latency_us: f64,
    /// Standard deviation of that time, us.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1e5, "x-way-out" = "give the jitter in microseconds, 0 for none"))]
    pub jitter_us: f64,
    /// Standard deviation of the beam's edge across itself, um.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1000, "x-way-out" = "give the noise in micrometres, 0 for none"))]
    pub noise_um: f64,
    /// Step of the spindle's encoder, degrees; 0 without.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 1, "x-way-out" = "give the step in degrees, e.g. 1e-4; 0 for none"))]
    pub encoder_step_deg: f64,
}

impl LightBarrier {
    /// delta and eps of the beam, degrees; `None` for one that does not rise.
    pub(crate) fn tilts_deg(&self) -> Option<[f64; 2]> {
        let Some([x, y, z]) = self.direction else { return Some([self.tilt_x_deg, self.tilt_y_deg]) };
        (z > 0.0).then(|| [x, y].map(|across| across.atan2(z).to_degrees()))
    }
}

fn direction_schema(_: &mut SchemaGenerator) -> Schema {
    list_schema(
        [3, 3],
        [-1000.0, 1000.0],
        "give x, y, z of a vector along the beam, machine coordinates, e.g. [0.0, 1.0, 0.2]",
    )
}

pub(super) fn point_schema(_: &mut SchemaGenerator) -> Schema {
    list_schema([3, 3], [-10_000.0, 10_000.0], "give X, Y, Z in mm, machine coordinates")
}
