//! Tangential dressing as a user runs it: `new`, `check`, `plan`, `simulate`, their files, exit statuses and messages.

use crate::command::{Run, repository, run, write_job};
use serde_json::Value;
use std::path::Path;

/// The template with a coarse grid and the given replacements, written to a file.
fn job(directory: &Path, replacements: &[(&str, &str)]) -> String {
    let text = run(&["new", "tangential-dressing"]).stdout;
    write_job(directory, text.replace("_points = 41", "_points = 9"), replacements)
}

fn planned(replacements: &[(&str, &str)], extra: &[&str]) -> (Run, tempfile::TempDir) {
    let directory = tempfile::tempdir().unwrap();
    let path = job(directory.path(), replacements);
    let output = directory.path().join("out");
    let mut arguments = vec!["plan", &path, "-o", output.to_str().unwrap()];
    arguments.extend(extra);
    (run(&arguments), directory)
}

const BOTH: (&str, &str) = ("flanks = \"right\"", "flanks = \"both\"");

fn result(directory: &tempfile::TempDir) -> Value {
    let bytes = std::fs::read(directory.path().join("out/result.json")).unwrap();
    let mut value: Value = serde_json::from_slice(&bytes).unwrap();
    value["timing_s"].take();
    value
}

#[test]
fn plan_writes_its_files_and_a_summary() {
    let (run, directory) = planned(&[BOTH], &[]);
    assert_eq!(run.exit, Some(0), "{run:?}");
    for words in ["target met", "variables by", "radial feed would leave -25.278 um of twist", "report.html"]
    {
        assert!(run.stdout.contains(words), "{words}: {}", run.stdout);
    }
    let out = directory.path().join("out");
    for name in [
        "result.json",
        "settings.json",
        "topography.csv",
        "sensitivities.csv",
        "fit.csv",
        "motions/dressing-left.csv",
        "motions/dressing-right.csv",
        "motions/grinding-left.csv",
        "motions/grinding-right.csv",
        "report.html",
    ] {
        assert!(std::fs::metadata(out.join(name)).unwrap().len() > 50, "{name}");
    }
    let report = std::fs::read_to_string(out.join("report.html")).unwrap();
    for heading in [
        "Variables of dressing and grinding",
        "How the values were found",
        "Beside it: crowning by radial feed",
        "Worm length and passes",
        "Sensitivity topographies",
        "How it was verified",
    ] {
        assert!(report.contains(heading), "{heading}");
    }
    let result = result(&directory);
    for flank in ["left", "right"] {
        let f = &result["flanks"][flank];
        assert!(f["max_deviation_um"].as_f64().unwrap() <= 1.0, "{f}");
        assert!(f["model_difference_um"].as_f64().unwrap() < 0.02, "{f}");
        assert!(f["sample_difference_um"].as_f64().unwrap() < 1e-8, "{f}");
        assert_eq!(f["simulated_um"].as_array().unwrap().len(), 9);
    }
    // The flanks are each other's mirror image, and so are their twists by radial feed.
    let twist = |flank: &str| result["flanks"][flank]["radial_feed"]["twist_normal_um"].as_f64().unwrap();
    assert!((twist("left") + twist("right")).abs() < 1e-6);
}

#[test]
fn the_same_job_gives_the_same_bytes() {
    let (a, first) = planned(&[], &["--quiet"]);
    let (b, second) = planned(&[], &["--quiet"]);
    assert_eq!((a.exit, b.exit, a.stdout.as_str()), (Some(0), Some(0), ""));
    for name in
        ["settings.json", "topography.csv", "sensitivities.csv", "motions/dressing-right.csv", "report.html"]
    {
        let read = |d: &tempfile::TempDir| std::fs::read(d.path().join("out").join(name)).unwrap();
        assert!(read(&first) == read(&second), "{name}");
    }
    assert_eq!(result(&first), result(&second));
}

#[test]
fn simulate_runs_what_plan_wrote() {
    // A shift ratio, an offset and a spline of its own beside powers.
    let lists = [(
        "# variables = \"auto\"",
        "variables = [\"Fp1\", \"Fp2\", \"Fp3\", \"dist0\", \"dX2\", \"FC2\", \"FT0\", \"kap\"]",
    )];
    let (plan, directory) = planned(&lists, &["--quiet"]);
    assert_eq!(plan.exit, Some(0), "{plan:?}");
    let settings = directory.path().join("out/settings.json");
    let again = directory.path().join("again");
    let simulated = run(&["simulate", settings.to_str().unwrap(), "-o", again.to_str().unwrap(), "--json"]);
    assert_eq!(simulated.exit, Some(0), "{simulated:?}");
    let (planned, simulated) = (result(&directory), simulated.json());
    let rows = |v: &Value| -> Vec<f64> {
        let rows = v["flanks"]["right"]["simulated_um"].as_array().unwrap().clone();
        rows.iter().flat_map(|r| r.as_array().unwrap().clone()).map(|x| x.as_f64().unwrap()).collect()
    };
    for (a, b) in rows(&planned).iter().zip(rows(&simulated)) {
        assert!((a - b).abs() < 1e-7, "{a} {b}");
    }
    assert!(simulated["passes"].as_array().unwrap().is_empty());
}

