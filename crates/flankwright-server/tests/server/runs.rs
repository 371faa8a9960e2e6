//! Runs: events, results, cancelling, again, a bounded queue.

use std::io::Write;
use std::net::TcpStream;
use std::thread;
use std::time::{Duration, Instant};

use crate::client::Served;
use serde_json::{Value, json};

/// Names of the charts of the example, by which clients ask for them: they stay whatever the titles say.
const CHARTS: [&str; 27] = [
    "deviation-of-the-flanks",
    "areas-over-the-width-of-the-tool",
    "target",
    "target-contour-map",
    "planned-analytic",
    "planned-analytic-contour-map",
    "simulated-referee",
    "simulated-referee-contour-map",
    "deviation-from-the-target",
    "deviation-from-the-target-contour-map",
    "profile-and-helix-diagram",
    "grinding-motion-over-the-axial-feed",
    "dressing-corrections-over-the-worm-position",
    "dressing-the-left-flank-section-through-the-thread-space",
    "dressing-the-right-flank-section-through-the-thread-space",
    "dressing-axis-x1-word-x",
    "dressing-axis-z1-word-z",
    "dressing-axis-a1-word-a",
    "dressing-axis-v1-word-y",
    "dressing-axis-b1-word-b",
    "grinding-axis-x1-word-x",
    "grinding-axis-z1-word-z",
    "grinding-axis-v1-word-y",
    "grinding-axis-b1-word-b",
    "grinding-axis-c2-word-c",
    "deviation-over-used-worm-width",
    "convergence-of-the-precompensation",
];

#[test]
fn a_run_tells_how_far_it_is_and_leaves_its_files() {
    let served = Served::new();
    let id = served.begin("plan", &served.example("twist-free-crowning"));
    let events = served.get(&format!("/api/runs/{id}/events"));
    assert_eq!(events.header("content-type"), Some("text/event-stream"));
    let told = events.text();
    for line in ["event: progress", "\"stage\":\"grinding\"", "\"state\":\"done\""] {
        assert!(told.contains(line), "{told}");
    }
    assert!(told.trim_end().ends_with("{\"state\":\"done\"}"), "the stream ends with the run");
    // Who comes late is told the end.
    assert!(served.get(&format!("/api/runs/{id}/events")).text().contains("\"state\":\"done\""));
    let run = served.ended(id);
    assert_eq!((&run["status"], &run["document"]["status"]), (&json!("met"), &json!("met")));
    let files: Vec<&str> =
        run["files"].as_array().unwrap().iter().map(|f| f["name"].as_str().unwrap()).collect();
    for name in ["result.json", "report.html", "topography.csv", "motions/grinding.csv"] {
        assert!(files.contains(&name), "{files:?}");
    }
    let report = served.get(&format!("/api/runs/{id}/files/report.html"));
    assert!(report.header("content-security-policy").unwrap().starts_with("sandbox; default-src 'none'"));
    for name in files {
        let file = served.get(&format!("/api/runs/{id}/files/{name}?download=true"));
        assert!(file.header("content-disposition").unwrap().starts_with("attachment"), "{name}");
        assert!(!file.text().contains("flankwright-"), "{name} names the folder of the run");
    }
    assert_eq!(run["scene"], true);
    let scene = served.get(&format!("/api/runs/{id}/scene"));
    assert_eq!((scene.header("content-encoding"), &scene.body[..2]), (Some("gzip"), &b"\x1f\x8b"[..]));
    let charts: Vec<&str> =
        run["charts"].as_array().unwrap().iter().map(|c| c["name"].as_str().unwrap()).collect();
    assert_eq!(charts, CHARTS);
    let last = run["charts"].as_array().unwrap().last().unwrap();
    assert_eq!(
        (&last["title"], &last["section"]),
        (&json!("Convergence of the precompensation"), &json!("Convergence of the precompensation"))
    );
    for name in charts {
        assert!(served.get(&format!("/api/runs/{id}/charts/{name}")).text().starts_with("<svg"));
    }
    assert_eq!(served.get(&format!("/api/runs/{id}/charts/none")).status, 404);
    assert_eq!(&served.get(&format!("/api/runs/{id}/archive")).body[..4], b"PK\x03\x04");
    for name in ["..%2F..%2Fstore.sqlite", ".scene.json.gz", ".charts.json"] {
        assert_eq!(served.get(&format!("/api/runs/{id}/files/{name}")).status, 404, "{name}");
    }
}

#[test]
fn a_job_that_is_wrong_fails_with_its_findings() {
    let served = Served::new();
    let text =
        served.example("twist-free-crowning")["text"].as_str().unwrap().replace("teeth = ", "teeth = 0 #");
    let run = served.ended(served.begin("plan", &json!({ "text": text })));
    assert_eq!((&run["state"], &run["failure"]["exit"]), (&json!("failed"), &json!(2)));
    assert_eq!(run["failure"]["errors"][0]["field"], "gear.teeth");
    let run = served.ended(served.begin("simulate", &served.example("milling/blisk-blade")));
    assert_eq!(run["failure"]["errors"][0]["code"], "process-not-available");
}

