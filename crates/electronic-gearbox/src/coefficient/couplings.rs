//! The couplings of continuous generating with a worm: how much the workpiece turns for each of the leading axes
//! (`docs/mathematics/gearbox.md#couplings`).

use core::f64::consts::{FRAC_PI_2, PI};

use super::GearGeometry;
use super::gear::require;
use crate::Error;
use crate::Sign;

/// Turn of the workpiece relative to the worm: they turn against each other in the chain of K_R.
const CHAIN: f64 = -1.0;

/// Mounting of each leading axis: `Minus` where it counts the other way round, or moves the other body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CouplingSigns {
    /// sigma_B: rotation of the worm.
    pub worm_turn: Sign,
    /// sigma_Z: axial feed.
    pub feed: Sign,
    /// sigma_V: shift of the worm.
    pub shift: Sign,
}

/// Rotation of the workpiece for each leading axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Couplings {
    /// dC/dB, degrees of the workpiece a degree of the worm.
    pub worm_turn: f64,
    /// dC/dZ, degrees a mm of axial feed; 0 for a spur gear.
    pub feed: f64,
    /// dC/dV, degrees a mm of shift.
    pub shift: f64,
}

impl Couplings {
    /// For a workpiece and a worm of the same normal module with `worm_starts` threads (z_1) and the helix angle `worm_helix_angle_rad`
    /// (beta_1, positive: right-handed).
    ///
    /// # Errors
    /// [`Error::BadGear`] for a worm without threads or with |beta_1| >= pi/2, [`Error::BadParameter`] for an angle that is not finite.
    pub fn new(
        workpiece: &GearGeometry,
        worm_starts: u32,
        worm_helix_angle_rad: f64,
        signs: CouplingSigns,
    ) -> Result<Self, Error> {
        let starts = f64::from(worm_starts);
        require("starts of the worm", starts, "at least 1", |starts| starts >= 1.0)?;
        require(
            "helix angle of the worm",
            worm_helix_angle_rad,
            "between -pi/2 and pi/2 rad, exclusive",
            |angle| angle.abs() < FRAC_PI_2,
        )?;
        // Teeth with their sign: an internal gear turns the other way round for rotation and shift, not for the feed.
        let teeth = f64::from(workpiece.teeth());
        let worm_lead_angle =
            360.0 * libm::sin(worm_helix_angle_rad) / (PI * workpiece.normal_module() * teeth);
        Ok(Self {
            worm_turn: signs.worm_turn.as_f64() * CHAIN * starts / teeth,
            feed: signs.feed.as_f64() * 360.0 * workpiece.turns_per_millimetre(),
            shift: signs.shift.as_f64() * -CHAIN * worm_lead_angle,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{CouplingSigns, Couplings, GearGeometry, Sign};
    use crate::Error;

    fn couplings(teeth: i32, signs: CouplingSigns) -> Couplings {
        let workpiece = GearGeometry::new(2.0, teeth, 0.25, 0.35).unwrap();
        Couplings::new(&workpiece, 3, 1.4, signs).unwrap()
    }

    #[test]
    fn an_internal_gear_turns_rotation_and_shift_round() {
        let external = couplings(40, CouplingSigns::default());
        let internal = couplings(-40, CouplingSigns::default());
        assert_eq!(internal.worm_turn, -external.worm_turn);
        assert_eq!(internal.feed, external.feed);
        assert_eq!(internal.shift, -external.shift);
        assert!(external.worm_turn < 0.0 && external.feed > 0.0 && external.shift > 0.0);
    }

    #[test]
    fn every_term_has_a_sign_of_its_own() {
        let plain = couplings(40, CouplingSigns::default());
        let feed = couplings(40, CouplingSigns { feed: Sign::Minus, ..CouplingSigns::default() });
        assert_eq!(feed, Couplings { feed: -plain.feed, ..plain });
        let turn = couplings(40, CouplingSigns { worm_turn: Sign::Minus, ..CouplingSigns::default() });
        assert_eq!(turn, Couplings { worm_turn: -plain.worm_turn, ..plain });
        let shift = couplings(40, CouplingSigns { shift: Sign::Minus, ..CouplingSigns::default() });
        assert_eq!(shift, Couplings { shift: -plain.shift, ..plain });
    }

    #[test]
    fn the_numbers_found_by_brute_force_come_out() {
        // `docs/mathematics/gearbox.md#couplings`: z_1 = 3, beta_1 = 70 deg, z_2 = 40, beta_2 = 15 deg; feed and shift printed there in rad
        // a mm.
        let workpiece = GearGeometry::new(2.0, 40, 15f64.to_radians(), 0.35).unwrap();
        let found = Couplings::new(&workpiece, 3, 70f64.to_radians(), CouplingSigns::default()).unwrap();
        assert!((found.worm_turn + 0.075).abs() < 1e-15);
        assert!((found.feed.to_radians() - 0.006_470_476).abs() < 5e-10);
        assert!((found.shift.to_radians() - 0.023_492_316).abs() < 5e-10);
    }

    #[test]
    fn worms_that_are_none_are_refused() {
        let workpiece = GearGeometry::new(2.0, 40, 0.25, 0.35).unwrap();
        let of = |starts, angle| Couplings::new(&workpiece, starts, angle, CouplingSigns::default());
        assert!(matches!(of(0, 1.4), Err(Error::BadGear { name: "starts of the worm", .. })));
        assert!(matches!(of(1, 1.6), Err(Error::BadGear { name: "helix angle of the worm", .. })));
        assert!(matches!(of(1, f64::NAN), Err(Error::BadParameter { .. })));
    }
}
