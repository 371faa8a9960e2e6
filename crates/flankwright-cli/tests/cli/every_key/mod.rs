//! Every key of a process counts: another value changes a figure, a text or a table of the result beside the echo of the job and the
//! timings. The schema says which keys there are; one that no job here gives is missing from the walk and fails it.

mod gearbox;
mod grinding;
mod modifications;
mod of_files;
mod skiving;
mod tangential;

use crate::command::{run, run_with};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

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

/// The type of modifications, which stand in many tables.
const MODIFICATIONS: &str = "ModificationSpec";

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
        // Their own keys are walked once, where they are built, and contain themselves.
        if name == MODIFICATIONS {
            keys.insert(at.to_owned());
            return;
        }
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

/// Other values of the title block, and another language of the report.
fn title_block() -> Vec<(&'static str, Value)> {
    let mut values: Vec<(&'static str, Value)> =
        ["job.part_number", "job.drawing_number", "job.customer", "job.machine_name", "job.author"]
            .map(|key| (key, json!("another")))
            .into();
    values.push(("job.date", json!("2026-04-01")));
    values.push(("output.language", json!("de")));
    values
}

/// The head of a report: language, title, title block. What stands below it follows from the result.
fn head_of_report(directory: &Path) -> Option<Vec<u8>> {
    let page = std::fs::read_to_string(directory.join("report.html")).ok()?;
    let (language, rest) = page.split_once("<head>")?;
    let (_, head) = rest.split_once("<header>")?;
    let (head, _) = head.split_once("</header>")?;
    Some(format!("{language}{head}").into_bytes())
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
    tables.extend(head_of_report(directory.path()).map(|head| ("head of the report".to_owned(), head)));
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
