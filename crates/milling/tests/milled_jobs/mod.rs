//! Jobs of five-axis milling from their text to the rays.

mod internal_access;
mod random_gears;
mod root_rays;

use job::{Source, parse_job_of};
use milling::job::{LoadedMillingJob, MillingJob};

/// A job that is read without findings.
fn job(text: &str) -> LoadedMillingJob {
    match parse_job_of::<MillingJob>(Source::new("job.toml", text)) {
        Ok(loaded) => loaded,
        Err(error) => panic!("{error}\n{text}"),
    }
}
