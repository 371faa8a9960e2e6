//! The checks against the reference file, and against changes of it that none may overlook.

use super::super::{FileReport, VerifyOptions, verify_value};
use serde_json::{Value, json};

fn file() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/reference/70-gearbox.json");
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Some blocks of the file, beside an empty one by which it is recognised: other schemas have a block `gearbox` as well.
fn blocks(keys: &[&str]) -> Value {
    let whole = file();
    let mut root = json!({ "pulse_trains": [] });
    for key in keys {
        root[key] = whole[key].clone();
    }
    root
}

/// The pulse trains of these names; long ones take too long for many runs.
fn trains(names: &[&str]) -> Value {
    let whole = file();
    let listed = whole["pulse_trains"].as_array().unwrap();
    let kept: Vec<Value> =
        listed.iter().filter(|case| names.iter().any(|name| case["name"] == *name)).cloned().collect();
    assert_eq!(kept.len(), names.len());
    json!({ "pulse_trains": kept })
}

/// The chain behind the shortest random train, with that train.
fn short_chain() -> Value {
    let mut root = trains(&["random 2 no_backlash"]);
    root["chain"] = json!([file()["chain"][1]]);
    root
}

/// The word whose count changes with every number of pulses.
fn one_multiplier() -> Value {
    let mut root = blocks(&["rate_multiplier"]);
    root["rate_multiplier"]["cases"].as_array_mut().unwrap().retain(|case| case["B18"] == 262_143);
    root
}

fn one_reversal() -> Value {
    let mut root = blocks(&["literal_reversal_loss"]);
    root["literal_reversal_loss"].as_array_mut().unwrap().truncate(1);
    root
}

fn check(root: &Value) -> FileReport {
    verify_value("test", root, &VerifyOptions::default()).unwrap()
}

/// Numbers, and texts of numbers.
fn numbers_below(value: &Value, pointer: &str, paths: &mut Vec<String>) {
    match value {
        Value::Object(map) => {
            map.iter().for_each(|(key, v)| numbers_below(v, &format!("{pointer}/{key}"), paths));
        }
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(k, v)| numbers_below(v, &format!("{pointer}/{k}"), paths));
        }
        Value::Number(_) => paths.push(pointer.into()),
        Value::String(text) if text.parse::<f64>().is_ok() => paths.push(pointer.into()),
        _ => {}
    }
}

/// Another number of the same kind.
fn changed(value: &Value) -> Value {
    let other_whole = |n: i64| n + 1 + n.abs() / 50;
    let other = |x: f64| x * 1.03 + 0.013;
    match value {
        Value::String(text) => match text.parse() {
            Ok(n) => json!(other_whole(n).to_string()),
            Err(_) => json!(other(text.parse().unwrap()).to_string()),
        },
        number => match number.as_i64() {
            Some(n) => json!(other_whole(n)),
            None => json!(other(number.as_f64().unwrap())),
        },
    }
}

/// Changes every number below `pointer` alone; each must be a failure unless nothing depends on it.
fn every_change_is_noticed(root: &Value, pointer: &str, least: usize, immaterial: impl Fn(&str) -> bool) {
    assert_eq!(check(root).failures, []);
    let mut paths = Vec::new();
    numbers_below(root.pointer(pointer).unwrap(), pointer, &mut paths);
    // Tolerances of floating numbers may be wider, that of whole ones is 0.
    paths.retain(|path| !path.contains("tolerance_") && !immaterial(path));
    assert!(paths.len() >= least, "{pointer}: only {} numbers", paths.len());
    let unnoticed = paths.into_iter().filter(|path| {
        let mut root = root.clone();
        let value = root.pointer_mut(path).unwrap();
        *value = changed(value);
        check(&root).failed == 0
    });
    assert_eq!(unnoticed.collect::<Vec<_>>(), Vec::<String>::new());
}

