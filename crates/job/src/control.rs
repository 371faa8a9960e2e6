//! Tables about the control of a machine that jobs of several processes share: scales and their interpolation, encoders, the
//! servo of the workpiece spindle. Values as in the file; knows neither pulses nor loops.

mod checks;
mod disturbance;
mod encoder;
mod scale;
mod servo;

pub(super) use checks::check_servo;
pub use disturbance::{Disturbance, Spindle};
pub(super) use encoder::encoder_pulses_schema;
pub use encoder::{RotationRate, WorkpieceEncoder, WormEncoder};
pub use scale::{InterpolationMode, ScaleInterpolation, ShiftScale};
pub(super) use scale::{clock_schema, pulses_per_interval_schema, scale_pulses_schema};
pub use servo::{Servo, ServoGains};
