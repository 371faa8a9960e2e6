#![no_std]
#![forbid(unsafe_code)]
#![doc = "The electronic gearbox that couples the axes of a gear machine."]

pub mod coefficient;
pub mod coupling;
mod error;

pub use error::{Error, TableFault};
