//! The ease-off of a bevel gear in mm.

use crate::job as drawn;
use foundation::geometry::EaseOffAmounts;

pub(super) fn amounts(given: drawn::EaseOffAmounts) -> EaseOffAmounts {
    EaseOffAmounts {
        length_crowning: 1e-3 * given.lengthwise_um,
        profile_crowning: 1e-3 * given.profile_um,
        bias: 1e-3 * given.bias_um,
    }
}
