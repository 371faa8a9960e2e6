//! Numerical tools: the scalar trait, series, splines, polynomials and roots. Knows no gears.

mod jet;
mod knots;
mod polynomial;
mod scalar;
mod spline;
mod spline_fit;
mod tensor_spline;

pub use jet::Jet2;
pub use knots::SplineError;
pub use polynomial::Polynomial2;
pub use scalar::Scalar;
pub use spline::CubicSpline;
pub use spline_fit::fit_tensor_spline;
pub use tensor_spline::TensorSpline;
