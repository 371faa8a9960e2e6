//! Plans: each result of a job once, whatever time it took.

use flankwright_store::{PlanRecord, digest_of};
use serde_json::{Value, json};

use crate::place::{Place, on_both};

on_both! {
    the_same_result_of_the_same_job_is_one_plan
    a_document_that_is_no_result_is_refused
}

const JOB: &[u8] = b"[job]\nname = \"ring\"\n";

fn document(seconds: f64, error: f64) -> Value {
    json!({ "job": "ring", "status": "met", "version": "0.1.0", "timing_s": { "all": seconds }, "error_um": error })
}

fn the_same_result_of_the_same_job_is_one_plan(place: &Place) {
    let store = place.open();
    let plan = |seconds, error, job| PlanRecord::of_result(document(seconds, error), job).unwrap();
    assert!(store.add_plan(&plan(1.0, 0.1, JOB)).unwrap());
    assert!(!store.add_plan(&plan(2.0, 0.1, JOB)).unwrap());
    assert!(store.add_plan(&plan(1.0, 0.2, JOB)).unwrap());
    assert!(store.add_plan(&plan(1.0, 0.1, b"another job")).unwrap());
    let plans = store.plans().unwrap();
    assert_eq!(plans.len(), 3);
    assert!(plans.is_sorted_by_key(|plan| plan.id));
    assert_eq!(
        (plans[0].job.as_str(), plans[0].status.as_str(), &plans[0].digest),
        ("ring", "met", &digest_of(JOB))
    );
    let found = store.plan(plans[1].id).unwrap().unwrap();
    assert_eq!(found, plan(1.0, 0.2, JOB));
    assert_eq!(store.plan(999).unwrap(), None);
}

fn a_document_that_is_no_result_is_refused(place: &Place) {
    for (key, value) in [("job", json!(7)), ("status", Value::Null), ("version", json!(["0.1.0"]))] {
        let mut wrong = document(1.0, 0.1);
        wrong[key] = value;
        let finding = PlanRecord::of_result(wrong, JOB).unwrap_err().finding();
        assert_eq!((finding.code, finding.field.as_deref()), ("invalid-record", Some(key)));
    }
    let mut wrong = document(1.0, 0.1);
    wrong["status"] = json!("");
    let plan = PlanRecord::of_result(wrong, JOB).unwrap();
    assert_eq!(place.open().add_plan(&plan).unwrap_err().code(), "invalid-record");
}
