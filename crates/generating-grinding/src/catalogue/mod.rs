//! The catalogue of a shop: worms and dressers that are there, as one TOML or JSON file or as two tables. Knows neither gear nor
//! target.

mod checks;
mod dresser;
pub mod read;
mod table;
mod worm;

pub use dresser::{DresserEntry, FlankDiameters};
pub use read::{
    LoadedCatalogue, catalogue_of_job, catalogue_schema, parse_catalogue, parse_catalogue_tables,
    read_catalogue, read_catalogue_tables,
};
pub use worm::WormEntry;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Worms and dressers of a shop.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Catalogue {
    /// The grinding worms.
    #[schemars(extend("minItems" = 1, "maxItems" = 10_000))]
    pub worm: Vec<WormEntry>,
    /// The disc dressers.
    #[schemars(extend("minItems" = 1, "maxItems" = 10_000))]
    pub dresser: Vec<DresserEntry>,
}
