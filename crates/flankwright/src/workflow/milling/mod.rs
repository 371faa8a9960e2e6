//! Jobs of five-axis milling.

pub mod programs;
