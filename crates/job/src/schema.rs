//! The JSON schema of job files and catalogues, from the types themselves. The same schema is published for editors and
//! used to check a file, so both always agree.

use std::sync::LazyLock;

use schemars::generate::{SchemaGenerator, SchemaSettings};
use schemars::{JsonSchema, Schema};
use serde_json::{Value, json};

use super::gearbox_job::GearboxJob;
use super::job::{Job, JobInfo, Process};
use super::milling_job::MillingJob;
use super::skiving_job::SkivingJob;
use super::tangential_job::TangentialJob;

static SCHEMA: LazyLock<Value> = LazyLock::new(schema_of_jobs);

/// The schema of a document type under a title.
pub(super) fn schema_of<T: JsonSchema>(title: &str) -> Value {
    let mut schema = generator().into_root_schema_for::<T>().to_value();
    without_null(&mut schema);
    schema["title"] = Value::from(title);
    schema
}

/// The schema of the job file, JSON Schema draft 2020-12: every job has a table `job`, and its process decides which other
/// tables there are. `x-way-out` beside a range is what messages advise.
pub fn job_schema() -> Value {
    SCHEMA.clone()
}

pub(super) fn shared() -> &'static Value {
    &SCHEMA
}

/// The part of the published schema that jobs of a process have to meet.
pub(super) fn of_process(process: Process) -> &'static Value {
    let place = Process::ALL.iter().position(|p| *p == process).unwrap_or_default();
    &SCHEMA["allOf"][place]["then"]
}

fn generator() -> SchemaGenerator {
    SchemaSettings::draft2020_12().into_generator()
}

/// One schema for all processes. An `if` for each rather than `oneOf`: a validator then tells what is wrong with the job of
/// this process, not that it is neither of all.
fn schema_of_jobs() -> Value {
    let mut generator = generator();
    let info = generator.subschema_for::<JobInfo>();
    let cases: Vec<Value> = Process::ALL
        .into_iter()
        .map(|process| {
            let named =
                json!({ "properties": { "process": { "const": process.name() } }, "required": ["process"] });
            json!({
                "if": { "properties": { "job": named }, "required": ["job"] },
                "then": tables(process, &mut generator),
            })
        })
        .collect();
    let mut schema = json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "flankwright job",
        "description": "A job file; `job.process` decides which tables it has.",
        "type": "object",
        "properties": { "job": info },
        "required": ["job"],
        "allOf": cases,
        "$defs": generator.take_definitions(true),
    });
    without_null(&mut schema);
    schema
}

/// What the jobs of a process consist of.
fn tables(process: Process, generator: &mut SchemaGenerator) -> Schema {
    match process {
        Process::GeneratingGrinding => generator.subschema_for::<Job>(),
        Process::TangentialDressing => generator.subschema_for::<TangentialJob>(),
        Process::ElectronicGearbox => generator.subschema_for::<GearboxJob>(),
        Process::FiveAxisMilling => generator.subschema_for::<MillingJob>(),
        Process::SkivingToolMeasuring => generator.subschema_for::<SkivingJob>(),
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_its_draft_and_allows_no_null() {
        let schema = job_schema();
        assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
        assert!(!schema.to_string().contains("\"null\""));
        assert_eq!(schema["required"], json!(["job"]));
    }

    #[test]
    fn every_process_has_its_closed_set_of_tables() {
        let schema = job_schema();
        for process in Process::ALL {
            let pointer = of_process(process)["$ref"].as_str().unwrap().trim_start_matches('#');
            let tables = schema.pointer(pointer).unwrap();
            assert_eq!(tables["additionalProperties"], false, "{process:?}");
            assert_eq!(tables["properties"]["job"]["$ref"], "#/$defs/JobInfo", "{process:?}");
        }
        assert_eq!(schema["allOf"].as_array().unwrap().len(), Process::ALL.len());
    }

    #[test]
    fn ranges_stand_beside_their_keys() {
        let gear = &job_schema()["$defs"]["Gear"]["properties"];
        assert_eq!(gear["normal_module"]["exclusiveMinimum"], 0);
        assert_eq!(gear["teeth"]["not"]["const"], 0);
        assert_eq!(gear["form_diameter"]["type"], "number");
    }
}
