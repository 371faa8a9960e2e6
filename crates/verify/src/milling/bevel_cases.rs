//! Bevel gears, straight and spiral, with ease-off (`docs/mathematics/milling.md#flanks-as-patches`).

use super::super::given::Checked;
use super::body::{Body, side};
use foundation::geometry::{
    BevelData, BevelGear, EaseOff, EaseOffAmounts, Flank, Hand, LineForm, Modified, SphericalInvolute,
    Spiral, Surface,
};
use milling::{ActiveFlank, CurveOnCone, HeightLimits};
use serde::Deserialize;
use std::sync::Arc;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct BevelInput {
    met: f64,
    z: u32,
    delta_deg: f64,
    alpha_deg: f64,
    b: f64,
    flank: String,
    h_ap: Option<f64>,
    h_fp: Option<f64>,
    /// Spiral angle, radius of the cutter head and hand: all or none.
    beta_m_deg: Option<f64>,
    rc: Option<f64>,
    hand: Option<f64>,
    /// Crowning along the tooth, along the profile, bias; mm.
    ease: Option<[f64; 3]>,
}

impl BevelInput {
    fn spiral(&self) -> Checked<Option<Spiral>> {
        match (self.beta_m_deg, self.rc, self.hand) {
            (None, None, None) => Ok(None),
            (Some(angle), Some(cutter_radius), Some(hand)) if hand.abs() == 1.0 => Ok(Some(Spiral {
                mean_angle: angle.to_radians(),
                form: LineForm::Circle { radius: cutter_radius },
                hand: if hand > 0.0 { Hand::Right } else { Hand::Left },
            })),
            _ => Err("a spiral needs beta_m_deg, rc and hand (+1 or -1)".into()),
        }
    }

    /// The flank, the other one of the space, the guide curve on the root cone, the body.
    pub fn case(&self) -> Checked<(ActiveFlank, ActiveFlank, CurveOnCone, Body)> {
        let plain = BevelData::new(
            self.met,
            self.z,
            self.delta_deg.to_radians(),
            self.alpha_deg.to_radians(),
            self.b,
        );
        let gear = BevelGear::new(BevelData {
            addendum_factor: self.h_ap.unwrap_or(plain.addendum_factor),
            dedendum_factor: self.h_fp.unwrap_or(plain.dedendum_factor),
            spiral: self.spiral()?,
            ..plain
        })?;
        let wanted = side(&self.flank)?;
        let other = if wanted == Flank::Left { Flank::Right } else { Flank::Left };
        let active = |flank: Flank| -> Checked<ActiveFlank> {
            let base = SphericalInvolute::new(&gear, flank);
            let surface: Arc<dyn Surface> = match self.ease {
                None => Arc::new(base),
                Some([length_crowning, profile_crowning, bias]) => {
                    let amounts = EaseOffAmounts { length_crowning, profile_crowning, bias };
                    Arc::new(Modified::new(base, Arc::new(EaseOff::of_bevel(amounts, &gear)?)))
                }
            };
            let heights = HeightLimits::Constant(gear.heights());
            Ok(ActiveFlank { surface, heights, face: gear.face(), kink: None })
        };
        let lead = CurveOnCone { cone_angle: gear.root_angle(), line: gear.line().clone() };
        Ok((active(wanted)?, active(other)?, lead, Body::Bevel(gear)))
    }
}
