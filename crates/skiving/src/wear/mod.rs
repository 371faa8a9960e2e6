//! How a skiving tool wears from measurement to measurement, when it has to be ground again, and how much of it. Knows numbers only: no
//! file, no clock.

mod error;
mod forecast;
mod growth;
mod growth_model;
mod regrind;
mod rounding;
mod trend;

pub use error::WearError;
pub use forecast::{Forecast, NoForecast};
pub use growth::{Attribution, GrowthOptions, Growths, ToothPositions, edge_growths, worn_since};
pub use regrind::{DecidingPlace, EdgeState, GroundDepth, Regrind, RegrindCause, regrind, regrind_edges};
pub use rounding::{chip_depth, depth_of_rounding, recession, renewing_depth};
pub use trend::{WearPoint, WearTrend};