#[test]
fn a_run_is_cancelled_and_begun_again() {
    let served = Served::new();
    let long = served.example("catalogue-free-diameter");
    let id = served.begin("explore", &long);
    let state = served.post(&format!("/api/runs/{id}/cancel"), &Value::Null).json();
    assert!(["queued", "running", "cancelled"].contains(&state["state"].as_str().unwrap()), "{state}");
    let run = served.ended(id);
    assert_eq!(run["state"], "cancelled");
    assert!(run["document"].is_null() && run["files"].as_array().unwrap().is_empty());
    // Its thread is free again.
    let short = served.begin("plan", &served.example("gearbox/reference-train"));
    assert_eq!(served.ended(short)["state"], "done");
    let again = served.post(&format!("/api/runs/{short}/again"), &Value::Null).json()["id"].as_i64().unwrap();
    assert_ne!(again, short);
    let (first, second) = (served.ended(short), served.ended(again));
    // Who has it already need not read it again.
    let path = format!("/api/runs/{again}");
    let tag = served.get(&path).header("etag").unwrap().to_owned();
    let known = |tag: &str| served.ask("GET", &path, &[("If-None-Match", tag)], b"");
    assert_eq!((known(&tag).status, known(&tag).body.len(), known("\"x\"").status), (304, 0, 200));
    assert_eq!((&first["job"], &second["state"]), (&second["job"], &json!("done")));
    assert_eq!(served.ask("DELETE", &format!("/api/runs/{short}"), &[], b"").status, 204);
    assert_eq!(served.get(&format!("/api/runs/{short}")).status, 404);
    assert_eq!(served.post(&format!("/api/runs/{short}/again"), &Value::Null).status, 404);
    // What has ended is not cancelled any more.
    assert_eq!(served.post(&format!("/api/runs/{again}/cancel"), &Value::Null).json()["state"], "done");
}

#[test]
fn the_queue_is_bounded_and_a_run_that_waits_can_be_taken_back() {
    let served = Served::new();
    let long = served.example("catalogue-free-diameter");
    let mut begun = Vec::new();
    let full = loop {
        let answer = served.post("/api/runs", &json!({ "kind": "explore", "job": long }));
        if answer.status != 202 {
            break answer;
        }
        begun.push(answer.json()["id"].as_i64().unwrap());
        assert!(begun.len() < 100, "the queue has no end");
    };
    assert_eq!((full.status, full.code().as_str()), (429, "queue-full"));
    let queue = served.get("/api/about").json()["queue"].clone();
    assert_eq!(queue["waiting"], queue["most"]);
    // Who leaves the queue makes room at once.
    let left = begun.remove(begun.len() / 2);
    assert_eq!(served.post(&format!("/api/runs/{left}/cancel"), &Value::Null).json()["state"], "cancelled");
    begun.push(served.begin("explore", &long));
    let last = *begun.last().unwrap();
    assert_eq!(served.ask("DELETE", &format!("/api/runs/{last}"), &[], b"").status, 409);
    for id in begun.iter().rev() {
        served.post(&format!("/api/runs/{id}/cancel"), &Value::Null);
    }
    for id in begun {
        assert_eq!(served.ended(id)["state"], "cancelled");
    }
    let runs = served.get("/api/runs?most=3").json();
    assert_eq!(runs.as_array().unwrap().len(), 3);
    assert_eq!(served.get("/api/runs?most=0").status, 422);
}

#[test]
fn the_history_of_a_tool_comes_back_with_its_line() {
    let served = Served::new();
    let mut job = served.example("skiving/worn-tool");
    let history = job["files"]["history.jsonl"].as_str().unwrap().trim_end().to_owned();
    // Without its last line, which is that of this measurement.
    let (before, _) = history.rsplit_once('\n').unwrap();
    job["files"]["history.jsonl"] = json!(format!("{before}\n"));
    let run = served.ended(served.begin("plan", &job));
    let after = served.get(&format!("/api/runs/{}/files/history.jsonl", run["id"])).text();
    assert_eq!(after.lines().count(), history.lines().count(), "{after}");
    assert!(after.starts_with(before));
}

