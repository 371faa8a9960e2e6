//! Tolerances of ISO 1328-1:2013 (`docs/mathematics/inspection.md#tolerances`). The formulas count in um, as the standard does; values here
//! are mm.

use super::InspectionError;
use super::rounding::round_tolerance;

/// A quantity with a tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ToleranceQuantity {
    /// fp: single pitch deviation.
    SinglePitch,
    /// Fp: total cumulative pitch deviation.
    TotalPitch,
    /// fHa: profile slope deviation.
    ProfileSlope,
    /// ffa: profile form deviation.
    ProfileForm,
    /// Fa: total profile deviation.
    ProfileTotal,
    /// fHb: helix slope deviation.
    HelixSlope,
    /// ffb: helix form deviation.
    HelixForm,
    /// Fb: total helix deviation.
    HelixTotal,
    /// Fr: run-out.
    RunOut,
    /// fu: difference of neighbouring pitches; informative, not verified against the text of the standard.
    NeighbouringPitch,
    /// Fpz/8: cumulative pitch over an eighth; informative, not verified against the text of the standard.
    SectorPitch,
}

/// Accuracy classes of the standard.
pub const CLASSES: std::ops::RangeInclusive<i32> = 1..=11;

/// What tolerances depend on. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToleranceGear {
    /// Number of teeth without sign.
    pub teeth: u32,
    /// m_n, mm.
    pub normal_module: f64,
    /// d: reference diameter, mm.
    pub reference_diameter: f64,
    /// b: face width, mm.
    pub face_width: f64,
    /// beta, rad, of either hand.
    pub helix_angle: f64,
}

/// Tolerances of a gear that the standard covers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances {
    /// Of class 5, um, unrounded.
    class_5: [f64; ToleranceQuantity::ALL.len()],
}

impl ToleranceQuantity {
    /// All, pitch first.
    pub const ALL: [Self; 11] = [
        Self::SinglePitch,
        Self::TotalPitch,
        Self::ProfileSlope,
        Self::ProfileForm,
        Self::ProfileTotal,
        Self::HelixSlope,
        Self::HelixForm,
        Self::HelixTotal,
        Self::RunOut,
        Self::NeighbouringPitch,
        Self::SectorPitch,
    ];

    /// Its symbol in plain letters.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::SinglePitch => "fp",
            Self::TotalPitch => "Fp",
            Self::ProfileSlope => "fHa",
            Self::ProfileForm => "ffa",
            Self::ProfileTotal => "Fa",
            Self::HelixSlope => "fHb",
            Self::HelixForm => "ffb",
            Self::HelixTotal => "Fb",
            Self::RunOut => "Fr",
            Self::NeighbouringPitch => "fu",
            Self::SectorPitch => "Fpz8",
        }
    }

    /// Whether the formula is informative only and not verified against the text of the standard.
    pub fn is_informative(self) -> bool {
        matches!(self, Self::NeighbouringPitch | Self::SectorPitch)
    }
}

impl Tolerances {
    /// Of a gear.
    ///
    /// # Errors
    /// [`InspectionError::OutOfStandardRange`]: nothing is extrapolated.
    pub fn new(gear: &ToleranceGear) -> Result<Self, InspectionError> {
        in_range("number of teeth", f64::from(gear.teeth), [5.0, 1000.0])?;
        in_range("reference diameter, mm", gear.reference_diameter, [5.0, 15_000.0])?;
        in_range("normal module, mm", gear.normal_module, [0.5, 70.0])?;
        in_range("face width, mm", gear.face_width, [4.0, 1200.0])?;
        // 45 degrees through radians and back may miss 45 by the last digit.
        in_range("helix angle, deg", (gear.helix_angle.abs().to_degrees() * 1e9).round() / 1e9, [0.0, 45.0])?;
        let (d, m, b) = (gear.reference_diameter, gear.normal_module, gear.face_width);
        let single_pitch = 0.001 * d + 0.4 * m + 5.0;
        let total_pitch = 0.002 * d + 0.55 * d.sqrt() + 0.7 * m + 12.0;
        let profile_slope = 0.4 * m + 0.001 * d + 4.0;
        let profile_form = 0.55 * m + 5.0;
        let helix_slope = 0.05 * d.sqrt() + 0.35 * b.sqrt() + 4.0;
        let helix_form = 0.07 * d.sqrt() + 0.45 * b.sqrt() + 4.0;
        let of = |quantity| match quantity {
            ToleranceQuantity::SinglePitch => single_pitch,
            ToleranceQuantity::TotalPitch => total_pitch,
            ToleranceQuantity::ProfileSlope => profile_slope,
            ToleranceQuantity::ProfileForm => profile_form,
            ToleranceQuantity::ProfileTotal => profile_slope.hypot(profile_form),
            ToleranceQuantity::HelixSlope => helix_slope,
            ToleranceQuantity::HelixForm => helix_form,
            ToleranceQuantity::HelixTotal => helix_slope.hypot(helix_form),
            ToleranceQuantity::RunOut => 0.9 * total_pitch,
            ToleranceQuantity::NeighbouringPitch => std::f64::consts::SQRT_2 * single_pitch,
            ToleranceQuantity::SectorPitch => (single_pitch + total_pitch) / 2.0,
        };
        Ok(Self { class_5: ToleranceQuantity::ALL.map(of) })
    }

