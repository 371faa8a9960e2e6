//! Worms and dressers that are there, and which of them make a target (`docs/mathematics/dressing.md`). Knows no file and no gear: a
//! [`Workshop`] puts the worms in place.

pub mod backwards;
pub mod bodies;
mod collisions;
pub mod life;
pub mod pair;
pub mod refusal;
pub mod search;

pub use backwards::{Backwards, BackwardsSearch, FreeQuantity, FreeValue, WorkingRange};
pub use bodies::{CatalogueDresser, CatalogueWorm, DesignedDresser, DresserSize, Workshop, WornDiameter};
pub use life::{LifeRow, RemainingLife};
pub use pair::{FlankOfPair, Look, Pair, PairFigures, PairLimits, Wanted};
pub use refusal::Refusal;
pub use search::{CatalogueSearch, RankedPair};
