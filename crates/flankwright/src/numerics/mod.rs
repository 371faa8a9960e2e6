//! Numerical tools: the scalar trait, series, splines and roots. Knows no gears.

mod chebyshev;
mod roots;
mod scalar;

pub use chebyshev::Chebyshev;
pub use roots::{bisect, golden_section};
pub use scalar::{Scalar, gradient_of, value_of, variables};
