//! Tangential dressing from job to result: bodies and targets, plan, referee, files. The counterpart of `plan` and `simulate` of
//! generating grinding, whose parts it shares.

pub mod control;
pub mod derived;
pub mod explore;
mod finding;
mod flank;
pub mod followed;
mod passes;
mod plan;
pub mod prepare;
pub mod preview;
pub mod previewed;
pub mod programs;
mod referee;
mod remarks;
mod result;
pub mod run;
pub mod scene;
mod sensitivities;
mod settings;
mod summary;
mod tables;
pub mod write;

pub use explore::{TangentialExploration, explore_tangential};
pub use flank::TangentialRun;
pub use passes::{TangentialPass, passes_of_runs};
pub use prepare::{TangentialPrepared, WantedFlank, prepare_tangential};
pub use referee::{DrivenMotions, referee, worm_rays};
pub use result::{
    ChoiceStep, MethodResult, PassResult, RadialFeedResult, SensitivityResult, SettingsResult,
    TangentialFlankResult, TangentialResult, VariableValue,
};
pub use run::{TangentialOutcome, plan_tangential, simulate_tangential};
pub use summary::TangentialJobOutcome;
pub use write::write_tangential;
