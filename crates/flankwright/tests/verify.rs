//! The reference files against the library, and the check itself against manipulated files.

use flankwright::workflow::verify::{
    FileReport, Schema, VerifyError, VerifyOptions, VerifySummary, verify_file, verify_value,
};
use serde_json::{Value, json};
use std::path::PathBuf;

fn path(name: &str) -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/reference")).join(name)
}

fn content(name: &str) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path(name)).unwrap()).unwrap()
}

fn check(root: &Value) -> FileReport {
    verify_value("test", root, &VerifyOptions::default()).unwrap()
}

/// Passes without failure and with at least `floor` comparisons, so that an empty check cannot pass.
fn passes(name: &str, floor: usize) -> FileReport {
    let report = verify_file(&path(name), &VerifyOptions::default()).unwrap();
    let failures: Vec<String> = report.failures.iter().take(20).map(|f| format!("{f:?}")).collect();
    assert!(failures.is_empty(), "{name}: {} failures\n{}", report.failed, failures.join("\n"));
    assert!(report.checks >= floor, "{name}: only {} checks", report.checks);
    report
}

fn uncovered(report: &FileReport) -> Vec<&str> {
    let mut blocks: Vec<&str> = report.not_covered.iter().map(|n| n.block.as_str()).collect();
    blocks.sort_unstable();
    blocks.dedup();
    blocks
}

#[test]
fn gears_pass_whole() {
    let report = passes("10-gears.json", 1100);
    assert_eq!((report.schema, report.not_covered.len()), (Schema::Gears, 0));
    assert!(report.worst.as_ref().unwrap().share_of_tolerance < 1.0);
    assert_eq!(VerifySummary::new(vec![report]).exit_code(false), 0);
}

#[test]
fn contact_passes() {
    let report = passes("20-generating-contact.json", 4900);
    assert_eq!(report.schema, Schema::Contact);
    let only = [
        "equal_diagonal_ratio",
        "left.step_error.facet_simulated_um",
        "left.step_error.feed_mark_simulated_um",
        "right.step_error.facet_simulated_um",
        "right.step_error.feed_mark_simulated_um",
    ];
    assert!(uncovered(&report).iter().all(|block| only.contains(block)), "{:?}", uncovered(&report));
}

#[test]
fn modifications_pass() {
    let report = passes("25-modifications.json", 1900);
    assert_eq!(report.schema, Schema::Modifications);
    assert!(
        report.not_covered.iter().all(|n| !["gears", "elementary", "mapping"].contains(&n.block.as_str()))
    );
}

#[test]
fn files_to_come_are_recognised_and_listed() {
    for (name, schema) in [("28-planning.json", Schema::Planning), ("30-dressing.json", Schema::Dressing)] {
        let report = passes(name, 0);
        assert_eq!(report.schema, schema);
        if report.checks == 0 {
            assert!(!report.not_covered.is_empty());
        }
    }
    let shapes = [
        (json!({"errors": content("10-gears.json")["errors"]}), Schema::Gears),
        (json!({"gears": []}), Schema::Contact),
        (json!({"ground_flank": {"cases": []}}), Schema::Contact),
        (json!({"gears": {}}), Schema::Modifications),
        (json!({"machines": {}, "inverse": []}), Schema::MachineChains),
        (json!({"dresser_profile": {}, "left": {}, "right": {}}), Schema::TangentialDressing),
        (json!({"topic": "", "cases": {}, "octoid": {}}), Schema::Milling),
        (json!({"calibration": [], "examples": {}}), Schema::Skiving),
        (json!({"pulse_trains": [], "servo": {}}), Schema::Gearbox),
        (json!({"reader": [], "traces": []}), Schema::Inspection),
    ];
    for (root, schema) in shapes {
        let report = check(&root);
        assert_eq!((report.schema, report.failed), (schema, 0));
        let uncovered = !report.not_covered.is_empty();
        let summary = VerifySummary::new(vec![report]);
        assert_eq!((summary.exit_code(false), summary.exit_code(true)), (u8::from(uncovered), 0));
    }
}

#[test]
fn absent_data_files_are_not_run_and_no_failure() {
    let report = check(&json!({"reader": [], "real_parts": [{"name": "pinion", "file": "no_such.mka"}]}));
    assert_eq!((report.failed, report.not_run.len()), (0, 1));
    assert!(report.not_run[0].reason.contains("no_such.mka"));
}

/// Every number under `pointer`'s expected object, moved by more than its tolerance, must be noticed.
/// `immaterial` names inputs among them on which nothing depends in this case.
fn notices_every_number(root: &Value, pointer: &str, immaterial: &[&str]) {
    let base = check(root).failed;
    let mut paths = Vec::new();
    numbers_below(root.pointer(pointer).unwrap(), pointer, &mut paths);
    assert!(paths.len() > 10);
    for path in paths {
        if immaterial.iter().any(|end| path.ends_with(end)) {
            continue;
        }
        let mut changed = root.clone();
        let value = changed.pointer_mut(&path).unwrap();
        let old = value.as_f64().unwrap();
        *value = json!(old + 0.013 + 0.01 * old.abs());
        let report = check(&changed);
        assert!(report.failed > base, "a change of {path} went unnoticed");
    }
}

