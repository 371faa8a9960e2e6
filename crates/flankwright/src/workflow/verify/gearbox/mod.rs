//! 70-gearbox: pulse interpolation, couplings, tables and the servo loop of the electronic gearbox.

mod budget;
mod formula;
mod servo;

pub(in super::super) use budget::error_budget;
pub(in super::super) use servo::servo;

#[cfg(test)]
mod tests {
    use super::super::{FileReport, VerifyOptions, verify_value};
    use serde_json::{Value, json};

    /// The two blocks of the reference file.
    fn blocks() -> Value {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/reference/70-gearbox.json");
        let whole: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
        json!({ "servo": whole["servo"], "error_budget": whole["error_budget"] })
    }

    fn check(root: &Value) -> FileReport {
        verify_value("test", root, &VerifyOptions::default()).unwrap()
    }

    fn numbers_below(value: &Value, pointer: &str, paths: &mut Vec<String>) {
        match value {
            Value::Object(map) => {
                map.iter().for_each(|(key, v)| numbers_below(v, &format!("{pointer}/{key}"), paths));
            }
            Value::Array(list) => {
                list.iter().enumerate().for_each(|(k, v)| numbers_below(v, &format!("{pointer}/{k}"), paths));
            }
            Value::Number(_) => paths.push(pointer.into()),
            _ => {}
        }
    }

    #[test]
    fn both_blocks_pass() {
        let report = check(&blocks());
        assert!(report.failures.is_empty(), "{:#?}", report.failures);
        assert!(
            report.checks == 4 * 8 + 4 + 3 + 5 + 4 * 12 && report.not_covered.is_empty(),
            "{}",
            report.checks
        );
    }

    #[test]
    fn every_changed_number_is_noticed() {
        let root = blocks();
        let mut paths = Vec::new();
        numbers_below(&root, "", &mut paths);
        // Tolerances may be wider. What a run does not reach or use may be anything, and the quantised run is compared
        // to a third of its error only. At standstill the share of the acceleration saturates.
        let immaterial = [
            "/servo/runs/0/input/par/w0",
            "/servo/runs/0/input/par/Tc",
            "/servo/runs/0/input/par/Tmax",
            "/servo/runs/1/input/par/Tmax",
            "/servo/runs/2/input/par/Tc",
            "/error_budget/3/input/a_mm_s2",
        ];
        let idle = |path: &String| {
            let symbol = path.rsplit('/').next().unwrap_or("");
            path.contains("tolerance")
                || path.starts_with("/servo/runs/3/input")
                || (path.starts_with("/servo/runs/") && ["ws", "Nw", "P", "steps"].contains(&symbol))
                || immaterial.contains(&path.as_str())
        };
        paths.retain(|path| !idle(path));
        assert!(paths.len() > 150);
        let mut unnoticed = Vec::new();
        for path in paths {
            let mut changed = root.clone();
            let value = changed.pointer_mut(&path).unwrap();
            *value = match value.as_u64() {
                Some(whole) if path.contains("/input/") => json!(whole + 1 + whole / 50),
                _ => json!(value.as_f64().unwrap() * 1.03 + 0.013),
            };
            if check(&changed).failed == 0 {
                unnoticed.push(path);
            }
        }
        assert!(unnoticed.is_empty(), "changes went unnoticed: {unnoticed:?}");
    }

    #[test]
    fn unknown_texts_and_quantities_are_failures() {
        for (pointer, value, named) in [
            ("/servo/runs/0/input/torque_Nm", json!("0.8 sin(2 pi 50 t) - 3 step(t)"), "`step`"),
            ("/servo/runs/1/input/reference_rad", json!("w1*t"), "`w1`"),
            ("/servo/runs/1/input/t", json!("k*Ts + 1"), "`k*Ts`"),
            ("/servo/runs/3/input/par/quant", json!(2), "quant"),
            ("/servo/runs/0/input/par/Kp", json!(-1.0), "unstable"),
            ("/servo/runs/0/expected/settling_s", json!(1.0), "settling_s"),
            ("/servo/damping", json!(1.0), "damping"),
            ("/servo/runs", json!("none"), "list"),
            ("/error_budget/0/expected/lag_mm", json!(1.0), "lag_mm"),
            ("/error_budget/0/input/f1_hz", json!(-1.0), "clock"),
        ] {
            let mut changed = blocks();
            let (parent, key) = pointer.rsplit_once('/').unwrap();
            changed.pointer_mut(parent).unwrap()[key] = value;
            let report = check(&changed);
            let told = format!("{:?}", report.failures);
            assert!(report.failed > 0 && told.contains(named), "{pointer}: {told}");
        }
        assert_eq!(check(&json!({ "servo": {}, "error_budget": [] })).failed, 0);
    }
}
