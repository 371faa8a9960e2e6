//! The root of the gear, ground by the worm's tip: what tip radius the head of the dresser must leave along the worm, and what the
//! rounded edge of the tip leaves between root and flank (`docs/mathematics/dressing.md#conditions`). Cylinders only. Knows no dresser.

use super::{GearRootChoice, GeneratingError, GrindingSetup};
use contact::{RootFillet, TipCorner};
use foundation::geometry::Flank;
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use foundation::numerics::{Chebyshev, equidistant};

/// Tip radius over the worm's z.
#[derive(Clone, Debug)]
pub struct WormTip {
    radius: f64,
    /// The centre distance over the feed, and the feed at which the worm's z faces the gear: (-z - origin)/slope.
    following: Option<(MotionLaw, f64, f64)>,
}

/// Nodes of the tip radius over the worm.
const NODES: usize = 33;

impl WormTip {
    /// Of a motion: a cylinder, or what keeps the root of the gear a cylinder.
    ///
    /// # Errors
    /// [`GeneratingError::RootNeedsShift`] where the root shall stay although one place of the worm grinds all of it.
    pub fn new(setup: &GrindingSetup, motion: &GeneratingMotion) -> Result<Self, GeneratingError> {
        let radius = setup.worm_tip_radius;
        let constant = setup.input.gear_root.is_some_and(|root| root.constant);
        if !constant || motion.delta_d.is_constant() {
            let offset = if constant { motion.delta_d.value(0.0) } else { 0.0 };
            return Ok(Self { radius: radius + offset, following: None });
        }
        let [origin, slope, _] = motion.shift.jet(0.0);
        if !motion.shift.is_affine() || slope == 0.0 {
            return Err(GeneratingError::RootNeedsShift { ratio: slope });
        }
        Ok(Self { radius, following: Some((motion.delta_d.clone(), origin, slope)) })
    }

    /// Tip radius at the worm's z, mm.
    pub fn radius(&self, z: f64) -> f64 {
        let follow = |(law, origin, slope): &(MotionLaw, f64, f64)| law.value((-z - origin) / slope);
        self.radius + self.following.as_ref().map_or(0.0, follow)
    }

    /// The same as a law over z, good from `range[0]` to `range[1]`.
    pub fn law(&self, range: [f64; 2]) -> MotionLaw {
        match &self.following {
            None => MotionLaw::polynomial(0.0, vec![self.radius]),
            Some(_) => {
                let values: Vec<f64> =
                    Chebyshev::nodes(range[0], range[1], NODES).into_iter().map(|z| self.radius(z)).collect();
                MotionLaw::series(Chebyshev::interpolate(range[0], range[1], &values))
            }
        }
    }
}

/// The ground root of one flank.
#[derive(Clone, Debug)]
pub struct GroundRoot {
    /// Fillets over the evaluated face.
    pub fillets: Vec<RootFillet>,
    /// Tip radius of the worm over its z.
    pub tip: MotionLaw,
}

/// Sections of the face in which the fillet is looked at.
const SECTIONS: usize = 5;
/// A fillet that rises by more on its way to the root has a notch, mm.
const NOTCH: f64 = 1e-3;
/// Largest angle between flank and fillet that counts as a tangential transition, rad.
const TANGENTIAL: f64 = 1e-4;

impl GroundRoot {
    /// Of one flank under a motion whose worm occupies `occupation` along its z, mm.
    ///
    /// # Errors
    /// [`GeneratingError::RootNeedsShift`]; those of [`TipCorner`]; [`GeneratingError::RootNotched`],
    /// [`GeneratingError::RootReachesFlank`], [`GeneratingError::RootTooSharp`].
    pub fn new(
        setup: &GrindingSetup,
        choice: &GearRootChoice,
        motion: &GeneratingMotion,
        flank: Flank,
        occupation: [f64; 2],
    ) -> Result<Self, GeneratingError> {
        let margin = 2.0 * choice.corner_radius + setup.worm_module();
        let tip = WormTip::new(setup, motion)?.law([occupation[0] - margin, occupation[1] + margin]);
        let corner = TipCorner::new(*setup.pair.worm.flank(flank), choice.corner_radius, tip.clone())?;
        let work = setup.pair.work.flank(flank);
        let [_, _, from, to] = setup.input.evaluation;
        let fillets = equidistant([from, to], SECTIONS)
            .into_iter()
            .map(|z| corner.fillet(motion, work, z))
            .collect::<Result<Vec<_>, _>>()?;
        let form = 0.5 * setup.input.blank.form_diameter;
        for fillet in &fillets {
            if fillet.rise() > NOTCH || fillet.transition() > TANGENTIAL {
                return Err(GeneratingError::RootNotched { flank, z: fillet.z });
            }
            if fillet.form_radius() > form {
                return Err(GeneratingError::RootReachesFlank {
                    flank,
                    ground: 2.0 * fillet.form_radius(),
                    form: 2.0 * form,
                });
            }
            let least = fillet.least_radius_of_curvature();
            if let Some(wanted) = choice.least_fillet_radius.filter(|&wanted| least < wanted) {
                return Err(GeneratingError::RootTooSharp { flank, least, wanted });
            }
        }
        Ok(Self { fillets, tip })
    }
}
