//! Spur and helical gears, external and internal (`docs/mathematics/milling.md#flanks-as-patches`).

use super::super::given::Checked;
use super::body::{Body, side};
use foundation::geometry::{Flank, Gear, GearData, Helicoid, Sides};
use milling::{ActiveFlank, HeightLimits, HelixOnCylinder};
use serde::Deserialize;
use std::sync::Arc;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CylinderInput {
    mn: f64,
    z: i32,
    alpha_n_deg: f64,
    beta_deg: f64,
    #[serde(default)]
    x: f64,
    b: f64,
    flank: String,
    r_form: f64,
    #[serde(default = "addendum")]
    h_ap: f64,
    #[serde(default = "dedendum")]
    h_fp: f64,
    /// Thinning at the pitch circle, mm.
    #[serde(default)]
    j_t: f64,
}

fn addendum() -> f64 {
    1.0
}

fn dedendum() -> f64 {
    1.25
}

impl CylinderInput {
    /// The flank, the other one of the space, the guide curve on the root cylinder, the body.
    pub fn case(&self) -> Checked<(ActiveFlank, ActiveFlank, HelixOnCylinder, Body)> {
        let gear = Gear::new(GearData {
            teeth: self.z,
            normal_module: self.mn,
            pressure_angle: Sides::from_fn(|_| self.alpha_n_deg.to_radians()),
            helix_angle: self.beta_deg.to_radians(),
            profile_shift: self.x,
            cone_angle: 0.0,
        })?;
        let wanted = side(&self.flank)?;
        let other = if wanted == Flank::Left { Flank::Right } else { Flank::Left };
        let helicoid = Helicoid::thinned(&gear, wanted, self.j_t)?;
        let radii = [helicoid.tip_radius(self.h_ap), helicoid.root_radius(self.h_fp)];
        helicoid.check_tip(radii[0])?;
        let heights = [helicoid.length_of_roll(self.r_form)?, helicoid.length_of_roll(radii[0])?];
        if !(self.b > 0.0 && self.b.is_finite() && heights[0] != heights[1]) {
            return Err(format!("a face of {} mm between heights {heights:?} is no flank", self.b).into());
        }
        let active = |helicoid: Helicoid| ActiveFlank {
            surface: Arc::new(helicoid),
            heights: HeightLimits::Constant(heights),
            face: [-0.5 * self.b, 0.5 * self.b],
            kink: None,
        };
        let opposite = Helicoid::thinned(&gear, other, self.j_t)?;
        let lead = HelixOnCylinder {
            radius: radii[1],
            turn_per_length: helicoid.twist(),
            external_sign: helicoid.external_sign(),
        };
        Ok((active(helicoid), active(opposite), lead, Body::Cylinder { helicoid, radii }))
    }
}
