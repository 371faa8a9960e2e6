//! The electronic gearbox as a process: its job, reference pulses, the run with its budget and its servo, set-ups side by side, page.
//! The gearbox itself is `electronic_gearbox`, what a control makes of a motion is `control`.

pub mod job;
pub mod page;
mod process;
pub mod reference_train;
pub mod workflow;

pub use process::ElectronicGearbox;
pub use reference_train::{ReferenceTrain, parse_reference_train, read_reference_train};
