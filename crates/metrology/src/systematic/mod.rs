//! Which part of a deviation is systematic (`docs/mathematics/inspection.md#what-all-teeth-share`): do the teeth really differ, do they
//! follow a harmonic of the rotation (run-out, wobble), and is what all teeth share large enough to be corrected. Knows neither features
//! nor processes: values are those of any one characteristic, in its own unit.

mod decision;
mod error;
mod harmonic;
mod variance;

pub use decision::{Decision, SystematicOptions, SystematicTest, systematic_test};
pub use error::SystematicError;
pub use harmonic::{FirstHarmonic, harmonic_left_in_mean};
pub use variance::{TeethVariance, WithinTeeth};