fn numbers_below(value: &Value, pointer: &str, paths: &mut Vec<String>) {
    match value {
        Value::Object(map) => {
            map.iter().for_each(|(k, v)| numbers_below(v, &format!("{pointer}/{k}"), paths))
        }
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(k, v)| numbers_below(v, &format!("{pointer}/{k}"), paths));
        }
        Value::Number(_) => paths.push(pointer.into()),
        _ => {}
    }
}

#[test]
fn every_changed_number_of_a_gear_is_noticed() {
    let mut root = content("10-gears.json");
    root["cases"].as_array_mut().unwrap().truncate(1);
    // Rack heights and thicknesses of a cylindrical gear are the same in every section.
    notices_every_number(&root, "/cases/0/expected", &["/z_mm"]);
}

#[test]
fn every_changed_number_of_a_contact_case_is_noticed() {
    let mut root = content("20-generating-contact.json");
    root["cases"].as_array_mut().unwrap().truncate(1);
    root["ground_flank"]["cases"] = json!([]);
    for flank in ["left", "right"] {
        let step = &mut root["cases"][0]["expected"][flank]["step_error"];
        step.as_object_mut().unwrap().retain(|key, _| !key.ends_with("simulated_um"));
        // The line functions are inputs whose curvature shifts the second order by less than its tolerance.
        root["cases"][0]["expected"][flank].as_object_mut().unwrap().remove("modification");
    }
    // The ratio does not enter the curvature of a cylindrical pair.
    notices_every_number(&root, "/cases/0/expected", &["step_error/K_ZV1"]);
    notices_every_number(&root, "/cases/0/input", &[]);
}

#[test]
fn a_changed_ground_flank_is_noticed() {
    let root = content("20-generating-contact.json");
    for quantity in
        ["f_n2_ray_um", "f_n2_arc_um", "w_1_mm", "z_V2_mm", "determinant_ratio", "d_f_d_gamma_mm_per_rad"]
    {
        let mut changed = json!({"ground_flank": root["ground_flank"]});
        let value = &mut changed["ground_flank"]["cases"][1]["expected"]["right"][quantity][7];
        *value = json!(value.as_f64().unwrap() + 1e-4);
        assert_eq!(check(&changed).failed, 1, "{quantity}");
    }
    let mut changed = json!({"ground_flank": root["ground_flank"]});
    changed["ground_flank"]["cases"][0]["input"]["left"]["Delta_d"]["coefficients"][2] = json!(-0.14);
    let report = check(&changed);
    assert!(report.failed > 50 && report.failures.iter().all(|f| f.case == "ground_flank radial_crowning"));
}

#[test]
fn unknown_quantities_keys_and_blocks_fail() {
    let root = content("10-gears.json");
    let fails_with = |root: &Value, text: &str| {
        let report = check(root);
        assert_eq!(report.failed, 1, "{text}");
        assert!(report.failures[0].quantity.contains(text), "{:?}", report.failures[0]);
    };
    let mut changed = root.clone();
    changed["cases"][2]["expected"]["left"]["tooth_colour"] = json!(3.0);
    fails_with(&changed, "unknown quantity left.tooth_colour");
    let mut changed = root.clone();
    changed["cases"][2]["expected"]["points"][1]["torsion"] = json!(3.0);
    fails_with(&changed, "unknown quantity points[1].torsion");
    let mut changed = root.clone();
    changed["cases"][2]["more"] = json!({});
    fails_with(&changed, "unknown quantity more");
    let mut changed = root.clone();
    changed["gear_pairs"] = json!([]);
    fails_with(&changed, "unknown block gear_pairs");
    let mut changed = root.clone();
    changed["cases"][2]["input"]["backlash"] = json!(0.1);
    assert!(check(&changed).failed >= 1);
    let mut changed = content("20-generating-contact.json");
    changed["ground_flank"]["cases"][0]["expected"]["left"]["roughness"] = json!([1.0]);
    fails_with(&changed, "unknown quantity left.roughness");
}

#[test]
fn missing_tolerances_and_null_values_fail() {
    let mut root = content("10-gears.json");
    root["tolerance"].as_object_mut().unwrap().remove("f_n_um");
    let report = check(&root);
    assert_eq!(report.failed, 48); // six deviations in each of eight cases
    let mut root = content("10-gears.json");
    root["cases"][0]["expected"]["r_w_mm"] = Value::Null;
    assert_eq!(check(&root).failed, 1);
}

#[test]
fn an_accepted_impossible_body_fails() {
    let mut root = content("10-gears.json");
    root["errors"][1]["input"]["m_n_mm"] = json!(2.0);
    let report = check(&root);
    assert_eq!((report.failed, &report.failures[0].actual), (1, &Value::Null));
    root["cases"][0]["input"]["m_n_mm"] = json!(-1.0);
    let report = check(&root);
    assert!(report.failures.iter().any(|f| f.actual.as_str().is_some_and(|t| t.contains("normal_module"))));
}

