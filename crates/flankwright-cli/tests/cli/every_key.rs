//! Every key of a process counts: another value changes a figure, a text or a table of the result beside the echo of the job and the
//! timings. The schema says which keys there are; one that no job here gives is missing from the walk and fails it.

use crate::command::{run, run_with};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};

/// The keys of a process, and how they are walked.
struct Walk {
    /// Name of the type in the schema.
    definition: &'static str,
    /// Jobs that give every key at least once.
    jobs: Vec<Value>,
    /// The command that runs a job from standard input.
    command: &'static str,
    /// Keys that change nothing, each with the reason.
    exceptions: &'static [(&'static str, &'static str)],
    /// Values to try for a key beside those that follow from its type.
    values: Vec<(&'static str, Value)>,
    /// Keys of the result that repeat the job.
    echoes: &'static [&'static str],
}

/// Places of all leaves as paths of keys and indices.
fn leaves(value: &Value, at: &mut Vec<String>, all: &mut Vec<Vec<String>>) {
    let mut below = |key: String, value: &Value| {
        at.push(key);
        leaves(value, at, all);
        at.pop();
    };
    match value {
        Value::Object(table) => table.iter().for_each(|(key, value)| below(key.clone(), value)),
        Value::Array(list) => list.iter().enumerate().for_each(|(k, value)| below(k.to_string(), value)),
        _ => all.push(at.clone()),
    }
}

/// A path without its indices, as the schema has it.
fn key(path: &[String]) -> String {
    path.iter().filter(|part| part.parse::<usize>().is_err()).cloned().collect::<Vec<_>>().join(".")
}

/// All keys of a schema below a node.
fn keys_of_schema(schema: &Value, node: &Value, at: &str, keys: &mut BTreeSet<String>) {
    if let Some(name) = node["$ref"].as_str() {
        let name = name.rsplit('/').next().unwrap();
        return keys_of_schema(schema, &schema["$defs"][name], at, keys);
    }
    let mut inner = false;
    for list in ["oneOf", "anyOf"] {
        for choice in node[list].as_array().into_iter().flatten() {
            keys_of_schema(schema, choice, at, keys);
            inner = true;
        }
    }
    if node["items"].is_object() {
        return keys_of_schema(schema, &node["items"], at, keys);
    }
    match node["properties"].as_object() {
        Some(table) => {
            for (name, value) in table {
                let below = if at.is_empty() { name.clone() } else { format!("{at}.{name}") };
                keys_of_schema(schema, value, &below, keys);
            }
        }
        None if !inner => {
            keys.insert(at.to_owned());
        }
        None => {}
    }
}

/// Removes keys of these names wherever they stand.
fn without(value: &mut Value, names: &[&str]) {
    match value {
        Value::Object(table) => {
            table.retain(|key, _| !names.contains(&key.as_str()));
            table.values_mut().for_each(|value| without(value, names));
        }
        Value::Array(list) => list.iter_mut().for_each(|value| without(value, names)),
        _ => {}
    }
}

/// What a job comes to without its echo: the result and the tables; `None` if it is refused.
fn outcome(walk: &Walk, job: &Value) -> Option<(Value, BTreeMap<String, Vec<u8>>)> {
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().to_str().unwrap();
    let answer = run_with(&[walk.command, "-", "--json", "-o", out], job.to_string().as_bytes());
    assert!(matches!(answer.exit, Some(0 | 2 | 3 | 4)), "{answer:?}");
    let mut result = answer.json();
    if !result["error"].is_null() {
        return None;
    }
    without(&mut result, walk.echoes);
    let mut tables = BTreeMap::new();
    for entry in std::fs::read_dir(directory.path()).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        // The report and the ranking repeat the job.
        if !["result.json", "report.html", "set-ups.csv"].contains(&name.as_str()) {
            tables.insert(name, std::fs::read(&path).unwrap());
        }
    }
    Some((result, tables))
}

