//! Pure evaluation of measured or computed flanks: grids, characteristics, comparison. Knows no process.

mod characteristics;
pub mod inspection;
mod topography;

pub use characteristics::Characteristics;
pub use topography::Topography;
