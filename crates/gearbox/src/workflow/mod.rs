//! The electronic gearbox from job to result: pulses of the slide, additional rotation, errors beside their budget, the servo behind
//! it, the choice of a set-up, files.

mod couple;
pub mod derived;
mod explore;
mod figures;
mod following;
mod judge;
mod model;
mod page;
mod remarks;
mod result;
pub mod run;
mod stimulus;
mod summary;
mod tables;
pub mod write;

pub use explore::MOST_SET_UPS;
pub use model::GearboxModel;
pub use result::{
    AlongFeedResult, AngleResult, BestSetUpResult, BudgetResult, CouplingResult, ExploreResult,
    FlankResponseResult, GearboxResult, GearboxSettingsResult, PulseFigures, RangeUm, ServoErrorResult,
    ServoResult, SetUpResult,
};
pub use run::{GearboxOutcome, MOST_TRACED_PULSES, coupling_of_job, run_gearbox};
pub use write::write_gearbox;
