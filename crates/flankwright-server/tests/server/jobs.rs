//! Jobs: examples, checks, edits, previews.

use crate::client::Served;
use serde_json::json;

#[test]
fn every_example_and_template_is_valid() {
    let served = Served::new();
    let examples = served.get("/api/examples").json();
    let examples = examples.as_array().unwrap();
    assert!(examples.len() > 60 && examples[0]["id"] == "twist-free-crowning");
    for example in examples {
        let id = example["id"].as_str().unwrap();
        let answer = served.post("/api/check", &served.example(id)).json();
        assert_eq!(
            (&answer["valid"], &answer["process"]),
            (&json!(true), &example["process"]),
            "{id}: {answer}"
        );
        assert!(!answer["derived"].as_array().unwrap().is_empty(), "{id}");
        assert_eq!(answer["tree"]["job"]["name"], example["name"]);
    }
    for process in served.get("/api/about").json()["processes"].as_array().unwrap() {
        let text = served.get(&format!("/api/templates/{}", process["name"].as_str().unwrap())).json();
        assert_eq!(served.post("/api/check", &text).json()["valid"], json!(true), "{process}");
    }
    for absent in ["examples/none", "examples/../Cargo", "templates/none", "machines/none", "none"] {
        assert_eq!(served.get(&format!("/api/{absent}")).status, 404, "{absent}");
    }
}

#[test]
fn a_finding_names_its_field_and_its_place() {
    let served = Served::new();
    let mut job = served.example("twist-free-crowning");
    let text = job["text"].as_str().unwrap().replace("helix_angle_deg", "helix_angel_deg");
    // Units of UTF-16: what stands before counts as a browser counts it.
    let text = format!("# \u{1d6fd} und µm\n{text}");
    job["text"] = json!(text);
    let answer = served.post("/api/check", &job).json();
    assert_eq!(answer["valid"], false);
    let finding =
        answer["findings"].as_array().unwrap().iter().find(|finding| finding["code"] == "unknown-key");
    let finding = finding.unwrap_or_else(|| panic!("{answer}"));
    assert!(finding["way_out"].as_str().unwrap().contains("helix_angle_deg"), "{finding}");
    let units: Vec<u16> = text.encode_utf16().collect();
    let [start, end] = ["start", "end"].map(|key| usize::try_from(finding[key].as_u64().unwrap()).unwrap());
    assert_eq!(String::from_utf16(&units[start..end]).unwrap(), "helix_angel_deg");
    let line = finding["line"].as_u64().unwrap() as usize;
    assert!(text.lines().nth(line - 1).unwrap().starts_with("helix_angel_deg"));
    assert!(
        answer["tree"]["gear"]["teeth"].is_number(),
        "the tree is there as long as the text can be parsed"
    );
}

#[test]
fn edits_keep_comments() {
    let served = Served::new();
    let text = served.example("twist-free-crowning")["text"].clone();
    let edits = json!([{ "path": ["target", "modifications", 0, "amount_um"], "value": 40 }]);
    let answer = served.post("/api/edit", &json!({ "text": text, "edits": edits })).json();
    assert_eq!(answer["tree"]["target"]["modifications"][0]["amount_um"], 40);
    let (before, after) =
        (text.as_str().unwrap().lines().count(), answer["text"].as_str().unwrap().lines().count());
    assert_eq!(before, after);
    let bad = json!([{ "path": ["target", "modifications", 99], "value": 1 }]);
    let refused = served.post("/api/edit", &json!({ "text": text, "edits": bad }));
    assert_eq!((refused.status, refused.code().as_str()), (422, "invalid-edit"));
}

#[test]
fn a_preview_is_the_plan_without_the_referee() {
    let served = Served::new();
    let job = served.example("twist-free-crowning");
    let charts = json!(["target", "planned", "deviation", "sections", "motions"]);
    let preview = served.post("/api/preview", &json!({ "job": job, "charts": charts })).json();
    for chart in charts.as_array().unwrap() {
        assert!(preview["charts"][chart.as_str().unwrap()].as_str().unwrap().starts_with("<svg"), "{chart}");
    }
    let run = served.ended(served.begin("plan", &job));
    let planned = &run["document"]["flanks"]["left"];
    let shown = &preview["flanks"]["left"];
    assert_eq!((&shown["w_mm"], &shown["z_mm"]), (&planned["w_mm"], &planned["z_mm"]));
    assert_eq!((&shown["target_um"], &shown["planned_um"]), (&planned["target_um"], &planned["planned_um"]));
    let settings = |of: &serde_json::Value| of["settings"].clone();
    assert_eq!(settings(&preview), settings(&run["document"]));

    let tangential = served.example("tangential/automotive");
    let preview = served.post("/api/preview", &json!({ "job": tangential, "charts": ["deviation"] })).json();
    let run = served.ended(served.begin("plan", &tangential));
    let largest = |grid: &serde_json::Value, other: &serde_json::Value| {
        let rows = grid.as_array().unwrap().iter().zip(other.as_array().unwrap());
        let values = rows.flat_map(|(a, b)| a.as_array().unwrap().iter().zip(b.as_array().unwrap()));
        values.map(|(a, b)| (a.as_f64().unwrap() - b.as_f64().unwrap()).abs()).fold(0.0, f64::max)
    };
    for flank in ["left", "right"] {
        let (shown, planned) = (&preview["flanks"][flank], &run["document"]["flanks"][flank]);
        assert!(largest(&shown["planned_um"], &planned["planned_um"]) < 1e-9);
        assert!(largest(&shown["target_um"], &planned["target_um"]) < 1e-9);
    }

    for (id, charts, code) in [
        ("milling/blisk-blade", json!([]), "process-not-available"),
        ("catalogue", json!([]), "not-yet-supported"),
        ("twist-free-crowning", json!(["none"]), "unknown-chart"),
    ] {
        let refused = served.post("/api/preview", &json!({ "job": served.example(id), "charts": charts }));
        assert_eq!((refused.status, refused.code().as_str()), (422, code), "{id}");
    }
}

#[test]
fn a_program_is_followed_on_a_machine() {
    let served = Served::new();
    let job = served.example("automotive-bias");
    let run = served.ended(served.begin("plan", &job));
    let mut names = run["files"].as_array().unwrap().iter().map(|file| file["name"].as_str().unwrap());
    let name = names.rfind(|name| name.ends_with(".mpf")).unwrap();
    let text = served.get(&format!("/api/runs/{}/files/{name}", run["id"])).text();
    let request = json!({ "text": text, "name": name, "machine": "machines/no-swivel.toml", "job": job });
    let checked = served.post("/api/programs/check", &request);
    assert_eq!(checked.status, 200, "{}", checked.text());
    assert!(checked.json()["axes"].as_array().unwrap().len() > 3);
    let other = json!({ "text": "hello", "name": "x", "machine": "machines/no-swivel.toml" });
    assert_eq!(served.post("/api/programs/check", &other).code(), "unknown-dialect");
}
