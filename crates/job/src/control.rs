//! Tables about the control of a machine that jobs of several processes share: scales and their interpolation, encoders, the
//! servo of the workpiece spindle. Values as in the file; knows neither pulses nor loops.

pub mod checks;
pub mod disturbance;
pub mod encoder;
pub mod scale;
pub mod servo;

pub use checks::check_servo;
pub use disturbance::{Disturbance, Spindle};
pub use encoder::{RotationRate, WorkpieceEncoder, WormEncoder, encoder_pulses_schema};
pub use scale::{
    InterpolationMode, ScaleInterpolation, ShiftScale, clock_schema, pulses_per_interval_schema,
    scale_pulses_schema,
};
pub use servo::{Servo, ServoGains};
