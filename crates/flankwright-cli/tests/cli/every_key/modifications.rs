//! The walk of modifications: every key of every kind changes the flank, or is refused. They stand in targets, compensations, worms and
//! dressers of several processes and are built by one function, so that they are walked here, at points of a flank.

use super::others;
use crate::command::run;
use flankwright::geometry::Flank;
use flankwright::modification::{EvaluationField, Modification, ModificationSpec, NoFiles};
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// An entry of each kind with all of its keys.
fn entries() -> Vec<Value> {
    let amount = |kind: &str| json!({ "kind": kind, "amount_um": 9.0 });
    let relief = |kind: &str| json!({ "kind": kind, "amount_um": 9.0, "length_mm": 5.0, "exponent": 1.0, "transition_mm": 1.0 });
    let child =
        json!([{ "kind": "helix_slope", "amount_um": 4.0 }, { "kind": "profile_slope", "amount_um": 3.0 }]);
    let rows =
        json!([[1.0, 2.0, 3.0, 4.0], [2.0, 2.0, 5.0, 1.0], [1.0, 0.0, 2.0, 2.0], [3.0, 1.0, 1.0, 0.0]]);
    let cloud: Vec<[f64; 3]> = (0..36)
        .map(|k| {
            let (i, j) = (f64::from(k % 6), f64::from(k / 6));
            [5.0 + 3.4 * i, -16.5 + 6.6 * j, (i * j) % 4.0]
        })
        .collect();
    // A wave whose height lies between noises: what is noise decides whether the curve follows it.
    let profile: Vec<[f64; 2]> =
        (0..40).map(|k| [6.0 + 0.4 * f64::from(k), 0.5 * (0.8 * f64::from(k)).sin()]).collect();
    vec![
        amount("profile_crowning"),
        amount("profile_crowning_arc"),
        amount("profile_crowning_radius"),
        amount("profile_slope_radius"),
        amount("helix_crowning"),
        amount("helix_crowning_arc"),
        amount("profile_slope"),
        amount("helix_slope"),
        amount("twist"),
        json!({ "kind": "helix_crowning_two_arc", "apex_z_mm": 2.0, "amount_I_um": 6.0, "amount_II_um": 14.0 }),
        json!({ "kind": "helix_crowning_two_arc", "apex_z_mm": 2.0, "amount_non_datum_face_um": 6.0, "amount_datum_face_um": 14.0 }),
        json!({ "kind": "profile_crowning_two_arc", "apex_w_mm": 11.0, "amount_I_um": 6.0, "amount_II_um": 9.0 }),
        relief("tip_relief"),
        relief("root_relief"),
        relief("end_relief_I"),
        relief("end_relief_II"),
        relief("end_relief_datum_face"),
        relief("end_relief_non_datum_face"),
        json!({ "kind": "triangular_end_relief", "amount_um": 9.0, "corner_profile": "tip", "corner_face": "II", "length_w_mm": 6.0,
            "length_z_mm": 8.0, "exponent": 1.0, "transition": 0.2 }),
        json!({ "kind": "directed_crowning", "amount_um": 9.0, "rho_deg": 20.0 }),
        json!({ "kind": "waviness", "rho_deg": 30.0, "wavelength_mm": 9.0, "phase_deg": 10.0, "amp_0_um": 2.0, "amp_uu_um": 1.0,
            "amp_vv_um": 0.5 }),
        json!({ "kind": "polynomial", "w0_mm": 3.0, "z0_mm": 1.0, "terms": [[2, 1, 0.02]] }),
        json!({ "kind": "grid", "w_mm": [6.0, 11.0, 16.0, 21.0], "z_mm": [-15.0, -5.0, 5.0, 15.0], "f_um": rows }),
        json!({ "kind": "grid", "file": "table.csv" }),
        json!({ "kind": "points", "points": cloud, "method": "linear" }),
        json!({ "kind": "points", "file": "table.csv" }),
        json!({ "kind": "helix_traces", "w_mm": [8.0, 18.0], "z_mm": [-15.0, -5.0, 5.0, 15.0], "f_um": [rows[0], rows[1]] }),
        json!({ "kind": "helix_traces", "file": "table.csv" }),
        json!({ "kind": "profile_trace", "points": profile, "noise_um": 0.3 }),
        json!({ "kind": "profile_trace", "file": "table.csv" }),
        json!({ "kind": "formula", "f_um": "u*v" }),
        json!({ "kind": "sum", "children": child }),
        json!({ "kind": "product", "children": child }),
        json!({ "kind": "scale", "children": child, "factor": 0.5 }),
        json!({ "kind": "mirror", "children": child, "axis": "z" }),
    ]
}

