//! `[mate]`: the gear that the workpiece is rolled against (`docs/mathematics/milling.md#contact-with-the-mate`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{BevelGear, EaseOffAmounts};
use foundation::geometry::{BevelData, Spiral};
use job::tables::{Gear, Modification};

/// The mate of a gear. That of `[bevel]` is conjugate, by `teeth`: module, face, proportions and flank line are those of the gear, its
/// hand is the opposite one; the shaft angle is by default 90 degrees, and at most one of `shaft_angle_deg` and `pitch_cone_angle_deg`
/// says otherwise. That of `[gear]` has a drawing of its own, `gear`, and stands at `centre_distance` on a parallel axis, both faces
/// about the same middle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mate {
    /// Number of teeth of the mate of a bevel gear.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 3, "maximum" = 2000, "x-way-out" = "give the number of teeth of the mating gear"))]
    pub teeth: Option<u32>,
    /// Angle of its pitch cone, degrees; 90 of a crown gear.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 90,
        "x-way-out" = "give the pitch cone angle of the mating gear in degrees, or leave it out"))]
    pub pitch_cone_angle_deg: Option<f64>,
    /// Angle between both axes, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 180,
        "x-way-out" = "give the angle between both axes in degrees; 90 is the default"))]
    pub shaft_angle_deg: Option<f64>,
    /// Ease-off of the mate of a bevel gear, over its own height and length.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ease_off: Option<EaseOffAmounts>,
    /// Drawing of the mate of a cylindrical gear: of an external one with the opposite helix angle; one of both may be internal, the helix
    /// angles then are the same.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gear: Option<Gear>,
    /// Centre distance of a cylindrical pair, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 10_000, "x-way-out" = "give the centre distance in mm"))]
    pub centre_distance: Option<f64>,
    /// Modifications of its flanks that add up, as those of `[target]`, over its own flank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub modifications: Option<Vec<Modification>>,
    /// Thickness of the marking compound: contact shows where the gap is not wider, um.
    #[serde(default = "default_marking")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the thickness in micrometres; 6 is the default"))]
    pub marking_um: f64,
    /// Roll positions for each mesh period.
    #[serde(default = "default_positions")]
    #[schemars(extend("minimum" = 8, "maximum" = 200, "x-way-out" = "24 positions are the default"))]
    pub roll_positions: usize,
}

/// By how much given angles may miss those that the numbers of teeth ask for, degrees: drawings round them.
const ROUNDED_DEG: f64 = 0.01;

/// By which share the sine of a pitch cone angle may be off 1 so that the gear is a crown gear: near 90 degrees the angle tells little of
/// the sine, and a pitch cone angle of the other gear that is rounded to a ten-thousandth of a degree is off by as much.
const CROWN: f64 = 2e-6;

/// An angle of a mate that does not fit its teeth, degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MisfitAngle {
    pub(super) key: &'static str,
    pub(super) given: f64,
    pub(super) wanted: f64,
}

impl Mate {
    /// The pitch cone angle with which both gears roll on one pitch line, degrees; `None` if there is none up to 90
    /// or no number of teeth.
    pub fn conjugate_angle_deg(&self, bevel: &BevelGear) -> Option<f64> {
        let sine =
            f64::from(self.teeth?) / f64::from(bevel.teeth) * bevel.pitch_cone_angle_deg.to_radians().sin();
        if (sine - 1.0).abs() <= CROWN {
            return Some(90.0);
        }
        (sine < 1.0).then(|| sine.asin().to_degrees())
    }

    /// Its drawing, rad; `None` as [`Self::conjugate_angle_deg`].
    pub fn data(&self, bevel: &BevelGear) -> Option<BevelData> {
        let gear = bevel.data();
        Some(BevelData {
            teeth: self.teeth?,
            pitch_angle: self.conjugate_angle_deg(bevel)?.to_radians(),
            spiral: gear.spiral.map(Spiral::reversed),
            form_angle: None,
            ..gear
        })
    }

    /// The angle of the job that does not fit, if one does not.
    pub(super) fn misfit(&self, bevel: &BevelGear) -> Option<MisfitAngle> {
        let own = self.conjugate_angle_deg(bevel)?;
        let (key, given, wanted) = match (self.pitch_cone_angle_deg, self.shaft_angle_deg) {
            (Some(given), _) => ("mate.pitch_cone_angle_deg", given, own),
            (None, Some(given)) => ("mate.shaft_angle_deg", given, own + bevel.pitch_cone_angle_deg),
            (None, None) => ("mate.teeth", 90.0, own + bevel.pitch_cone_angle_deg),
        };
        ((given - wanted).abs() > ROUNDED_DEG).then_some(MisfitAngle { key, given, wanted })
    }
}

fn default_marking() -> f64 {
    6.0
}

fn default_positions() -> usize {
    24
}
