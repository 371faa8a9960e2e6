//! Scale, clock, interpolation and encoder of a gearbox, as the job gives or offers them, and how they couple the workpiece to the
//! slide.

use crate::job::GearboxWorkpiece;
use control::{Interpolation, Rotation};
use electronic_gearbox::coefficient::{Coefficient, GearGeometry};
use electronic_gearbox::{Error as GearboxError, Sign};
use job::control::ScaleInterpolation;
use run::RunFailure;
use run::control::{interpolation, rotation};

/// What a gearbox is set up with.
#[derive(Clone, Copy, Debug)]
pub struct SetUp {
    /// Scale of the slide, clock and interpolation.
    pub feed: ScaleInterpolation,
    /// Encoder of the workpiece, and its sense.
    pub workpiece: GearboxWorkpiece,
}

impl SetUp {
    /// Sense in which the workpiece turns over the feed: -1 where the machine counts the other way.
    pub fn sense(&self) -> Sign {
        if self.workpiece.reversed { Sign::Minus } else { Sign::Plus }
    }

    /// The interpolator of the slide.
    ///
    /// # Errors
    /// [`RunFailure`] on `feed`.
    pub fn interpolation(&self) -> Result<Interpolation, RunFailure> {
        interpolation(&self.feed, "")
    }

    /// How pulses of this interpolator turn the workpiece.
    ///
    /// # Errors
    /// The gearbox's own: a coefficient beyond the rate multiplier, a ratio beyond the accumulator.
    pub fn rotation(
        &self,
        gear: &GearGeometry,
        interpolation: &Interpolation,
    ) -> Result<Rotation, GearboxError> {
        let (workpiece, sense) = (&self.workpiece, self.sense());
        let turns_per_millimetre = gear.turns_per_millimetre() * sense.as_f64();
        rotation(workpiece.encoder(), turns_per_millimetre, interpolation, || {
            Coefficient::new(gear, workpiece.pulses_per_revolution, 1e3 / interpolation.pitch, sense)
        })
    }
}
