//! `[gear]` of the electronic gearbox: what the rotation over the feed depends on.

use std::f64::consts::PI;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Drawing data of the workpiece as far as its rotation depends on them. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearboxGear {
    /// Number of teeth; negative for an internal gear.
    #[schemars(extend("minimum" = -2000, "maximum" = 2000, "not" = {"const": 0},
        "x-way-out" = "give the number of teeth of the drawing; negative for an internal gear"))]
    pub teeth: i32,
    /// Normal module.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100,
        "x-way-out" = "give the normal module of the drawing in mm"))]
    pub normal_module: f64,
    /// Normal pressure angle in degrees.
    #[schemars(extend("minimum" = 5, "maximum" = 45,
        "x-way-out" = "give the normal pressure angle of the drawing in degrees, e.g. 20.0"))]
    pub normal_pressure_angle_deg: f64,
    /// Helix angle at the pitch cylinder in degrees, positive for a right-hand gear.
    #[schemars(extend("exclusiveMinimum" = -90, "exclusiveMaximum" = 90,
        "x-way-out" = "give the helix angle in degrees: 0 for a spur gear, > 0 right-hand, < 0 left-hand"))]
    pub helix_angle_deg: f64,
}

impl GearboxGear {
    /// Lead p_z = pi m_n |z|/sin(beta), mm, positive for right-hand teeth (spec 70 section 1); `None` for a spur gear.
    pub fn lead_mm(&self) -> Option<f64> {
        let sine = self.helix_angle_deg.to_radians().sin();
        (sine != 0.0).then(|| PI * self.normal_module * f64::from(self.teeth.unsigned_abs()) / sine)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lead_has_the_sign_of_the_hand() {
        let gear = |teeth, helix_angle_deg| GearboxGear {
            teeth,
            normal_module: 2.0,
            normal_pressure_angle_deg: 20.0,
            helix_angle_deg,
        };
        // Rotation over the feed in rad/mm as found on the helicoids themselves (spec 70 section 5).
        const ROTATION: f64 = 0.006470476;
        for teeth in [40, -40] {
            for sign in [1.0, -1.0] {
                let lead = gear(teeth, sign * 15.0).lead_mm().unwrap();
                assert!((lead * ROTATION - sign * 2.0 * PI).abs() < 1e-6, "{lead}");
            }
        }
        assert_eq!(gear(40, 0.0).lead_mm(), None);
    }
}
