//! Everyday slips and habits: two jobs of one name, a job in its own results, spreadsheets with a decimal comma, what `check` finds before
//! anything is planned, names of faces.

use crate::command::{check, example, replaced, run, write_job};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// The first example with a coarse grid.
fn job() -> String {
    example("twist-free-crowning.toml").replace("_points = 41", "_points = 5")
}

fn file(directory: &Path, name: &str, text: &str) -> String {
    let path = directory.join(name);
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

fn error_of(arguments: &[&str]) -> Value {
    let refused = run(&[arguments, &["--json"]].concat());
    assert_eq!(refused.exit, Some(2), "{refused:?}");
    refused.json()["error"].clone()
}

#[test]
fn results_of_another_job_are_not_overwritten_without_a_word() {
    let directory = tempfile::tempdir().unwrap();
    let (one, two) = (file(directory.path(), "one.toml", &job()), file(directory.path(), "two.toml", &job()));
    let out = directory.path().join("twist-free-crowning.out");
    for _ in 0..2 {
        assert_eq!(run(&["plan", &one]).exit, Some(0));
    }
    let result = || fs::read(out.join("result.json")).unwrap();
    let before = result();
    let error = error_of(&["plan", &two]);
    assert_eq!((&error["code"], &error["field"]), (&json!("folder-of-another-job"), &json!("job.name")));
    assert!(error["message"].as_str().unwrap().contains("one.toml"), "{error}");
    assert_eq!(result(), before);
    // Asked for, or with nobody to lose anything, it goes there.
    assert_eq!(run(&["plan", &two, "-o", out.to_str().unwrap()]).exit, Some(0));
    fs::remove_file(&one).unwrap();
    assert_eq!(run(&["plan", &two]).exit, Some(0));
}

#[test]
fn settings_are_simulated_beside_the_results_that_they_lie_in() {
    let directory = tempfile::tempdir().unwrap();
    let one = file(directory.path(), "one.toml", &job());
    assert_eq!(run(&["plan", &one]).exit, Some(0));
    let settings = directory.path().join("twist-free-crowning.out/settings.json");
    assert_eq!(run(&["simulate", settings.to_str().unwrap()]).exit, Some(0));
    assert!(directory.path().join("twist-free-crowning.settings.out/result.json").is_file());
    assert!(!directory.path().join("twist-free-crowning.out/twist-free-crowning.out").exists());
}

#[test]
fn check_says_what_a_plan_would_say() {
    let refused = |replacements: &[(&str, &str)], field: &str| {
        let (_, told) = check("job.toml", replaced(job(), replacements).as_bytes());
        assert_eq!(told.exit, Some(2), "{replacements:?}: {told:?}");
        assert_eq!(told.json()["error"]["field"], field, "{replacements:?}: {told:?}");
        told.json()["error"].clone()
    };
    let grinding = "[grid]\n";
    refused(&[(grinding, "[machine]\nfile = \"nowhere.toml\"\n\n[grid]\n")], "machine.file");
    refused(
        &[
            ("teeth = 19", "teeth = -57"),
            ("tip_diameter = 88.5315", "tip_diameter = 236.0"),
            ("root_diameter = 72.4315", "root_diameter = 252.0"),
            ("form_diameter = 76.2065", "form_diameter = 250.0"),
            (
                "evaluation = { start_diameter = 76.2065, end_diameter = 88.5315, z_start = -20.0, z_end = 20.0 }",
                "",
            ),
        ],
        "grinding",
    );
    let both = refused(&[("profile_points = 5", "profile_points = 2000")], "grid.profile_points");
    assert!(both["way_out"].as_str().unwrap().contains("40401"), "{both}");
    // The drawing's own number of teeth, not the best one.
    let text = replaced(job(), &[("profile_shift = 0.0\n", "span = { teeth = 3, length = 26.65 }\n")]);
    let (_, told) = check("job.toml", text.as_bytes());
    let thickness = told.json()["derived"]["tooth_thickness"].clone();
    assert_eq!(thickness["span_teeth"], 3, "{told:?}");
    assert!((thickness["span_mm"].as_f64().unwrap() - 26.65).abs() < 1e-6);
}

/// What a shop asks before it plans: sizes with their limits, tolerances of the class, reach of the worm, the axes of its machine.
#[test]
fn check_answers_before_any_plan() {
    let machine = format!("{}/../../machines/eight-axis.toml", env!("CARGO_MANIFEST_DIR"));
    let drawn = "span = { teeth = 3, length = 26.65 }\nallowances_um = { lower = -90.0, upper = -50.0 }\n\
                 measured_over = { ball_diameter = 6.0, roll_diameter = 6.0 }\ntolerance_class = 6\n";
    let on_machine = format!("[machine]\nfile = {machine:?}\n\n[grid]\n");
    let text = replaced(job(), &[("profile_shift = 0.0\n", drawn), ("[grid]\n", &on_machine)]);
    let (_, told) = check("job.toml", text.as_bytes());
    assert_eq!(told.exit, Some(0), "{told:?}");
    let derived = &told.json()["derived"];
    let number = |section: &str, key: &str| {
        derived[section][key].as_f64().unwrap_or_else(|| panic!("no {section}.{key}: {derived}"))
    };
    for (key, want) in [("span_mm", 26.58), ("span_least_mm", 26.56), ("span_greatest_mm", 26.6)] {
        assert!(
            (number("tooth_thickness", key) - want).abs() < 1e-9,
            "{key}: {}",
            number("tooth_thickness", key)
        );
    }
    // An odd number of helical teeth: rolls slide opposite each other, balls stand in one section.
    assert!(number("tooth_thickness", "over_rolls_mm") > number("tooth_thickness", "over_balls_mm") + 0.2);
    assert_eq!(number("tolerances_of_ISO_1328-1", "class"), 6.0);
    assert!((number("tolerances_of_ISO_1328-1", "F_pT_um") - 28.0).abs() < 0.5);
    let reach = number("reach_and_feed", "generated_from_left_mm");
    assert!(reach > 72.4 && reach < 76.21, "{reach}");
    for axis in ["X1_room_mm", "Z1_room_mm", "A1_room_deg", "V1_room_mm"] {
        assert!(number("machine,_before_corrections", axis) > 0.0, "{axis}");
    }
    // The whole width passes the dresser: a travel of 110 mm has no room for it, whatever the plan.
    let description = std::fs::read_to_string(&machine).unwrap();
    let directory = tempfile::tempdir().unwrap();
    let (before, shift) = description.split_once("[axes.V1]").unwrap();
    let shift = shift.replacen("min_mm = -140", "min_mm = -55", 1).replacen("max_mm = 140", "max_mm = 55", 1);
    file(directory.path(), "narrow.toml", &format!("{before}[axes.V1]{shift}"));
    let text = text.replace(&format!("{machine:?}"), "\"narrow.toml\"");
    let path = write_job(directory.path(), text, &[]);
    let told = run(&["check", &path, "--json"]);
    assert_eq!(told.exit, Some(0), "{told:?}");
    let warnings = told.json()["warnings"].clone();
    let said = warnings.as_array().unwrap().iter().find(|warning| warning["code"] == "beyond-travel");
    assert!(said.is_some_and(|said| said["text"].as_str().unwrap().contains("V1")), "{warnings}");
    // A roll that no face width brings opposite its fellow, a measure that touches no involute.
    for (key, more) in [
        ("gear.measured_over.roll_diameter", "measured_over = { roll_diameter = 6.0 }\n"),
        ("gear.measured_over.ball_diameter", "measured_over = { ball_diameter = 1.0 }\n"),
        ("gear.measured_over.span_teeth", "measured_over = { span_teeth = 12 }\n"),
        ("gear.allowances_um.lower", "allowances_um = { lower = -50.0, upper = -90.0 }\n"),
        ("gear.tolerance_class", "tolerance_class = 12\n"),
    ] {
        let text = replaced(job(), &[("profile_shift = 0.0\n", &format!("profile_shift = 0.0\n{more}"))]);
        let text = if key.ends_with("roll_diameter") {
            replaced(
                text,
                &[
                    ("face_width = 40.0", "face_width = 9.0"),
                    ("z_start = -20.0, z_end = 20.0", "z_start = -4.0, z_end = 4.0"),
                ],
            )
        } else {
            text
        };
        let (_, told) = check("job.toml", text.as_bytes());
        assert_eq!(told.exit, Some(2), "{key}: {told:?}");
        assert_eq!(told.json()["error"]["field"], key, "{told:?}");
        assert!(
            told.json()["error"]["way_out"].as_str().is_some_and(|way_out| !way_out.is_empty()),
            "{told:?}"
        );
    }
}

#[test]
fn decimal_commas_are_read_in_tables_and_named_in_jobs() {
    let directory = tempfile::tempdir().unwrap();
    let rows = |row: &dyn Fn(f64, f64) -> String| -> String {
        let places = (0..25).map(|k| (4.0 + 5.0 * f64::from(k / 5), -20.5 + 10.25 * f64::from(k % 5)));
        places.map(|(w, z)| row(w, z)).collect()
    };
    let plain = rows(&|w, z| format!("{w},{z},{}\n", -0.5 - 0.25 * w / 30.0));
    file(directory.path(), "plain.csv", &format!("w_mm,z_mm,f_um\n{plain}"));
    let german = plain.replace(',', ";").replace('.', ",");
    file(directory.path(), "german.csv", &format!("w_mm;z_mm;f_um\n{german}"));
    let of = |table: &str| {
        let from = "modifications = [";
        let text = job();
        let (start, end) = (text.find(from).unwrap(), text.find("\n]\n").unwrap() + 3);
        let text = text[..start].to_owned() + &format!("file = \"{table}\"\n") + &text[end..];
        let path = write_job(directory.path(), text, &[]);
        let out = directory.path().join("out");
        let planned = run(&["plan", &path, "-o", out.to_str().unwrap()]);
        assert!(matches!(planned.exit, Some(0 | 3)), "{planned:?}");
        fs::read_to_string(out.join("topography.csv")).unwrap()
    };
    assert_eq!(of("german.csv"), of("plain.csv"));
    let (_, told) =
        check("job.toml", replaced(job(), &[("normal_module = 3.5", "normal_module = 3,5")]).as_bytes());
    let error = told.json()["error"].clone();
    assert!(error["message"].as_str().unwrap().contains("decimal sign is a point"), "{error}");
    assert_eq!(error["line"], job().lines().position(|line| line.starts_with("normal_module")).unwrap() + 1);
}

#[test]
fn faces_by_number_are_explained_and_stand_in_the_programs() {
    let directory = tempfile::tempdir().unwrap();
    let with = |entry: &str| {
        let text = replaced(
            job(),
            &[("{ kind = \"profile_crowning\", amount_um = 5.0, flank = \"both\" },", entry)],
        );
        let path = write_job(directory.path(), text, &[]);
        let out = directory.path().join("out");
        let planned = run(&["plan", &path, "--json", "-o", out.to_str().unwrap()]);
        let report = fs::read_to_string(out.join("report.html")).unwrap();
        (planned.json(), report)
    };
    let numbered = "{ kind = \"end_relief_I\", amount_um = 4.0, length_mm = 8.0, exponent = 2 },";
    let (by_number, report) = with(numbered);
    let remark =
        by_number["warnings"].as_array().unwrap().iter().find(|w| w["code"] == "face-names").unwrap();
    assert!(
        remark["text"]
            .as_str()
            .unwrap()
            .starts_with("end_relief_I means the face opposite the datum face (lower z, face I)")
    );
    for words in [
        "End relief at face I (not the datum face)",
        "face II is the datum face",
        "(datum face)",
        "(not datum)",
    ] {
        assert!(report.contains(words), "{words}");
    }
    let (by_name, _) = with(&numbered.replace("end_relief_I", "end_relief_non_datum_face"));
    assert!(by_name["warnings"].as_array().unwrap().iter().all(|w| w["code"] != "face-names"));
    assert_eq!(by_name["flanks"], by_number["flanks"]);
}

#[test]
fn a_gear_that_goes_to_rexs_and_back_can_still_be_planned() {
    let directory = tempfile::tempdir().unwrap();
    // The root is below the base circle, and a model without a profile crowning does not say where the profile begins.
    let evaluation =
        "evaluation = { start_diameter = 76.2065, end_diameter = 88.5315, z_start = -20.0, z_end = 20.0 }";
    let crowning = "{ kind = \"profile_crowning\", amount_um = 5.0, flank = \"both\" },";
    let relief =
        "{ kind = \"tip_relief\", amount_um = 5.0, length_mm = 4.0, exponent = 2, flank = \"both\" },";
    let text = replaced(job(), &[(evaluation, ""), (crowning, relief)]);
    let path = write_job(directory.path(), text, &[]);
    let model = directory.path().join("gear.rexs");
    let converted = run(&["convert", &path]);
    assert_eq!(converted.exit, Some(0), "{converted:?}");
    fs::write(&model, converted.stdout).unwrap();
    let back = run(&["convert", model.to_str().unwrap(), "--job", &path]);
    let job: Value = back.json();
    assert_eq!(job["gear"]["form_diameter"], 76.2065);
    let again = file(directory.path(), "again.json", &back.stdout);
    assert_eq!(run(&["check", &again]).exit, Some(0));
}
