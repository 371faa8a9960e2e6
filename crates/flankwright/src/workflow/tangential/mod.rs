//! Tangential dressing from job to result: bodies and targets, plan, referee, files. The counterpart of `plan` and `simulate` of
//! generating grinding, whose parts it shares.

mod flank;
mod page;
mod passes;
mod plan;
mod prepare;
mod preview;
mod referee;
mod remarks;
mod result;
mod run;
mod sensitivities;
mod settings;
mod tables;
mod write;

pub use flank::TangentialRun;
pub(super) use passes::{TangentialPass, passes_of_runs};
pub use prepare::{TangentialPrepared, WantedFlank, prepare_tangential};
pub(super) use preview::{PreviewedPass, preview_passes};
pub(super) use referee::{DrivenMotions, referee, worm_rays};
pub use result::{
    ChoiceStep, MethodResult, PassResult, RadialFeedResult, SensitivityResult, SettingsResult,
    TangentialFlankResult, TangentialResult, VariableValue,
};
pub use run::{TangentialOutcome, plan_tangential, simulate_tangential};
pub use write::write_tangential;
