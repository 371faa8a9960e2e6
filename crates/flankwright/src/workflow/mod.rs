//! Plan, simulate and verify: the only room where processes, referee and reports meet; what command, server and Python call.

mod prepare;

pub use prepare::{Prepared, prepare};
