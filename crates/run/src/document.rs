//! Documents that tasks write, with their JSON schema from the types themselves.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::Value;

/// A kind of document.
#[derive(Clone, Copy)]
pub struct DocumentFormat {
    /// Its name: that of the process for a `result.json`, else that of the study.
    pub kind: &'static str,
    /// The file that holds it.
    pub file: &'static str,
    schema: fn(&str) -> Value,
}

impl DocumentFormat {
    /// The format of a type, in a file of this name.
    pub const fn of<T: JsonSchema>(kind: &'static str, file: &'static str) -> Self {
        Self { kind, file, schema: schema_of::<T> }
    }

    /// Its schema, JSON Schema draft 2020-12.
    pub fn schema(&self) -> Value {
        (self.schema)(&format!("flankwright {}: {}", self.kind, self.file))
    }
}

fn schema_of<T: JsonSchema>(title: &str) -> Value {
    let settings = SchemaSettings::draft2020_12().for_serialize();
    let mut schema = settings.into_generator().into_root_schema_for::<T>().to_value();
    schema["title"] = Value::from(title);
    schema
}
