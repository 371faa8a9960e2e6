//! The JSON schema of job files and catalogues, from the types themselves. The same schema is published for editors and
//! used to check a file, so both always agree.

use super::job_format::JobFormat;
use super::tables::JobInfo;
use schemars::JsonSchema;
use schemars::generate::{SchemaGenerator, SchemaSettings};
use serde_json::{Value, json};

/// The schema of a document type under a title.
pub fn schema_of<T: JsonSchema>(title: &str) -> Value {
    let mut schema = generator().into_root_schema_for::<T>().to_value();
    without_null(&mut schema);
    schema["title"] = Value::from(title);
    schema
}

fn generator() -> SchemaGenerator {
    SchemaSettings::draft2020_12().into_generator()
}

/// One schema for all processes. An `if` for each rather than `oneOf`: a validator then tells what is wrong with the job of
/// this process, not that it is neither of all.
pub(super) fn schema_of_jobs(formats: &[JobFormat]) -> Value {
    let mut generator = generator();
    let info = generator.subschema_for::<JobInfo>();
    let cases: Vec<Value> = formats
        .iter()
        .map(|format| {
            let named =
                json!({ "properties": { "process": { "const": format.name } }, "required": ["process"] });
            json!({
                "if": { "properties": { "job": named }, "required": ["job"] },
                "then": (format.tables)(&mut generator),
            })
        })
        .collect();
    let mut definitions = generator.take_definitions(true);
    let names: Vec<Value> = formats
        .iter()
        .map(|format| json!({ "description": format.about, "type": "string", "const": format.name }))
        .collect();
    definitions.insert(
        "Process".to_owned(),
        json!({ "description": "The processes that have jobs.", "oneOf": names }),
    );
    let mut schema = json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "flankwright job",
        "description": "A job file; `job.process` decides which tables it has.",
        "type": "object",
        "properties": { "job": info },
        "required": ["job"],
        "allOf": cases,
        "$defs": definitions,
    });
    without_null(&mut schema);
    schema
}

/// An optional key may be left out, but not be null: TOML has no null, and both formats shall take the same.
fn without_null(schema: &mut Value) {
    match schema {
        Value::Array(items) => items.iter_mut().for_each(without_null),
        Value::Object(map) => {
            if let Some(Value::Array(types)) = map.get_mut("type") {
                types.retain(|t| t != "null");
                if let [only] = types.as_slice() {
                    let only = only.clone();
                    map.insert("type".to_owned(), only);
                }
            }
            if let Some(Value::Array(variants)) = map.get_mut("anyOf") {
                variants.retain(|v| v.get("type").is_none_or(|t| t != "null"));
                if let [Value::Object(only)] = variants.as_slice() {
                    let only = only.clone();
                    map.remove("anyOf");
                    map.extend(only);
                }
            }
            map.values_mut().for_each(without_null);
        }
        _ => {}
    }
}