#[test]
fn a_run_whose_client_vanishes_is_carried_out() {
    let served = Served::new();
    let job = served.example("gearbox/reference-train");
    let body = json!({ "kind": "plan", "job": job }).to_string();
    let request = format!(
        "POST /api/runs HTTP/1.1\r\nHost: {}\r\nContent-Type: application/json\r\nContent-Length: {}\r\n\r\n{body}",
        served.address,
        body.len()
    );
    const CLIENTS: usize = 8;
    for _ in 0..CLIENTS {
        TcpStream::connect(served.address).unwrap().write_all(request.as_bytes()).unwrap();
    }
    // Whether the server has read a request before its client was gone is chance; what it took in, it ends.
    let begun = Instant::now();
    loop {
        let runs = served.get("/api/runs").json();
        let states: Vec<&str> =
            runs.as_array().unwrap().iter().map(|run| run["state"].as_str().unwrap()).collect();
        if begun.elapsed() > Duration::from_secs(2) && states.iter().all(|state| *state == "done") {
            assert!(states.len() <= CLIENTS);
            if !states.is_empty() {
                break;
            }
            // None was read in time: once more.
            TcpStream::connect(served.address).unwrap().write_all(request.as_bytes()).unwrap();
        }
        assert!(begun.elapsed() < Duration::from_secs(60), "{states:?}");
        thread::sleep(Duration::from_millis(50));
    }
    assert_eq!(served.get("/api/about").json()["queue"]["waiting"], 0);
}

#[test]
fn servers_with_one_store_leave_each_others_runs_alone() {
    let first = Served::new();
    let long = first.begin("explore", &first.example("catalogue-free-diameter"));
    let second = first.beside();
    let state = |at: &Served| at.get(&format!("/api/runs/{long}")).json()["state"].clone();
    assert!(["queued", "running"].contains(&state(&second).as_str().unwrap()));
    let refused = second.post(&format!("/api/runs/{long}/cancel"), &Value::Null);
    assert_eq!((refused.status, refused.code().as_str()), (409, "run-elsewhere"));
    let short = second.begin("plan", &second.example("gearbox/reference-train"));
    assert_eq!(second.ended(short)["state"], "done");
    assert_eq!(first.ended(short)["document"], second.ended(short)["document"]);
    // Whoever listens at the other one is told the end as well.
    let told = thread::scope(|scope| {
        let listener = scope.spawn(|| second.get(&format!("/api/runs/{long}/events")).text());
        first.post(&format!("/api/runs/{long}/cancel"), &Value::Null);
        listener.join().unwrap()
    });
    assert!(told.trim_end().ends_with("{\"state\":\"cancelled\"}"), "{told}");
    assert_eq!(second.ended(long)["state"], "cancelled");
    assert_eq!(second.post("/api/runs/99/cancel", &Value::Null).status, 404);
}

#[test]
fn previews_do_not_wait_for_runs() {
    let served = Served::new();
    let request = json!({ "job": served.example("twist-free-crowning"), "charts": ["planned"] });
    let preview = || {
        let begun = Instant::now();
        assert_eq!(served.post("/api/preview", &request).status, 200);
        begun.elapsed()
    };
    preview();
    let long = served.example("catalogue-free-diameter");
    let runs: Vec<i64> = (0..2).map(|_| served.begin("explore", &long)).collect();
    while served.get("/api/about").json()["queue"]["running"] != 2 {
        thread::sleep(Duration::from_millis(20));
    }
    preview();
    let state = served.get(&format!("/api/runs/{}", runs[0])).json()["state"].clone();
    assert_eq!(state, "running", "the preview came when the study was over");
    for id in runs {
        served.post(&format!("/api/runs/{id}/cancel"), &Value::Null);
    }
}

/// A job that its bodies cannot make fails with its reason, and its report stands beside it with the picture of what limits.
#[test]
fn a_refused_run_offers_its_report() {
    let served = Served::new();
    let mut job = served.example("twist-free-crowning");
    job["text"] = job["text"].as_str().unwrap().replace("\nwidth = 100.0", "\nwidth = 20.0").into();
    let id = served.begin("plan", &job);
    let run = served.ended(id);
    assert_eq!((&run["state"], &run["failure"]["exit"]), (&json!("failed"), &json!(4)), "{run}");
    assert_eq!(run["failure"]["errors"][0]["code"], "worm-too-short");
    let files: Vec<&str> =
        run["files"].as_array().unwrap().iter().map(|f| f["name"].as_str().unwrap()).collect();
    assert_eq!(files, ["report.html", "result.json"]);
    let report = served.get(&format!("/api/runs/{id}/files/report.html"));
    assert!(report.header("content-security-policy").unwrap().starts_with("sandbox; default-src 'none'"));
    for part in ["not producible", "What limits", "Candidates tried", "Bodies"] {
        assert!(report.text().contains(part), "{part}");
    }
    assert!(!report.text().contains("flankwright-"), "the report names the folder of the run");
    let charts: Vec<&str> =
        run["charts"].as_array().unwrap().iter().map(|c| c["name"].as_str().unwrap()).collect();
    assert_eq!(charts, ["width-of-the-worm-that-each-diagonal-ratio-needs", "reach-of-the-worm"]);
    for name in charts {
        assert!(served.get(&format!("/api/runs/{id}/charts/{name}")).text().starts_with("<svg"), "{name}");
    }
    assert_eq!(&served.get(&format!("/api/runs/{id}/archive")).body[..4], b"PK\x03\x04");
}
