//! The electronic gearbox in the terms of a machine's own axes (`docs/mathematics/generating-contact.md#coupling-of-the-rotations`).

use super::{Machine, MachineError, Mounts, Role};
use std::f64::consts::FRAC_PI_2;

/// The couplings of the bodies: dphi_2 = -(z_1/z_2) dphi_1 + (k_V1/z_2) dz_V1 + (k_V2/z_2) dz_V2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GearCoupling {
    /// Threads z_1.
    pub threads: u32,
    /// Teeth z_2; < 0 internal.
    pub teeth: i32,
    /// k_V1, rad/mm of tool shift.
    pub shift: f64,
    /// k_V2, rad/mm of feed.
    pub feed: f64,
    /// Crossed-axes angle gamma, rad.
    pub crossed_axes_angle: f64,
}

/// Rates of the work axis with the axes that lead it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CouplingRates {
    /// Numerator of d(work)/d(worm): threads with their sign.
    pub worm_numerator: i32,
    /// Its denominator: |teeth|.
    pub worm_denominator: u32,
    /// d(work)/d(axial), rad/mm.
    pub axial: f64,
    /// d(work)/d(shift or tangential), rad/mm.
    pub shift: f64,
    /// Tilt at which they hold, rad.
    pub tilt: f64,
}

impl CouplingRates {
    /// d(work)/d(worm), rad/rad.
    pub fn worm(&self) -> f64 {
        f64::from(self.worm_numerator) / f64::from(self.worm_denominator)
    }
}

impl Machine {
    /// Rates of the work axis, exact for a constant tilt.
    ///
    /// # Errors
    /// [`MachineError::MissingAxis`]; [`MachineError::Singular`] for a tangential slide across which the head stands.
    pub fn gearbox(&self, coupling: &GearCoupling, mounts: &Mounts) -> Result<CouplingRates, MachineError> {
        let [worm, work, axial] = [Role::Worm, Role::Work, Role::Axial].map(|role| self.needed(role));
        let (worm, work, axial) = (worm?, work?, axial?);
        // The closed form speaks of axes along the spindles of the zero position; a machine may count the other way.
        let along_tool = self.tool().z;
        let along_work = self.station(super::Station::Work)?.z;
        let sign = |axis: usize, canonical: nalgebra::Vector3<f64>| {
            self.axes()[axis].direction.dot(&canonical).signum()
        };
        let (s_worm, s_work, s_axial) =
            (sign(worm, along_tool), sign(work, along_work), sign(axial, along_work));
        let (r_1, r_2) = (mounts.tool.sense(), mounts.counterpart.sense());
        let teeth = f64::from(coupling.teeth);
        let tilt = r_1 * r_2 * FRAC_PI_2 - coupling.crossed_axes_angle;
        let (by_shift, by_feed) = (r_1 * r_2 * coupling.shift / teeth, coupling.feed / teeth);
        let shift = match (self.role(Role::Shift), self.role(Role::Tangential)) {
            (Some(axis), _) => by_shift * sign(axis, along_tool) * s_work,
            (None, Some(axis)) => {
                let cos = tilt.cos();
                if cos.abs() < 1e-9 {
                    return Err(MachineError::Singular {
                        axes: self.names(&[axis, axial]),
                        measure: cos.abs(),
                    });
                }
                (by_shift / cos + by_feed * tilt.tan()) * sign(axis, along_tool) * s_work
            }
            (None, None) => return Err(self.missing(Role::Shift.key())),
        };
        let sense = -r_1 * r_2 * s_worm * s_work * teeth.signum();
        let tilt =
            self.role(Role::Tilt).map_or(tilt, |axis| tilt * sign(axis, along_tool.cross(&along_work)));
        Ok(CouplingRates {
            worm_numerator: if sense < 0.0 { -(coupling.threads as i32) } else { coupling.threads as i32 },
            worm_denominator: coupling.teeth.unsigned_abs(),
            axial: -by_feed * s_axial * s_work,
            shift,
            tilt,
        })
    }
}
