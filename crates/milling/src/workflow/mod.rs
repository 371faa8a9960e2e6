//! Five-axis milling from a checked job to its result: bodies and options, the plan, the referee's rays with what was predicted for
//! them, and the files of a run.

mod bladed;
mod bodies;
mod body;
pub mod check;
mod clamping;
mod cylindrical;
pub mod derived;
mod finding;
mod judge;
mod lands;
mod machine_remarks;
mod mate;
mod mate_flank;
mod meshes;
mod model;
mod of_job;
mod orientation;
mod orientation_result;
mod page;
pub mod part_mesh;
mod part_rays;
mod program_result;
pub mod programs;
mod referee;
mod result;
mod root;
pub mod run;
pub mod scene;
mod summary;
mod tables;
mod walls;
mod wear;
mod whole_part;
pub mod whole_program;
pub mod write;

pub use ::run::program_check::{PartProof, ProgramFault};
pub use bodies::{FlankRange, MillingBodies, prepare_milling};
pub use check::{MillingCheck, check_milling};
pub use mate::{MateFlank, MateOutcome};
pub use mate_flank::needed_polar_angle;
pub use model::MillingModel;
pub use of_job::MillingTexts;
pub use orientation::{ComparedOrientations, OrientationCurve, RotaryCourse, rotary_course};
pub use orientation_result::{OrientationFigures, OrientationResult, RotaryFigures};
pub use program_result::{MountTilt, ProgramOperation, ProgramResult};
pub use referee::{RefereedFlank, referee};
pub use result::{
    CutterResult, DistancesResult, FlankResult, MateFlankResult, MateResult, MateStartResult, MillingResult,
    OperationResult, OutOfReachResult, PatternResult, RootDeviationResult, RootResult, RowResult, WearResult,
};
pub use root::{RefereedRoot, referee_root};
pub use run::{MillingOutcome, run_milling};
pub use write::write_milling;