#[test]
fn every_changed_number_of_servo_and_budget_is_noticed() {
    let immaterial = [
        "/servo/runs/0/input/par/w0",
        "/servo/runs/0/input/par/Tc",
        "/servo/runs/0/input/par/Tmax",
        "/servo/runs/1/input/par/Tmax",
        "/servo/runs/2/input/par/Tc",
        "/error_budget/3/input/a_mm_s2",
        "/servo/runs/0/expected/k/0",
        "/servo/runs/2/expected/k/0",
    ];
    // What a run does not reach or use may be anything, and the quantised run is compared to a third of its error only. At standstill the
    // share of the acceleration saturates. The first two samples of a run with feedforward are both without error.
    every_change_is_noticed(&blocks(&["servo", "error_budget"]), "", 150, |path| {
        let symbol = path.rsplit('/').next().unwrap_or("");
        ["input", "expected/k"].iter().any(|part| path.starts_with(&format!("/servo/runs/3/{part}")))
            || (path.starts_with("/servo/runs/") && ["ws", "Nw", "P", "steps"].contains(&symbol))
            || immaterial.contains(&path)
    });
}

#[test]
fn every_changed_number_of_pulses_is_noticed() {
    let root = trains(&["constant speed", "quick reversal literal", "random 2 no_backlash"]);
    // After the last pulse time may go on, and no interval is long enough for the period counter.
    every_change_is_noticed(&root, "", 200, |path| {
        path.ends_with("counter_max") || (path.ends_with("last_tick") && !path.starts_with("/pulse_trains/2"))
    });
    every_change_is_noticed(&short_chain(), "/chain", 10, |_| false);
    every_change_is_noticed(&one_multiplier(), "", 25, |_| false);
}

#[test]
fn every_changed_number_of_couplings_is_noticed() {
    let keys = ["coefficients", "couplings", "gearbox", "ratio_of_lead", "table", "synchroniser"];
    // Beyond the ends of a natural table the value is held, wherever; half a pitch forward is no other way for a greater pitch.
    let outside = [0, 1, 2, 19, 20, 21, 22].map(|k| format!("/table/0/input/x_mm/{k}"));
    let half_way = "/synchroniser/3/input/tooth_pitch_deg";
    every_change_is_noticed(&blocks(&keys), "", 200, |path| {
        path == half_way || outside.iter().any(|place| place == path)
    });
    every_change_is_noticed(&blocks(&["bresenham"]), "", 8, |_| false);
}

#[test]
fn every_changed_number_of_reversals_is_noticed() {
    // The share depends on nothing but P: neither on scale, clock and acceleration, nor on a counter that is never full.
    let immaterial = ["q_per_m", "f1_hz", "a_mm_s2", "counter_max"];
    every_change_is_noticed(&one_reversal(), "", 5, |path| immaterial.iter().any(|end| path.ends_with(end)));
}

/// Sets a value of the file and gives what the report says of it.
fn told(mut root: Value, pointer: &str, value: Value) -> (usize, String) {
    let (parent, key) = pointer.rsplit_once('/').unwrap();
    let parent = root.pointer_mut(parent).unwrap_or_else(|| panic!("{pointer}"));
    match parent {
        Value::Array(list) => list[key.parse::<usize>().unwrap()] = value,
        other => other[key] = value,
    }
    let report = check(&root);
    (report.failed, format!("{:?}", report.failures))
}

