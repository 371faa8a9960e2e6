//! 85-inspection: surfaces, what is systematic, the closed loop.

mod areal;
mod axis_recovery;
mod closed_loop;
mod dressing_influence;
mod each_case;
mod grinding;
mod loop_input;
mod reconstruction;
mod systematic_test;

pub(in super::super) use areal::areal;
pub(in super::super) use axis_recovery::{axis_recovery, trace_layouts};
pub(in super::super) use closed_loop::closed_loop;
pub(in super::super) use dressing_influence::dressing_influence;
pub(in super::super) use reconstruction::reconstruction;
pub(in super::super) use systematic_test::systematic_test;
