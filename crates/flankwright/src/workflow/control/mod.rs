//! A run through a real gearbox and servo instead of ideal couplings: what the control that the job describes leaves on the flank of every
//! tooth, beside what the process leaves (`docs/mathematics/gearbox.md`). Grinding goes through it, after the dresser of either process.

mod alarms;
mod of_grinding;
mod of_tangential;
mod page;
mod pass;
mod result;
mod run;
mod setup;

pub(super) use alarms::interpolator_alarms;
pub(super) use of_grinding::control_of_grinding;
pub(super) use of_tangential::control_of_tangential;
pub(super) use page::control_report;
pub use result::{ControlFlankResult, ControlResult, ErrorTrace, Trace};
pub(super) use setup::{
    disturbances, interpolation, of_scale, of_servo, on_field, rotation, rotation_refused, servo_parameters,
};