/// Other values of a leaf, the nearest first.
fn others(value: &Value) -> Vec<Value> {
    match value {
        Value::Bool(yes) => vec![json!(!yes)],
        Value::Number(number) if number.is_i64() || number.is_u64() => {
            let n = number.as_i64().unwrap();
            vec![json!(n + 1), json!(2 * n), json!(n / 2), json!(n - 1), json!(-n)]
        }
        Value::Number(number) => {
            let x = number.as_f64().unwrap();
            [x * 1.01, x * 2.0, x * 0.3, x * 30.0, x * 0.01, x + 0.1].iter().map(|x| json!(x)).collect()
        }
        _ => Vec::new(),
    }
}

fn changed(job: &Value, path: &[String], value: &Value) -> Value {
    let mut job = job.clone();
    *job.pointer_mut(&format!("/{}", path.join("/"))).unwrap() = value.clone();
    job
}

/// Walks the keys; gives those that are ignored, and those that no job gives.
fn walk(walk: &Walk) -> (BTreeSet<String>, BTreeSet<String>) {
    let schema = run(&["schema"]).json();
    let mut missing = BTreeSet::new();
    keys_of_schema(&schema, &schema["$defs"][walk.definition], "", &mut missing);
    let excepted = |key: &str| walk.exceptions.iter().any(|(name, _)| *name == key);
    assert!(walk.exceptions.iter().all(|(name, reason)| missing.contains(*name) && !reason.is_empty()));
    missing.retain(|key| !excepted(key));
    let mut ignored = BTreeSet::new();
    let mut counted = BTreeSet::new();
    for job in &walk.jobs {
        let before = outcome(walk, job).unwrap_or_else(|| panic!("a sound job: {job}"));
        let mut paths = Vec::new();
        leaves(job, &mut Vec::new(), &mut paths);
        let todo: Vec<_> =
            paths.into_iter().filter(|path| !excepted(&key(path)) && !counted.contains(&key(path))).collect();
        let counts = |path: &Vec<String>| {
            let own =
                walk.values.iter().filter(|(name, _)| *name == key(path)).map(|(_, value)| value.clone());
            let value = job.pointer(&format!("/{}", path.join("/"))).unwrap();
            own.chain(others(value))
                .filter(|other| other != value)
                .any(|other| outcome(walk, &changed(job, path, &other)).is_some_and(|after| after != before))
        };
        let counts = &counts;
        let found: Vec<bool> = std::thread::scope(|scope| {
            let halves: Vec<_> = todo
                .chunks(todo.len().div_ceil(2).max(1))
                .map(|half| scope.spawn(move || half.iter().map(counts).collect::<Vec<_>>()))
                .collect();
            halves.into_iter().flat_map(|half| half.join().unwrap()).collect()
        });
        for (path, counts) in todo.iter().zip(found) {
            missing.remove(&key(path));
            if counts {
                counted.insert(key(path));
            } else {
                ignored.insert(path.join("."));
            }
        }
    }
    (ignored, missing)
}

