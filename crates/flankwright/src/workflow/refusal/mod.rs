//! A job that these bodies cannot make: the true cause with a remedy that exists, and what is handed over all the same: a report
//! and `result.json` with the bodies, the candidates that were tried and the picture of what limits.

mod cause;
mod evidence;
mod page;
mod write;

pub(super) use cause::{exact_beyond_axis_limits, of_planning, of_simulation, stated_ratio};
pub use write::write_refusal;
