//! Numerical tools: the scalar trait, series, splines and roots. Knows no gears.

mod scalar;

pub use scalar::Scalar;
