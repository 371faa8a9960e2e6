//! The coefficient of the additional rotation: what share of the scale's pulses turns the workpiece
//! (`docs/mathematics/gearbox.md#couplings`).

use super::gear::{GearGeometry, pulses};
use crate::Error;
use crate::Sign;

/// Places of the rate multiplier's word: B = b 2^18.
const STEPS: f64 = (1 << 18) as f64;

/// b rounds to 2^18 or more from here on, which 18 bits do not hold.
const TOO_LARGE: f64 = 1.0 - 1.0 / (1 << 19) as f64;

/// b = 1000 N_w |sin(beta)| / (pi m_n |z| q), workpiece pulses per reference pulse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficient {
    exact: f64,
    word: u32,
    hand: Sign,
}

impl Coefficient {
    /// For a workpiece of `pulses_per_revolution` (N_w) and a slide with `pulses_per_metre` (q) reference pulses a metre; `machine` is
    /// `Minus` where slide or workpiece count the other way round.
    ///
    /// # Errors
    /// [`Error::CoefficientTooLarge`] from b = 1 - 2^-19 on, with a scale that would just do; [`Error::BadParameter`] for no pulses per
    /// revolution and for a scale that is not positive and finite.
    pub fn new(
        gear: &GearGeometry,
        pulses_per_revolution: u32,
        pulses_per_metre: f64,
        machine: Sign,
    ) -> Result<Self, Error> {
        let per_revolution = pulses(pulses_per_revolution)?;
        if !(pulses_per_metre > 0.0 && pulses_per_metre.is_finite()) {
            return Err(Error::BadParameter {
                name: "reference pulses per metre",
                value: pulses_per_metre,
                allowed: "above 0, finite",
            });
        }
        let per_metre = 1e3 * per_revolution * gear.turns_per_millimetre().abs();
        let exact = per_metre / pulses_per_metre;
        if exact >= TOO_LARGE {
            // The limit itself is excluded: a few roundings more than the quotient.
            let least_pulses_per_metre = per_metre / TOO_LARGE * (1.0 + 4.0 * f64::EPSILON);
            return Err(Error::CoefficientTooLarge { b: exact, least_pulses_per_metre });
        }
        // Below 2^18 after rounding, for b < 1 - 2^-19.
        let word = libm::round(exact * STEPS) as u32;
        Ok(Self { exact, word, hand: Sign::of(gear.helix_angle()).times(machine) })
    }

    /// b before rounding.
    pub const fn exact(&self) -> f64 {
        self.exact
    }

    /// B = round(b 2^18), 18 bits.
    pub const fn word(&self) -> u32 {
        self.word
    }

    /// Position h of the hand switch: hand of the helix times the machine's sign; for a spur gear the machine's sign.
    pub const fn hand(&self) -> Sign {
        self.hand
    }

    /// B/2^18 / b - 1: relative error of the additional rotation. 0 for a spur gear, which has none.
    pub fn relative_error(&self) -> f64 {
        if self.exact == 0.0 {
            return 0.0;
        }
        (f64::from(self.word) - self.exact * STEPS) / (self.exact * STEPS)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{Coefficient, GearGeometry, STEPS, Sign, TOO_LARGE};
    use crate::Error;

    fn gear(helix: f64) -> GearGeometry {
        GearGeometry::new(2.0, 40, helix, 0.35).unwrap()
    }

    #[test]
    fn a_spur_gear_needs_no_additional_rotation() {
        let none = Coefficient::new(&gear(0.0), 36_000, 1e5, Sign::Minus).unwrap();
        assert_eq!((none.exact(), none.word(), none.relative_error()), (0.0, 0, 0.0));
        assert_eq!(none.hand(), Sign::Minus);
    }

    #[test]
    fn the_hand_is_that_of_helix_and_machine() {
        for (helix, machine, hand) in [
            (0.3, Sign::Plus, Sign::Plus),
            (0.3, Sign::Minus, Sign::Minus),
            (-0.3, Sign::Plus, Sign::Minus),
            (-0.3, Sign::Minus, Sign::Plus),
        ] {
            assert_eq!(Coefficient::new(&gear(helix), 36_000, 1e5, machine).unwrap().hand(), hand);
        }
    }

    #[test]
    fn scales_without_pulses_are_refused() {
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let refused = Coefficient::new(&gear(0.3), 36_000, bad, Sign::Plus);
            assert!(matches!(refused, Err(Error::BadParameter { .. })), "{refused:?}");
        }
        let refused = Coefficient::new(&gear(0.3), 0, 1e5, Sign::Plus);
        assert!(matches!(refused, Err(Error::BadParameter { .. })), "{refused:?}");
    }

    proptest! {
        #[test]
        fn a_refusal_names_a_scale_that_just_does(helix in -1.5f64..1.5, pulses in 1u32.., scale in 1.0f64..1e7) {
            prop_assume!(helix.abs() > 1e-6);
            match Coefficient::new(&gear(helix), pulses, scale, Sign::Plus) {
                Ok(fits) => {
                    prop_assert!(fits.exact() < TOO_LARGE && fits.word() < 1 << 18);
                    prop_assert!((f64::from(fits.word()) / STEPS - fits.exact()).abs() <= 0.5 / STEPS);
                }
                Err(Error::CoefficientTooLarge { b, least_pulses_per_metre }) => {
                    prop_assert!(b >= TOO_LARGE && least_pulses_per_metre > scale);
                    let just = Coefficient::new(&gear(helix), pulses, least_pulses_per_metre, Sign::Plus);
                    prop_assert_eq!(just.unwrap().word(), (1 << 18) - 1);
                    let less = least_pulses_per_metre * (1.0 - 1e-14);
                    prop_assert!(Coefficient::new(&gear(helix), pulses, less, Sign::Plus).is_err());
                }
                Err(other) => prop_assert!(false, "{other}"),
            }
        }
    }
}
