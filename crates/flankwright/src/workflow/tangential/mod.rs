//! Tangential dressing from job to result: bodies and targets, plan, referee, files. The counterpart of `plan` and `simulate` of
//! generating grinding, whose parts it shares.

mod page;
mod plan;
mod prepare;
mod referee;
mod result;
mod run;
mod tables;
mod write;

pub use prepare::{TangentialPrepared, WantedFlank, prepare_tangential};
pub use result::{
    ChoiceStep, MethodResult, PassResult, RadialFeedResult, SensitivityResult, SettingsResult,
    TangentialFlankResult, TangentialResult, VariableValue,
};
pub use run::{TangentialOutcome, TangentialRun, plan_tangential, simulate_tangential};
pub use write::write_tangential;
