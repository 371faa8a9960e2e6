//! 60-skiving: virtual edges, measuring poses, real tools at the light barrier, evaluation, setting, calibration, scans.
//!
//! The examples are a table of named tools with their workpieces and beams; the other blocks refer to them by name.

mod band;
mod calibration;
mod conventional;
mod edges;
mod evaluation;
mod example;
mod examples;
mod measured;
mod measurement;
mod mounting;
mod noise;
mod poses;
mod random;
mod scan;

pub(crate) use calibration::calibration;
pub(crate) use conventional::conventional;
pub(crate) use examples::examples;
pub(crate) use measurement::measurement;
pub(crate) use mounting::mounting_only;
pub(crate) use random::random;
pub(crate) use scan::scan;
