//! From a job's tables to the control that is simulated: units become mm, rad, s, and errors name the key. The tables are those
//! of a grinding job below `control`, or of a job of the electronic gearbox at its top: `below` is "control." or empty.

use crate::finding::RunFailure;
use control::servo::{Disturbances, Drive, Gains, Quantisation, ServoParameters};
use control::{ControlError, Interpolation, Rotation, RotationRule, servo as loops};
use electronic_gearbox::Error as GearboxError;
use electronic_gearbox::chain::RateRule;
use electronic_gearbox::coefficient::Coefficient;
use electronic_gearbox::pulse::{Mode, Settings};
use job::Diagnostic;
use job::control::{
    Disturbance, InterpolationMode, RotationRate, ScaleInterpolation, Servo, Spindle, WorkpieceEncoder,
};

/// Scale and interpolator of the feed slide.
///
/// # Errors
/// [`RunFailure`] on keys of `feed`.
pub fn interpolation(feed: &ScaleInterpolation, below: &str) -> Result<Interpolation, RunFailure> {
    let mode = match feed.mode {
        InterpolationMode::OneWay => Mode::OneWay,
        InterpolationMode::NoBacklash => Mode::NoBacklash,
        InterpolationMode::Literal => Mode::Literal,
    };
    let settings = Settings::new(feed.pulses_per_interval, feed.counter_limit, mode).map_err(|error| {
        let counter = matches!(error, GearboxError::CounterLimit { .. });
        let key = if counter { "counter_limit" } else { "pulses_per_interval" };
        on_field(&error, &format!("{below}feed.{key}"))
    })?;
    let interpolation = Interpolation { settings, clock: feed.clock_hz, pitch: feed.pitch_mm() };
    interpolation.validate().map_err(|error| of_scale(&error, below, "feed.pulses_per_metre"))?;
    Ok(interpolation)
}

/// What a scale or a slide refuses; `other` is the key of what is neither clock nor pitch.
pub fn of_scale(error: &ControlError, below: &str, other: &str) -> RunFailure {
    let key = match error {
        ControlError::BadParameter { name: "clock", .. } => "feed.clock_hz",
        ControlError::BadParameter { name: "pitch" | "pulses_per_metre", .. } => "feed.pulses_per_metre",
        _ => other,
    };
    control_refused(error, &format!("{below}{key}"))
}

/// How pulses of the slide turn the workpiece by `turns_per_millimetre` of feed; `coefficient` is that of a rate multiplier.
///
/// # Errors
/// The gearbox's own: a coefficient beyond the rate multiplier, a ratio beyond the accumulator.
pub fn rotation(
    workpiece: WorkpieceEncoder,
    turns_per_millimetre: f64,
    feed: &Interpolation,
    coefficient: impl FnOnce() -> Result<Coefficient, GearboxError>,
) -> Result<Rotation, GearboxError> {
    let p = f64::from(feed.settings.pulses_per_interval());
    let parts_per_revolution = f64::from(workpiece.pulses_per_revolution) * p;
    let rule = match workpiece.rate {
        RotationRate::Exact => {
            return Rotation::exact(turns_per_millimetre, parts_per_revolution, feed.pitch / p);
        }
        RotationRate::Bresenham => RateRule::Bresenham,
        RotationRate::Binary => RateRule::Binary,
    };
    let rule = RotationRule::Multiplier { coefficient: coefficient()?, rule };
    Ok(Rotation { rule, turns_per_millimetre, parts_per_revolution })
}

/// What [`rotation`] refuses, on the encoder of the workpiece.
pub fn rotation_refused(error: &GearboxError, workpiece: WorkpieceEncoder, below: &str) -> RunFailure {
    let finding = Diagnostic::with_code(error.code(), error.to_string())
        .field(format!("{below}workpiece.pulses_per_revolution"))
        .value(workpiece.pulses_per_revolution);
    RunFailure::bad_input(match *error {
        GearboxError::CoefficientTooLarge { b, least_pulses_per_metre } => {
            // The greatest encoder that the scale takes is smaller in the ratio of the coefficients.
            let most = (f64::from(workpiece.pulses_per_revolution) * (1.0 - 2f64.powi(-19)) / b).floor();
            finding.allowed(format!("up to {most} with this scale")).way_out(format!(
                "take a scale with {below}feed.pulses_per_metre of at least {}, fewer pulses per revolution, or rate = \"exact\"",
                least_pulses_per_metre.ceil()
            ))
        }
        _ => finding.way_out(error.way_out()),
    })
}

/// Loop and motor of the workpiece spindle.
///
/// # Errors
/// [`RunFailure`] on keys of `servo`.
pub fn servo_parameters(
    servo: &Servo,
    workpiece_pulses: u32,
    multiplier: u32,
    below: &str,
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
            .map_err(|error| of_servo(&error, servo, below))?,
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
    parameters.validate().map_err(|error| of_servo(&error, servo, below))?;
    Ok(parameters)
}

/// Torques on the workpiece.
///
/// # Errors
/// [`RunFailure`] on `servo.disturbances`.
pub fn disturbances(servo: &Servo, below: &str) -> Result<Disturbances, RunFailure> {
    let sources = servo.disturbances.iter().map(disturbance).collect();
    Disturbances::new(sources).map_err(|error| control_refused(&error, &format!("{below}servo.disturbances")))
}

fn disturbance(given: &Disturbance) -> loops::Disturbance {
    let spindle = |axis| match axis {
        Spindle::Worm => loops::Spindle::Worm,
        Spindle::Workpiece => loops::Spindle::Workpiece,
    };
    match *given {
        Disturbance::Constant { torque_n_m } => loops::Disturbance::Constant { torque: torque_n_m },
        Disturbance::Step { torque_n_m, at_s } => {
            loops::Disturbance::Step { torque: torque_n_m, after: at_s }
        }
        Disturbance::Harmonic { torque_n_m, frequency_hz, phase_deg } => loops::Disturbance::HarmonicInTime {
            amplitude: torque_n_m,
            frequency: frequency_hz,
            phase: phase_deg.to_radians(),
        },
        Disturbance::Order { torque_n_m, axis, order, phase_deg } => loops::Disturbance::HarmonicInAngle {
            spindle: spindle(axis),
            amplitude: torque_n_m,
            order,
            phase: phase_deg.to_radians(),
        },
        Disturbance::Pulses { torque_n_m, axis, per_revolution, width_deg } => {
            loops::Disturbance::PulseTrain {
                spindle: spindle(axis),
                torque: torque_n_m,
                pulses: per_revolution,
                first: 0.0,
                width: width_deg.to_radians(),
            }
        }
    }
}

/// What a loop or its simulation refuses.
pub fn of_servo(error: &ControlError, servo: &Servo, below: &str) -> RunFailure {
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
    control_refused(error, &format!("{below}{field}"))
}

/// A fault of a control on a key of the job.
pub fn control_refused(error: &ControlError, field: &str) -> RunFailure {
    let mut finding = Diagnostic::with_code(error.code(), error.to_string()).field(field);
    if let ControlError::BadParameter { value, allowed, .. } = error {
        finding = finding.value(value).allowed(*allowed);
    }
    RunFailure::bad_input(finding.way_out(error.way_out()))
}

/// A fault of the gearbox on a key of the job.
pub fn on_field(error: &GearboxError, field: &str) -> RunFailure {
    RunFailure::bad_input(
        Diagnostic::with_code(error.code(), error.to_string()).field(field).way_out(error.way_out()),
    )
}
