//! A dresser on worms that it was not designed for (`docs/mathematics/dressing.md#conditions`).

pub mod other_worm;
pub(super) mod settled;
pub mod stretch_angle;
pub mod stretch_cone;

pub use other_worm::WormSeat;
pub use stretch_angle::{StretchAngle, angle_of_least_stretch};
pub use stretch_cone::{StretchCone, cone_without_stretch};
