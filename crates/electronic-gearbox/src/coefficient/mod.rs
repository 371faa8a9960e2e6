//! From gear data to the numbers that the couplings run with (`docs/mathematics/gearbox.md`): lead and flank factors of a gear, the 18-bit
//! coefficient of the additional rotation, the couplings of the generating chain.

mod couplings;
mod gear;
mod rate;

pub use couplings::{CouplingSigns, Couplings};
pub use gear::GearGeometry;
pub use rate::Coefficient;
