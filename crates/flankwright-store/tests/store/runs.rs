//! Runs of a server: from the queue to the result with its files, and what a server that is gone leaves.

use flankwright_store::{NewRun, RunEnd, RunFile, RunFileSummary, RunState};
use serde_json::json;

use crate::place::{Place, on_both};

on_both! {
    a_run_goes_from_the_queue_to_its_result
    what_a_dead_server_left_is_interrupted
}

fn new(owner: &str, name: &str) -> NewRun {
    NewRun {
        owner: owner.into(),
        kind: "plan".into(),
        name: name.into(),
        job: format!("[job]\nname = \"{name}\"\n"),
        created: "2026-03-14T09:30:00Z".into(),
    }
}

fn end(state: RunState) -> RunEnd {
    let file = |name: &str, bytes: &[u8]| RunFile { name: name.into(), bytes: bytes.to_vec() };
    RunEnd {
        state,
        ended: "2026-03-14T09:31:00Z".into(),
        document: Some(json!({ "job": "ring", "status": "met" })),
        files: vec![file("result.json", b"{}"), file("programs/work.ngc", &[0, 159, 255])],
    }
}

fn a_run_goes_from_the_queue_to_its_result(place: &Place) {
    let store = place.open();
    let id = store.add_run(&new("desk", "ring")).unwrap();
    let state = || store.run(id).unwrap().unwrap().summary.state;
    assert_eq!(state(), RunState::Queued);
    assert!(store.begin_run(id).unwrap() && !store.begin_run(id).unwrap());
    assert_eq!(state(), RunState::Running);
    assert!(!store.remove_run(id).unwrap());
    assert!(store.end_run(id, &end(RunState::Done)).unwrap());
    // What has ended stays as it is.
    assert!(!store.end_run(id, &end(RunState::Cancelled)).unwrap());
    let run = store.run(id).unwrap().unwrap();
    assert_eq!(
        (run.summary.state, run.summary.ended.as_deref()),
        (RunState::Done, Some("2026-03-14T09:31:00Z"))
    );
    assert_eq!(run.document, end(RunState::Done).document);
    let file = |name: &str, bytes| RunFileSummary { name: name.into(), bytes };
    assert_eq!(run.files, [file("result.json", 2), file("programs/work.ngc", 3)]);
    assert_eq!(store.run_file(id, "programs/work.ngc").unwrap().unwrap().bytes, [0, 159, 255]);
    assert_eq!(store.run_file(id, "../store.sqlite").unwrap(), None);
    let other = store.add_run(&new("desk", "wheel")).unwrap();
    let names: Vec<String> = store.runs(10).unwrap().into_iter().map(|run| run.name).collect();
    assert_eq!(names, ["wheel", "ring"]);
    assert_eq!(store.runs(1).unwrap()[0].id, other);
    assert!(store.remove_run(id).unwrap() && store.run(id).unwrap().is_none());
    assert_eq!(store.run_file(id, "result.json").unwrap(), None);
}

fn what_a_dead_server_left_is_interrupted(place: &Place) {
    let store = place.open();
    let [queued, running, ended, elsewhere] = ["a", "b", "c", "d"]
        .map(|name| store.add_run(&new(if name == "d" { "hall" } else { "desk" }, name)).unwrap());
    assert!(store.begin_run(running).unwrap() && store.begin_run(elsewhere).unwrap());
    assert!(store.end_run(ended, &end(RunState::Failed)).unwrap());
    drop(store);
    let store = place.open();
    assert_eq!(store.interrupt_runs("desk", "2026-03-14T10:00:00Z").unwrap(), 2);
    let state = |id| store.run(id).unwrap().unwrap().summary.state;
    assert_eq!(
        [queued, running, ended, elsewhere].map(state),
        [RunState::Interrupted, RunState::Interrupted, RunState::Failed, RunState::Running]
    );
}
