//! Reference files of the repository for tests of `verify`, as they are and with a number moved.

use serde_json::{Value, json};
use std::path::PathBuf;
use verify::{FileReport, VerifyOptions, verify_value};

/// Where a reference file lies.
pub fn path(name: &str) -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/reference")).join(name)
}

/// Its content.
pub fn content(name: &str) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path(name)).unwrap()).unwrap()
}

/// What `verify` says of a content.
pub fn check(root: &Value) -> FileReport {
    verify_value("test", root, &VerifyOptions::default()).unwrap()
}

/// The content with one number moved; a whole number by whole steps stays one.
pub fn moved(root: &Value, place: &str, step: f64) -> Value {
    let mut changed = root.clone();
    let value = changed.pointer_mut(place).unwrap();
    *value = match value.as_i64().filter(|_| step.fract() == 0.0) {
        Some(n) => json!(n + step as i64),
        None => json!(value.as_f64().unwrap() + step),
    };
    changed
}
