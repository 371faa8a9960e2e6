//! `plan`, `simulate` and `verify` as a user runs them: files, exit status, messages.

use crate::command::{Run, example, run, write_job};
use std::path::Path;

/// The first example with a coarse grid and the given replacements, written to a file.
fn job(directory: &Path, replacements: &[(&str, &str)]) -> String {
    let text = example("twist-free-crowning.toml");
    write_job(directory, text.replace("_points = 41", "_points = 7"), replacements)
}

fn planned(replacements: &[(&str, &str)], extra: &[&str]) -> (Run, tempfile::TempDir) {
    let directory = tempfile::tempdir().unwrap();
    let path = job(directory.path(), replacements);
    let output = directory.path().join("out");
    let mut arguments = vec!["plan", &path, "-o", output.to_str().unwrap()];
    arguments.extend(extra);
    (run(&arguments), directory)
}

#[test]
fn plan_writes_its_files_and_a_summary() {
    let (run, directory) = planned(&[], &[]);
    assert_eq!(run.exit, Some(0), "{run:?}");
    for words in [
        "target met",
        "left  target, fitted over the whole field: helix crowning 20.00 um",
        "deviation max",
        "time",
        "report.html",
    ] {
        assert!(run.stdout.contains(words), "{words}: {}", run.stdout);
    }
    let out = directory.path().join("out");
    let names = [
        "result.json",
        "settings.json",
        "topography.csv",
        "motions/grinding.csv",
        "motions/dressing-left.csv",
        "motions/dressing-right.csv",
        "report.html",
    ];
    for name in names {
        assert!(std::fs::metadata(out.join(name)).unwrap().len() > 100, "{name}");
    }
    let report = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(report.contains("<svg") && !report.contains("src=\"http") && !report.contains("href=\"http"));
    let csv = std::fs::read_to_string(out.join("topography.csv")).unwrap();
    assert_eq!(csv.lines().count(), 1 + 2 * 7 * 7);
    assert_eq!(csv.lines().next(), Some("flank,w_mm,z_mm,target_um,planned_um,simulated_um,deviation_um"));
}

#[test]
fn the_same_job_gives_the_same_bytes() {
    let read = |directory: &tempfile::TempDir, name: &str| {
        std::fs::read(directory.path().join("out").join(name)).unwrap()
    };
    let (a, first) = planned(&[], &["--quiet"]);
    let (b, second) = planned(&[], &["--quiet"]);
    assert_eq!((a.exit, b.exit, a.stdout.as_str()), (Some(0), Some(0), ""));
    for name in [
        "settings.json",
        "topography.csv",
        "motions/grinding.csv",
        "motions/dressing-left.csv",
        "report.html",
    ] {
        assert!(read(&first, name) == read(&second, name), "{name}");
    }
    let result = |directory| {
        let mut value: serde_json::Value = serde_json::from_slice(&read(directory, "result.json")).unwrap();
        value["timing_s"].take();
        value
    };
    assert_eq!(result(&first), result(&second));
}

#[test]
fn json_is_the_result_and_nothing_else() {
    let (run, directory) = planned(&[], &["--json"]);
    let printed = run.json();
    let written = std::fs::read(directory.path().join("out/result.json")).unwrap();
    assert_eq!(printed, serde_json::from_slice::<serde_json::Value>(&written).unwrap());
    assert_eq!(printed["status"], "met");
    for key in ["job", "process", "version", "status", "warnings", "settings", "flanks", "timing_s"] {
        assert!(!printed[key].is_null(), "{key}");
    }
    for flank in ["left", "right"] {
        let f = &printed["flanks"][flank];
        for key in ["w_mm", "z_mm", "target_um", "planned_um", "simulated_um"] {
            assert_eq!(f[key].as_array().unwrap().len(), 7, "{key}");
        }
        for key in ["max_deviation_um", "rms_deviation_um", "model_difference_um"] {
            assert!(f[key].as_f64().unwrap() < 0.05, "{key}");
        }
    }
}

