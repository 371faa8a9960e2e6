//! What a control makes of a motion before it reaches the flank (`docs/mathematics/gearbox.md`): slides and their scales, pulse
//! interpolation, the gearbox, the sampled position loop of the workpiece spindle, and what their errors are on the flank. Knows neither
//! processes nor files.

pub mod servo;

mod at_flank;
mod budget;
mod drive;
mod error;
mod following;
mod interpolation;
mod rotation;
mod slide;
mod stroke;

pub use at_flank::{ControlledFlank, FlankPlaces, FlankSlopes};
pub use budget::{BudgetInput, ErrorBound, ErrorBudget};
pub use error::ControlError;
pub use following::{FollowedSlide, FollowedWorm, Following, FollowingBin, FollowingError, FollowingRecord};
pub use interpolation::{ErrorBin, Extremes, Interpolation, InterpolationRun, PulseCounts};
pub use rotation::{Rotation, RotationCounter, RotationRule};
pub use slide::{Crossing, Crossings, Move, SlideCursor, SlideMotion, SlideState};
pub use stroke::{StrokeControl, StrokeError, StrokeRecord, StrokeSpeeds, run_stroke, run_there_and_back};