#[test]
fn unknown_quantities_of_every_block_are_failures() {
    let root = || {
        let mut root = blocks(&[
            "coefficients",
            "couplings",
            "gearbox",
            "bresenham",
            "ratio_of_lead",
            "table",
            "synchroniser",
            "error_budget",
            "servo",
        ]);
        for part in [one_multiplier(), one_reversal(), short_chain()] {
            root.as_object_mut().unwrap().extend(part.as_object().unwrap().clone());
        }
        root
    };
    assert_eq!(root().as_object().unwrap().len(), 13);
    let mut places: Vec<String> = ["/rate_multiplier", "/rate_multiplier/cases/0"].map(String::from).into();
    places.extend(["/servo", "/servo/runs/0", "/servo/gains"].map(String::from));
    places.extend(["/literal_reversal_loss/0", "/literal_reversal_loss/0/input"].map(String::from));
    for (key, value) in root().as_object().unwrap() {
        let case = if value.is_array() { format!("/{key}/0") } else { format!("/{key}") };
        if root().pointer(&case).unwrap()["expected"].is_object() {
            places.extend(["", "/input", "/expected"].map(|part| format!("{case}{part}")));
        }
    }
    assert_eq!(places.len(), 7 + 3 * 10);
    for place in places {
        let (failed, told) = told(root(), &format!("{place}/surprise"), json!(1.0));
        assert!(failed > 0 && told.contains("surprise"), "{place}: {told}");
    }
}

#[test]
fn what_is_not_known_is_named() {
    for (pointer, value, named) in [
        ("/servo/runs/0/input/torque_Nm", json!("0.8 sin(2 pi 50 t) - 3 step(t)"), "`step`"),
        ("/servo/runs/1/input/reference_rad", json!("w1*t"), "`w1`"),
        ("/servo/runs/1/input/t", json!("k*Ts + 1"), "`k*Ts`"),
        ("/servo/runs/3/input/par/quant", json!(2), "quant"),
        ("/servo/runs/0/input/par/Kp", json!(-1.0), "unstable"),
        ("/servo/runs", json!("none"), "list"),
        ("/error_budget/0/input/f1_hz", json!(-1.0), "clock"),
    ] {
        let (failed, told) = told(blocks(&["servo", "error_budget"]), pointer, value);
        assert!(failed > 0 && told.contains(named), "{pointer}: {told}");
    }
    for (root, pointer, value, named) in [
        (trains(&["constant speed"]), "/pulse_trains/0/input/mode", json!("other"), "variant"),
        (trains(&["constant speed"]), "/pulse_trains/0/input/reference_sign", json!([1]), "as many"),
        (trains(&["constant speed"]), "/pulse_trains/0/input/last_tick", json!(700), "last_tick"),
        (trains(&["constant speed"]), "/pulse_trains/0/expected/kind", json!("RRK"), "clocked form"),
        (trains(&["constant speed"]), "/pulse_trains/0/expected/fnv1a64", json!("0"), "event form"),
        (trains(&["constant speed"]), "/pulse_trains/0/expected/tick", json!([100]), "80 whole numbers"),
        (trains(&["random 2 seed"]), "/pulse_trains/0/input/lcg/lmin", json!(0), "random train"),
        (short_chain(), "/chain/0/input/lcg_seed", json!(7), "no random train"),
        (short_chain(), "/chain/0/input/hand", json!(0), "hand = 0"),
        (short_chain(), "/chain/0/input/B18", json!(1 << 18), "2^18"),
        (one_multiplier(), "/rate_multiplier/first_64_of_B_123456", json!("01"), "first_64"),
        (one_multiplier(), "/rate_multiplier/first_x_of_B_123456", json!("01"), "first_x"),
        (one_multiplier(), "/rate_multiplier/cases/0/n", json!([1u64 << 60]), "up to"),
        (one_reversal(), "/literal_reversal_loss/0/input/motion", json!("at rest"), "`at rest`"),
        (one_reversal(), "/literal_reversal_loss/0/input/q_per_m", json!(0), "pitch"),
        (one_reversal(), "/literal_reversal_loss/0/input/n", json!(0), "n = 0"),
        (blocks(&["bresenham"]), "/bresenham/input/dx", json!("(s mod 131) - 50"), "(s mod 131)"),
        (blocks(&["bresenham"]), "/bresenham/input/dx", json!("((s>>33) mod 0) - 50"), "mod 0"),
        (blocks(&["gearbox"]), "/gearbox/0/input/terms_n_d_x0", json!([]), "0 terms"),
        (blocks(&["gearbox"]), "/gearbox/0/input/x/1", json!([]), "leading axes"),
        (blocks(&["gearbox"]), "/gearbox/0/input/x/1", json!(["a"]), "whole number"),
        (blocks(&["ratio_of_lead"]), "/ratio_of_lead/0/expected/n", json!("NaN"), "NaN"),
        (blocks(&["table"]), "/table/1/input/kind", json!("cubic"), "variant"),
    ] {
        let (failed, told) = told(root, pointer, value);
        assert!(failed > 0 && told.contains(named), "{pointer}: {told}");
    }
}

