//! From a job to bodies, plan, proof, files and page: where generating grinding, its referee and its report meet.

pub mod catalogue;
mod changes;
mod conditions;
pub mod control;
pub mod correction_series;
pub mod derived;
pub mod deviated;
pub mod drawn_values;
pub mod dressing_model;
pub mod dressing_study;
pub mod equal_ratio_offers;
pub mod executed_strokes;
pub mod execution;
pub mod explore;
pub mod flank_verdict;
pub mod forward;
pub mod gear_root;
pub mod generating_finding;
pub mod influence;
pub mod line_dressing;
mod machine_fit;
pub mod measured_worm;
mod miss;
pub mod occupation;
pub mod partition;
pub mod prepare;
mod preview;
pub mod programs;
pub mod referee;
pub mod refusal;
pub mod removal;
pub mod result;
mod roughing;
pub mod roughing_pass;
pub mod run;
pub mod scene;
pub mod spared_worms;
pub mod stroke_plan;
mod summary;
pub mod tables;
mod tip_edge;
pub mod tip_land;
pub mod wanted_worm;
pub mod worm_life;
pub mod write;

pub use catalogue::{
    CatalogueLimits, CatalogueOutcome, CataloguePair, FreeOutcome, FreePair, FreePoint, FreeRange, LifeCurve,
    LifePoint, MOST_PAIRS, PAIR_RANKING, PairFlank, PairLife, PlannedPair, plan_from_catalogue,
    rank_catalogue, study_free_worm, wanted_of_catalogue, write_catalogue, write_free_study,
};
pub use changes::try_changes;
pub use conditions::ConditionResult;
pub use control::{ControlFlankResult, ControlResult, ErrorTrace, Trace};
pub use dressing_model::DressingModel;
pub use dressing_study::{
    AxisInfluence, CrowningCurve, CrowningPoint, CurveEnd, DeviationCurve, DeviationQuantile,
    DressingStudyOutcome, ProfileCurve, StrokeCurve, StrokeFigures, StudyCurves, WormCurve, WormPoint,
    study_dressing, write_dressing_study,
};
pub use equal_ratio_offers::{EqualRatioOffer, equal_ratio_offers};
pub use execution::{ExecutedFlank, Execution};
pub use explore::{
    ExploreCandidate, ExploreOutcome, FlankFigures, MOST_COMBINATIONS, RANKING, Refused, explore_job,
    write_exploration,
};
pub use forward::{Deviation, ForwardModel};
pub use gear_root::{FilletResult, FilletSection, GearRootResult};
pub use line_dressing::{LineDressingResult, WrittenFlank};
pub use measured_worm::{MeasuredWormResult, WormAxis};
pub use occupation::occupation_chart;
pub use partition::Partition;
pub use prepare::{Prepared, prepare, setup_of_job, tolerance_of_job};
pub use preview::preview_job;
pub use programs::{
    AxisResult, Built, BuiltProgram, ClearanceResult, DressingWork, GrindingWork, Indexing, PassResult,
    ProgramResult, ProgramTask, ProgramsResult, ProofResult, RunPrograms, WormUse,
};
pub use referee::{StageReport, Verdict};
pub use result::{
    CandidateResult, ChangeResult, DeviatedFlank, DeviatedResult, FlankResult, JobResult, KeyChange,
    SettingsResult,
};
pub use run::{Outcome, plan_job, simulate_job};
pub use spared_worms::{SparedWormsResult, UnderminedResult};
pub use stroke_plan::StrokePlan;
pub use summary::{JobOutcome, controlled, proven};
pub use worm_life::{
    DressingOfLife, PlanOfLife, WormLifeOutcome, WormOfLife, study_worm_life, write_worm_life,
};
pub use write::write_outcome;
