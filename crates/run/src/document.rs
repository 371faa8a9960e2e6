//! Documents that tasks write, with their JSON schema from the types themselves.

use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde_json::Value;

/// A kind of document.
#[derive(Clone, Copy)]
pub struct DocumentFormat {
    /// Its name: that of the process for a `result.json`, else that of the study.
    pub kind: &'static str,
    /// The file that holds it.
    pub file: &'static str,
    root: fn(&mut SchemaGenerator) -> Schema,
    part: fn(&mut SchemaGenerator) -> Schema,
}

impl DocumentFormat {
    /// The format of a type, in a file of this name.
    pub const fn of<T: JsonSchema>(kind: &'static str, file: &'static str) -> Self {
        let (root, part) = (SchemaGenerator::root_schema_for::<T>, SchemaGenerator::subschema_for::<T>);
        Self { kind, file, root, part }
    }

    /// Its schema, JSON Schema draft 2020-12.
    pub fn schema(&self) -> Value {
        let mut generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
        let mut schema = (self.root)(&mut generator).to_value();
        schema["title"] = Value::from(format!("flankwright {}: {}", self.kind, self.file));
        schema
    }

    /// Its schema as a part of a larger one, whose definitions the generator collects.
    pub fn schema_in(&self, generator: &mut SchemaGenerator) -> Schema {
        (self.part)(generator)
    }
}
