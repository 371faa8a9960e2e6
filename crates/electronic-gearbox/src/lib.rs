#![no_std]
#![forbid(unsafe_code)]
#![doc = "The electronic gearbox that couples the axes of a gear machine."]

pub mod chain;
pub mod coupling;
mod error;
pub mod pulse;

pub use error::{Error, TableFault, TrainFault};
