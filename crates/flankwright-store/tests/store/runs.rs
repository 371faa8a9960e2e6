//! Runs of a server: from the queue to the result with its files, and what a server that is gone leaves.

use std::time::Duration;

use flankwright::workflow::Task;
use flankwright_store::{NewRun, RunEnd, RunFile, RunFileSummary, RunState};
use serde_json::json;

use crate::place::{Place, on_both};

on_both! {
    a_run_goes_from_the_queue_to_its_result
    what_servers_left_is_interrupted
}

fn new(owner: &str, name: &str) -> NewRun {
    NewRun {
        owner: owner.into(),
        kind: Task::Plan,
        name: name.into(),
        job: format!("[job]\nname = \"{name}\"\n"),
        created: "2026-03-14T09:30:00Z".into(),
        files: vec![RunFile { name: "result.json".into(), bytes: b"handed in".to_vec() }],
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
    assert_eq!(run.summary.status.as_deref(), Some("met"));
    assert_eq!(store.run_inputs(id).unwrap(), new("desk", "ring").files);
    assert_eq!(store.run_input_names(id).unwrap(), ["result.json"]);
    assert_eq!(store.run_file(id, "result.json").unwrap().unwrap().bytes, b"{}");
    assert_eq!(store.run_file(id, "../store.sqlite").unwrap(), None);
    let other = store.add_run(&new("desk", "wheel")).unwrap();
    let names: Vec<String> = store.runs(10).unwrap().into_iter().map(|run| run.name).collect();
    assert_eq!(names, ["wheel", "ring"]);
    assert_eq!(store.runs(1).unwrap()[0].id, other);
    assert!(store.remove_run(id).unwrap() && store.run(id).unwrap().is_none());
    assert_eq!(store.run_file(id, "result.json").unwrap(), None);
    // The number of a run that was taken out is not given again.
    assert!(store.begin_run(other).unwrap() && store.end_run(other, &end(RunState::Cancelled)).unwrap());
    assert!(store.remove_run(other).unwrap());
    assert!(store.add_run(&new("desk", "wheel")).unwrap() > other);
}

fn what_servers_left_is_interrupted(place: &Place) {
    const LONG: Duration = Duration::from_secs(3600);
    let now = "2026-03-14T10:00:00Z";
    let store = place.open();
    for owner in ["desk", "hall"] {
        assert_eq!(store.beat(owner, &[], LONG, now).unwrap(), 0);
    }
    let [queued, running, ended, elsewhere] = ["a", "b", "c", "d"]
        .map(|name| store.add_run(&new(if name == "d" { "hall" } else { "desk" }, name)).unwrap());
    assert!(store.begin_run(running).unwrap() && store.begin_run(elsewhere).unwrap());
    assert!(store.end_run(ended, &end(RunState::Failed)).unwrap());
    drop(store);
    let store = place.open();
    let state = |id| store.run_summary(id).unwrap().unwrap().state;
    // One that is known to be gone.
    assert_eq!(store.beat("new", &["desk".into()], LONG, now).unwrap(), 2);
    assert_eq!(
        [queued, running, ended, elsewhere].map(state),
        [RunState::Interrupted, RunState::Interrupted, RunState::Failed, RunState::Running]
    );
    assert!(!store.end_run(running, &end(RunState::Done)).unwrap());
    // One that is not heard of any more; who beats is there.
    std::thread::sleep(Duration::from_millis(2100));
    let own = store.add_run(&new("new", "e")).unwrap();
    let beat = || store.beat("new", &[], Duration::from_secs(1), now).unwrap();
    assert_eq!(beat(), 0, "it was asleep itself");
    assert_eq!(beat(), 1);
    assert_eq!([elsewhere, own].map(state), [RunState::Interrupted, RunState::Queued]);
    // One that says farewell.
    assert_eq!(store.leave("new", now).unwrap(), 1);
    assert_eq!(state(own), RunState::Interrupted);
    assert_eq!(store.run_summary(own + 1).unwrap(), None);
}
