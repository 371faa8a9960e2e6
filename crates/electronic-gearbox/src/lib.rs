#![no_std]
#![forbid(unsafe_code)]
#![doc = include_str!("../README.md")]

pub mod chain;
pub mod coefficient;
pub mod coupling;
mod error;
pub mod pulse;
mod sign;

pub use error::{Error, TableFault, TrainFault};
pub use sign::Sign;
