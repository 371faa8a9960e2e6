//! Measuring a skiving tool in the machine, from job to result: preparation, readings simulated or read, what they say of the tool and
//! of the workpiece to come, correction of the setting, scan, history, files.

pub mod check;
mod conventional;
pub mod derived;
pub mod finding;
mod history;
mod measurement;
mod model;
mod monte_carlo;
mod outcome;
pub mod prepare;
mod probe;
mod program_work;
pub mod programs;
mod readings_file;
mod real_tool;
mod referee;
mod remarks;
mod resharpening;
mod result;
pub mod run;
mod runout;
mod scan;
pub mod scene;
mod summary;
mod tables;
mod verdict;
pub mod write;

pub use check::SkivingCheck;
pub use measurement::{Measurement, Taken};
pub use model::MeasuringModel;
pub use prepare::{PreparedSkiving, SkivingBodies, prepare_skiving};
pub use probe::Probed;
pub use resharpening::{
    BrokenEdge, DecidingCause, DecidingEdge, EdgeResharpening, Resharpening, ToothResharpening, WithoutBroken,
};
pub use result::*;
pub use run::{SkivingOutcome, inspect_skiving, run_skiving, simulate_skiving};
pub use write::write_skiving;
