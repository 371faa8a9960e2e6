//! Jobs of five-axis milling from their text to the rays.

mod internal_access;
mod random_gears;
mod root_rays;

use flankwright::exchange::{AnyJob, LoadedMillingJob, Source, parse_any_job};

/// A job that is read without findings.
fn job(text: &str) -> LoadedMillingJob {
    match parse_any_job(Source::new("job.toml", text)) {
        Ok(AnyJob::Milling(loaded)) => loaded,
        Ok(other) => panic!("{other:?}"),
        Err(error) => panic!("{error}\n{text}"),
    }
}
