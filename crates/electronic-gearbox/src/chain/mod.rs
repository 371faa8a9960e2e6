//! From pulses of the slide to the additional rotation of the workpiece: a rate multiplier on each line, the hand switch, and the split
//! into whole workpiece pulses and a rest that a converter puts out (`docs/mathematics/gearbox.md#from-pulses-to-counts`).

mod multiplier;
mod rotation;
mod split;

pub use multiplier::{Multiplier, RateRule, passed_pulses};
pub use rotation::AdditionalRotation;
pub use split::{SharedRotation, Split, SplitRotation};