    /// Unrounded tolerance of a class, mm.
    ///
    /// # Errors
    /// [`InspectionError::OutOfStandardRange`] for a class outside 1 to 11.
    pub fn unrounded(&self, quantity: ToleranceQuantity, class: i32) -> Result<f64, InspectionError> {
        Ok(self.um(quantity, class)? * 1e-3)
    }

    /// Tolerance of a class rounded as the standard states it, mm.
    ///
    /// # Errors
    /// [`InspectionError::OutOfStandardRange`] for a class outside 1 to 11.
    pub fn rounded(&self, quantity: ToleranceQuantity, class: i32) -> Result<f64, InspectionError> {
        Ok(round_tolerance(self.um(quantity, class)?) * 1e-3)
    }

    fn um(&self, quantity: ToleranceQuantity, class: i32) -> Result<f64, InspectionError> {
        in_range("tolerance class", f64::from(class), [*CLASSES.start(), *CLASSES.end()].map(f64::from))?;
        Ok(self.class_5[quantity as usize] * 2f64.powf(f64::from(class - 5) / 2.0))
    }
}

fn in_range(name: &'static str, value: f64, ends: [f64; 2]) -> Result<(), InspectionError> {
    in_range_of("ISO 1328-1", name, value, ends)
}

/// Refuses what a standard does not cover.
///
/// # Errors
/// [`InspectionError::OutOfStandardRange`].
pub(super) fn in_range_of(
    standard: &'static str,
    name: &'static str,
    value: f64,
    [from, to]: [f64; 2],
) -> Result<(), InspectionError> {
    if (from..=to).contains(&value) {
        Ok(())
    } else {
        Err(InspectionError::OutOfStandardRange { standard, name, value, from, to })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GEAR: ToleranceGear = ToleranceGear {
        teeth: 33,
        normal_module: 3.0,
        reference_diameter: 100.0,
        face_width: 30.0,
        helix_angle: 0.0,
    };

    #[test]
    fn tolerances_are_those_of_printed_tables() {
        let of = Tolerances::new(&GEAR).unwrap();
        let rounded = |class| ToleranceQuantity::ALL.map(|q| of.rounded(q, class).unwrap() * 1e3);
        let tables = [
            (5, [6.5, 20.0, 5.5, 6.5, 8.5, 6.5, 7.0, 9.5, 18.0, 9.0, 13.0]),
            (6, [9.0, 28.0, 7.5, 9.5, 12.0, 9.0, 10.0, 14.0, 25.0, 13.0, 18.0]),
        ];
        for (class, want) in tables {
            for (got, want) in rounded(class).iter().zip(want) {
                assert!((got - want).abs() < 1e-9, "class {class}: {got} {want}");
            }
        }
        let symbols = ToleranceQuantity::ALL.map(ToleranceQuantity::symbol);
        assert!((0..11).all(|k| symbols.iter().filter(|s| **s == symbols[k]).count() == 1));
        assert!((0..11).all(|k| ToleranceQuantity::ALL[k] as usize == k));
    }

    #[test]
    fn the_limits_of_the_standard_belong_to_it() {
        let least = ToleranceGear {
            teeth: 5,
            normal_module: 0.5,
            reference_diameter: 5.0,
            face_width: 4.0,
            helix_angle: -45f64.to_radians(),
        };
        let greatest = ToleranceGear {
            teeth: 1000,
            normal_module: 70.0,
            reference_diameter: 15_000.0,
            face_width: 1200.0,
            helix_angle: 45f64.to_radians(),
        };
        for gear in [least, greatest] {
            assert!(Tolerances::new(&gear).is_ok(), "{gear:?}");
        }
        let beyond = [
            ToleranceGear { teeth: 4, ..GEAR },
            ToleranceGear { teeth: 1001, ..GEAR },
            ToleranceGear { normal_module: 0.49, ..GEAR },
            ToleranceGear { normal_module: f64::NAN, ..GEAR },
            ToleranceGear { reference_diameter: 15_000.1, ..GEAR },
            ToleranceGear { face_width: 3.9, ..GEAR },
            ToleranceGear { helix_angle: 45.001f64.to_radians(), ..GEAR },
        ];
        for gear in beyond {
            assert_eq!(Tolerances::new(&gear).unwrap_err().code(), "out-of-standard-range", "{gear:?}");
        }
        let of = Tolerances::new(&GEAR).unwrap();
        for class in [0, 12, i32::MIN] {
            let error = of.rounded(ToleranceQuantity::RunOut, class).unwrap_err();
            assert_eq!(error.code(), "out-of-standard-range");
        }
    }
}
