//! Bevel gears: their cones from drawing data, flank lines, and the flanks over them (`docs/mathematics/milling.md#flanks-as-patches`).
//!
//! Coordinates: the origin is the common apex of all cones, z runs from it towards the heel; the tooth space stays centred on +y at
//! the mean distance.

mod flank_line;
mod gear;
mod line_bounds;
mod octoid;
mod spherical_involute;
mod tangent_line;

pub use flank_line::{CircularLine, FlankLine, Hand, LineForm, Spiral};
pub use gear::{BevelData, BevelGear};
pub use octoid::Octoid;
pub use spherical_involute::SphericalInvolute;
pub use tangent_line::TangentLine;
