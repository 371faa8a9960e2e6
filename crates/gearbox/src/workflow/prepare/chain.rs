//! What stands between the slide and the workpiece of a job.

use super::set_up::SetUp;
use crate::job::{GearboxGear, GearboxJob};
use control::{Interpolation, Rotation};
use electronic_gearbox::coefficient::GearGeometry;
use run::RunFailure;
use run::control::{on_field, rotation_refused};

/// Gear, interpolator and coupling.
#[derive(Clone, Debug)]
pub struct Chain {
    /// The workpiece.
    pub gear: GearGeometry,
    /// Its normal pressure angle, rad.
    pub pressure_angle: f64,
    /// Its teeth; negative for an internal gear.
    pub teeth: i32,
    /// Scale, clock, interpolation and encoder.
    pub set_up: SetUp,
    /// The interpolator of the slide.
    pub interpolation: Interpolation,
    /// How its pulses turn the workpiece.
    pub rotation: Rotation,
}

impl Chain {
    /// Of a job.
    ///
    /// # Errors
    /// [`RunFailure`]: a gear, scale or coefficient that cannot be.
    pub fn of_job(job: &GearboxJob) -> Result<Self, RunFailure> {
        let gear = geometry(&job.gear)?;
        let set_up = SetUp { feed: job.feed, workpiece: job.workpiece };
        let interpolation = set_up.interpolation()?;
        let rotation = set_up
            .rotation(&gear, &interpolation)
            .map_err(|error| rotation_refused(&error, job.workpiece.encoder(), ""))?;
        Ok(Self {
            gear,
            pressure_angle: job.gear.normal_pressure_angle_deg.to_radians(),
            teeth: job.gear.teeth,
            set_up,
            interpolation,
            rotation,
        })
    }
}

/// The workpiece as the coupling sees it.
fn geometry(gear: &GearboxGear) -> Result<GearGeometry, RunFailure> {
    GearGeometry::new(
        gear.normal_module,
        gear.teeth,
        gear.helix_angle_deg.to_radians(),
        gear.normal_pressure_angle_deg.to_radians(),
    )
    .map_err(|error| on_field(&error, "gear"))
}