/// What other words a key may have.
fn words(key: &str) -> Vec<Value> {
    match key {
        "flank" => vec![json!("left")],
        "reference" => vec![json!("normal")],
        "corner_profile" => vec![json!("root")],
        "corner_face" => vec![json!("I"), json!("non_datum_face")],
        "method" => vec![json!("spline")],
        "f_um" => vec![json!("u")],
        "file" => vec![json!("other.csv")],
        _ => Vec::new(),
    }
}

/// Values on both flanks, or why there are none.
fn outcome(entry: &Value) -> Result<Vec<f64>, String> {
    let field = EvaluationField::new([6.5, 20.8], [-15.0, 15.0], 38.45, 0.327).unwrap();
    let spec = ModificationSpec::from_json(entry).map_err(|error| error.to_string())?;
    let mut values = Vec::new();
    for flank in Flank::BOTH {
        let built = Modification::for_flank(std::slice::from_ref(&spec), flank, &field, &NoFiles)
            .map_err(|error| error.to_string())?;
        for (w, z) in [(6.7, -14.0), (9.3, 13.9), (13.1, 2.3), (17.0, -6.1), (20.2, 14.4), (20.5, -14.2)] {
            values.push(built.value(w, z).map_err(|error| error.to_string())?);
        }
    }
    Ok(values)
}

/// Another value of a list or a child changes what is built from it.
fn inner(value: &Value) -> Vec<Value> {
    match value {
        Value::Array(items) => items
            .iter()
            .enumerate()
            .flat_map(|(i, item)| {
                let mut others = others(item);
                others.extend(inner(item));
                others.into_iter().map(move |other| (i, other))
            })
            .map(|(i, other)| {
                let mut items = items.clone();
                items[i] = other;
                Value::Array(items)
            })
            .collect(),
        Value::Object(table) => table
            .iter()
            .flat_map(|(key, item)| others(item).into_iter().map(move |other| (key.clone(), other)))
            .map(|(key, other)| {
                let mut table = table.clone();
                table.insert(key, other);
                Value::Object(table)
            })
            .collect(),
        _ => Vec::new(),
    }
}

#[test]
fn every_key_of_every_modification_counts() {
    let schema = run(&["schema"]).json();
    let mut open: BTreeSet<(String, String)> = BTreeSet::new();
    for form in schema["$defs"]["ModificationSpec"]["oneOf"].as_array().unwrap() {
        let kind = form["properties"]["kind"]["const"].as_str().unwrap().to_owned();
        let of = match form["$ref"].as_str() {
            Some(name) => &schema["$defs"][name.rsplit('/').next().unwrap()],
            None => form,
        };
        let keys = of["properties"].as_object().unwrap().keys().filter(|key| *key != "kind");
        open.extend(keys.map(|key| (kind.clone(), key.clone())));
    }
    assert!(open.len() > 100, "{open:?}");
    for entry in entries() {
        let kind = entry["kind"].as_str().unwrap().to_owned();
        let before = outcome(&entry);
        // A table in a file is refused here by its name, which is how its key counts.
        assert!(before.is_ok() || before.as_ref().unwrap_err().contains("table.csv"), "{before:?}");
        let keys: Vec<String> =
            open.iter().filter(|(of, _)| *of == kind).map(|(_, key)| key.clone()).collect();
        for key in keys {
            let given = entry.get(&key);
            let mut tried = words(&key);
            tried.extend(given.iter().flat_map(|value| others(value)));
            tried.extend(given.iter().flat_map(|value| inner(value)));
            let counts = tried.into_iter().filter(|other| given != Some(other)).any(|other| {
                let mut changed = entry.clone();
                changed[&key] = other;
                outcome(&changed) != before
            });
            if counts || (kind == "mirror" && key == "axis") {
                // `axis` has one word only.
                open.remove(&(kind.clone(), key));
            }
        }
    }
    assert!(open.is_empty(), "without effect: {open:?}");
}
