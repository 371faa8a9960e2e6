//! Every answer that a test gets is held against the description of the interface.

use std::cmp::Reverse;
use std::collections::HashMap;
use std::io::Read;
use std::sync::{Arc, LazyLock, Mutex};

use flankwright_server::openapi;
use flate2::read::GzDecoder;
use jsonschema::Validator;
use serde_json::Value;

use crate::http::Answer;

static DOCUMENT: LazyLock<Value> = LazyLock::new(openapi);
static VALIDATORS: LazyLock<Mutex<HashMap<String, Arc<Validator>>>> = LazyLock::new(Mutex::default);

/// Whether a path is one of those that `described` stands for; a parameter at its end may hold slashes.
fn is_one_of(path: &str, described: &str) -> bool {
    match (path.split_once('/'), described.split_once('/')) {
        (Some((step, path)), Some((name, described))) => {
            (name == step || name.starts_with('{')) && is_one_of(path, described)
        }
        (_, None) => described.starts_with('{') || path == described,
        (None, Some(_)) => false,
    }
}

/// Panics if the description of an operation has no such answer. Paths that it does not have are none of its business.
pub fn hold(method: &str, path: &str, answer: &Answer) {
    if answer.header("content-type") != Some("application/json") {
        return;
    }
    let path = path.split('?').next().unwrap_or_default();
    let paths = DOCUMENT["paths"].as_object().unwrap();
    let candidates = paths.keys().filter(|described| is_one_of(path, described));
    // As many steps as there are, and those by their words before parameters.
    let rank =
        |described: &&String| (described.matches('/').count(), Reverse(described.matches('{').count()));
    let Some(described) = candidates.max_by_key(rank) else { return };
    let responses = &DOCUMENT["paths"][described][method.to_lowercase()]["responses"];
    let response = responses.get(answer.status.to_string()).or_else(|| responses.get("default"));
    let Some(schema) = response.and_then(|response| response.pointer("/content/application~1json/schema"))
    else {
        return;
    };
    let key = format!("{method} {described} {}", answer.status);
    let made = || {
        let mut schema = schema.clone();
        schema["components"] = DOCUMENT["components"].clone();
        Arc::new(jsonschema::draft202012::new(&schema).unwrap_or_else(|error| panic!("{key}: {error}")))
    };
    let validator = VALIDATORS.lock().unwrap().entry(key.clone()).or_insert_with(made).clone();
    let told = match answer.header("content-encoding") {
        Some("gzip") => {
            let mut text = String::new();
            GzDecoder::new(&answer.body[..]).read_to_string(&mut text).unwrap();
            serde_json::from_str(&text).unwrap()
        }
        _ => answer.json(),
    };
    if let Some(error) = validator.iter_errors(&told).next() {
        panic!("{key} is not as described: {error} at {}", error.instance_path());
    }
}
