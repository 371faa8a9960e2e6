//! A worm that a disc in point contact writes line by line, as a user of the command meets it: files, figures, refusals.

use crate::command::{Run, check, example, replaced, repository, run, write_job};
use serde_json::Value;
use std::path::Path;

const POINT: &str = "contact = \"point\"\n";
const TIP: &str = "tip_radius = 0.4";
const SCALLOP: &str = "scallop_um = 0.5";

/// Change of the example, code, field, and what is said.
type Case<'a> = ((&'a str, &'a str), &'a str, &'a str, &'a [&'a str]);

/// The example on a coarse grid with the given replacements.
fn job(replacements: &[(&str, &str)]) -> String {
    let text = example("line-dressing.toml")
        .replace("profile_points = 25", "profile_points = 7")
        .replace("helix_points = 31", "helix_points = 9");
    replaced(text, replacements)
}

fn planned(directory: &Path, replacements: &[(&str, &str)]) -> Run {
    let path = write_job(directory, job(replacements), &[]);
    run(&["plan", &path, "-o", directory.join("out").to_str().unwrap(), "--json"])
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key}: {value}"))
}

#[test]
fn lines_are_planned_refereed_and_written() {
    let directory = tempfile::tempdir().unwrap();
    let plan = planned(directory.path(), &[]);
    assert_eq!(plan.exit, Some(0), "{plan:?}");
    let result = plan.json();
    for flank in ["left", "right"] {
        let f = &result["flanks"][flank];
        let lines = &f["line_dressing"];
        // The rays see what the curvature tells, somewhat less where it is not greatest, and nothing cut too deep.
        let (told, seen) = (number(lines, "scallop_um"), number(lines, "simulated_scallop_um"));
        assert!(told <= 0.5 + 1e-9 && seen < 1.02 * told && seen > 0.8 * told, "{flank}: {told} {seen}");
        assert!(number(lines, "simulated_undercut_um") < 0.01, "{flank}: {lines}");
        assert!(number(lines, "clearance_mm") > 0.0);
        let share = (number(f, "max_deviation_um") + seen) / number(&result, "tolerance_um");
        assert!((number(f, "tolerance_share") - share).abs() < 1e-9, "{flank}: {share}");

        let table = directory.path().join(format!("out/motions/dressing-lines-{flank}.csv"));
        let table = std::fs::read_to_string(table).unwrap();
        let title = "line,X_1_mm,w_1_mm,z_1_mm,phi_S_deg,v_zS_mm,d_A_mm,gamma_A_deg,v_yA_mm";
        assert_eq!(table.lines().next(), Some(title));
        let rows = number(lines, "lines") * number(lines, "nodes_per_line");
        assert_eq!(table.lines().count() as f64, 1.0 + rows);
    }
    // Both flanks ask for one ratio with these lines.
    let codes: Vec<&str> =
        result["warnings"].as_array().unwrap().iter().filter_map(|w| w["code"].as_str()).collect();
    assert_eq!(codes, ["dressing-lines-laid"]);
    let report = std::fs::read_to_string(directory.path().join("out/report.html")).unwrap();
    for words in ["in a point, line by line", "scallops by rays", "disc on its lines against worm"] {
        assert!(report.contains(words), "{words}");
    }

    // The settings hold the lines, whatever the target becomes.
    let settings = directory.path().join("out/settings.json");
    let again = directory.path().join("again");
    let repeat = |expected: i32| {
        let run = run(&["simulate", settings.to_str().unwrap(), "-o", again.to_str().unwrap(), "--json"]);
        assert_eq!(run.exit, Some(expected), "{run:?}");
        run.json()
    };
    let simulated = repeat(0);
    for flank in ["left", "right"] {
        let pick = |result: &Value| result["flanks"][flank]["line_dressing"].clone();
        let (a, b) = (pick(&result), pick(&simulated));
        for key in
            ["line_direction_deg", "lines", "pitch_mm", "scallop_um", "simulated_scallop_um", "clearance_mm"]
        {
            let (a, b) = (number(&a, key), number(&b, key));
            assert!((a - b).abs() < 1e-6 * a.abs().max(1e-3), "{flank} {key}: {a} {b}");
        }
    }
    let text = std::fs::read_to_string(&settings).unwrap();
    let mut changed: Value = serde_json::from_str(&text).unwrap();
    changed["target"]["modifications"] = Value::Array(Vec::new());
    std::fs::write(&settings, changed.to_string()).unwrap();
    let other = repeat(3);
    let direction = |result: &Value| number(&result["flanks"]["left"]["line_dressing"], "line_direction_deg");
    assert!((direction(&other) - direction(&result)).abs() < 1e-9);
}

