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

pub(crate) use areal::areal;
pub(crate) use axis_recovery::{axis_recovery, trace_layouts};
pub(crate) use closed_loop::closed_loop;
pub(crate) use dressing_influence::dressing_influence;
pub(crate) use eccentricity::eccentricity_and_run_out;
pub(crate) use k_band::k_band;
pub(crate) use pitch::pitch;
pub(crate) use reader::reader;
pub(crate) use real_parts::real_parts;
pub(crate) use reconstruction::reconstruction;
pub(crate) use rexs::rexs;
pub(crate) use series::series;
pub(crate) use systematic_test::systematic_test;
pub(crate) use thickness::thickness;
pub(crate) use tolerances::{classes, tolerance_errors, tolerances};
pub(crate) use traces::{trace_errors, traces};
pub(crate) use twist_from_traces::twist_from_traces;

#[cfg(test)]
mod evaluation_tests;
