//! What runs of all processes share. [`Process`] is what a process brings, [`Processes`] the registry that command, server and Python ask;
//! here are also tasks and what they come to, findings on keys of a job, files as one set, previews, refusals, and what a program does
//! on a machine. Knows no process.

pub mod cancel;
mod characteristics;
pub mod control;
pub mod derived;
mod document;
pub mod elsewhere;
pub mod face_names;
pub mod files;
pub mod finding;
pub mod finish;
pub mod gear;
pub mod modified_flank;
mod outcome;
pub mod output_set;
pub mod output_warnings;
pub mod preview;
mod process;
mod processes;
pub mod program_check;
pub mod refusal;
pub mod release;
pub mod report_head;
pub mod summary;
pub mod task;

pub use characteristics::{CharacteristicsUm, reported};
pub use derived::{DerivedGeometry, DerivedQuantity, DerivedSection};
pub use document::DocumentFormat;
pub use elsewhere::standing_elsewhere;
pub use face_names::face_names_remark;
pub use files::{NamedFile, WriteError, json, write_study, write_with_report};
pub use finding::{JobFailure, Remark, RunFailure, geometry_finding, modification_finding};
pub use finish::{finished, unmeshed};
pub use gear::{blank_of_job, gear_of_job, job_files, specs_of_flank};
pub use modified_flank::ModifiedFlank;
pub use outcome::{Carried, Conclusion, FlankMaps, JobOutcome, TaskOutcome, complaint};
pub use output_set::{SetFile, write_set};
pub use output_warnings::{output_warnings, parquet_warning};
pub use preview::{Preview, PreviewChart, PreviewFlank};
pub use process::{AnyProcess, Process};
pub use processes::Processes;
pub use refusal::{Evidence, RefusedResult, write_refusal};
pub use release::Release;
pub use report_head::{Answer, report_head, sentence};
pub use task::Task;
