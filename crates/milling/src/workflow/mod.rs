//! Five-axis milling from a checked job to its result: preparation, the plan, the referee's rays with what was predicted for them, and
//! the files of a run.

pub mod check;
mod clamping;
pub mod derived;
mod engagement;
mod finding;
mod flank_result;
mod judge;
mod machine_remarks;
mod mate;
mod mate_flank;
mod mate_result;
mod mate_start;
mod meshes;
mod model;
mod orientation;
mod orientation_result;
mod out_of_reach;
pub mod part_mesh;
mod part_rays;
mod plan_remarks;
pub mod prepare;
mod program_result;
pub mod programs;
mod referee;
mod result;
mod root;
pub mod run;
pub mod scene;
mod stock;
mod summary;
mod tables;
mod texts;
mod tool_result;
mod wear;
mod whole_part;
pub mod whole_program;
mod work;
pub mod write;

pub use ::run::program_check::{PartProof, ProgramFault};
pub use check::{MillingCheck, check_milling};
pub use finding::failure as planning_failure;
pub use mate::{MateFlank, MateOutcome, MilledContact};
pub use mate_flank::needed_polar_angle;
pub use mate_result::{MateFlankResult, MateResult, MateStartResult, PatternResult};
pub use model::MillingModel;
pub use orientation::{ComparedOrientations, OrientationCurve, RotaryCourse, rotary_course};
pub use orientation_result::{OrientationFigures, OrientationResult, RotaryFigures};
pub use prepare::{FlankRange, MillingBodies, PreparedMilling, prepare_milling};
pub use program_result::{MountTilt, ProgramOperation, ProgramResult};
pub use referee::{RefereedFlank, deviations_at, referee};
pub use result::{
    CutterResult, DistancesResult, EngagementResult, FlankResult, MillingResult, OperationResult,
    OutOfReachResult, RootDeviationResult, RootResult, RowResult, WearResult,
};
pub use root::{RefereedRoot, referee_root};
pub use run::{MillingOutcome, run_milling};
pub use stock::{StandingStock, StockResult};
pub use texts::MillingTexts;
pub use tool_result::{ClockingResult, HeldAngle, LengthNumbers, ToolResult, WorkOffsetResult};
pub(crate) use wear::histograms;
pub use write::write_milling;
