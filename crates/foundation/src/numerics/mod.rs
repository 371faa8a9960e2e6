//! Numerical tools: the scalar trait, series, splines, polynomials, roots and tail probabilities. Knows no gears.

mod angle;
mod bernstein;
mod bspline;
mod chebyshev;
mod chebyshev_table;
mod chi_square;
mod equidistant;
mod extremes;
mod harmonic;
mod jet;
mod knots;
mod least_over;
mod minimum;
mod monotone_root;
mod noise;
mod polynomial;
mod powers;
mod probability;
mod progress;
mod root_mean_square;
mod roots;
mod scalar;
mod spline;
mod spline_fit;
mod tensor_spline;

pub use angle::wrapped_angle;
pub use bspline::{BSpline, BSplineBasis};
pub use chebyshev::Chebyshev;
pub use chebyshev_table::ChebyshevTable;
pub use chi_square::{chi_square_quantile, incomplete_gamma};
pub use equidistant::equidistant;
pub use extremes::extremes;
pub use harmonic::Harmonic;
pub use jet::Jet2;
pub use knots::SplineError;
pub use least_over::least_over;
pub use minimum::least_value;
pub use monotone_root::monotone_root;
pub use noise::Noise;
pub use polynomial::Polynomial2;
pub use powers::power_series;
pub use probability::{
    fisher_upper, incomplete_beta, normal_upper_tail, student_quantile, student_two_sided,
};
pub use progress::{Progress, Silent};
pub use root_mean_square::root_mean_square;
pub use roots::{bisect, brent, golden_section};
pub use scalar::{Scalar, gradient_of, value_of, variables};
pub use spline::CubicSpline;
pub use spline_fit::fit_tensor_spline;
pub use tensor_spline::{BicubicPatch, TensorSpline};
