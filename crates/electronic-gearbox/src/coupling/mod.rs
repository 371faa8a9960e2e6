//! The gearbox of several leading axes: y = y_0 + sum (n_i/d_i)(x_i - x_i0) + polynomials + tables (spec 70 section 7). Positions are
//! counts of 64 bits, ratios exact fractions, accumulators 128 bits wide: nothing drifts, however long the axes turn.

mod bresenham;
mod counter;
mod divisor;
mod gearbox;
mod linear;
mod ratio;

pub use bresenham::Bresenham;
pub use counter::WrappingCounter;
pub use gearbox::{Gearbox, GearboxPosition, IncrementalGearbox};
pub use linear::LinearTerm;
pub use ratio::Ratio;
