//! Decomposition of any target into the functions a worm, a dresser and the motion can carry, as B-splines by weighted least
//! squares or with the least largest residual (`docs/mathematics/planning.md#producibility`). Knows coordinates on a flank, not bodies;
//! only the search asks [`super::FlankLines`] for directions.
//!
//! Cost of one fit with m samples, n intervals, degree k: the p functions of X touch s = p (k + 1) neighbouring columns a row
//! and are reduced stretch by stretch; profile and path, b = 2 (n + k) columns, are dense: 2 m (s (s + b) + b^2) operations,
//! then 4/3 (5 (n + k))^3 for the rank. Linear in the samples, quadratic in the intervals while samples prevail. Memory
//! beyond the samples does not grow with the rows but for their order.

pub mod class;
mod columns;
mod coordinates;
mod decomposition;
mod fit;
mod functions;
mod gauge;
mod moving_lines;
mod quality;
pub mod samples;
mod scan;
pub mod search;

pub use class::{FitNorm, FitSettings, FunctionClass, Kinks};
pub use columns::ArgumentKinks;
pub use coordinates::{Arguments, DiagonalCoordinates, FlankCoordinates, StraightRelations};
pub use decomposition::SplineDecomposition;
pub use fit::{FitReport, FunctionsFit, MinimaxReport, fit_functions};
pub use functions::{RollScale, WormFunctions};
pub use gauge::SplineGauge;
pub(super) use moving_lines::{LineSlopes, MovingLines};
pub use quality::FitQuality;
pub use samples::{DEFAULT_GRID, Samples};
pub use scan::{Candidates, Tried};
pub use search::{
    DirectionSearch, FlankFit, Objective, RatioSearch, deviation_free, search_direction, search_ratio,
};