#[test]
fn every_key_of_the_electronic_gearbox_counts() {
    let gear = json!({ "teeth": 40, "normal_module": 2.5, "normal_pressure_angle_deg": 20.0, "helix_angle_deg": 20.0 });
    let info =
        json!({ "name": "every-key", "process": "electronic-gearbox", "description": "each key once" });
    let choices = |key: &str, values: [f64; 2]| json!([{ key: values[0], "cost": 1.0 }, { key: values[1], "cost": 1.5 }]);
    let whole = |key: &str, values: [u32; 2]| json!([{ key: values[0], "cost": 1.0 }, { key: values[1], "cost": 1.5 }]);
    let motion = json!({
        "job": info, "gear": gear,
        "target": { "tolerance_um": 50.0 },
        "feed": { "pulses_per_metre": 100_000.0, "clock_hz": 1e6, "pulses_per_interval": 16, "mode": "no-backlash",
            "counter_limit": 16_777_215 },
        "workpiece": { "pulses_per_revolution": 36_000, "rate": "exact", "reversed": false },
        "worm": { "threads": 3, "pulses_per_revolution": 65_536, "speed_rpm": 3000.0 },
        "stimulus": { "start": 0.002, "rest_s": 0.05, "motion": [
            { "to": 1.003, "speed_mm_per_min": 600.0, "acceleration_mm_per_s2": 300.0 },
            { "dwell_s": 0.02 },
            { "to": 0.002, "speed_mm_per_min": 500.0, "acceleration_mm_per_s2": 200.0 } ] },
        "servo": { "sample_time_us": 125.0, "inertia_kg_m2": 0.12, "damping_n_m_s": 0.05, "friction_n_m": 0.5,
            "friction_speed_rad_per_s": 5.0, "torque_limit_n_m": 60.0, "bandwidth_hz": 60.0, "feed_forward": 0.5,
            "quantised": true, "disturbances": [
                { "kind": "constant", "torque_n_m": 0.5 },
                { "kind": "step", "torque_n_m": -0.6, "at_s": 0.1 },
                { "kind": "harmonic", "torque_n_m": 0.3, "frequency_hz": 50.0, "phase_deg": 10.0 },
                { "kind": "order", "torque_n_m": 0.3, "axis": "workpiece", "order": 40.0, "phase_deg": 10.0 },
                { "kind": "pulses", "torque_n_m": 0.3, "axis": "workpiece", "per_revolution": 3, "width_deg": 20.0 } ] },
        "explore": { "wanted_um": 0.5, "speed_mm_per_min": 600.0, "acceleration_mm_per_s2": 100.0,
            "scales": choices("pulses_per_metre", [100_000.0, 250_000.0]), "clocks": choices("clock_hz", [1e6, 1e7]),
            "interpolations": whole("pulses_per_interval", [16, 64]),
            "encoders": whole("pulses_per_revolution", [36_000, 90_000]) },
        "output": { "pulse_trace": true },
    });
    let mut gains = motion.clone();
    gains["servo"].as_object_mut().unwrap().remove("bandwidth_hz");
    gains["servo"]["gains"] = json!({
        "proportional_n_m_per_rad": 22_740.0, "integral_n_m_per_rad_s": 1.9e6, "derivative_n_m_s_per_rad": 90.4
    });
    let mut train = motion.clone();
    train["stimulus"] =
        json!({ "reference_ticks": [100, 260, 420], "reference_signs": [1, 1, 1], "last_tick": 1000 });
    let (ignored, missing) = walk(&Walk {
        definition: "GearboxJob",
        jobs: vec![motion, gains, train],
        command: "gearbox",
        exceptions: &[
            ("job.name", "a name"),
            ("job.description", "a comment"),
            ("job.process", "says which keys there are"),
            ("servo.disturbances.kind", "says which keys there are"),
            (
                "stimulus.references",
                "the name of a table, whose rows are those of reference_ticks and reference_signs",
            ),
        ],
        values: vec![
            ("feed.mode", json!("one-way")),
            ("feed.counter_limit", json!(3)),
            ("workpiece.rate", json!("bresenham")),
            ("servo.disturbances.axis", json!("worm")),
        ],
        echoes: &[
            "job",
            "version",
            "settings",
            "timing_s",
            "tolerance_um",
            "scope",
            "reason",
            "warnings",
            "wanted_um",
            "speed_mm_per_min",
            "acceleration_mm_per_s2",
            "pulses_per_metre",
            "clock_hz",
            "pulses_per_interval",
            "pulses_per_revolution",
            "cost",
        ],
    });
    assert!(ignored.is_empty(), "ignored: {ignored:?}");
    assert!(missing.is_empty(), "in no job of the walk: {missing:?}");
}
