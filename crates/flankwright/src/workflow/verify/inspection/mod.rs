//! 85-inspection: readers and real parts, evaluation of traces and pitch, tolerances and classes, series of parts, surfaces, what is
//! systematic, the closed loop, REXS.

mod areal;
mod axis_recovery;
mod closed_loop;
mod dressing_influence;
mod each_case;
mod eccentricity;
mod evaluation_case;
mod grinding;
mod k_band;
mod loop_input;
mod pitch;
mod reader;
mod real_parts;
mod reconstruction;
mod rexs;
mod series;
mod systematic_test;
mod thickness;
mod tolerances;
mod traces;
mod twist_from_traces;

pub(in super::super) use areal::areal;
pub(in super::super) use axis_recovery::{axis_recovery, trace_layouts};
pub(in super::super) use closed_loop::closed_loop;
pub(in super::super) use dressing_influence::dressing_influence;
pub(in super::super) use eccentricity::eccentricity_and_run_out;
pub(in super::super) use k_band::k_band;
pub(in super::super) use pitch::pitch;
pub(in super::super) use reader::reader;
pub(in super::super) use real_parts::real_parts;
pub(in super::super) use reconstruction::reconstruction;
pub(in super::super) use rexs::rexs;
pub(in super::super) use series::series;
pub(in super::super) use systematic_test::systematic_test;
pub(in super::super) use thickness::thickness;
pub(in super::super) use tolerances::{classes, tolerance_errors, tolerances};
pub(in super::super) use traces::{trace_errors, traces};
pub(in super::super) use twist_from_traces::twist_from_traces;

#[cfg(test)]
mod evaluation_tests;
