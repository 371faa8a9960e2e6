//! Tolerances of ISO 17485:2006 for the pitch and the run-out of bevel gears (`docs/mathematics/inspection.md#bevel-gears`). The formulas
//! count in um, as the standard does; values here are mm and are not rounded. The standard has no tolerances for flank forms.

use super::InspectionError;
use super::error::usable;
use super::tolerances::in_range_of;

/// A quantity with a tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum BevelQuantity {
    /// fp: single pitch deviation.
    SinglePitch,
    /// Fp: total cumulative pitch deviation.
    TotalPitch,
    /// Fr: run-out.
    RunOut,
}

/// Classes of the standard.
pub const BEVEL_CLASSES: std::ops::RangeInclusive<i32> = 2..=11;

/// Class whose tolerances the formulas give; each further one is larger by the square root of 2.
const BASE: i32 = 4;
/// How much a value may exceed its tolerance and still count as equal to it, mm.
const SAME: f64 = 1e-12;

fn in_range(name: &'static str, value: f64, ends: [f64; 2]) -> Result<(), InspectionError> {
    in_range_of("ISO 17485", name, value, ends)
}

/// What tolerances depend on. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BevelToleranceGear {
    /// Number of teeth.
    pub teeth: u32,
    /// m_mn: normal module in the middle of the face, mm.
    pub mean_normal_module: f64,
    /// d_T: diameter in the middle of the face and of the working depth, mm.
    pub tolerance_diameter: f64,
}

/// Tolerances of a bevel gear that the standard covers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BevelTolerances {
    /// Of class 4, um.
    base: [f64; 3],
}

impl BevelQuantity {
    /// All, pitch first.
    pub const ALL: [Self; 3] = [Self::SinglePitch, Self::TotalPitch, Self::RunOut];

    /// Its symbol in plain letters.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::SinglePitch => "fp",
            Self::TotalPitch => "Fp",
            Self::RunOut => "Fr",
        }
    }
}

impl BevelTolerances {
    /// Of a gear.
    ///
    /// # Errors
    /// [`InspectionError::OutOfStandardRange`]: nothing is extrapolated.
    pub fn new(gear: &BevelToleranceGear) -> Result<Self, InspectionError> {
        in_range("number of teeth", f64::from(gear.teeth), [5.0, 400.0])?;
        in_range("tolerance diameter, mm", gear.tolerance_diameter, [5.0, 2500.0])?;
        in_range("mean normal module, mm", gear.mean_normal_module, [1.0, 50.0])?;
        let (d, m) = (gear.tolerance_diameter, gear.mean_normal_module);
        let total = 0.025 * d + 0.3 * m + 19.0;
        Ok(Self { base: [0.003 * d + 0.3 * m + 5.0, total, 0.8 * total] })
    }

    /// Tolerance of a class, mm.
    ///
    /// # Errors
    /// [`InspectionError::OutOfStandardRange`] for a class outside 2 to 11.
    pub fn of(&self, quantity: BevelQuantity, class: i32) -> Result<f64, InspectionError> {
        in_range(
            "tolerance class",
            f64::from(class),
            [*BEVEL_CLASSES.start(), *BEVEL_CLASSES.end()].map(f64::from),
        )?;
        Ok(1e-3 * self.base[quantity as usize] * 2f64.powf(f64::from(class - BASE) / 2.0))
    }

    /// The best class whose tolerance holds the magnitude of a value, mm; `None` if class 11 does not.
    ///
    /// # Errors
    /// [`InspectionError::InvalidNumber`].
    pub fn reached(&self, quantity: BevelQuantity, value: f64) -> Result<Option<i32>, InspectionError> {
        usable("value to be judged", value, true, "a finite deviation")?;
        for class in BEVEL_CLASSES {
            if value.abs() <= self.of(quantity, class)? + SAME {
                return Ok(Some(class));
            }
        }
        Ok(None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_are_those_of_the_formulas_and_double_every_two_classes() {
        let gear = BevelToleranceGear { teeth: 16, mean_normal_module: 4.0, tolerance_diameter: 200.0 };
        let of = BevelTolerances::new(&gear).unwrap();
        // By hand: 0.6 + 1.2 + 5, 5 + 1.2 + 19, 0.8 of that.
        for (quantity, um) in BevelQuantity::ALL.into_iter().zip([6.8, 25.2, 20.16]) {
            assert!((of.of(quantity, 4).unwrap() - 1e-3 * um).abs() < 1e-12, "{quantity:?}");
            assert!((of.of(quantity, 8).unwrap() - 4e-3 * um).abs() < 1e-12);
            assert!((of.of(quantity, 2).unwrap() - 0.5e-3 * um).abs() < 1e-12);
            for class in BEVEL_CLASSES {
                let limit = of.of(quantity, class).unwrap();
                assert_eq!(of.reached(quantity, -limit).unwrap(), Some(class));
                let next = (class < 11).then_some(class + 1);
                assert_eq!(of.reached(quantity, limit + 1e-9).unwrap(), next);
            }
            assert!(of.reached(quantity, f64::NAN).is_err());
        }
        for class in [1, 12] {
            assert_eq!(of.of(BevelQuantity::RunOut, class).unwrap_err().code(), "out-of-standard-range");
        }
    }

    #[test]
    fn nothing_is_extrapolated() {
        let gear = BevelToleranceGear { teeth: 16, mean_normal_module: 4.0, tolerance_diameter: 200.0 };
        for wrong in [
            BevelToleranceGear { teeth: 4, ..gear },
            BevelToleranceGear { mean_normal_module: 0.9, ..gear },
            BevelToleranceGear { tolerance_diameter: 2501.0, ..gear },
            BevelToleranceGear { tolerance_diameter: f64::NAN, ..gear },
        ] {
            assert_eq!(BevelTolerances::new(&wrong).unwrap_err().code(), "out-of-standard-range");
        }
    }
}
