//! Entries of a job of the electronic gearbox as gear, interpolator, coupling and servo; what these refuse, as findings on the keys
//! of the job.

use crate::control::{ControlError, Interpolation, Move, Rotation, RotationRule, SlideMotion, StrokeError};
use crate::exchange::Diagnostic;
use crate::exchange::control::{RotationRate, Servo};
use crate::exchange::gearbox_job::{GearboxGear, GearboxWorkpiece, Move as JobMove, Stimulus};
use crate::workflow::RunFailure;
use crate::workflow::control::{of_scale, of_servo, on_field};
use electronic_gearbox::chain::RateRule;
use electronic_gearbox::coefficient::{Coefficient, GearGeometry};
use electronic_gearbox::{Error as GearboxError, Sign};

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
    let p = f64::from(interpolation.settings.pulses_per_interval());
    let turns_per_millimetre = gear.turns_per_millimetre() * sense(workpiece).as_f64();
    let parts_per_revolution = f64::from(workpiece.pulses_per_revolution) * p;
    let rule = match workpiece.rate {
        RotationRate::Exact => {
            return Rotation::exact(turns_per_millimetre, parts_per_revolution, interpolation.pitch / p);
        }
        RotationRate::Bresenham => RateRule::Bresenham,
        RotationRate::Binary => RateRule::Binary,
    };
    let per_metre = 1e3 / interpolation.pitch;
    let coefficient = Coefficient::new(gear, workpiece.pulses_per_revolution, per_metre, sense(workpiece))?;
    let rule = RotationRule::Multiplier { coefficient, rule };
    Ok(Rotation { rule, turns_per_millimetre, parts_per_revolution })
}

/// What the coupling refuses, on the encoder of the workpiece.
pub(super) fn coupling_refused(error: &GearboxError, workpiece: &GearboxWorkpiece) -> RunFailure {
    let finding = Diagnostic::with_code(error.code(), error.to_string())
        .field("workpiece.pulses_per_revolution")
        .value(workpiece.pulses_per_revolution);
    RunFailure::bad_input(match *error {
        GearboxError::CoefficientTooLarge { b, least_pulses_per_metre } => {
            // The greatest encoder that the scale takes is smaller in the ratio of the coefficients.
            let most = (f64::from(workpiece.pulses_per_revolution) * (1.0 - 2f64.powi(-19)) / b).floor();
            finding.allowed(format!("up to {most} with this scale")).way_out(format!(
                "take a scale with feed.pulses_per_metre of at least {}, fewer pulses per revolution, or rate = \"exact\"",
                least_pulses_per_metre.ceil()
            ))
        }
        _ => finding.way_out(error.way_out()),
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