#[test]
fn settings_of_a_plan_can_be_simulated() {
    let (_, directory) = planned(&[], &["--quiet"]);
    let settings = directory.path().join("out/settings.json");
    let again = directory.path().join("again");
    let run = run(&["simulate", settings.to_str().unwrap(), "-o", again.to_str().unwrap(), "--json"]);
    assert_eq!(run.exit, Some(0), "{run:?}");
    assert!(run.json()["flanks"]["left"]["max_deviation_um"].as_f64().unwrap() < 0.05);
}

#[test]
fn a_job_without_settings_cannot_be_simulated() {
    let run = run(&["simulate", "examples/twist-free-crowning.toml"]);
    assert_eq!(run.exit, Some(2), "{run:?}");
    assert!(run.message().contains("missing-key") && run.message().contains("settings.json"), "{run:?}");
}

#[test]
fn a_worm_that_is_too_short_is_named_with_what_would_help() {
    let (run, directory) = planned(&[("diagonal_ratio = \"auto\"", "diagonal_ratio = 1.9")], &["--json"]);
    assert_eq!(run.exit, Some(4), "{run:?}");
    let error = &run.json()["error"];
    assert_eq!(error["code"], "worm-too-short");
    assert_eq!(error["field"], "worm.width");
    assert!(error["line"].as_u64().unwrap() > 0 && error["way_out"].as_str().unwrap().contains("wider worm"));
    let written = std::fs::read(directory.path().join("out/result.json")).unwrap();
    let written: serde_json::Value = serde_json::from_slice(&written).unwrap();
    assert_eq!(written["status"], "not_producible");
    assert_eq!(written["reason"]["code"], "worm-too-short");
    assert_eq!(run.json()["status"], "not_producible");
    let page = std::fs::read_to_string(directory.path().join("out/report.html")).unwrap();
    assert!(page.contains("Width of the worm that each diagonal ratio needs"));
    assert_eq!(run.json()["report"], directory.path().join("out/report.html").display().to_string());
}

#[test]
fn limits_of_axes_and_folds_end_with_4() {
    for (replacement, code) in [
        (("profile_crowning_by = \"dresser\"", "profile_crowning_by = \"correction\""), ["axis-limit"; 2]),
        (("amount_um = 20.0", "amount_um = 2000.0"), ["undercut", "contact-not-found"]),
        (("pitch_diameter = 115.65", "pitch_diameter = 115.65\ntip_land = 3.2"), ["counter-flank-cut"; 2]),
    ] {
        let (run, _) = planned(&[replacement], &["--json"]);
        assert_eq!(run.exit, Some(4), "{code:?}: {run:?}");
        assert!(code.contains(&run.json()["error"]["code"].as_str().unwrap()), "{code:?}: {run:?}");
    }
}

/// A root that the worm's edge cannot grind ends with 4, an edge that the worm cannot have with 2; both say why.
#[test]
fn roots_that_cannot_be_ground_are_refused() {
    let job = example("dressing/gear-root.toml");
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("job.toml");
    for (old, new, exit, code) in [
        ("corner_radius = 0.8", "corner_radius = 0.9", 4, "root-reaches-flank"),
        ("along = \"constant\"", "least_fillet_radius = 5.0", 4, "root-too-sharp"),
        ("corner_radius = 0.8", "corner_radius = 95.0", 2, "corner-radius-too-large"),
        ("diagonal_ratio = -1.2", "diagonal_ratio = 0.0", 4, "root-needs-shift"),
    ] {
        assert!(job.contains(old));
        std::fs::write(&path, job.replace(old, new)).unwrap();
        let output = directory.path().join("out");
        let run = run(&["plan", path.to_str().unwrap(), "--json", "-o", output.to_str().unwrap()]);
        assert_eq!(run.exit, Some(exit), "{new}: {run:?}");
        let error = &run.json()["error"];
        assert_eq!(error["code"], code, "{error}");
        assert!(error["way_out"].is_string());
    }
}

#[test]
fn a_machine_that_is_not_there_is_named() {
    let (run, _) = planned(&[("[grid]", "[machine]\nfile = \"m.toml\"\n\n[grid]")], &["--json"]);
    assert_eq!(run.exit, Some(2), "{run:?}");
    assert_eq!(run.json()["error"]["field"], "machine.file");
}

