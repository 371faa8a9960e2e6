//! A grinding job that these bodies cannot make: the true cause with a remedy that exists, and the candidates that were tried.

mod cause;
pub mod evidence;

pub use cause::{exact_beyond_axis_limits, of_planning, of_simulation, stated_ratio};
pub use evidence::Evidence;
