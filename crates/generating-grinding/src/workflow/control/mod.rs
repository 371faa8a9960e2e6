//! A run through a real gearbox and servo instead of ideal couplings: what the control that the job describes leaves on the flank of every
//! tooth, beside what the process leaves (`docs/mathematics/gearbox.md`). Grinding goes through it, after the dresser of either process.

pub mod of_grinding;
pub mod pass;
pub mod result;
pub mod run;

pub use of_grinding::control_of_grinding;
pub use result::{ControlFlankResult, ControlResult, ErrorTrace, Trace};
