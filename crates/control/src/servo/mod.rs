//! The sampled position loop of the workpiece spindle with a motor model: what disturbances, quantisation, friction and
//! the limit of the torque leave at the flank (`docs/mathematics/gearbox.md#position-loop`).
//!
//! ```
//! use control::servo::{Drive, FlankRecord, Gains, ServoLoop, ServoParameters, Setpoint};
//!
//! let drive = Drive {
//!     inertia: 0.12, viscous_friction: 0.05, coulomb_friction: 0.0, friction_speed: 0.05, torque_limit: 60.0,
//! };
//! let gains = Gains::triple_pole(40.0, &drive)?;
//! let parameters =
//!     ServoParameters { sample_time: 125e-6, drive, gains, feed_forward: 1.0, quantisation: None };
//! let mut servo = ServoLoop::new(parameters)?.starting_at(0.0, 20.0)?;
//! let mut flank = FlankRecord::new(46_984.6)?; // um per rad: normal module 2.5, 40 teeth, 20 deg
//! for k in 0..8000 {
//!     let time = f64::from(k) * parameters.sample_time;
//!     let setpoint = Setpoint { position: 20.0 * time, speed: 20.0, acceleration: 0.0 };
//!     let cutting_torque = 0.8 * (std::f64::consts::TAU * 50.0 * time).sin();
//!     flank.add(servo.step(&setpoint, cutting_torque)?.error);
//! }
//! // The closed form: 0.8 Nm at 50 Hz.
//! let amplitude = 0.8 * parameters.disturbance_response(50.0)?.norm() * 46_984.6;
//! assert!(amplitude < flank.peak_um() && flank.peak_um() < 1.2 * amplitude);
//! # Ok::<(), control::ControlError>(())
//! ```

mod disturbance;
mod flank;
mod parameters;
mod response;
mod simulation;
mod stability;

pub use disturbance::{Disturbance, Disturbances, Moment, Spindle};
pub use flank::FlankRecord;
pub use parameters::{Drive, Gains, Quantisation, ServoParameters};
pub use simulation::{SampleRecord, ServoLoop, Setpoint};
