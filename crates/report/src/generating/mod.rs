//! The report of diagonal generating grinding: typed figures in, a [`PlanReport`](crate::data::PlanReport) out.
//!
//! The workflow fills [`GeneratingReport`] with finished numbers; this room only arranges them. Whatever is absent
//! (`None`, an empty list) leaves no trace on the page.

mod compose;
mod data;
mod motions;
mod result;
mod strokes;
mod topographies;

pub use compose::{TOPOGRAPHIES, VERIFICATION};
pub use data::{
    Characteristics, ConvergenceRound, DressingMotion, FlankReport, GeneratingReport, GrindingMotion,
    OutsideTerm, RatioCandidate, RatioChoice, Reason, RefereeStage, StrokeReport, TargetAmount, Timing,
    Verification, WrittenFile,
};
pub use motions::grinding_motion_chart;
pub use topographies::{FlankPicture, flank_picture};