#[test]
fn other_dressing_conditions_are_met() {
    let default = "conditions = [\"three-point\", \"radius-map\"]";
    for conditions in ["[\"four-point\"]", "[\"three-point\", \"fix-gamma\"]"] {
        let (run, _) = planned(&[(default, &format!("conditions = {conditions}"))], &["--json"]);
        assert_eq!(run.exit, Some(0), "{conditions}: {run:?}");
        assert_eq!(run.json()["status"], "met", "{conditions}");
    }
    for (conditions, code) in [
        ("[\"radius-map\", \"head\", \"fix-d\", \"fix-gamma\"]", "invalid-job"),
        ("[\"three-point\"]", "invalid-job"),
    ] {
        let (run, _) = planned(&[(default, &format!("conditions = {conditions}"))], &["--json"]);
        assert_eq!(run.exit, Some(2), "{conditions}: {run:?}");
        let error = &run.json()["error"];
        assert_eq!((&error["field"], &error["code"]), (&"dressing.conditions".into(), &code.into()));
    }
}

#[test]
fn one_motion_for_both_flanks_is_refused_where_it_cannot_be() {
    let two = ("flanks = \"one\"", "flanks = \"two\"");
    for (replacement, field) in [
        (("flanks = \"both\"\ndiagonal", "flanks = \"left\"\ndiagonal"), "grinding.flanks"),
        (("threads = 3", "threads = 3\ncone_angle_deg = 1.0"), "worm.cone_angle_deg"),
        (
            ("profile_crowning_by = \"dresser\"", "profile_crowning_by = \"correction\""),
            "dressing.profile_crowning_by",
        ),
    ] {
        let (run, _) = planned(&[two, replacement], &["--json"]);
        assert_eq!(run.exit, Some(2), "{field}: {run:?}");
        let error = &run.json()["error"];
        assert_eq!((&error["field"], &error["code"]), (&field.into(), &"invalid-job".into()));
        assert!(
            error["way_out"].as_str().is_some_and(|text| text.contains("dress") || text.contains("crowning"))
        );
    }
}

#[test]
fn one_flank_alone_is_planned_alone() {
    let (run, _) = planned(&[("flanks = \"both\"\ndiagonal", "flanks = \"left\"\ndiagonal")], &["--json"]);
    assert_eq!(run.exit, Some(0), "{run:?}");
    let flanks = run.json()["flanks"].as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    assert_eq!(flanks, ["left"]);
}

#[cfg(feature = "verify")]
#[test]
fn verify_passes_and_counts() {
    let run = run(&["verify", "tests/reference/10-gears.json", "--json"]);
    assert_eq!(run.exit, Some(0), "{run:?}");
    let summary = run.json();
    assert_eq!(summary["failed"], 0);
    assert!(summary["files"][0]["checks"].as_u64().unwrap() > 1000);
}

#[cfg(not(feature = "verify"))]
#[test]
fn a_build_without_verify_names_the_feature() {
    let run = run(&["verify", "tests/reference/10-gears.json", "--json"]);
    assert_eq!(run.exit, Some(2), "{run:?}");
    assert_eq!(run.json()["error"]["code"], "not-in-this-build");
    assert!(run.json()["error"]["way_out"].as_str().unwrap().contains("--features verify"));
}

#[cfg(feature = "verify")]
#[test]
fn verify_refuses_what_it_does_not_know() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("x.json");
    std::fs::write(&path, "{\"hello\": 1}").unwrap();
    let unknown = run(&["verify", path.to_str().unwrap()]);
    assert_eq!(unknown.exit, Some(2), "{unknown:?}");
    assert_eq!(run(&["verify", "no-such-file.json"]).exit, Some(2));
}

