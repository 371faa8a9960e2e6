//! German help of the form: a text for every description in the schema of jobs, and no other. A text is found by the place of the
//! description in the schema (`web/src/lib/helpKeys.ts` makes the same keys), so that a better English sentence leaves it where it is.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::{Map, Value};

const FILE: &str = "web/src/texts/help-de.json";

fn read() -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(FILE);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn every_description_of_the_schema_has_a_german_text_and_no_text_is_left_over() {
    let german: BTreeMap<String, String> = serde_json::from_str(&read()).expect("a map of texts");
    let keys: BTreeSet<String> = keys(&flankwright::exchange::job_schema()).into_iter().collect();
    let missing: Vec<_> = keys.iter().filter(|key| german.get(*key).is_none_or(String::is_empty)).collect();
    let left_over: Vec<_> = german.keys().filter(|key| !keys.contains(*key)).collect();
    assert!(
        missing.is_empty() && left_over.is_empty(),
        "{FILE} lacks {missing:#?} and holds without a description {left_over:#?}"
    );
}

#[test]
fn a_key_says_where_a_description_stands() {
    let schema = serde_json::json!({
        "description": "A file.",
        "properties": { "job": { "$ref": "#/$defs/Info", "description": "Head." } },
        "$defs": {
            "Info": { "properties": { "hand": { "description": "Hand." }, "all": { "items": { "description": "One." } } } },
            "Hand": { "oneOf": [{ "const": "left", "description": "Left." }, { "const": "right" }] },
            "Kind": { "oneOf": [{ "properties": { "kind": { "const": "twist" } }, "description": "Twist." }] },
            "Ratio": { "anyOf": [
                { "type": "number", "description": "A number." },
                { "$ref": "#/$defs/Hand", "description": "A word." },
                { "properties": { "b": {}, "a": {} }, "required": ["b", "a"], "description": "Both." },
            ] },
        },
    });
    let mut found = keys(&schema);
    found.sort();
    let expected = [
        "Hand=left",
        "Info.all[]",
        "Info.hand",
        "Kind.kind=twist",
        "Ratio{a,b}",
        "Ratio|Hand",
        "Ratio|number",
        "job",
        "job file",
    ];
    assert_eq!(found, expected);
}

/// The keys of all descriptions. Two descriptions with the same key could not both be translated.
fn keys(schema: &Value) -> Vec<String> {
    let mut keys = Vec::new();
    collect(schema, "", &mut keys);
    let different: BTreeSet<_> = keys.iter().collect();
    assert_eq!(different.len(), keys.len(), "two descriptions have one key");
    keys
}

fn collect(schema: &Value, key: &str, keys: &mut Vec<String>) {
    let Some(schema) = schema.as_object() else { return };
    if schema.contains_key("description") {
        keys.push(if key.is_empty() { "job file".to_owned() } else { key.to_owned() });
    }
    for (name, inner) in table(schema, "$defs") {
        collect(inner, name, keys);
    }
    for (name, inner) in table(schema, "properties") {
        let inner_key = if key.is_empty() { name.clone() } else { format!("{key}.{name}") };
        collect(inner, &inner_key, keys);
    }
    for (name, ending) in [("items", "[]"), ("additionalProperties", ".*")] {
        if let Some(inner) = schema.get(name) {
            collect(inner, &format!("{key}{ending}"), keys);
        }
    }
    for (place, inner) in list(schema, "prefixItems").enumerate() {
        collect(inner, &format!("{key}[{place}]"), keys);
    }
    for inner in list(schema, "oneOf").chain(list(schema, "anyOf")) {
        collect(inner, &format!("{key}{}", variant(inner)), keys);
    }
}

/// What distinguishes a variant from its siblings.
fn variant(schema: &Value) -> String {
    if let Some(value) = schema.get("const") {
        return format!("={}", text(value));
    }
    if let Some(target) = schema["$ref"].as_str() {
        return format!("|{}", target.rsplit('/').next().unwrap_or_default());
    }
    let Some(properties) = schema["properties"].as_object() else {
        return format!("|{}", schema["type"].as_str().unwrap_or_default());
    };
    if let Some((name, value)) =
        properties.iter().find_map(|(name, inner)| inner.get("const").map(|value| (name, value)))
    {
        return format!(".{name}={}", text(value));
    }
    let mut names: Vec<String> = match schema["required"].as_array() {
        Some(required) => required.iter().map(text).collect(),
        None => properties.keys().cloned().collect(),
    };
    names.sort();
    format!("{{{}}}", names.join(","))
}

fn text(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

fn table<'a>(schema: &'a Map<String, Value>, name: &str) -> impl Iterator<Item = (&'a String, &'a Value)> {
    schema.get(name).and_then(Value::as_object).into_iter().flatten()
}

fn list<'a>(schema: &'a Map<String, Value>, name: &str) -> impl Iterator<Item = &'a Value> {
    schema.get(name).and_then(Value::as_array).into_iter().flatten()
}
