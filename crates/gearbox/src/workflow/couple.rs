//! Entries of a job of the electronic gearbox as gear, interpolator, coupling and servo; what these refuse, as findings on the keys
//! of the job.

use crate::job::{GearboxGear, GearboxWorkpiece, Move as JobMove, Stimulus};
use control::{ControlError, Interpolation, Move, Rotation, SlideMotion, StrokeError};
use electronic_gearbox::coefficient::{Coefficient, GearGeometry};
use electronic_gearbox::{Error as GearboxError, Sign};
use job::control::Servo;
use run::RunFailure;
use run::control::{of_scale, of_servo, on_field, rotation};

/// The workpiece as the coupling sees it.
///
/// # Errors
/// [`RunFailure`] on `gear`.
pub(super) fn geometry(gear: &GearboxGear) -> Result<GearGeometry, RunFailure> {
    GearGeometry::new(
        gear.normal_module,
        gear.teeth,
        gear.helix_angle_deg.to_radians(),
        gear.normal_pressure_angle_deg.to_radians(),
    )
    .map_err(|error| on_field(&error, "gear"))
}

/// Sense in which the workpiece turns over the feed: -1 where the machine counts the other way.
pub(super) fn sense(workpiece: &GearboxWorkpiece) -> Sign {
    if workpiece.reversed { Sign::Minus } else { Sign::Plus }
}

/// How pulses of the slide turn the workpiece.
///
/// # Errors
/// The gearbox's own: a coefficient beyond the rate multiplier, a ratio beyond the accumulator.
pub(super) fn coupling(
    gear: &GearGeometry,
    workpiece: &GearboxWorkpiece,
    interpolation: &Interpolation,
) -> Result<Rotation, GearboxError> {
    let sense = sense(workpiece);
    let turns_per_millimetre = gear.turns_per_millimetre() * sense.as_f64();
    rotation(workpiece.encoder(), turns_per_millimetre, interpolation, || {
        Coefficient::new(gear, workpiece.pulses_per_revolution, 1e3 / interpolation.pitch, sense)
    })
}

/// The motion of a stimulus without its rest; `None` for a train of pulses.
///
/// # Errors
/// [`RunFailure`] on `stimulus.motion`.
pub(super) fn slide_motion(stimulus: &Stimulus) -> Result<Option<SlideMotion>, RunFailure> {
    let Some(moves) = &stimulus.motion else { return Ok(None) };
    let moves: Vec<Move> = moves
        .iter()
        .map(|step| match step {
            JobMove::Travel(travel) => Move::To {
                position: travel.to,
                speed: travel.speed_mm_per_min / 60.0,
                acceleration: travel.acceleration_mm_per_s2,
            },
            JobMove::Dwell(dwell) => Move::Rest { duration: dwell.dwell_s },
        })
        .collect();
    SlideMotion::of_moves(stimulus.start_or_default(), &moves).map(Some).map_err(|error| of_feed(&error))
}

/// What a scale or a slide refuses.
pub(super) fn of_feed(error: &ControlError) -> RunFailure {
    of_scale(error, "", "stimulus.motion")
}

/// What a simulation of the servo refuses.
pub(super) fn of_following(error: &StrokeError, servo: &Servo) -> RunFailure {
    match error {
        StrokeError::Control(error) => of_servo(error, servo, ""),
        StrokeError::Gearbox(error) => on_field(error, "worm"),
    }
}
