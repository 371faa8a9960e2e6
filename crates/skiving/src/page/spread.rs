//! How much a figure scatters when the measurement is repeated.

use crate::workflow::SkivingResult;

/// Standard deviation of a result of the repeated measurements; none without them.
pub(super) fn spread(result: &SkivingResult, name: &str) -> Option<f64> {
    let found = result.monte_carlo.as_ref()?.results.iter().find(|scatter| scatter.name == name)?;
    Some(found.sigma)
}
