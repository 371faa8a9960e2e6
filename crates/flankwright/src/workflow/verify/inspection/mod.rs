//! 85-inspection: evaluation of traces and pitch, tolerances and classes, series of parts.

mod eccentricity;
mod evaluation_case;
mod k_band;
mod pitch;
mod series;
mod thickness;
mod tolerances;
mod traces;
mod twist_from_traces;

pub(in super::super) use eccentricity::eccentricity_and_run_out;
pub(in super::super) use k_band::k_band;
pub(in super::super) use pitch::pitch;
pub(in super::super) use series::series;
pub(in super::super) use thickness::thickness;
pub(in super::super) use tolerances::{classes, tolerance_errors, tolerances};
pub(in super::super) use traces::{trace_errors, traces};
pub(in super::super) use twist_from_traces::twist_from_traces;

#[cfg(test)]
mod evaluation_tests;
