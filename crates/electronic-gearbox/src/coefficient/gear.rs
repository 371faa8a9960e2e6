//! A gear as the couplings see it: module, teeth, helix, pressure angle.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::Error;

/// Gear data, checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GearGeometry {
    normal_module: f64,
    teeth: i32,
    helix_angle: f64,
    normal_pressure_angle: f64,
}

impl GearGeometry {
    /// Normal module in mm, teeth (negative: internal gear), helix angle in rad (positive: right-handed, 0: spur gear), normal pressure
    /// angle in rad.
    ///
    /// # Errors
    /// [`Error::BadParameter`] for a value that is not finite; [`Error::BadGear`] for m_n <= 0, z = 0, |beta| >= pi/2, alpha_n outside
    /// (0, pi/2), and for a module with which the factors leave the range of numbers (`docs/mathematics/gearbox.md#limits`).
    pub fn new(
        normal_module_mm: f64,
        teeth: i32,
        helix_angle_rad: f64,
        normal_pressure_angle_rad: f64,
    ) -> Result<Self, Error> {
        let gear = Self {
            normal_module: normal_module_mm,
            teeth,
            helix_angle: helix_angle_rad,
            normal_pressure_angle: normal_pressure_angle_rad,
        };
        // The limits keep every factor below within the range of numbers, for any number of pulses of 32 bits.
        require("normal module", normal_module_mm, "above 0 mm", |module| {
            module > 0.0 && (1e3 * PI * gear.teeth_abs() * module).is_finite() && (1e16 / module).is_finite()
        })?;
        require("number of teeth", f64::from(teeth), "not 0", |teeth| teeth != 0.0)?;
        require("helix angle", helix_angle_rad, "between -pi/2 and pi/2 rad, exclusive", |angle| {
            angle.abs() < FRAC_PI_2
        })?;
        require(
            "normal pressure angle",
            normal_pressure_angle_rad,
            "between 0 and pi/2 rad, exclusive",
            |angle| 0.0 < angle && angle < FRAC_PI_2,
        )?;
        Ok(gear)
    }

    /// m_n, mm.
    pub const fn normal_module(&self) -> f64 {
        self.normal_module
    }

    /// z, negative for an internal gear.
    pub const fn teeth(&self) -> i32 {
        self.teeth
    }

    /// beta, rad.
    pub const fn helix_angle(&self) -> f64 {
        self.helix_angle
    }

    /// Lead p_z in mm a turn, positive for right-hand teeth, of internal gears too.
    ///
    /// # Errors
    /// [`Error::SpurGear`] for beta = 0, and for a helix so slight that its lead is beyond the range of numbers.
    pub fn lead(&self) -> Result<f64, Error> {
        let lead = PI * self.normal_module * self.teeth_abs() / libm::sin(self.helix_angle);
        if lead.is_finite() { Ok(lead) } else { Err(Error::SpurGear) }
    }

    /// 1/p_z in turns a mm; 0 for a spur gear.
    pub fn turns_per_millimetre(&self) -> f64 {
        libm::sin(self.helix_angle) / (PI * self.normal_module * self.teeth_abs())
    }

    /// s_rot: movement of the flank along its normal for a rotation of the gear, um/rad.
    pub fn flank_per_angle(&self) -> f64 {
        1e3 * self.normal_module * self.teeth_abs() * libm::cos(self.normal_pressure_angle) / 2.0
    }

    /// s_ax: movement of the flank along its normal for an axial displacement, um/um.
    pub fn flank_per_axial(&self) -> f64 {
        libm::sin(self.helix_angle).abs() * libm::cos(self.normal_pressure_angle)
    }

    /// Movement of the flank along its normal for one of `pulses_per_revolution` pulses of the workpiece, um.
    ///
    /// # Errors
    /// [`Error::BadParameter`] for no pulses.
    pub fn flank_per_work_pulse(&self, pulses_per_revolution: u32) -> Result<f64, Error> {
        Ok(self.flank_per_angle() * TAU / pulses(pulses_per_revolution)?)
    }

    fn teeth_abs(&self) -> f64 {
        f64::from(self.teeth.unsigned_abs())
    }
}

/// Pulses per revolution as a number to divide by.
pub(super) fn pulses(per_revolution: u32) -> Result<f64, Error> {
    if per_revolution == 0 {
        return Err(Error::BadParameter { name: "pulses per revolution", value: 0.0, allowed: "at least 1" });
    }
    Ok(f64::from(per_revolution))
}