#[test]
fn refusals_may_be_expected() {
    let bad_train = |ticks: Value, signs: Value| {
        let input = json!({
            "P": 4, "mode": "seed", "counter_max": 255, "last_tick": 900, "reference_tick": ticks, "reference_sign": signs
        });
        (trains(&["constant speed"]), "pulse_trains", input)
    };
    let changed_input = |block: &'static str, key: &str, value: Value| {
        let mut input = file()[block][0]["input"].clone();
        input[key] = value;
        let root = if block == "pulse_trains" { trains(&["constant speed"]) } else { blocks(&[block]) };
        (root, block, input)
    };
    for ((root, block, input), error) in [
        (bad_train(json!([10, 10]), json!([1, 1])), "BadReferenceTrain"),
        (bad_train(json!([-7, 10]), json!([1, 1])), "BadReferenceTrain(0)"),
        (bad_train(json!([9, 10]), json!([1, 0])), "bad_reference_train"),
        (changed_input("pulse_trains", "P", json!(1)), "BadMultiplier"),
        (changed_input("pulse_trains", "counter_max", json!(0)), "bad-multiplier"),
        (changed_input("coefficients", "q_per_m", json!(1.0)), "CoefficientTooLarge"),
        (changed_input("coefficients", "beta_deg", json!(0.0)), "SpurGear"),
        (changed_input("couplings", "z2", json!(0)), "BadGear"),
        (changed_input("gearbox", "terms_n_d_x0", json!([["1", "0", "0"]])), "GearRange"),
        (changed_input("table", "h_mm", json!(0.0)), "BadTable"),
        (changed_input("error_budget", "f1_hz", json!(0.0)), "BadParameter"),
    ] {
        let with = |input: Value, error: &str| {
            let (failed, _) = told(
                root.clone(),
                &format!("/{block}/0"),
                json!({ "input": input, "expected": { "error": error } }),
            );
            failed
        };
        assert_eq!(with(input.clone(), error), 0, "{block} {error}");
        assert_eq!(with(input.clone(), "EncoderJump"), 1, "{block} {error}");
        assert!(with(root[block][0]["input"].clone(), error) > 0, "{block} {error}");
        // Without an expected error it is a failure.
        assert!(told(root.clone(), &format!("/{block}/0/input"), input).0 > 0, "{block} {error}");
    }
}

#[test]
fn a_spur_gear_has_coefficients_and_no_lead() {
    let mut root = blocks(&["coefficients"]);
    root["coefficients"][0]["input"]["beta_deg"] = json!(0.0);
    root["coefficients"][0]["expected"] = json!({ "lead_mm": null, "b": 0.0, "B18": 0, "b_error_rel": 0.0 });
    assert_eq!(check(&root).failures, []);
    root["coefficients"][0]["expected"]["lead_mm"] = json!(1e300);
    assert_eq!(check(&root).failed, 1);
}

#[test]
fn blocks_without_cases_are_no_failure_and_no_lists_are() {
    assert_eq!(check(&json!({ "servo": {}, "error_budget": [], "chain": [], "pulse_trains": [] })).failed, 0);
    for block in ["pulse_trains", "literal_reversal_loss", "table"] {
        let (failed, told) = told(blocks(&["servo"]), &format!("/{block}"), json!(7));
        assert!(failed == 1 && told.contains("list"), "{told}");
    }
}
