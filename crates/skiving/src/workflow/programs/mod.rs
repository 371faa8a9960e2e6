//! NC programs that measure a skiving tool in its machine, and their proof: poses at the light barrier or the stylus -> positions of
//! the axes -> text of every control -> read back -> forward kinematics -> where the ideal tool switches (`docs/mathematics/skiving.md`).
//! Nothing leaves this room that was not read back and compared.

mod build;
mod course;
mod failure;
mod judge;
mod measuring;
mod proof;
mod replay;
mod result;
mod room;
mod scan;
mod scan_proof;
mod stand;
mod target;
mod task;
mod text_check;

pub use build::{ToolProgram, measuring_programs, prove_measuring, prove_scan, scan_programs};
pub use measuring::Recording;
pub use proof::Proof;
pub use result::{RecordingResult, ScanResult, ToolProgramResult};
pub use scan::Scanned;
pub use task::{MeasuringWork, Retreat, ScanWork, ToolMachining};
pub use text_check::{TextBlocks, TextJudgement, check_measuring, check_scan, looks_like_scan};
