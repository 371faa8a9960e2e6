//! The JSON schema of job files and catalogues, from the types themselves. The same schema is published for editors and
//! used to check a file, so both always agree.

use std::sync::LazyLock;

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::Value;

use super::job::Job;

static SCHEMA: LazyLock<Value> = LazyLock::new(|| schema_of::<Job>("flankwright job"));

/// The schema of a document type under a title.
pub(super) fn schema_of<T: JsonSchema>(title: &str) -> Value {
    let schema = SchemaSettings::draft2020_12().into_generator().into_root_schema_for::<T>();
    let mut schema = schema.to_value();
    without_null(&mut schema);
    schema["title"] = Value::from(title);
    schema
}

/// The schema of the job file, JSON Schema draft 2020-12. `x-way-out` beside a range is what messages advise.
pub fn job_schema() -> Value {
    SCHEMA.clone()
}

pub(super) fn shared() -> &'static Value {
    &SCHEMA
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
        assert_eq!(schema["additionalProperties"], false);
    }

    #[test]
    fn ranges_stand_beside_their_keys() {
        let gear = &job_schema()["$defs"]["Gear"]["properties"];
        assert_eq!(gear["normal_module"]["exclusiveMinimum"], 0);
        assert_eq!(gear["teeth"]["not"]["const"], 0);
        assert_eq!(gear["form_diameter"]["type"], "number");
    }
}
