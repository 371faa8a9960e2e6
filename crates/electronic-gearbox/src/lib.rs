#![no_std]
#![forbid(unsafe_code)]
#![doc = "The electronic gearbox that couples the axes of a gear machine."]

pub mod chain;
pub mod coefficient;
pub mod coupling;
mod error;
pub mod pulse;
mod sign;

pub use error::{Error, TableFault, TrainFault};
pub use sign::Sign;
