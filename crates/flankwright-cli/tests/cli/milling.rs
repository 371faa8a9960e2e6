//! Milling jobs with a machine as a user meets them: what result and report say of programs and orientation, and `program check` of
//! the written texts and of changed ones.

use crate::command::{Run, repository, run};
use serde_json::Value;
use std::path::{Path, PathBuf};

fn machine(name: &str) -> String {
    repository().join("machines").join(format!("{name}.toml")).display().to_string()
}

/// An example as a job of its own, with other things in it.
fn job(directory: &Path, example: &str, changes: &[(&str, &str)]) -> String {
    let path = repository().join(format!("examples/milling/{example}.toml"));
    let mut text = std::fs::read_to_string(path).expect("an example");
    text = text.replace("../../machines", &repository().join("machines").display().to_string());
    for (from, to) in changes {
        assert!(text.contains(from), "{example} has no {from}");
        text = text.replace(from, to);
    }
    let path = directory.join("job.toml");
    std::fs::write(&path, text).expect("a written job");
    path.display().to_string()
}

fn planned(example: &str, changes: &[(&str, &str)]) -> (Value, String, PathBuf, tempfile::TempDir) {
    let directory = tempfile::tempdir().expect("a directory");
    let job = job(directory.path(), example, changes);
    let out = directory.path().join("out");
    let run = run(&["plan", &job, "-o", &out.display().to_string(), "--json"]);
    assert_eq!(run.exit, Some(0), "{example}: {}", run.stderr);
    (run.json(), job, out, directory)
}