#[test]
fn methods_stand_beside_each_other_where_the_job_asks() {
    let (run, directory) = planned(
        &[
            ("# compare_methods = false", "compare_methods = true"),
            ("# variables = \"auto\"", "variables = \"source\""),
        ],
        &["--quiet"],
    );
    assert_eq!(run.exit, Some(0), "{run:?}");
    let result = result(&directory);
    let pass = &result["passes"][0];
    assert_eq!(pass["compared"].as_array().unwrap().len(), 6);
    let rms = pass["weighted_rms_by_round_um"].as_array().unwrap();
    assert!(rms.len() >= 2 && rms[0].as_f64().unwrap() > 1.0);
    assert_eq!(pass["variables"].as_array().unwrap().len(), 9);
}

#[test]
fn a_shared_pass_says_which_variables_cannot_crown_both_flanks() {
    let changes = [
        BOTH,
        ("# passes = \"each\"", "passes = \"one\""),
        ("# variables = \"auto\"", "variables = [\"Fp2\", \"dist0\", \"Fz2\", \"FC2\"]"),
    ];
    let (run, directory) = planned(&changes, &["--quiet"]);
    assert_eq!(run.exit, Some(3), "{run:?}");
    let result = result(&directory);
    let warnings = result["warnings"].as_array().unwrap();
    assert!(warnings.iter().any(|w| w["code"] == "antisymmetric-variables"), "{warnings:?}");
    assert_eq!(result["reason"]["code"], "target-missed");
    let way_out = result["reason"]["way_out"].as_str().unwrap();
    assert!(way_out.contains("dressing.passes = \"each\""), "{way_out}");
}

/// A command, the code of its refusal, and what is changed in the template.
type Case = (&'static str, &'static str, &'static [(&'static str, &'static str)]);

#[test]
fn limits_of_the_bodies_end_with_four() {
    let cases: [Case; 3] = [
        ("plan", "worm-too-short", &[("# width = 100.0", "width = 40.0")]),
        ("plan", "outside-tool", &[("tip_diameter = 123.0", "tip_diameter = 119.0")]),
        // Crowning of 50 um by radial feed (`docs/mathematics/tangential-dressing.md#limits`).
        (
            "simulate",
            "undercut",
            &[("# [settings]", "[settings.right]\nkap = 0.0\nvalues = { dist2 = -0.052426, FT0 = 0.0 }\n#")],
        ),
    ];
    for (command, code, changes) in cases {
        let directory = tempfile::tempdir().unwrap();
        let path = job(directory.path(), changes);
        let out = directory.path().join("out");
        let run = run(&[command, &path, "-o", out.to_str().unwrap(), "--quiet"]);
        assert_eq!(run.exit, Some(4), "{code}: {run:?}");
        assert!(run.message().contains(code), "{code}: {}", run.message());
        let result: Value = serde_json::from_slice(&std::fs::read(out.join("result.json")).unwrap()).unwrap();
        assert_eq!(
            (result["status"].as_str(), result["reason"]["code"].as_str()),
            (Some("not_producible"), Some(code))
        );
    }
}

#[test]
fn what_is_not_there_is_said() {
    let directory = tempfile::tempdir().unwrap();
    let path = job(directory.path(), &[]);
    let simulated = run(&["simulate", &path]);
    assert_eq!(simulated.exit, Some(2), "{simulated:?}");
    assert!(simulated.message().contains("settings"), "{simulated:?}");
}

#[test]
fn check_prints_the_derived_geometry() {
    let directory = tempfile::tempdir().unwrap();
    let path = job(directory.path(), &[]);
    let checked = run(&["check", &path, "--json"]);
    assert_eq!(checked.exit, Some(0), "{checked:?}");
    let derived = &checked.json()["derived"];
    let near = |section: &str, key: &str, value: f64| {
        let found = derived[section][key].as_f64().unwrap_or(f64::NAN);
        assert!((found - value).abs() < 1e-5, "{section}.{key} {found}");
    };
    near("grinding", "centre_distance_mm", 136.215755);
    near("grinding", "crossed_axes_angle_deg", 121.852767);
    near("grinding", "neutral_shift_ratio", 1.916054);
    near("grinding", "shift_offset_left_mm", 2.747867);
    near("dressing", "dressing_crossing_angle_deg", 3.147233);
    assert!(repository().join("examples/tangential/example-1.toml").is_file());
}
