//! Jobs of both grinding processes through the control that they describe.

use crate::command::{example, run, write_job};
use serde_json::Value;
use std::path::Path;

/// The example with some of its text replaced.
fn job(directory: &Path, replacements: &[(&str, &str)]) -> String {
    write_job(directory, example("control/with-real-control.toml"), replacements)
}

#[test]
fn the_report_shows_what_the_control_costs() {
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().join("out");
    let file = job(directory.path(), &[]);
    let run = run(&["plan", &file, "--json", "-o", out.to_str().unwrap()]);
    assert_eq!(run.exit, Some(0), "{run:?}");
    let result: Value = serde_json::from_str(&run.stdout).unwrap();
    for flank in ["left", "right"] {
        let f = &result["control"]["flanks"][flank];
        let um = |key: &str| f[key].as_f64().unwrap();
        // Out of balance once a turn, the threads of the worm, and the steps of encoders and scales.
        assert!((0.1..0.6).contains(&um("largest_um")), "{f}");
        assert!(um("rms_um") < um("largest_um") && um("cumulative_pitch_um") > 0.05);
        assert!(um("model_difference_um") < 0.005, "closed form against rays: {}", um("model_difference_um"));
        assert!((um("deviation_with_control_um") - um("largest_um")).abs() < 0.01);
        assert_eq!(f["tooth_means_um"].as_array().unwrap().len(), 19);
    }
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("Gearbox and servo") && page.contains("Mean deviation of each tooth"));
}

#[test]
fn a_soft_loop_misses_the_target_and_says_so() {
    let directory = tempfile::tempdir().unwrap();
    let file = job(
        directory.path(),
        &[("bandwidth_hz = 60.0", "bandwidth_hz = 8.0"), ("torque_n_m = 0.15", "torque_n_m = 1.5")],
    );
    let out = directory.path().join("out");
    let run = run(&["plan", &file, "-o", out.to_str().unwrap()]);
    assert_eq!(run.exit, Some(3), "{run:?}");
    let result: Value = serde_json::from_slice(&std::fs::read(out.join("result.json")).unwrap()).unwrap();
    assert_eq!(result["status"], "missed");
    assert_eq!(result["reason"]["code"], "control-above-tolerance");
}

/// The example of tangential dressing on a coarse grid.
fn tangential_job(directory: &Path, replacements: &[(&str, &str)]) -> String {
    let text = example("tangential/with-control.toml").replace("_points = 21", "_points = 5");
    write_job(directory, text, replacements)
}

#[test]
fn tangential_dressing_tells_what_the_control_costs() {
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().join("out");
    let file = tangential_job(directory.path(), &[]);
    let told = run(&["plan", &file, "-o", out.to_str().unwrap()]);
    assert_eq!(told.exit, Some(0), "{told:?}");
    for words in [
        "left  gearbox and servo leave 0.",
        "right gearbox and servo leave 0.",
        "left flank with gearbox and servo",
    ] {
        assert!(told.stdout.contains(words), "{words}: {}", told.stdout);
    }
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("Gearbox and servo") && page.contains("Mean deviation of each tooth"));
    // The settings that it writes keep their control.
    let settings = out.join("settings.json");
    let again = directory.path().join("again");
    let simulated = run(&["simulate", settings.to_str().unwrap(), "-o", again.to_str().unwrap()]);
    assert_eq!(simulated.exit, Some(0), "{simulated:?}");
    let control = |folder: &Path| -> Value {
        let result: Value =
            serde_json::from_slice(&std::fs::read(folder.join("result.json")).unwrap()).unwrap();
        result["control"]["flanks"]["left"]["largest_um"].clone()
    };
    let [planned, simulated] = [control(&out), control(&again)].map(|um| um.as_f64().unwrap());
    assert!((planned - simulated).abs() < 1e-3, "{planned} {simulated}");
}

#[test]
fn a_soft_loop_misses_the_target_of_tangential_dressing() {
    let directory = tempfile::tempdir().unwrap();
    let file = tangential_job(
        directory.path(),
        &[("bandwidth_hz = 60.0", "bandwidth_hz = 8.0"), ("torque_n_m = 0.15", "torque_n_m = 1.5")],
    );
    let run = run(&["plan", &file, "--json", "-o", directory.path().join("out").to_str().unwrap()]);
    assert_eq!(run.exit, Some(3), "{run:?}");
    let result = run.json();
    assert_eq!(result["status"], "missed");
    assert_eq!(result["reason"]["code"], "control-above-tolerance");
}

/// Each pass has a stroke of its own, and so an alarm of its own, which says of which flank.
#[test]
fn alarms_of_passes_name_their_flanks() {
    let directory = tempfile::tempdir().unwrap();
    let file = tangential_job(directory.path(), &[("clock_hz = 10e6", "clock_hz = 50.4e3")]);
    let run = run(&["plan", &file, "--json", "-o", directory.path().join("out").to_str().unwrap()]);
    let result = run.json();
    let warnings = result["warnings"].as_array().unwrap();
    let alarms = warnings.iter().filter(|w| w["code"] == "interpolator-too-fast");
    let alarms: Vec<&str> = alarms.map(|w| w["text"].as_str().unwrap()).collect();
    let [left, right] = alarms.as_slice() else { panic!("{warnings:?}") };
    assert!(
        left.starts_with("left flank: alarm: ") && right.starts_with("right flank: alarm: "),
        "{alarms:?}"
    );
}

#[test]
fn a_feed_too_fast_for_the_interpolator_is_a_warning_with_the_count() {
    let directory = tempfile::tempdir().unwrap();
    // 3.158 mm/s pass a line of 4 um in 1.267 ms: 63.84 ticks, now 63, now 64, for 64 pulses.
    let file = job(directory.path(), &[("clock_hz = 10e6", "clock_hz = 50.4e3")]);
    let run = run(&["plan", &file, "--json", "-o", directory.path().join("out").to_str().unwrap()]);
    let result = run.json();
    let warnings = result["warnings"].as_array().unwrap();
    let alarms: Vec<_> = warnings.iter().filter(|w| w["code"] == "interpolator-too-fast").collect();
    let [alarm] = alarms.as_slice() else { panic!("{warnings:?}") };
    assert!(
        alarm["text"].as_str().unwrap().contains("intervals had fewer ticks than the 64 pulses"),
        "{alarm}"
    );
}

#[test]
fn what_the_control_cannot_be_is_refused_by_its_key() {
    let directory = tempfile::tempdir().unwrap();
    for (from, to, code, key) in [
        ("bandwidth_hz = 60.0", "bandwidth_hz = 20000.0", "unstable-loop", "control.servo.bandwidth_hz"),
        (
            "pulses_per_revolution = 4194304 }",
            "pulses_per_revolution = 4194304, rate = \"binary\" }",
            "coefficient-too-large",
            "control.workpiece.pulses_per_revolution",
        ),
        (
            "sample_time_us = 62.5",
            "sample_time_us = 1e-5",
            "too-many-samples",
            "control.servo.sample_time_us",
        ),
        ("feed_per_revolution = 0.3\n", "", "", "control"),
    ] {
        let file = job(directory.path(), &[(from, to)]);
        let run = run(&["plan", &file, "-o", directory.path().join("out").to_str().unwrap()]);
        assert_eq!(run.exit, Some(2), "{to}: {run:?}");
        assert!(run.stderr.contains(code) && run.stderr.contains(key), "{to}: {run:?}");
    }
}
