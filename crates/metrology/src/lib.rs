//! Pure evaluation of measured or computed flanks: grids, characteristics, surfaces, comparison, what of it is systematic. Knows no process.

pub mod areal;
mod characteristics;
pub mod inspection;
pub mod systematic;
mod topography;

pub use characteristics::Characteristics;
pub use topography::Topography;