/// Gear data must be finite and pass `is_good`.
pub(super) fn require(
    name: &'static str,
    value: f64,
    allowed: &'static str,
    is_good: impl Fn(f64) -> bool,
) -> Result<(), Error> {
    match (value.is_finite(), is_good(value)) {
        (false, _) => Err(Error::BadParameter { name, value, allowed }),
        (true, false) => Err(Error::BadGear { name, value, allowed }),
        (true, true) => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::{FRAC_PI_2, GearGeometry, PI, TAU};
    use crate::Error;

    const ALPHA: f64 = 0.35;

    #[test]
    fn gear_data_that_describe_no_gear_are_named() {
        let name = |gear: Result<GearGeometry, Error>| match gear {
            Err(Error::BadGear { name, .. }) => name,
            other => panic!("{other:?}"),
        };
        assert_eq!(name(GearGeometry::new(0.0, 40, 0.3, ALPHA)), "normal module");
        assert_eq!(name(GearGeometry::new(-2.0, 40, 0.3, ALPHA)), "normal module");
        assert_eq!(name(GearGeometry::new(f64::MAX, 40, 0.3, ALPHA)), "normal module");
        assert_eq!(name(GearGeometry::new(1e-300, 40, 0.3, ALPHA)), "normal module");
        assert_eq!(name(GearGeometry::new(2.0, 0, 0.3, ALPHA)), "number of teeth");
        assert_eq!(name(GearGeometry::new(2.0, 40, FRAC_PI_2, ALPHA)), "helix angle");
        assert_eq!(name(GearGeometry::new(2.0, 40, -1.6, ALPHA)), "helix angle");
        assert_eq!(name(GearGeometry::new(2.0, 40, 0.3, 0.0)), "normal pressure angle");
        assert_eq!(name(GearGeometry::new(2.0, 40, 0.3, FRAC_PI_2)), "normal pressure angle");
    }

    #[test]
    fn values_that_are_no_numbers_are_named() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for gear in [
                GearGeometry::new(bad, 40, 0.3, ALPHA),
                GearGeometry::new(2.0, 40, bad, ALPHA),
                GearGeometry::new(2.0, 40, 0.3, bad),
            ] {
                assert!(matches!(gear, Err(Error::BadParameter { .. })), "{gear:?}");
            }
        }
    }

    #[test]
    fn a_spur_gear_has_no_lead_and_no_axial_factor() {
        let spur = GearGeometry::new(2.0, 40, 0.0, ALPHA).unwrap();
        assert_eq!(spur.lead(), Err(Error::SpurGear));
        assert_eq!(spur.turns_per_millimetre(), 0.0);
        assert_eq!(spur.flank_per_axial(), 0.0);
        let almost = GearGeometry::new(2.0, 40, -1e-308, ALPHA).unwrap();
        assert_eq!(almost.lead(), Err(Error::SpurGear));
    }

    #[test]
    fn lead_has_the_sign_of_the_hand() {
        // Rotation over the feed in rad/mm as found on the helicoids themselves (`docs/mathematics/gearbox.md#couplings`).
        const ROTATION: f64 = 0.006470476;
        for teeth in [40, -40] {
            for sign in [1.0, -1.0] {
                let lead = GearGeometry::new(2.0, teeth, sign * PI / 12.0, ALPHA).unwrap().lead().unwrap();
                assert!((lead * ROTATION - sign * TAU).abs() < 1e-6, "{lead}");
            }
        }
    }

    #[test]
    fn an_internal_gear_keeps_the_sign_of_its_lead() {
        let external = GearGeometry::new(2.0, 40, 0.3, ALPHA).unwrap();
        let internal = GearGeometry::new(2.0, -40, 0.3, ALPHA).unwrap();
        assert_eq!(external.lead(), internal.lead());
        assert_eq!(external.flank_per_angle(), internal.flank_per_angle());
        assert!(external.lead().unwrap() > 0.0);
        assert!((external.lead().unwrap() * external.turns_per_millimetre() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn no_pulses_are_refused() {
        let gear = GearGeometry::new(2.0, 40, 0.3, ALPHA).unwrap();
        assert!(matches!(gear.flank_per_work_pulse(0), Err(Error::BadParameter { .. })));
    }
}
