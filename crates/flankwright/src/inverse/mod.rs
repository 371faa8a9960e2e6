//! Inversion: damped Newton, weighted Gauss-Newton and least squares with a rank report. Exact derivatives only; knows no gears.

mod gauss_newton;
mod least_squares;
mod newton;

pub use gauss_newton::{GaussNewton, GaussNewtonReport, gauss_newton};
pub use least_squares::{LeastSquares, RankReport, weighted_least_squares};
pub use newton::{NewtonError, NewtonOptions, NewtonReport, newton};
