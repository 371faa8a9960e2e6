//! A job that these bodies cannot make: what is handed over all the same, a report and `result.json` with the reason, the bodies, what was
//! tried and the picture of what limits.

mod page;
pub mod write;

pub use write::{RefusedResult, write_refusal};
