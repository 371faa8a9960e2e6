//! A process of a program's own, for the command (`main.rs`) and for the wheel of the Python tests.

mod process;

pub use process::{Chamfer, ChamferJob, TipChamfering};