#[test]
fn optional_gears_of_a_contact_file_are_checked() {
    let gears = content("10-gears.json");
    let mut root = content("20-generating-contact.json");
    root["gears"] = gears["cases"].clone();
    root["gears_tolerance"] = gears["tolerance"].clone();
    let without = check(&content("20-generating-contact.json"));
    let with = check(&root);
    assert_eq!(with.failed, 0);
    assert!(with.checks > without.checks + 1000);
}

#[test]
fn unknown_content_is_a_clear_error() {
    let options = VerifyOptions::default();
    for root in [json!({}), json!([1, 2]), json!({"job": {"name": "x"}}), json!({"cases": []})] {
        let error = verify_value("x.json", &root, &options).unwrap_err();
        assert_eq!(error.code(), "unknown-schema");
        assert!(error.to_string().contains("x.json") && !error.way_out().is_empty());
    }
    let error = verify_file(&path("absent.json"), &options).unwrap_err();
    assert!(matches!(&error, VerifyError::Unreadable { file, .. } if file.ends_with("absent.json")));
    let broken = std::env::temp_dir().join(format!("flankwright-verify-{}.json", std::process::id()));
    std::fs::write(&broken, "{\n \"cases\": [,]}").unwrap();
    let error = verify_file(&broken, &options).unwrap_err();
    std::fs::remove_file(&broken).unwrap();
    assert!(matches!(error, VerifyError::NotJson { line: 2, .. }), "{error}");
}

#[test]
fn the_json_has_the_fields_of_the_contract() {
    let summary = VerifySummary::new(vec![passes("10-gears.json", 1)]);
    let json = serde_json::to_value(&summary).unwrap();
    let file = &json["files"][0];
    for key in ["file", "schema", "checks", "failed", "failures", "not_run", "not_covered", "worst"] {
        assert!(file.get(key).is_some(), "{key}");
    }
    assert_eq!((&file["schema"], &json["failed"]), (&json!("10-gears"), &json!(0)));
    assert!(file["worst"]["share_of_tolerance"].as_f64().is_some());
    let mut root = content("10-gears.json");
    root["cases"][0]["expected"]["r_w_mm"] = json!(1.0);
    let failure = serde_json::to_value(check(&root)).unwrap()["failures"][0].clone();
    for key in ["case", "quantity", "expected", "actual", "difference", "tolerance"] {
        assert!(!failure[key].is_null(), "{key}");
    }
}

/// All places of a value, as JSON pointers.
fn places(value: &Value, pointer: String, found: &mut Vec<String>) {
    match value {
        Value::Object(map) => map.iter().for_each(|(k, v)| places(v, format!("{pointer}/{k}"), found)),
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(k, v)| places(v, format!("{pointer}/{k}"), found))
        }
        _ => {}
    }
    found.push(pointer);
}

/// One case of every block, so that a check is quick.
fn shortened(name: &str) -> Value {
    let mut root = content(name);
    let first = |list: &mut Value, n: usize| list.as_array_mut().unwrap().truncate(n);
    match name {
        "10-gears.json" => first(&mut root["cases"], 1),
        "20-generating-contact.json" => {
            first(&mut root["cases"], 1);
            first(&mut root["ground_flank"]["cases"], 2);
            root.as_object_mut().unwrap().remove("equal_diagonal_ratio");
        }
        _ => {
            root.as_object_mut().unwrap().retain(|key, _| {
                ["gears", "elementary", "mapping", "constant_ratio_lengths"].contains(&key.as_str())
            });
            first(&mut root["mapping"], 1);
            first(&mut root["constant_ratio_lengths"], 1);
            first(&mut root["elementary"]["items"], 3);
        }
    }
    root
}

#[test]
fn damaged_files_end_in_a_report_or_an_error() {
    let damages = [
        json!(null),
        json!("x"),
        json!(-1),
        json!(0),
        json!(1e300),
        json!(-1e-300),
        json!([]),
        json!({}),
        json!([[1e9]]),
    ];
    for name in ["10-gears.json", "20-generating-contact.json", "25-modifications.json"] {
        let root = shortened(name);
        assert_eq!(check(&root).failed, 0);
        let mut found = Vec::new();
        places(&root, String::new(), &mut found);
        for (k, place) in found.iter().enumerate() {
            for damage in [&damages[k % damages.len()], &damages[(k + 4) % damages.len()]] {
                let mut damaged = root.clone();
                *damaged.pointer_mut(place).unwrap() = damage.clone();
                match verify_value("damaged", &damaged, &VerifyOptions::default()) {
                    Ok(report) => {
                        let number = root.pointer(place).unwrap().is_number();
                        let exempt = place.contains("step_error") && place.ends_with("simulated_um")
                            || place.ends_with("brute_minus_kernel_um");
                        let expected =
                            place.contains("/expected/") && number && !damage.is_number() && !exempt;
                        assert!(!expected || report.failed > 0, "{name}{place} -> {damage} went unnoticed");
                    }
                    Err(error) => assert_eq!(error.code(), "unknown-schema"),
                }
            }
        }
    }
}
