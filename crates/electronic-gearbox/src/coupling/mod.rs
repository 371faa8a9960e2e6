//! The gearbox of several leading axes: y = y_0 + sum (n_i/d_i)(x_i - x_i0) + polynomials + tables
//! (`docs/mathematics/gearbox.md#couplings`). Positions are counts of 64 bits, ratios exact fractions, accumulators 128 bits wide: nothing
//! drifts, however long the axes turn.

mod bresenham;
mod counter;
mod counts;
mod divisor;
mod engagement;
mod gearbox;
mod linear;
mod polynomial;
mod ratio;
mod rational;
mod table;

pub use bresenham::Bresenham;
pub use counter::WrappingCounter;
pub use engagement::{
    Engagement, EngagementOutput, EngagementSettings, EngagementState, FollowingWindow, Motion, shortest_move,
};
pub use gearbox::{Gearbox, GearboxPosition, IncrementalGearbox};
pub use linear::LinearTerm;
pub use polynomial::{MOST_COEFFICIENTS, PolynomialCoupling};
pub use ratio::Ratio;
pub use rational::{BestRational, Dyadic, best_rational, dyadic, endless_ratio, error_per_metre};
pub use table::{CubicTable, EndRule, solve_slopes};
