//! The document of the interface and the server agree.

use crate::client::Served;
use flankwright_server::openapi;
use serde_json::Value;
use std::{env, fs};

/// Paths that the router knows, as it writes them.
fn routed() -> Vec<String> {
    let source = include_str!("../../src/router.rs");
    let routes = source.split(".route(").skip(1).filter_map(|rest| rest.split('"').nth(1));
    routes.map(|path| format!("/api{}", path.replace("{*", "{"))).collect()
}

#[test]
fn every_path_is_described_and_every_description_is_answered() {
    let served = Served::new();
    let document = served.get("/api/openapi.json").json();
    let paths = document["paths"].as_object().unwrap();
    let mut described: Vec<&String> = paths.keys().collect();
    let routed = routed();
    let mut known: Vec<&String> = routed.iter().collect();
    described.sort();
    known.sort();
    assert_eq!(described, known);
    for (path, methods) in paths {
        for (method, of) in methods.as_object().unwrap() {
            assert!(
                of["description"].is_string() || of["summary"].is_string(),
                "{method} {path} has no words"
            );
            let path = path.replace("{id}", "1").replace(['{', '}'], "");
            let answer =
                served.ask(&method.to_uppercase(), &path, &[("Content-Type", "application/json")], b"");
            assert_ne!(answer.status, 405, "{method} {path}");
            assert!(answer.status < 500, "{method} {path}: {}", answer.text());
            let type_ = answer.header("content-type").unwrap_or_default();
            if answer.status >= 400 {
                assert_eq!(type_, "application/json", "{method} {path}");
                let told: Value = answer.json();
                assert!(told["errors"][0]["way_out"].is_string(), "{method} {path}: {told}");
            }
        }
    }
}

/// What `document` refers to below `#/components/schemas/`.
fn references(document: &Value) -> Vec<&str> {
    match document {
        Value::Array(items) => items.iter().flat_map(references).collect(),
        Value::Object(keys) => {
            let own = keys.get("$ref").and_then(Value::as_str);
            own.into_iter().chain(keys.values().flat_map(references)).collect()
        }
        _ => Vec::new(),
    }
}

#[test]
fn references_lead_to_schemas() {
    let document = openapi();
    let schemas = document["components"]["schemas"].as_object().unwrap();
    for reference in references(&document) {
        let name = reference.strip_prefix("#/components/schemas/").unwrap_or_default();
        let schema = schemas.get(name).unwrap_or_else(|| panic!("{reference}"));
        assert_ne!(schema["$ref"], reference);
    }
}

#[test]
fn operations_have_names_of_their_own() {
    let document = openapi();
    let paths = document["paths"].as_object().unwrap().values();
    let operations = paths.flat_map(|methods| methods.as_object().unwrap().values());
    let mut names: Vec<&str> = operations.map(|of| of["operationId"].as_str().unwrap()).collect();
    names.sort_unstable();
    assert!(names.is_sorted_by(|a, b| a < b), "{names:?}");
}

/// The types of the pages are made from `web/src/api/openapi.json`.
#[test]
fn the_pages_have_this_description() {
    let kept = concat!(env!("CARGO_MANIFEST_DIR"), "/../../web/src/api/openapi.json");
    let document = openapi();
    if env::var_os("UPDATE_OPENAPI").is_some() {
        fs::write(kept, serde_json::to_string_pretty(&document).unwrap() + "\n").unwrap();
    }
    let text = fs::read_to_string(kept).unwrap_or_default();
    let known: Value = serde_json::from_str(&text).unwrap_or_default();
    assert!(
        known == document,
        "{kept} is not what the server tells; UPDATE_OPENAPI=1 with this test writes it"
    );
}
