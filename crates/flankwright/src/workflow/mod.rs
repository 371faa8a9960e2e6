//! Plan, simulate and verify: the only room where processes, referee and reports meet; what command, server and Python
//! call. Knows every layer below, and no user interface.

pub mod cancel;
mod catalogue;
mod control;
mod convert;
mod derived;
mod dressing_model;
mod dressing_study;
mod elsewhere;
mod equal_ratio_offers;
mod executed_strokes;
mod execution;
mod explore;
mod face_names;
mod finding;
mod flank_verdict;
mod forward;
mod gear_root;
pub mod gearbox;
mod influence;
pub mod inspection;
mod line_dressing;
pub mod milling;
mod miss;
mod modified_flank;
mod occupation;
mod output_set;
mod page;
mod partition;
mod prepare;
mod preview;
mod programs;
mod referee;
mod refusal;
mod release;
mod report_head;
mod result;
mod run;
pub mod scene;
mod shift;
pub mod skiving;
mod strokes;
mod tables;
pub mod tangential;
mod task;
mod tip_edge;
mod tip_land;
mod write;

pub use catalogue::{
    CatalogueLimits, CatalogueOutcome, CataloguePair, CataloguePlan, FreeOutcome, FreePair, FreePoint,
    FreeRange, LifeCurve, LifePoint, MOST_PAIRS, PAIR_RANKING, PairFlank, PairLife, plan_from_catalogue,
    rank_catalogue, study_free_worm, wanted_of_catalogue, write_catalogue, write_free_study,
};
pub use control::{ControlFlankResult, ControlResult, ErrorTrace, Trace};
pub use convert::{GearOfRexs, gear_of_rexs, rexs_of_job};
pub use derived::{DerivedGeometry, DerivedQuantity, DerivedSection, derived_geometry};
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
pub use finding::{JobFailure, Remark, RunFailure};
pub use forward::{Deviation, ForwardModel};
pub use gear_root::{FilletResult, FilletSection, GearRootResult};
pub use line_dressing::{LineDressingResult, WrittenFlank};
pub use occupation::occupation_chart;
pub use partition::{Partition, StrokePlan};
pub use prepare::{Prepared, blank_of_job, gear_of_job, prepare, setup_of_job, tolerance_of_job};
pub use preview::{Preview, PreviewChart, PreviewFlank, preview_job};
pub use programs::{
    AxisResult, BodyClearance, Built, BuiltProgram, CheckedAxis, CheckedFlank, CheckedMeasuring,
    CheckedProgram, CheckedStroke, ClearanceResult, DressingWork, GrindingWork, Indexing, PassResult,
    ProgramChecker, ProgramResult, ProgramTask, ProgramsResult, ProofResult, RunPrograms, ThreadProof,
    WormUse, check_program,
};
pub use referee::{StageReport, Verdict};
pub use refusal::write_refusal;
pub use result::{CandidateResult, CharacteristicsUm, FlankResult, JobResult, SettingsResult, Status};
pub use run::{Outcome, plan_job, simulate_job};
pub use task::{Completed, Task, carry_out};
pub use write::{WriteError, write_outcome};