fn checked(program: &Path, machine_name: &str, job: &str) -> Run {
    let program = program.display().to_string();
    run(&[
        "program",
        "check",
        &program,
        "--machine",
        &machine(machine_name),
        "--job",
        job,
        "--quiet",
        "--json",
    ])
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

const FILES: [(&str, &str); 3] =
    [("milling-linuxcnc.ngc", "linuxcnc"), ("milling-siemens.mpf", "siemens"), ("milling-fanuc.nc", "fanuc")];

#[test]
fn programs_of_a_spur_gear_say_what_was_planned_and_a_changed_one_does_not() {
    let (result, job, out, directory) = planned("spur-on-ac-table", &[]);
    let programs = result["programs"].as_array().expect("programs");
    assert_eq!(programs.len(), 3);
    for program in programs {
        // All 20 spaces: the first one twenty times but for positioning and the turns between.
        let [whole, one] = ["duration_s", "one_space_s"].map(|key| number(&program[key]));
        assert!(whole > 19.0 * one && whole < 24.0 * one, "{whole} {one}");
        let operations = program["operations"].as_array().expect("operations");
        let sum = |key: &str| operations.iter().map(|operation| number(&operation[key])).sum::<f64>();
        assert!((sum("cutting_s") + sum("rapid_s") - whole).abs() < 1e-6 * whole);
        assert!((sum("one_space_s") - one).abs() < 1e-6 * one);
        // A row is one block, so that a path has one cut: 2 x 6 rows, two fillets, the bottom's.
        let cuts = |operation: &Value| -> f64 {
            operation["limited_by"].as_object().expect("limits").values().map(number).sum()
        };
        let paths = result["operations"].as_array().expect("operations").iter();
        for (operation, planned) in operations.iter().zip(paths) {
            assert_eq!(cuts(operation), 20.0 * number(&planned["paths"]), "{operation}");
        }
    }
    for (file, control) in FILES {
        let path = out.join("programs").join(file);
        let run = checked(&path, "five-axis-ac-table", &job);
        assert_eq!(run.exit, Some(0), "{file}: {}{}", run.stdout, run.stderr);
        let found = run.json();
        assert_eq!((&found["control"], &found["kind"]), (&control.into(), &"milling".into()), "{file}");
        let whole = number(&programs[0]["duration_s"]);
        assert!((number(&found["duration_s"]) / whole - 1.0).abs() < 0.02, "{file}: {}", found["duration_s"]);
        for flank in ["left", "right"] {
            let flank = &found["flanks"][flank];
            assert!(number(&flank["difference_um"]) < 0.5, "{file}: {flank}");
            assert!(number(&flank["max_deviation_um"]) < 40.0, "{file}: {flank}");
        }
    }
    // The last cut of the first flank in the first space, 50 um off in X: not what was planned.
    let text = std::fs::read_to_string(out.join("programs/milling-linuxcnc.ngc")).expect("a program");
    let line = text.lines().find(|line| line.contains("G1") && line.contains(" X")).expect("a cut");
    let word = line.split_whitespace().find(|word| word.starts_with('X')).expect("an X");
    let x: f64 = word[1..].parse().expect("a number");
    let shifted = directory.path().join("shifted.ngc");
    // Every block that goes to this X goes to another one: the row as a whole is moved.
    let moved = text.replace(&format!(" {word} "), &format!(" X{:.4} ", x + 0.05));
    assert_ne!(moved, text);
    std::fs::write(&shifted, moved).expect("a written program");
    let run = checked(&shifted, "five-axis-ac-table", &job);
    let found = run.json();
    let differences = ["left", "right"].map(|flank| number(&found["flanks"][flank]["difference_um"]));
    assert!(differences.iter().any(|um| *um > 5.0), "{differences:?}");
    // Tools that the job does not have.
    let foreign = directory.path().join("foreign.ngc");
    std::fs::write(&foreign, text.replace("T1 M6", "T7 M6")).expect("a written program");
    let run = checked(&foreign, "five-axis-ac-table", &job);
    assert_eq!(run.exit, Some(2), "{}", run.stdout);
    assert!(run.stderr.contains("unknown-tool") || run.stdout.contains("unknown-tool"), "{run:?}");
}

#[test]
fn led_tips_are_checked_and_orientations_compared() {
    let (result, job, out, _directory) = planned("spiral-bevel-on-head-table", &[]);
    let orientation = &result["flanks"]["left"]["orientation"];
    assert_eq!(orientation["axes"], serde_json::json!(["C", "B"]));
    // This flank pays some degrees for a third of the lean (`docs/mathematics/milling.md#positions-of-five-axes`).
    let of = |key: &str, what: &str, k: usize| number(&orientation[key][what][k]);
    let saved = of("iso", "travel_deg", 0) - of("column", "travel_deg", 0);
    assert!((-8.0..-6.0).contains(&saved), "{orientation}");
    assert!(of("column", "lean_deg", 1) < 4.5 && of("iso", "lean_deg", 0) < -16.0, "{orientation}");
    assert!(of("sheared", "travel_deg", 1) > 15.0 && of("sheared", "reversals", 1) == 2.0, "{orientation}");
    let report = std::fs::read_to_string(out.join("report.html")).expect("a report");
    for said in [
        "Orientation of the cutter",
        "does not generally save rotary motion",
        "Cycle times: linuxcnc",
        "Cycle times: siemens, fanuc",
        "Axes over time: all paths of the first space",
        "two positions of the rotary axes",
        "shares no code with the writer",
    ] {
        assert!(report.contains(said), "{said}");
    }
    for (file, _) in FILES {
        let run = checked(&out.join("programs").join(file), "five-axis-head-table", &job);
        assert_eq!(run.exit, Some(0), "{file}: {}{}", run.stdout, run.stderr);
        let found = run.json();
        assert!(number(&found["flanks"]["left"]["difference_um"]) < 2.0, "{file}: {}", found["flanks"]);
        let axes = found["axes"].as_array().expect("axes");
        assert_eq!(axes.len(), 5, "{file}");
        assert!(axes.iter().all(|axis| number(&axis["way"]) > 0.1), "{file}: {axes:?}");
    }
}

/// The reference's helical row, on a table B-C: polar angles of the axis are those of a table A-C.
#[test]
fn a_helical_row_turns_as_the_reference_says() {
    let one = [("\"linuxcnc\", \"siemens\", \"fanuc\"", "\"fanuc\"")];
    let (result, ..) = planned("helical-on-bc-table", &one);
    let orientation = &result["flanks"]["left"]["orientation"];
    let of = |key: &str, what: &str| {
        let pair = orientation[key][what].as_array().expect("two numbers");
        [number(&pair[0]), number(&pair[1])]
    };
    let near = |a: [f64; 2], b: [f64; 2]| (0..2).all(|k| (a[k] - b[k]).abs() < 1e-3);
    assert!(near(of("column", "travel_deg"), [18.16487, 0.0]), "{orientation}");
    assert!(near(of("iso", "travel_deg"), [18.16487, 0.0]), "{orientation}");
    assert!(near(of("sheared", "travel_deg"), [18.16487, 19.76404]), "{orientation}");
    assert!(near(of("column", "lean_deg"), [0.48709, 0.48709]), "{orientation}");
    assert!(near(of("iso", "lean_deg"), [-8.45486, -8.45486]), "{orientation}");
    assert!(near(of("sheared", "lean_deg"), [-13.76488, -2.99485]), "{orientation}");
    assert!(near(of("sheared", "max_second_deg_per_mm2"), [0.02674, 0.06128]), "{orientation}");
}

#[test]
fn a_machine_without_wishes_gets_all_its_controls_and_parquet_a_warning() {
    let coarse = [
        ("programs = [\"linuxcnc\", \"siemens\", \"fanuc\"]", "tables = [\"parquet\"]"),
        ("rows = 5", "rows = 3"),
        ("tolerance_um = 60.0", "tolerance_um = 600.0"),
        ("rays_length = 11", "rays_length = 11\ncompare_orientation = false"),
    ];
    let (result, ..) = planned("spiral-bevel-on-head-table", &coarse);
    assert_eq!(result["programs"].as_array().map(Vec::len), Some(3));
    let warnings = result["warnings"].as_array().expect("warnings");
    assert!(warnings.iter().any(|warning| warning["code"] == "parquet-not-written"), "{warnings:?}");
    assert!(result["flanks"]["left"].get("orientation").is_none());
}

#[test]
fn a_job_without_machine_cannot_tell_what_a_program_does() {
    let directory = tempfile::tempdir().expect("a directory");
    let job = repository().join("examples/milling/spur-module-8.toml").display().to_string();
    let program = directory.path().join("any.ngc");
    std::fs::write(&program, "G21 G90\nG0 X1\nM2\n").expect("a written program");
    let run = checked(&program, "five-axis-ac-table", &job);
    assert_eq!(run.exit, Some(2), "{run:?}");
    assert!(run.stderr.contains("[machine]") || run.stdout.contains("[machine]"), "{run:?}");
}
