//! NC programs that measure a skiving tool in its machine, and their proof: poses at the light barrier or the stylus -> positions of
//! the axes -> text of every control -> read back -> forward kinematics -> where the ideal tool switches (`docs/mathematics/skiving.md`).
//! Nothing leaves this room that was not read back and compared.

mod build;
mod calibration;
mod calibration_proof;
mod course;
mod failure;
mod judge;
mod measuring;
mod probe;
mod probe_proof;
mod proof;
mod replay;
mod result;
mod room;
mod scan;
mod scan_proof;
mod skive;
mod skive_proof;
mod stand;
mod target;
mod task;
mod text_check;

pub use build::{
    ToolProgram, calibration_programs, measuring_programs, probe_programs, prove_measuring, prove_scan,
    scan_programs, skiving_programs,
};
pub use calibration::MandrelWay;
pub use measuring::Recording;
pub use probe::ProbedProfile;
pub use proof::Proof;
pub use result::{MandrelWayResult, ProbedProfileResult, RecordingResult, ScanResult, ToolProgramResult};
pub use scan::Scanned;
pub use task::{
    CalibrationWork, Carried, Carrier, MeasuringWork, ProbeWork, Retreat, ScanWork, SkivingWork,
    ToolMachining,
};
pub use text_check::{
    TextBlocks, TextJudgement, check_calibration, check_measuring, check_probe, check_scan, check_skiving,
    looks_like_calibration, looks_like_probe, looks_like_scan,
};
