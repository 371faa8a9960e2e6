//! Inversion: damped Newton, continuation along a parameter, weighted Gauss-Newton and least squares with a rank report, also with bounds. Exact derivatives only; knows no gears.

mod banded_reduction;
mod bounded_least_squares;
mod cone_programme;
mod constrained;
mod continuation;
mod gauss_newton;
mod largest_residual;
mod least_squares;
mod newton;
mod panel_cholesky;
mod pivots;
mod row_reduction;
mod svd_loop;

pub use banded_reduction::BandedReduction;
pub use bounded_least_squares::{BoundedLeastSquares, bounded_least_squares};
pub use cone_programme::{Affine, Band, ConeOptimum, ConeProgramme};
pub use constrained::{ConstrainedReport, Rows, constrained_gauss_newton};
pub use continuation::{ContinuationOptions, ParameterLinearised, Path, PathEnd, PathPoint, Watch, follow};
pub use gauss_newton::{GaussNewton, GaussNewtonReport, gauss_newton};
pub use largest_residual::{LargestResidual, minimise_largest_residual};
pub use least_squares::{LeastSquares, RankReport, weighted_least_squares};
pub use newton::{NewtonError, NewtonOptions, NewtonReport, newton};
pub use panel_cholesky::PanelCholesky;
pub use row_reduction::{MinimumNorm, RowReduction};
pub use svd_loop::{SvdLoop, SvdLoopError, SvdReport, SvdRound, svd_loop};
