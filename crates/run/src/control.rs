//! From a job's tables of the control to the control that is simulated, for every process that couples axes.

pub mod alarms;
pub mod setup;

pub use alarms::interpolator_alarms;
pub use setup::{
    control_refused, disturbances, interpolation, of_scale, of_servo, on_field, rotation, rotation_refused,
    servo_parameters,
};
