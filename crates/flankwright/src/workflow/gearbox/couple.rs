//! Entries of a job of the electronic gearbox as gear, interpolator, coupling and servo; what these refuse, as findings on the keys
//! of the job.

use crate::control::servo::{self, Disturbances, Drive, Gains, Quantisation, ServoParameters};
use crate::control::{ControlError, Interpolation, Move, Rotation, RotationRule, SlideMotion, StrokeError};
use crate::exchange::Diagnostic;
use crate::exchange::control::{
    Disturbance, InterpolationMode, RotationRate, ScaleInterpolation, Servo, Spindle,
};
use crate::exchange::gearbox_job::{GearboxGear, GearboxWorkpiece, Move as JobMove, Stimulus};
use crate::workflow::RunFailure;
use electronic_gearbox::chain::RateRule;
use electronic_gearbox::coefficient::{Coefficient, GearGeometry};
use electronic_gearbox::pulse::{Mode, Settings};
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

/// Scale and interpolator of the feed slide.
///
/// # Errors
/// [`RunFailure`] on keys of `feed`.
pub(super) fn interpolation(feed: &ScaleInterpolation) -> Result<Interpolation, RunFailure> {
    let mode = match feed.mode {
        InterpolationMode::OneWay => Mode::OneWay,
        InterpolationMode::NoBacklash => Mode::NoBacklash,
        InterpolationMode::Literal => Mode::Literal,
    };
    let settings = Settings::new(feed.pulses_per_interval, feed.counter_limit, mode).map_err(|error| {
        let counter = matches!(error, GearboxError::CounterLimit { .. });
        on_field(&error, if counter { "feed.counter_limit" } else { "feed.pulses_per_interval" })
    })?;
    let interpolation = Interpolation { settings, clock: feed.clock_hz, pitch: feed.pitch_mm() };
    interpolation.validate().map_err(|error| of_feed(&error))?;
    Ok(interpolation)
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
    let field = match error {
        ControlError::BadParameter { name: "clock", .. } => "feed.clock_hz",
        ControlError::BadParameter { name: "pitch" | "pulses_per_metre", .. } => "feed.pulses_per_metre",
        _ => "stimulus.motion",
    };
    control_refused(error, field)
}

/// Loop and motor of the workpiece spindle.
///
/// # Errors
/// [`RunFailure`] on keys of `servo`.
pub(super) fn servo_parameters(
    servo: &Servo,
    workpiece_pulses: u32,
    multiplier: u32,
) -> Result<ServoParameters, RunFailure> {
    let drive = Drive {
        inertia: servo.inertia_kg_m2,
        viscous_friction: servo.damping_n_m_s,
        coulomb_friction: servo.friction_n_m,
        friction_speed: servo.friction_speed_rad_per_s,
        torque_limit: servo.torque_limit_n_m,
    };
    let gains = match (&servo.gains, servo.bandwidth_hz) {
        (Some(gains), _) => Gains {
            proportional: gains.proportional_n_m_per_rad,
            integral: gains.integral_n_m_per_rad_s,
            derivative: gains.derivative_n_m_s_per_rad,
        },
        (None, bandwidth) => Gains::triple_pole(bandwidth.unwrap_or_default(), &drive)
            .map_err(|error| of_servo(&error, servo))?,
    };
    let parameters = ServoParameters {
        sample_time: 1e-6 * servo.sample_time_us,
        drive,
        gains,
        feed_forward: servo.feed_forward,
        quantisation: servo
            .quantised
            .then_some(Quantisation { counts_per_revolution: workpiece_pulses, multiplier }),
    };
    parameters.validate().map_err(|error| of_servo(&error, servo))?;
    Ok(parameters)
}

/// Torques on the workpiece.
///
/// # Errors
/// [`RunFailure`] on `servo.disturbances`.
pub(super) fn disturbances(servo: &Servo) -> Result<Disturbances, RunFailure> {
    let sources = servo.disturbances.iter().map(disturbance).collect();
    Disturbances::new(sources).map_err(|error| control_refused(&error, "servo.disturbances"))
}

fn disturbance(given: &Disturbance) -> servo::Disturbance {
    let spindle = |axis| match axis {
        Spindle::Worm => servo::Spindle::Worm,
        Spindle::Workpiece => servo::Spindle::Workpiece,
    };
    match *given {
        Disturbance::Constant { torque_n_m } => servo::Disturbance::Constant { torque: torque_n_m },
        Disturbance::Step { torque_n_m, at_s } => {
            servo::Disturbance::Step { torque: torque_n_m, after: at_s }
        }
        Disturbance::Harmonic { torque_n_m, frequency_hz, phase_deg } => servo::Disturbance::HarmonicInTime {
            amplitude: torque_n_m,
            frequency: frequency_hz,
            phase: phase_deg.to_radians(),
        },
        Disturbance::Order { torque_n_m, axis, order, phase_deg } => servo::Disturbance::HarmonicInAngle {
            spindle: spindle(axis),
            amplitude: torque_n_m,
            order,
            phase: phase_deg.to_radians(),
        },
        Disturbance::Pulses { torque_n_m, axis, per_revolution, width_deg } => {
            servo::Disturbance::PulseTrain {
                spindle: spindle(axis),
                torque: torque_n_m,
                pulses: per_revolution,
                first: 0.0,
                width: width_deg.to_radians(),
            }
        }
    }
}

/// What a simulation of the servo refuses.
pub(super) fn of_following(error: &StrokeError, servo: &Servo) -> RunFailure {
    match error {
        StrokeError::Control(error) => of_servo(error, servo),
        StrokeError::Gearbox(error) => on_field(error, "worm"),
    }
}

fn of_servo(error: &ControlError, servo: &Servo) -> RunFailure {
    let field = match error {
        ControlError::UnstableLoop { .. } if servo.gains.is_some() => "servo.gains",
        ControlError::UnstableLoop { .. } => "servo.bandwidth_hz",
        ControlError::BadParameter { name, .. } => match *name {
            "inertia" => "servo.inertia_kg_m2",
            "viscous_friction" => "servo.damping_n_m_s",
            "coulomb_friction" => "servo.friction_n_m",
            "friction_speed" => "servo.friction_speed_rad_per_s",
            "torque_limit" => "servo.torque_limit_n_m",
            "bandwidth" => "servo.bandwidth_hz",
            "proportional" => "servo.gains.proportional_n_m_per_rad",
            "integral" => "servo.gains.integral_n_m_per_rad_s",
            "derivative" => "servo.gains.derivative_n_m_s_per_rad",
            "feed_forward" => "servo.feed_forward",
            "counts_per_revolution" => "workpiece.pulses_per_revolution",
            "disturbance_torque" | "torque" | "amplitude" => "servo.disturbances",
            "position" | "speed" | "acceleration" => "stimulus",
            _ => "servo.sample_time_us",
        },
        ControlError::TooFast { .. } => "stimulus",
    };
    control_refused(error, field)
}

/// A fault of a control on a key of the job.
pub(super) fn control_refused(error: &ControlError, field: &str) -> RunFailure {
    let mut finding = Diagnostic::with_code(error.code(), error.to_string()).field(field);
    if let ControlError::BadParameter { value, allowed, .. } = error {
        finding = finding.value(value).allowed(*allowed);
    }
    RunFailure::bad_input(finding.way_out(error.way_out()))
}

/// A fault of the gearbox on a key of the job.
pub(super) fn on_field(error: &GearboxError, field: &str) -> RunFailure {
    let finding = Diagnostic::with_code(error.code(), error.to_string());
    RunFailure::bad_input(finding.field(field).way_out(error.way_out()))
}