#[test]
fn scallops_count_in_the_verdict() {
    let directory = tempfile::tempdir().unwrap();
    let run = planned(directory.path(), &[(SCALLOP, "scallop_um = 1.5")]);
    assert_eq!(run.exit, Some(3), "{run:?}");
    let reason = &run.json()["reason"];
    assert_eq!(reason["code"], "scallops-above-tolerance");
    assert!(reason["way_out"].as_str().unwrap().contains("dressing.scallop_um"));
}

/// The job of few lines, with a machine and two threads.
fn small_job(directory: &Path) -> String {
    let path = repository().join("crates/flankwright-cli/tests/cli/every_key/grinding/line-dressing.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let machine = repository().join("machines/eight-axis.toml").display().to_string();
    let text = replaced(
        text,
        &[
            ("threads = 1", "threads = 2"),
            ("tolerance_um = 5.0", "tolerance_um = 10.0"),
            ("scallop_um = 4.0", "scallop_um = 8.0"),
            ("{ left = 85.0, right = 85.0 }", "80.0"),
        ],
    );
    let text = format!("{text}\n[machine]\nfile = {machine:?}\n[output]\nprograms = [\"siemens\"]\n");
    write_job(directory, text, &[])
}

#[test]
fn lines_on_all_threads_become_a_proven_program() {
    let directory = tempfile::tempdir().unwrap();
    let job = small_job(directory.path());
    let out = directory.path().join("out");
    let plan = run(&["plan", &job, "-o", out.to_str().unwrap(), "--json"]);
    assert_eq!(plan.exit, Some(0), "{plan:?}");
    let result = plan.json();
    let lines = &result["programs"]["proofs"][0]["lines"][0];
    assert_eq!((&lines["flank"], &lines["threads"]), (&"left".into(), &2.into()));
    assert_eq!(lines["lines"], result["flanks"]["left"]["line_dressing"]["lines"]);
    let report = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(report.contains("dressing the left flank by lines"));

    let program = out.join("programs/dressing-left-siemens.mpf");
    let machine = repository().join("machines/eight-axis.toml");
    let checked = |program: &Path| {
        let (program, machine) = (program.to_str().unwrap(), machine.to_str().unwrap());
        run(&["program", "check", program, "--machine", machine, "--job", &job, "--quiet", "--json"])
    };
    let sound = checked(&program);
    assert_eq!(sound.exit, Some(0), "{sound:?}");
    assert_eq!(sound.json()["threads"].as_array().map(Vec::len), Some(2));

    // Without its second thread the text is refused by name.
    let text = std::fs::read_to_string(&program).unwrap();
    let from = text.find("; DRESSING LEFT FLANK BY LINES THREAD 2").unwrap();
    let to = from + text[from..].find("M2=5").unwrap();
    let damaged = directory.path().join("damaged.mpf");
    std::fs::write(&damaged, text[..from].to_owned() + &text[to..]).unwrap();
    let refused = checked(&damaged);
    assert_eq!(refused.exit, Some(3), "{refused:?}");
    let answer = refused.json();
    let remarks = answer["remarks"].as_array().unwrap();
    let missing = remarks.iter().find(|r| r["code"] == "line-missing").unwrap_or_else(|| panic!("{answer}"));
    assert!(missing["text"].as_str().unwrap().contains("thread 2 of 2"), "{missing}");
}

#[test]
fn a_disc_that_finds_no_room_ends_with_4() {
    let directory = tempfile::tempdir().unwrap();
    let run = planned(directory.path(), &[(TIP, "tip_radius = 3.0")]);
    assert_eq!(run.exit, Some(4), "{run:?}");
    let error = &run.json()["error"];
    assert_eq!((&error["code"], &error["field"]), (&"disc-collides".into(), &"dresser.tip_radius".into()));
    assert!(error["way_out"].as_str().unwrap().contains("smaller tip radius"));
}

#[test]
fn every_contradiction_is_told_in_full() {
    let cases: &[Case] = &[
        ((TIP, "tip_radius = 40.0"), "invalid-geometry", "dresser.tip_radius", &["40", "up to 30"]),
        ((TIP, "tip_radius = 400.0"), "invalid-number", "dresser.tip_radius", &["400", "100", "0.5"]),
        ((TIP, "tip_radius = 0.0"), "invalid-number", "dresser.tip_radius", &["> 0"]),
        ((TIP, ""), "missing-key", "dresser.tip_radius", &["radius of the rounded tip", "0.5"]),
        ((POINT, ""), "invalid-job", "dresser.tip_radius", &["contact = \"line\"", "\"point\""]),
        ((POINT, ""), "invalid-job", "dressing.scallop_um", &["contact = \"line\"", "\"point\""]),
        ((POINT, "contact = \"points\"\n"), "unknown-value", "dresser.contact", &["did you mean \"point\""]),
        ((SCALLOP, "scallop_um = 0.0"), "invalid-number", "dressing.scallop_um", &["0.001", "100"]),
        ((SCALLOP, "scallop_um = 500.0"), "invalid-number", "dressing.scallop_um", &["500", "0.001", "100"]),
        ((SCALLOP, "scallop_um = \"0.5\""), "wrong-type", "dressing.scallop_um", &["number"]),
        (
            (SCALLOP, "line_direction_deg = 90.0"),
            "invalid-number",
            "dressing.line_direction_deg",
            &["90", "-90"],
        ),
        (
            (SCALLOP, "line_direction_deg = { left = 65.0, right = 60.0 }"),
            "direction-is-contact-path",
            "dressing.line_direction_deg",
            &["left flank", "65", "at least 0.1 deg from 64.", "turn the lines"],
        ),
        (
            (TIP, "tip_radius = 0.4\ntip_land = 0.5"),
            "invalid-job",
            "dresser.tip_land",
            &["contact = \"point\"", "leave it out"],
        ),
        (
            (TIP, "tip_radius = 0.4\nmodification = \"none\""),
            "invalid-job",
            "dresser.modification",
            &["contact = \"point\""],
        ),
        ((SCALLOP, "flanks = \"two\""), "invalid-job", "dressing.flanks", &["contact = \"point\""]),
        (
            (SCALLOP, "conditions = [\"four-point\"]"),
            "invalid-job",
            "dressing.conditions",
            &["contact = \"point\""],
        ),
        (
            ("width = 100.0", "width = 100.0\ncone_angle_deg = 3.0"),
            "not-yet-supported",
            "worm.cone_angle_deg",
            &["line dressing of a conical worm", "free direction"],
        ),
        (
            ("[grid]", "[explore]\ndressing = { over = \"crowning\" }\n[grid]"),
            "invalid-job",
            "dresser.contact",
            &["study of dressing", "leave `contact` out"],
        ),
    ];
    for ((from, to), code, field, says) in cases {
        let (human, machine) = check("bad.toml", job(&[(from, to)]).as_bytes());
        let about = format!("{from} -> {to}\n{}\n{}", human.stderr, machine.stdout);
        assert_eq!((human.exit, machine.exit), (Some(2), Some(2)), "{about}");
        let answer = machine.json();
        let errors = answer["errors"].as_array().cloned().unwrap_or_else(|| vec![answer["error"].clone()]);
        let error = errors.iter().find(|e| e["code"] == *code && e["field"] == *field);
        let error = error.unwrap_or_else(|| panic!("no {code} of {field}: {about}"));
        for part in ["message", "allowed", "way_out"] {
            assert!(error[part].as_str().is_some_and(|t| !t.is_empty()), "{part}: {about}");
        }
        assert!(error["line"].as_u64().is_some(), "{about}");
        let message = human.message();
        for said in says.iter().copied().chain([*code, *field]) {
            assert!(message.contains(said), "`{said}` is not said: {about}");
        }
    }
}
