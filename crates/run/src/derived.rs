//! What follows from a job before anything is planned, in sections of named quantities: what `check` shows.

use schemars::JsonSchema;
use serde::Serialize;
use serde_json::{Map, Value};
use std::borrow::Cow;
use std::fmt::Write;

/// Sections in the order of the printed text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DerivedGeometry {
    sections: Vec<DerivedSection>,
}

/// Quantities that belong together.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DerivedSection {
    /// Heading, e.g. `worm`.
    pub title: &'static str,
    /// Quantities in the order of reading.
    pub quantities: Vec<DerivedQuantity>,
}

/// A quantity with its name.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DerivedQuantity {
    /// Key in JSON, with the unit.
    pub key: Cow<'static, str>,
    /// Name.
    pub label: Cow<'static, str>,
    /// Number or word.
    pub value: Value,
    /// Unit, empty where there is none.
    pub unit: &'static str,
}

impl DerivedGeometry {
    /// All sections.
    pub fn sections(&self) -> &[DerivedSection] {
        &self.sections
    }

    /// Begins a section; its title is its key in JSON as well, blanks as `_`.
    pub fn section(&mut self, title: &'static str) {
        self.sections.push(DerivedSection { title, quantities: Vec::new() });
    }

    /// Adds a quantity to the last section.
    pub fn quantity(
        &mut self,
        key: impl Into<Cow<'static, str>>,
        label: impl Into<Cow<'static, str>>,
        value: impl Into<Value>,
        unit: &'static str,
    ) {
        if let Some(section) = self.sections.last_mut() {
            section.quantities.push(DerivedQuantity {
                key: key.into(),
                label: label.into(),
                value: value.into(),
                unit,
            });
        }
    }

    /// `{ section: { key: value } }`.
    pub fn to_json(&self) -> Value {
        let section = |section: &DerivedSection| {
            let quantities: Map<String, Value> =
                section.quantities.iter().map(|q| (q.key.clone().into_owned(), q.value.clone())).collect();
            (section.title.replace(' ', "_"), Value::Object(quantities))
        };
        Value::Object(self.sections.iter().map(section).collect())
    }

    /// Aligned lines, a blank line before each section.
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        for section in &self.sections {
            // Writing to a text cannot fail.
            let _ = writeln!(text, "\n{}", section.title);
            for quantity in &section.quantities {
                let value = match &quantity.value {
                    Value::String(word) => word.clone(),
                    Value::Number(number) if number.is_f64() => {
                        format!("{:.6}", number.as_f64().unwrap_or(f64::NAN))
                    }
                    other => other.to_string(),
                };
                let _ = writeln!(text, "  {:<46} {value} {}", quantity.label, quantity.unit);
            }
        }
        text
    }
}
