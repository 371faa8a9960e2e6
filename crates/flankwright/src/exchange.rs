//! Files of jobs, bodies and measured gears. Jobs of any process are read by the registry of [`crate::processes`].

pub use ::gearbox::job::{GearboxJob, LoadedGearboxJob};
pub use ::gearbox::{ReferenceTrain, parse_reference_train, read_reference_train};
pub use ::job::*;
pub use ::milling::job::{LoadedMillingJob, MillingJob};
pub use ::scene::mesh;
pub use ::skiving::history as skiving_history;
pub use ::skiving::job::{LoadedSkivingJob, SkivingJob};
pub use ::skiving::probe_readings::{ProbeValue, parse_probe_values, probe_table, read_probe_values};
pub use ::skiving::readings::{parse_skiving_readings, read_skiving_readings, readings_table};
pub use ::tangential_dressing::job::{LoadedTangentialJob, TangentialJob};
pub use generating_grinding::catalogue;
pub use generating_grinding::job::{Job, LoadedJob};
pub use generating_grinding::stock_file::{MeasuredStock, StockTable, parse_stock, read_stock, stock_table};
pub use generating_grinding::worm_file::{WormPoints, parse_measured_worm, read_measured_worm};
pub use measured_files::{inspection, rexs};

use crate::processes;
use serde_json::Value;
use std::path::Path;

/// Tables of the job of generating grinding, and those that jobs of several processes share.
pub mod job {
    pub use ::job::tables::*;
    pub use generating_grinding::job::*;
}

/// Tables of the job of tangential dressing.
pub mod tangential_job {
    pub use ::tangential_dressing::job::*;
}

/// Tables of the job of the electronic gearbox.
pub mod gearbox_job {
    pub use ::gearbox::job::*;
}

/// Tables of the job of five-axis milling.
pub mod milling_job {
    pub use ::milling::job::*;
}

/// Tables of the job of measuring a skiving tool.
pub mod skiving_job {
    pub use ::skiving::job::*;
}

/// Reads, parses and checks a job file (TOML or JSON) of any process.
///
/// # Errors
/// All findings of the first stage that has any: text, process, keys and types and ranges, contradictions.
pub fn read_any_job(path: &Path) -> Result<AnyJob, JobError> {
    processes().formats().read(path)
}

/// As [`read_any_job`], from a text.
///
/// # Errors
/// As [`read_any_job`].
pub fn parse_any_job(source: Source) -> Result<AnyJob, JobError> {
    processes().formats().parse(source)
}

/// Reads, parses and checks a job file of generating grinding (TOML or JSON).
///
/// # Errors
/// As [`read_any_job`]; `process-not-available` for a job of another process.
pub fn read_job(path: &Path) -> Result<LoadedJob, JobError> {
    read_job_of(path)
}

/// As [`read_job`], from a text.
///
/// # Errors
/// As [`read_job`].
pub fn parse_job(source: Source) -> Result<LoadedJob, JobError> {
    parse_job_of(source)
}

/// The schema of the job file, JSON Schema draft 2020-12: every job has a table `job`, and its process decides which other tables there
/// are.
pub fn job_schema() -> Value {
    processes().formats().schema().clone()
}

/// A runnable job of a process with a comment on every key, by the name of the process.
pub fn job_template(process: &str) -> Option<&'static str> {
    processes().formats().format(process).map(|format| format.template)
}