#[test]
fn a_wave_between_the_points_of_the_grid_is_not_called_made() {
    let wave = "modifications = [ { kind = \"waviness\", rho_deg = 0.0, wavelength_mm = 1.0, phase_deg = 0.0, \
                amp_0_um = 20.0, amp_uu_um = 0.0, amp_vv_um = 0.0 } ]\n[old]\nmodifications = [";
    let directory = tempfile::tempdir().unwrap();
    let path = job(directory.path(), &[("modifications = [", wave)]);
    // What stood in the target before is cut off again.
    let text = std::fs::read_to_string(&path).unwrap();
    let (head, rest) = text.split_once("[old]").unwrap();
    let tail = rest.split_once("\n]").unwrap().1;
    std::fs::write(&path, format!("{head}{tail}")).unwrap();
    let output = directory.path().join("out");
    let run = run(&["plan", &path, "-o", output.to_str().unwrap(), "--json"]);
    assert_eq!(run.exit, Some(3), "{run:?}");
    let result = run.json();
    assert_eq!(result["status"], "missed");
    let left = &result["flanks"]["left"];
    let of = |key: &str| left[key].as_f64().unwrap();
    assert!(of("outside_class_um") > 10.0 || of("max_deviation_um") > 1.0, "{left}");
}

#[test]
fn settings_carry_the_reliefs_of_the_dresser() {
    let relief =
        "modifications = [\n  { kind = \"tip_relief\", amount_um = 15.0, length_mm = 3.0, exponent = 2 },";
    let (_, directory) = planned(&[("modifications = [", relief)], &["--quiet"]);
    let path = directory.path().join("out/settings.json");
    let mut settings: serde_json::Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
    assert_eq!(settings["settings"]["left"]["reliefs"][0]["kind"], "tip_relief");
    // A target without the relief: the dresser still cuts it, and the simulation says so.
    settings["target"]["modifications"].as_array_mut().unwrap().remove(0);
    std::fs::write(&path, settings.to_string()).unwrap();
    let again = directory.path().join("again");
    let run = run(&["simulate", path.to_str().unwrap(), "-o", again.to_str().unwrap(), "--json"]);
    assert_eq!(run.exit, Some(3), "{run:?}");
    assert!(run.json()["flanks"]["left"]["max_deviation_um"].as_f64().unwrap() > 10.0);
}

#[test]
fn a_refusal_leaves_nothing_of_an_earlier_run() {
    let (run, directory) = planned(&[], &["--quiet"]);
    assert_eq!(run.exit, Some(0));
    let path = job(directory.path(), &[("diagonal_ratio = \"auto\"", "diagonal_ratio = 1.9")]);
    let output = directory.path().join("out");
    let refused = crate::command::run(&["plan", &path, "-o", output.to_str().unwrap(), "--quiet"]);
    assert_eq!(refused.exit, Some(4));
    assert!(output.join("result.json").exists() && output.join("report.html").exists());
    for name in ["settings.json", "topography.csv", "motions/grinding.csv"] {
        assert!(!output.join(name).exists(), "{name}");
    }
}

#[test]
fn limits_that_a_given_ratio_overrides_are_told() {
    let (run, _) = planned(
        &[("diagonal_ratio = \"auto\"", "diagonal_ratio = 1.916"), ("width = 100.0", "width = 200.0")],
        &["--json"],
    );
    assert_eq!(run.exit, Some(0), "{run:?}");
    let warnings = run.json()["warnings"].to_string();
    assert!(
        warnings.contains("given-ratio-beyond-limits") && warnings.contains("tangentially"),
        "{warnings}"
    );
}

#[test]
fn feeds_that_leave_high_marks_are_told() {
    let (run, _) = planned(&[("feed_per_revolution = 0.3", "feed_per_revolution = 5.0")], &["--json"]);
    assert_eq!(run.exit, Some(0), "{run:?}");
    assert!(run.json()["warnings"].to_string().contains("feed-marks-above-tolerance"));
}

#[test]
fn a_worm_of_one_thread_is_dressed_and_refereed() {
    let (run, _) = planned(
        &[("threads = 3", "threads = 1"), ("pitch_diameter = 115.65", "# pitch_diameter = 115.65")],
        &["--json"],
    );
    assert_eq!(run.exit, Some(0), "{run:?}");
}
