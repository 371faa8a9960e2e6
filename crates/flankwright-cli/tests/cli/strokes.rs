//! Dressing in strokes as a user runs it: planned, refereed, simulated again, refused.

use crate::command::{Run, example, largest, plan_in, run};
use serde_json::Value;
use std::path::Path;

/// The example with a coarse grid and the given replacements, run in a directory.
fn plan(directory: &Path, replacements: &[(&str, &str)]) -> Run {
    let text = example("dressing/strokes.toml") + "\n[grid]\nprofile_points = 9\nhelix_points = 5\n";
    plan_in(directory, text, replacements)
}

#[test]
fn strokes_are_planned_refereed_and_simulated() {
    let directory = tempfile::tempdir().unwrap();
    let planned = plan(directory.path(), &[]);
    assert_eq!(planned.exit, Some(0), "{planned:?}");
    let result = planned.json();
    assert!(largest(&result, "model_difference_um") < 0.05, "{result}");
    let strokes = &result["settings"]["strokes"];
    for flank in ["left", "right"] {
        let dressers: Vec<u64> =
            strokes[flank].as_array().unwrap().iter().map(|s| s["dresser"].as_u64().unwrap()).collect();
        assert_eq!(dressers, [2, 1, 1, 2]);
        assert!(strokes[flank][0]["d_gamma_deg"].as_array().unwrap().len() > 1);
    }
    let out = directory.path().join("out");
    let table = std::fs::read_to_string(out.join("motions/dressing-left.csv")).unwrap();
    assert!(table.starts_with("stroke,dresser,v_zS_mm,d_phi_S_deg,"), "{}", &table[..80]);
    assert_eq!(table.lines().count(), 1 + 4 * 201);
    let report = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(report.contains("Strokes of the left worm flank"));

    let (settings, again) = (out.join("settings.json"), directory.path().join("again"));
    let simulated = run(&["simulate", settings.to_str().unwrap(), "-o", again.to_str().unwrap(), "--json"]);
    assert_eq!(simulated.exit, Some(0), "{simulated:?}");
    let apart = largest(&simulated.json(), "max_deviation_um") - largest(&result, "max_deviation_um");
    assert!(apart.abs() < 1e-3, "{apart}");
}

#[test]
fn strokes_that_leave_stock_are_refused_with_the_place() {
    let directory = tempfile::tempdir().unwrap();
    let run = plan(
        directory.path(),
        &[
            ("from = 0.40, to = 0.61", "from = 0.155, to = 0.85"),
            ("from = 0.30, to = 0.70", "from = 0.155, to = 0.85"),
        ],
    );
    assert_eq!(run.exit, Some(4), "{run:?}");
    let error = &run.json()["error"];
    assert_eq!((&error["code"], &error["field"]), (&"gap".into(), &"dressing.strokes".into()));
    assert!(error["way_out"].as_str().unwrap().contains("overlap"));
}

#[test]
fn settings_of_strokes_are_checked() {
    let directory = tempfile::tempdir().unwrap();
    assert_eq!(plan(directory.path(), &[]).exit, Some(0));
    let settings = std::fs::read_to_string(directory.path().join("out/settings.json")).unwrap();
    let job: Value = serde_json::from_str(&settings).unwrap();
    let changed = |change: &dyn Fn(&mut Value), field: &str| {
        let mut job = job.clone();
        change(&mut job);
        let path = directory.path().join("changed.json");
        std::fs::write(&path, job.to_string()).unwrap();
        let out = directory.path().join("changed");
        let run = run(&["simulate", path.to_str().unwrap(), "-o", out.to_str().unwrap(), "--json"]);
        assert_eq!(run.exit, Some(2), "{field}: {run:?}");
        assert_eq!(run.json()["error"]["field"], field);
    };
    changed(&|job| job["settings"]["strokes"]["left"] = Value::Array(Vec::new()), "settings.strokes.left");
    changed(
        &|job| job["settings"]["strokes"]["left"][0]["dresser"] = 3.into(),
        "settings.strokes.left[0].dresser",
    );
    changed(
        &|job| job["settings"]["strokes"]["right"][1]["v_to_mm"] = (-4000.0).into(),
        "settings.strokes.right[1].v_to_mm",
    );
    changed(
        &|job| job["settings"]["strokes"]["right"][1]["area_mm"][1] = 1.0.into(),
        "settings.strokes.right[1].area_mm[1]",
    );
    changed(
        &|job| {
            job["dressing"].as_object_mut().unwrap().remove("strokes");
        },
        "dresser.others",
    );
}
