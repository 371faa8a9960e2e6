//! 60-skiving: virtual edges, measuring poses, real tools at the light barrier, evaluation, setting, calibration, scans.
//!
//! The examples are a table of named tools with their workpieces and beams; the other blocks refer to them by name.

mod band;
mod calibration;
mod conventional;
mod edges;
mod evaluation;
mod example;
mod measurement;
mod mounting;
mod noise;
mod poses;
mod random;
mod scan;

pub(in super::super) use calibration::calibration;
pub(in super::super) use conventional::conventional;
pub(in super::super) use example::examples;
pub(in super::super) use measurement::measurement;
pub(in super::super) use mounting::mounting_only;
pub(in super::super) use random::random;
pub(in super::super) use scan::scan;
