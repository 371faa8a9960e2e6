//! What a control makes of a motion before it reaches the flank (`docs/mathematics/gearbox.md`): slides and their scales, pulse
//! interpolation, the gearbox, the sampled position loop of the workpiece spindle, and what their errors are on the flank. Knows neither
//! processes nor files.

pub mod servo;

mod at_flank;
mod budget;
mod converter;
mod correction;
mod drive;
mod encoder_errors;
mod engaging;
mod error;
mod following;
mod interpolation;
mod line_errors;
mod multipliers;
mod rotation;
mod slide;
mod stroke;

pub use at_flank::{ControlledFlank, FlankPlaces, FlankSlopes};
pub use budget::{BudgetInput, ErrorBound, ErrorBudget};
pub use converter::Converter;
pub use correction::{AxisState, Correction, CorrectionCurve, LeadingAxis, SolvedTable, added};
pub use encoder_errors::{EncoderErrors, EncoderWave, ToothErrors};
pub use engaging::{Engaging, EngagingRecord, EngagingSample};
pub use error::ControlError;
pub use following::{FollowedSlide, FollowedWorm, Following, FollowingBin, FollowingError, FollowingRecord};
pub use interpolation::{ErrorBin, Extremes, Interpolation, InterpolationRun, PulseCounts};
pub use line_errors::{LineErrors, LineWave};
pub use multipliers::{AmplitudeInterpolation, MultiplierRun, PhaseLockedLoop};
pub use rotation::{Rotation, RotationCounter, RotationRule};
pub use slide::{Crossing, Crossings, Move, SlideCursor, SlideMotion, SlideState};
pub use stroke::{StrokeControl, StrokeError, StrokeRecord, StrokeSpeeds, run_stroke, run_there_and_back};
