//! Generating grinding as a process: its job, the plan and its proof, simulation of settings, studies, catalogues of worms and dressers,
//! NC programs, scene and page. The mathematics is that of `generating` and `dressing`.

pub mod catalogue;
pub mod job;
pub mod page;
mod process;
pub mod stock_file;
pub mod workflow;
pub mod worm_file;

pub use process::GeneratingGrinding;
