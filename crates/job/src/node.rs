//! The neutral tree of a parsed document: values with their place in the text, the same for TOML and JSON.
//! Unlike a JSON value it can hold NaN and infinity, which TOML allows, so that they can be refused by name.

use std::ops::Range;

use serde_json::Value;

/// Tables and lists nested deeper than this are refused; a job needs 6 levels, sums of modifications a few
/// more, and readers that recurse stay far from the end of their stack.
pub const MAXIMUM_DEPTH: usize = 64;

/// A value and its place in the text.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// What it is.
    pub kind: Kind,
    /// Its place, in bytes of the text.
    pub span: Range<usize>,
}

/// What a value is.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// JSON only; no key of a job takes it.
    Null,
    /// A truth value.
    Bool(bool),
    /// A whole number of 64 bits.
    Integer(i64),
    /// Also integers beyond 64 bits.
    Float(f64),
    /// A text.
    Text(String),
    /// TOML only; keys that hold dates take one in place of a text.
    Date(String),
    /// A list.
    List(Vec<Node>),
    /// In the order of the text; keys are unique.
    Table(Vec<Entry>),
}

/// A key of a table with its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The key.
    pub key: String,
    /// The place of the key, in bytes of the text.
    pub key_span: Range<usize>,
    /// The value.
    pub value: Node,
}

impl Node {
    /// The value as a person wrote it, shortened.
    pub fn shown(&self) -> String {
        match &self.kind {
            Kind::Null => "null".to_owned(),
            Kind::Bool(value) => value.to_string(),
            Kind::Integer(value) => value.to_string(),
            Kind::Float(value) => shown_number(*value),
            Kind::Text(text) => {
                const LONGEST: usize = 60;
                let short: String = text.chars().take(LONGEST).collect();
                let dots = if short.len() < text.len() { "..." } else { "" };
                format!("{:?}", short + dots)
            }
            Kind::Date(text) => text.clone(),
            Kind::List(items) => format!("a list of {}", items.len()),
            Kind::Table(entries) => format!("a table of {}", entries.len()),
        }
    }

    /// What the value is, in words.
    pub fn type_name(&self) -> &'static str {
        match self.kind {
            Kind::Null => "null",
            Kind::Bool(_) => "a truth value",
            Kind::Integer(_) => "a whole number",
            Kind::Float(_) => "a number",
            Kind::Text(_) => "a text",
            Kind::Date(_) => "a date",
            Kind::List(_) => "a list",
            Kind::Table(_) => "a table",
        }
    }

    /// The entry of a table.
    pub fn entry(&self, key: &str) -> Option<&Entry> {
        match &self.kind {
            Kind::Table(entries) => entries.iter().find(|e| e.key == key),
            _ => None,
        }
    }

    /// Follows a path such as `target.modifications[1].amount_um`: the value and the place of its key.
    pub fn follow(&self, path: &str) -> Option<(&Node, Option<Range<usize>>)> {
        let mut found = (self, None);
        for step in path.split('.').filter(|s| !s.is_empty()) {
            let (key, indices) = step.split_at(step.find('[').unwrap_or(step.len()));
            if !key.is_empty() {
                let entry = found.0.entry(key)?;
                found = (&entry.value, Some(entry.key_span.clone()));
            }
            for index in indices.split('[').skip(1) {
                let index: usize = index.strip_suffix(']')?.parse().ok()?;
                let Kind::List(items) = &found.0.kind else { return None };
                found = (items.get(index)?, None);
            }
        }
        Some(found)
    }

    /// The value as JSON. Numbers that JSON cannot hold become null; they are refused before this is used.
    pub fn to_value(&self) -> Value {
        match &self.kind {
            Kind::Null => Value::Null,
            Kind::Bool(value) => Value::from(*value),
            Kind::Integer(value) => Value::from(*value),
            Kind::Float(value) => Value::from(*value),
            Kind::Text(text) | Kind::Date(text) => Value::from(text.as_str()),
            Kind::List(items) => items.iter().map(Node::to_value).collect(),
            Kind::Table(entries) => entries.iter().map(|e| (e.key.clone(), e.value.to_value())).collect(),
        }
    }
}

/// A number as a person would write it: plain where short, with exponent where long.
pub fn shown_number(value: f64) -> String {
    let magnitude = value.abs();
    if value.is_finite() && magnitude != 0.0 && !(1e-4..1e9).contains(&magnitude) {
        format!("{value:e}")
    } else {
        value.to_string()
    }
}
