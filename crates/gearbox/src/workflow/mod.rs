//! The electronic gearbox from job to result: pulses of the slide, additional rotation, errors beside their budget, the servo behind
//! it, the choice of a set-up, files.

mod additions;
pub mod derived;
mod explore;
mod figures;
mod finding;
mod following;
mod judge;
mod measuring;
mod model;
pub mod prepare;
mod remarks;
mod result;
pub mod run;
mod summary;
mod tables;
pub mod write;

pub use additions::SplitChange;
pub use model::GearboxModel;
pub use result::{
    AlongFeedResult, AngleResult, BestSetUpResult, BudgetResult, ComparedResult, CorrectionResult,
    CouplingResult, EncoderResult, EngagementResult, ExploreResult, FlankResponseResult, GearboxResult,
    GearboxSettingsResult, MeasuringPart, MeasuringResult, PulseFigures, RangeUm, ServoErrorResult,
    ServoResult, SetUpResult, SplitResult,
};
pub use run::{GearboxOutcome, run_gearbox};
pub use write::write_gearbox;
