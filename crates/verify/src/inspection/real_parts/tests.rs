//! The block on the real files, where `../shared/measurements` lies beside the repository; skipped where it does not. Right
//! expectations pass, no changed one does.

use super::super::super::VerifyOptions;
use super::super::super::ledger::Ledger;
use super::super::super::reference::Reference;
use super::printed::compared;
use super::real_parts;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn block() -> Value {
    let text = std::fs::read_to_string(repository().join("tests/reference/85-inspection.json")).unwrap();
    serde_json::from_str::<Value>(&text).unwrap()["real_parts"].take()
}

/// The folder of the measurements, or a message.
fn measurements() -> Option<PathBuf> {
    let folder = Some(repository().join("../shared/measurements")).filter(|folder| folder.is_dir());
    if folder.is_none() {
        eprintln!("not run: ../shared/measurements is not beside the repository");
    }
    folder
}

fn checked(block: &Value, folder: PathBuf) -> Ledger {
    let options = VerifyOptions { data_directories: vec![folder] };
    let mut ledger = Ledger::default();
    real_parts(&Reference::new(&Value::Null, &options), block, &mut ledger);
    ledger
}

/// Pointers to everything below a value for which `wanted` is true.
fn below(value: &Value, pointer: &str, wanted: fn(&Value) -> bool, found: &mut Vec<String>) {
    if wanted(value) {
        found.push(pointer.into());
    }
    match value {
        Value::Object(map) => {
            map.iter().for_each(|(key, value)| below(value, &format!("{pointer}/{key}"), wanted, found));
        }
        Value::Array(list) => {
            list.iter()
                .enumerate()
                .for_each(|(k, value)| below(value, &format!("{pointer}/{k}"), wanted, found));
        }
        _ => {}
    }
}

fn pointers(value: &Value, wanted: fn(&Value) -> bool) -> Vec<String> {
    let mut found = Vec::new();
    below(value, "", wanted, &mut found);
    found
}

#[test]
fn both_parts_are_as_expected_and_as_printed() {
    let Some(folder) = measurements() else { return };
    let ledger = checked(&block(), folder);
    assert!(ledger.failures.is_empty(), "{:#?}", ledger.failures);
    assert!(ledger.not_run.is_empty() && ledger.checks > 190, "{} {:?}", ledger.checks, ledger.not_run);
}

#[test]
fn every_changed_number_is_noticed() {
    let Some(folder) = measurements() else { return };
    let right = block();
    let numbers = pointers(&right, Value::is_number);
    let mut changes = 0;
    for pointer in numbers.iter().filter(|pointer| !pointer.contains("/tolerance/")) {
        let mut changed = right.clone();
        let number = changed.pointer_mut(pointer).unwrap();
        *number = match number.as_i64() {
            Some(whole) => json!(whole + 1),
            None => json!(number.as_f64().unwrap() * (1.0 + 1e-4) + 3e-6),
        };
        assert!(!checked(&changed, folder.clone()).failures.is_empty(), "{pointer}");
        changes += 1;
    }
    assert!(changes > 140, "{changes}");
}

#[test]
fn unknown_quantities_and_tolerances_not_stated_are_noticed() {
    let Some(folder) = measurements() else { return };
    let right = block();
    for pointer in pointers(&right, Value::is_object) {
        let mut changed = right.clone();
        changed.pointer_mut(&pointer).unwrap()["colour"] = json!(1.0);
        assert!(!checked(&changed, folder.clone()).failures.is_empty(), "{pointer}");
    }
    for part in 0..2 {
        for tolerance in ["um", "printed_um", "MdK_mm"] {
            let mut changed = right.clone();
            changed[part]["tolerance"].as_object_mut().unwrap().remove(tolerance).unwrap();
            assert!(!checked(&changed, folder.clone()).failures.is_empty(), "{tolerance}");
        }
        let mut changed = right.clone();
        changed[part].as_object_mut().unwrap().remove("tolerance").unwrap();
        assert!(!checked(&changed, folder.clone()).failures.is_empty());
    }
}

#[test]
fn what_the_machine_printed_is_compared_with_the_evaluation() {
    let Some(folder) = measurements() else { return };
    let mut strict = block();
    for part in 0..2 {
        strict[part]["tolerance"]["printed_um"] = json!(0.0);
        strict[part]["tolerance"]["MdK_mm"] = json!(0.0);
    }
    let ledger = checked(&strict, folder);
    let marked = compared("");
    assert!(
        ledger.failures.iter().all(|failure| failure.quantity.ends_with(&marked)),
        "{:#?}",
        ledger.failures
    );
    // All printed values but the spans; those of Rp, rounded as the machine rounds them, may agree exactly.
    assert!(ledger.failures.len() >= 35, "{}", ledger.failures.len());
}

#[test]
fn absent_files_are_noted_and_no_failure() {
    let ledger = checked(&block(), repository().join("no-such-folder"));
    assert_eq!((ledger.checks, ledger.failures.len(), ledger.not_run.len()), (0, 0, 2));
}
