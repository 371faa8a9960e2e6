//! `[machine]`: which machine, how the bodies are clamped in it, how fast it works.

use foundation::geometry::TurnedBody;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The machine, and what its programs have to know beyond the flank. Lengths in mm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Machine {
    /// Machine description (TOML or JSON), beside the job file.
    #[schemars(extend("minLength" = 1))]
    pub file: String,
    /// How the worm sits in its spindle; default in the middle, not turned.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub worm: Option<Clamping>,
    /// How the workpiece sits in its spindle. Which way round it is clamped follows from the hand of the worm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub work: Option<Clamping>,
    /// How the dresser sits in its spindle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dresser: Option<Clamping>,
    /// Angle at which the dresser's swivel stands, degrees; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90, "x-way-out" = "give an angle below 90 degrees, or leave it out"))]
    pub swivel_deg: Option<f64>,
    /// Speed of the worm's tip while it grinds, m/s; default 50.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 200, "x-way-out" = "give the cutting speed in m/s, e.g. 50"))]
    pub cutting_speed_m_per_s: Option<f64>,
    /// Speed of the worm while it is dressed, 1/min; default 60.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000, "x-way-out" = "give the speed in 1/min, e.g. 60"))]
    pub dressing_worm_speed_rpm: Option<f64>,
    /// Speed of the dresser, 1/min; default 4000.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100_000, "x-way-out" = "give the speed in 1/min, e.g. 4000"))]
    pub dresser_speed_rpm: Option<f64>,
    /// How far the worm stands off before and after a stroke; default 15.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 1, "maximum" = 1000, "x-way-out" = "give a distance in mm, e.g. 15"))]
    pub clearance: Option<f64>,
    /// Stock left on the flank by the roughing strokes one after the other, um, falling; default no roughing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("maxItems" = 20), inner(range(min = 1, max = 2000)))]
    pub roughing_stock_um: Vec<f64>,
    /// Strokes without infeed after the finishing stroke; default 0.
    #[serde(default, skip_serializing_if = "is_zero")]
    #[schemars(extend("maximum" = 20))]
    pub spark_out: u32,
    /// Stock left on the worm flank by the dressing strokes before the last one, um, falling; default one stroke only.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("maxItems" = 20), inner(range(min = 1, max = 1000)))]
    pub dressing_stock_um: Vec<f64>,
    /// What holds the gear: arbor, nut, fixture, centre, as bodies of revolution about its axis, from which programs keep the worm away; default none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("maxItems" = 20))]
    pub clamping: Vec<ClampingBody>,
    /// Distance that programs keep from the clamping and from the machine's bodies; default 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0.1, "maximum" = 100, "x-way-out" = "give a distance in mm, e.g. 1"))]
    pub body_clearance: Option<f64>,
}

/// Distance from clamping and bodies of the machine where a job gives none, mm.
pub const BODY_CLEARANCE: f64 = 1.0;

/// A cylinder or a frustum of a cone about the axis of the workpiece. Lengths in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ClampingBody {
    /// Its name.
    #[schemars(extend("minLength" = 1, "maxLength" = 60))]
    pub name: String,
    /// From where to where it reaches along the axis of the workpiece, ascending, from the origin of its coordinates: of cylindrical gears the middle of the face.
    #[schemars(inner(range(min = -10_000, max = 10_000)))]
    pub z: [f64; 2],
    /// Its diameter, of a cone that at the lower z.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000, "x-way-out" = "give the diameter in mm"))]
    pub diameter: f64,
    /// Diameter of a cone at the higher z; default that of a cylinder.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 10_000, "x-way-out" = "give the diameter in mm, or leave it out for a cylinder"))]
    pub end_diameter: Option<f64>,
}

impl ClampingBody {
    /// The body in coordinates of the workpiece; `None` for one without length.
    pub fn body(&self) -> Option<TurnedBody> {
        let end = self.end_diameter.unwrap_or(self.diameter);
        TurnedBody::about_z(self.z, [0.5 * self.diameter, 0.5 * end])
    }
}

/// How a body sits in its spindle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Clamping {
    /// Middle of the body along the spindle axis, from the spindle's origin.
    #[serde(default)]
    pub axial: f64,
    /// Angle by which the body's zero is turned in the spindle, degrees.
    #[serde(default)]
    pub angle_deg: f64,
}

fn is_zero(count: &u32) -> bool {
    *count == 0
}
