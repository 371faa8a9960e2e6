//! A component in the making.

use super::attributes;
use super::document::{Attribute, Value};

/// A component without number and name.
pub(super) struct Draft {
    pub kind: &'static str,
    pub attributes: Vec<Attribute>,
}

impl Draft {
    pub fn new(kind: &'static str) -> Self {
        Self { kind, attributes: Vec::new() }
    }

    fn with(mut self, id: &str, value: Value) -> Self {
        // Every identifier written stands in the table; a test asks for each.
        if let Some((id, form)) = attributes::known(self.kind, id) {
            self.attributes.push(Attribute { id: id.into(), unit: Some(form.unit().into()), value });
        }
        self
    }

    pub fn number(self, id: &str, value: f64) -> Self {
        self.with(id, Value::Number(value + 0.0))
    }

    pub fn integer(self, id: &str, value: i32) -> Self {
        self.with(id, Value::Integer(value.into()))
    }

    pub fn optional(self, id: &str, value: Option<f64>) -> Self {
        match value {
            Some(value) => self.number(id, value),
            None => self,
        }
    }

    pub fn word(self, id: &str, word: &str) -> Self {
        self.with(id, Value::Word(word.into()))
    }

    pub fn boolean(self, id: &str, value: bool) -> Self {
        self.with(id, Value::Boolean(value))
    }

    pub fn list(self, id: &str, list: Vec<f64>) -> Self {
        self.with(id, Value::Numbers(list))
    }
}
