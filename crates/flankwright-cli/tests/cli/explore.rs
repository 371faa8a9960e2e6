//! `explore` as a user runs it: files, exit status, messages.

use crate::command::{Run, example, run};

fn explore(text: &str, extra: &[&str]) -> (Run, tempfile::TempDir) {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("job.toml");
    std::fs::write(&path, text).unwrap();
    let output = directory.path().join("out");
    let mut arguments = vec!["explore", path.to_str().unwrap(), "-o", output.to_str().unwrap()];
    arguments.extend(extra);
    (run(&arguments), directory)
}

fn with(name: &str, steps: &str) -> String {
    let text = example(name);
    assert!(text.contains("[grid]"));
    text.replace("[grid]", &format!("[explore]\n{steps}\n[grid]"))
}

#[test]
fn explore_writes_its_files_and_ranks() {
    let steps = "diagonal_ratio = { from = -2.4, to = 0.6, count = 7 }";
    let (run, directory) = explore(&with("twist-free-crowning.toml", steps), &["--top", "3"]);
    assert_eq!((run.exit, run.stderr.as_str()), (Some(0), ""), "{run:?}");
    for words in ["of 7 combinations are allowed", "-1.90000", "and 4 more in explore.csv", "explore.html"] {
        assert!(run.stdout.contains(words), "{words}: {}", run.stdout);
    }
    let read = |name: &str| std::fs::read_to_string(directory.path().join("out").join(name)).unwrap();
    let csv = read("explore.csv");
    assert_eq!(csv.lines().count(), 8);
    assert!(csv.starts_with(
        "rank,worm_cone_angle_deg,crossed_axes_angle_deg,worm_pitch_diameter_mm,diagonal_ratio,"
    ));
    let document: serde_json::Value = serde_json::from_str(&read("explore.json")).unwrap();
    assert_eq!(document["candidates"].as_array().unwrap().len(), 7);
    assert!((document["candidates"][0]["diagonal_ratio"].as_f64().unwrap() + 1.9).abs() < 1e-12);
    let page = read("explore.html");
    assert!(page.contains("<svg") && page.contains("tolerance 1 µm") && !page.contains("src=\"http"));
}

#[test]
fn json_is_one_document_and_quiet_is_quiet() {
    let text = with("twist-free-crowning.toml", "diagonal_ratio = { from = -1.9, to = -1.5, count = 2 }");
    let (json, directory) = explore(&text, &["--json"]);
    assert_eq!(json.exit, Some(0), "{json:?}");
    let written = std::fs::read_to_string(directory.path().join("out/explore.json")).unwrap();
    assert_eq!(json.json(), serde_json::from_str::<serde_json::Value>(&written).unwrap());
    let (quiet, _) = explore(&text, &["--quiet"]);
    assert_eq!((quiet.exit, quiet.stdout.as_str(), quiet.stderr.as_str()), (Some(0), "", ""));
}

#[test]
fn the_exit_status_tells_what_can_be_made() {
    // A tolerance too tight for these ratios: made, but outside it.
    let steps = "diagonal_ratio = { from = 4.4, to = 5.0, count = 3 }";
    let tight =
        with("asymmetric-conical-worm.toml", steps).replace("tolerance_um = 1.0", "tolerance_um = 0.02");
    let (missed, directory) = explore(&tight, &[]);
    assert_eq!(missed.exit, Some(3), "{missed:?}");
    assert!(missed.stdout.contains("0 of 3") && missed.stdout.contains("model-error"), "{missed:?}");
    assert!(directory.path().join("out/explore.html").is_file());
    // No worm as narrow as this.
    let steps = "diagonal_ratio = { from = -2.0, to = -1.8, count = 2 }";
    let narrow = with("twist-free-crowning.toml", steps).replace("width = 100.0", "width = 40.0");
    let (never, _) = explore(&narrow, &["--quiet"]);
    assert_eq!(never.exit, Some(4), "{never:?}");
    assert!(never.message().contains("worm width"), "{never:?}");
    let many = "diagonal_ratio = { from = -2.0, to = -1.8, count = 5000 }\n\
                crossed_axes_angle_deg = { from = 110.0, to = 120.0, count = 5000 }";
    let (refused, directory) = explore(&with("twist-free-crowning.toml", many), &["--json"]);
    assert_eq!(refused.exit, Some(2));
    assert_eq!(refused.json()["error"]["code"], "too-many-combinations");
    assert_eq!(refused.json()["error"]["field"], "explore");
    assert!(!directory.path().join("out").exists());
}

#[test]
fn plan_leaves_the_study_alone() {
    let steps = "diagonal_ratio = { from = 1.0, to = 2.0, count = 2 }";
    let text = with("twist-free-crowning.toml", steps).replace("_points = 41", "_points = 7");
    let text = text.replace("diagonal_ratio = \"auto\"", "diagonal_ratio = \"auto\"\nprefer = \"accuracy\"");
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("job.toml");
    std::fs::write(&path, text).unwrap();
    let planned = run(&["plan", path.to_str().unwrap(), "--json"]);
    assert_eq!(planned.exit, Some(0), "{planned:?}");
    assert!((planned.json()["settings"]["diagonal_ratio"].as_f64().unwrap() + 1.916_053_7).abs() < 1e-6);
}
