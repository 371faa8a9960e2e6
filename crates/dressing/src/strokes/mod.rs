//! A profile dressed in several strokes, each with an active area and a correction of its own (`docs/mathematics/dressing.md#conditions`).

pub mod multi_stroke;
pub mod stroke;
pub mod stroke_division;
pub mod stroke_motion;
pub(super) mod stroke_surface;

pub use multi_stroke::{MultiStroke, StrokePoint};
pub use stroke::{ActiveArea, DressedStroke, Stroke};
pub use stroke_division::{MovingSection, ProfileSection, StrokeSection, divide, divide_moving};
pub use stroke_motion::{
    MovingStroke, StrokeAlong, StrokeWish, StrokedPoint, StrokedWorm, solve_stroke_node,
};
pub use stroke_surface::StrokeSurface;
