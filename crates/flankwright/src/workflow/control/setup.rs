//! From a job's tables to the control that is simulated: units become mm, rad, s, and what is wrong is told by its key.

use crate::control::servo::{
    Disturbance, Disturbances, Drive, Gains, Quantisation, ServoParameters, Spindle,
};
use crate::control::{ControlError, Interpolation, StrokeError};
use crate::exchange::Diagnostic;
use crate::exchange::control as file;
use crate::workflow::finding::RunFailure;
use electronic_gearbox::pulse::{Mode, Settings};

/// A fault of the control on a key of the job.
pub(in crate::workflow) fn failure(error: &StrokeError, field: &str) -> RunFailure {
    let finding = Diagnostic::with_code(error.code(), error.to_string());
    RunFailure::bad_input(finding.field(field.to_owned()).way_out(error.way_out()))
}

/// Scale and interpolator of a table `feed`.
///
/// # Errors
/// [`RunFailure`] on a key of that table.
pub(in crate::workflow) fn interpolation(
    scale: &file::ScaleInterpolation,
    field: &str,
) -> Result<Interpolation, RunFailure> {
    let mode = match scale.mode {
        file::InterpolationMode::OneWay => Mode::OneWay,
        file::InterpolationMode::NoBacklash => Mode::NoBacklash,
        file::InterpolationMode::Literal => Mode::Literal,
    };
    let settings = Settings::new(scale.pulses_per_interval, scale.counter_limit, mode)
        .map_err(|error| failure(&error.into(), &format!("{field}.pulses_per_interval")))?;
    Ok(Interpolation { settings, clock: scale.clock_hz, pitch: scale.pitch_mm() })
}

/// Loop and motor of a table `servo`; counts of the workpiece's encoder and P of the setpoint.
///
/// # Errors
/// [`RunFailure`] on a key of that table, among them an unstable loop.
pub(in crate::workflow) fn servo_parameters(
    servo: &file::Servo,
    counts_per_revolution: u32,
    multiplier: u32,
    field: &str,
) -> Result<ServoParameters, RunFailure> {
    let refused = |error: ControlError| {
        let key = match error {
            ControlError::BadParameter { name, .. } => match name {
                "inertia" => "inertia_kg_m2",
                "viscous_friction" => "damping_n_m_s",
                "coulomb_friction" => "friction_n_m",
                "friction_speed" => "friction_speed_rad_per_s",
                "torque_limit" => "torque_limit_n_m",
                "feed_forward" => "feed_forward",
                "bandwidth" => "bandwidth_hz",
                "proportional" | "integral" | "derivative" => "gains",
                _ => "sample_time_us",
            },
            ControlError::UnstableLoop { .. } if servo.gains.is_some() => "gains",
            ControlError::UnstableLoop { .. } => "bandwidth_hz",
            ControlError::TooFast { .. } => "sample_time_us",
        };
        failure(&error.into(), &format!("{field}.{key}"))
    };
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
        // Reading has made sure that one of the two is there; 0 is refused by the next line.
        (None, bandwidth) => Gains::triple_pole(bandwidth.unwrap_or(0.0), &drive).map_err(refused)?,
    };
    let parameters = ServoParameters {
        sample_time: servo.sample_time_us * 1e-6,
        drive,
        gains,
        feed_forward: servo.feed_forward,
        quantisation: servo.quantised.then_some(Quantisation { counts_per_revolution, multiplier }),
    };
    parameters.validate().map_err(refused)?;
    Ok(parameters)
}

/// Torques of a table `servo`.
///
/// # Errors
/// [`RunFailure`] on its list `disturbances`.
pub(in crate::workflow) fn disturbances(
    list: &[file::Disturbance],
    field: &str,
) -> Result<Disturbances, RunFailure> {
    let spindle = |axis: file::Spindle| match axis {
        file::Spindle::Worm => Spindle::Worm,
        file::Spindle::Workpiece => Spindle::Workpiece,
    };
    let sources = list.iter().map(|source| match *source {
        file::Disturbance::Constant { torque_n_m } => Disturbance::Constant { torque: torque_n_m },
        file::Disturbance::Step { torque_n_m, at_s } => Disturbance::Step { torque: torque_n_m, after: at_s },
        file::Disturbance::Harmonic { torque_n_m, frequency_hz, phase_deg } => Disturbance::HarmonicInTime {
            amplitude: torque_n_m,
            frequency: frequency_hz,
            phase: phase_deg.to_radians(),
        },
        file::Disturbance::Order { torque_n_m, axis, order, phase_deg } => Disturbance::HarmonicInAngle {
            spindle: spindle(axis),
            amplitude: torque_n_m,
            order,
            phase: phase_deg.to_radians(),
        },
        file::Disturbance::Pulses { torque_n_m, axis, per_revolution, width_deg } => {
            Disturbance::PulseTrain {
                spindle: spindle(axis),
                torque: torque_n_m,
                pulses: per_revolution,
                first: 0.0,
                width: width_deg.to_radians(),
            }
        }
    });
    Disturbances::new(sources.collect())
        .map_err(|error| failure(&error.into(), &format!("{field}.disturbances")))
}
