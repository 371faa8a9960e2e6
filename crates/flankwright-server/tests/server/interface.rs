//! The document of the interface and the server agree.

use crate::client::Served;
use serde_json::Value;

/// Paths that the router knows, as it writes them.
fn routed() -> Vec<String> {
    let source = include_str!("../../src/app.rs");
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
