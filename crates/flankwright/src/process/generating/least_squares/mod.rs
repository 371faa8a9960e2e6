//! Decomposition of any target into the functions a worm, a dresser and the motion can carry, as B-splines by weighted least
//! squares or with the least largest residual (spec 25 section 4.1). Knows coordinates on a flank, not bodies; only
//! the search asks [`super::FlankLines`] for directions.

mod class;
mod columns;
mod coordinates;
mod decomposition;
mod fit;
mod gauge;
mod moving_lines;
mod quality;
mod samples;
mod scan;
mod search;

pub use class::{FitNorm, FitSettings, FunctionClass, Kinks};
pub use columns::ArgumentKinks;
pub use coordinates::{Arguments, DiagonalCoordinates, FlankCoordinates, StraightRelations};
pub use decomposition::{RollScale, SplineDecomposition, WormFunctions};
pub use fit::{FitReport, FunctionsFit, MinimaxReport, fit_functions};
pub use gauge::SplineGauge;
pub(super) use moving_lines::{LineSlopes, MovingLines};
pub use quality::FitQuality;
pub use samples::{DEFAULT_GRID, Samples};
pub use scan::{Candidates, Tried};
pub use search::{
    DirectionSearch, FlankFit, Objective, RatioSearch, deviation_free, search_direction, search_ratio,
};
