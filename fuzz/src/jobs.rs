//! Job files of every process, as TOML and as JSON.

use flankwright::exchange::{AnyJob, Source, parse_any_job};

use crate::complaints::taken;

/// The text decides between TOML and JSON.
pub fn job(data: &[u8]) {
    let Some(job) = taken(Source::from_bytes("job", data).and_then(parse_any_job)) else { return };
    let text = json(&job);
    let back =
        parse_any_job(Source::new("job.json", &text)).unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert_eq!(json(&back), text);
}

fn json(job: &AnyJob) -> String {
    job.to_json().expect("a job as JSON")
}
