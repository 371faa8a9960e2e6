//! Parts of the gearbox of several leading axes (spec 70 section 7).

mod counts;
mod engagement;
mod polynomial;
mod rational;
mod table;

pub use engagement::{
    Engagement, EngagementOutput, EngagementSettings, EngagementState, FollowingWindow, Motion, shortest_move,
};
pub use polynomial::{MOST_COEFFICIENTS, PolynomialCoupling};
pub use rational::{BestRational, Dyadic, Fraction, best_rational, dyadic, endless_ratio, error_per_metre};
pub use table::{CubicTable, EndRule, solve_slopes};
