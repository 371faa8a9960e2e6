//! Measurements that are handed in, and what the store keeps of them.

use crate::client::Served;
use serde_json::json;

#[test]
fn a_table_is_judged_by_its_job() {
    let served = Served::new();
    let job = served.example("inspection/measured");
    let table = include_bytes!("../../../../examples/inspection/measured.csv");
    let answer = served.hand_in(&[("file", "measured.csv", table), ("job", "", job.to_string().as_bytes())]);
    assert_eq!(answer.status, 202, "{}", answer.text());
    let run = served.ended(answer.json()["id"].as_i64().unwrap());
    assert_eq!(
        (&run["state"], &run["kind"], &run["measurements"]),
        (&json!("done"), &json!("inspect"), &json!(["measured.csv"])),
        "{run}"
    );
    let files: Vec<&str> =
        run["files"].as_array().unwrap().iter().map(|f| f["name"].as_str().unwrap()).collect();
    for name in ["sheet.html", "report.html", "corrected-job.json"] {
        assert!(files.contains(&name), "{files:?}");
    }
    // The corrected job is one that the server takes again.
    let corrected = served.get(&format!("/api/runs/{}/files/corrected-job.json", run["id"])).text();
    assert_eq!(served.post("/api/check", &json!({ "text": corrected })).json()["valid"], json!(true));
    let again = served.post(&format!("/api/runs/{}/again", run["id"]), &json!(null)).json();
    assert_eq!(served.ended(again["id"].as_i64().unwrap())["document"]["status"], run["document"]["status"]);
}

#[test]
fn measured_parts_are_kept_and_followed() {
    let served = Served::new();
    let job = served.example("twist-free-crowning");
    let rexs = flankwright_rexs(&job);
    let options = json!({ "class": 6, "keep": true, "series": "pinions" }).to_string();
    let parts = [("file", "pinion.rexsj", rexs.as_bytes()), ("options", "", options.as_bytes())];
    let run = served.ended(served.hand_in(&parts).json()["id"].as_i64().unwrap());
    // A model without measured lines is refused by name; nothing of it is kept.
    assert_eq!(run["state"], "failed", "{run}");
    assert_eq!(served.get("/api/series").json(), json!([]));
    assert_eq!(served.get("/api/parts?series=pinions").json(), json!([]));
    assert_eq!(served.get("/api/trends?series=pinions&name=fHa&flank=left").json(), json!([]));
    assert_eq!(served.get("/api/trends?flank=upper").status, 422);
    assert_eq!(served.get("/api/parts?from=yesterday").status, 422);
    assert_eq!(served.get("/api/parts/none").status, 404);
    assert!(served.get("/api/catalogue").json()["worm"].is_array());
    assert_eq!(served.get("/api/tools").json(), json!([]));
}

/// A REXS model of a job's gear.
fn flankwright_rexs(job: &serde_json::Value) -> String {
    let text = job["text"].as_str().unwrap();
    format!("{{\"model\": {{\"version\": \"1.6\", \"note\": {} }}}}", json!(text))
}

#[test]
fn what_is_no_measurement_is_refused_by_name() {
    let served = Served::new();
    let refused = |parts: &[(&str, &str, &[u8])], code: &str| {
        let answer = served.hand_in(parts);
        assert_eq!((answer.status, answer.code().as_str()), (422, code), "{}", answer.text());
    };
    refused(&[], "invalid-request");
    refused(&[("x", "", b"1")], "invalid-request");
    refused(&[("file", "", b"1")], "invalid-request");
    refused(&[("file", "a.mka", b"1"), ("file", "a.mka", b"1")], "invalid-request");
    refused(&[("file", "a.mka", b"1"), ("options", "", b"{\"class\": 99}")], "invalid-option");
    refused(&[("file", "a.mka", b"1"), ("options", "", b"{\"klass\": 9}")], "invalid-request");
    refused(&[("file", "a.mka", b"1"), ("job", "", b"[]")], "invalid-request");
    for (name, bytes) in [
        ("part.mka", &b"\xff\xfe\x00"[..]),
        ("part.rexsz", b"PK\x03\x04"),
        ("part.rexs", b"<model"),
        ("part.txt", b"hello"),
        ("..\\..\\part.mka", b"1"),
    ] {
        let answer = served.hand_in(&[("file", name, bytes)]);
        assert_eq!(answer.status, 202, "{name}: {}", answer.text());
        let run = served.ended(answer.json()["id"].as_i64().unwrap());
        assert_eq!((&run["state"], &run["failure"]["exit"]), (&json!("failed"), &json!(2)), "{name}: {run}");
    }
}
