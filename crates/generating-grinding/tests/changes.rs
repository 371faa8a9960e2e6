//! What would meet a target that its plan misses: found by planning changes of the job.

use foundation::numerics::Silent;
use generating_grinding::job::{Job, LoadedJob};
use generating_grinding::workflow::{Outcome, plan_job, try_changes};
use job::read_job_of;
use serde_json::json;
use std::path::Path;
use verdict::Status;

fn radial() -> LoadedJob {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/radial-feed-crowning.toml");
    let mut loaded = read_job_of::<Job>(Path::new(file)).unwrap();
    loaded.job.machine = None;
    loaded
}

fn tried(loaded: &LoadedJob) -> Outcome {
    let mut outcome = plan_job(loaded, &Silent).unwrap();
    try_changes(loaded, &mut outcome, &Silent);
    outcome
}

#[test]
fn the_way_out_of_a_miss_is_a_change_that_was_planned() {
    let mut loaded = radial();
    let outcome = tried(&loaded);
    let [change] = outcome.result.changes.as_slice() else { panic!("{:?}", outcome.result.changes) };
    assert_eq!((change.status, change.jobs.len()), (Some(Status::Met), 1));
    assert_eq!(change.keys(), "`grinding.method = \"diagonal\"`");
    let reason = outcome.result.verdict.reason().unwrap();
    assert_eq!(reason.code, "natural-twist");
    assert!(reason.way_out.starts_with("Set `grinding.method = \"diagonal\"`"), "{}", reason.way_out);
    // What was tried is what the changed job does.
    let word = serde_json::from_value(json!("diagonal")).unwrap();
    loaded.job.grinding.method = word;
    let changed = plan_job(&loaded, &Silent).unwrap();
    assert_eq!(changed.result.verdict.status(), Status::Met);
    let largest = changed.result.flanks.values().map(|flank| flank.max_deviation_um).fold(0.0, f64::max);
    assert!((largest - change.deviation_um.unwrap()).abs() < 1e-9, "{largest} {change:?}");
}

#[test]
fn no_change_is_tried_where_none_is_wanted_or_needed() {
    let mut loaded = radial();
    loaded.job.grinding.try_changes = Some(false);
    assert_eq!(tried(&loaded).result.changes, []);
    loaded.job.grinding.try_changes = None;
    loaded.job.target.tolerance_um = 100.0;
    let outcome = tried(&loaded);
    assert_eq!((outcome.result.changes.len(), outcome.result.verdict.status()), (0, Status::Met));
}
