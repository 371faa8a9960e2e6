//! The alternatives that a schema allows at one place, with references and combinations resolved, and how they are
//! worded. Knows the parts of JSON Schema that the job's schema uses, and no key.

use std::collections::BTreeMap;

use serde_json::Value;

use super::node::{Kind, shown_number};

/// One alternative of a schema, its references and `allOf` resolved.
#[derive(Clone, Default)]
pub(super) struct Form<'s> {
    pub types: Vec<&'s str>,
    pub words: Vec<&'s str>,
    pub properties: BTreeMap<&'s str, &'s Value>,
    pub required: Vec<&'s str>,
    pub closed: bool,
    /// Where ranges, items and advice stand.
    keywords: Vec<&'s Value>,
}

impl<'s> Form<'s> {
    /// A number without a range.
    pub fn any_number() -> Self {
        Self { types: vec!["number"], ..Self::default() }
    }

    /// All alternatives of a schema; `root` is where its references lead.
    pub fn alternatives(root: &'s Value, schema: &'s Value) -> Vec<Self> {
        Self::within(root, schema, &Self::default())
    }

    /// All alternatives, each with what its surroundings add.
    fn within(root: &'s Value, schema: &'s Value, around: &Self) -> Vec<Self> {
        let mut form = around.clone();
        form.keywords.push(schema);
        match schema.get("type") {
            Some(Value::String(name)) => form.types = vec![name],
            Some(Value::Array(names)) => form.types = names.iter().filter_map(Value::as_str).collect(),
            _ => {}
        }
        form.words.extend(schema.get("const").and_then(Value::as_str));
        form.words.extend(
            schema.get("enum").and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_str),
        );
        if let Some(properties) = schema.get("properties").and_then(Value::as_object) {
            form.properties.extend(properties.iter().map(|(key, value)| (key.as_str(), value)));
        }
        let required = schema.get("required").and_then(Value::as_array).into_iter().flatten();
        form.required.extend(required.filter_map(Value::as_str));
        form.closed |= ["additionalProperties", "unevaluatedProperties"]
            .iter()
            .any(|k| schema.get(k) == Some(&false.into()));
        let mut forms = vec![form];
        if let Some(referred) = schema.get("$ref").and_then(Value::as_str) {
            let target = referred.strip_prefix('#').and_then(|pointer| root.pointer(pointer));
            forms = target.map_or_else(Vec::new, |target| {
                forms.iter().flat_map(|form| Self::within(root, target, form)).collect()
            });
            // What stands beside the reference is nearer to the key than what it refers to.
            forms.iter_mut().for_each(|form| form.keywords.push(schema));
        }
        for part in schema.get("allOf").and_then(Value::as_array).into_iter().flatten() {
            forms = forms.iter().flat_map(|form| Self::within(root, part, form)).collect();
        }
        for keyword in ["anyOf", "oneOf"] {
            if let Some(parts) = schema.get(keyword).and_then(Value::as_array) {
                forms = forms
                    .iter()
                    .flat_map(|form| parts.iter().flat_map(|p| Self::within(root, p, form)))
                    .collect();
            }
        }
        forms
    }

    pub fn keyword(&self, name: &str) -> Option<&'s Value> {
        self.keywords.iter().rev().find_map(|schema| schema.get(name))
    }

    /// What values of a table under keys that are not named have to meet, if it takes such.
    pub fn other_values(&self) -> Option<&'s Value> {
        self.keyword("additionalProperties").filter(|schema| schema.is_object())
    }

    pub fn number(&self, name: &str) -> Option<f64> {
        self.keyword(name).and_then(Value::as_f64)
    }

    pub fn takes(&self, kind: &Kind) -> bool {
        let takes = |name: &str| self.types.contains(&name);
        match kind {
            Kind::Null => false,
            Kind::Date(_) => takes("string") && self.is_date(),
            Kind::Bool(_) => takes("boolean"),
            Kind::Integer(_) | Kind::Float(_) => takes("number") || takes("integer"),
            Kind::Text(_) => takes("string") || !self.words.is_empty(),
            Kind::List(_) => takes("array"),
            Kind::Table(_) => takes("object"),
        }
    }

    /// Whether its texts are dates.
    pub fn is_date(&self) -> bool {
        self.keyword("format").and_then(Value::as_str) == Some("date")
    }

    /// What the form takes, in words.
    pub fn expected(&self) -> String {
        if !self.words.is_empty() {
            return listed(&self.words);
        }
        let named = |name: &&str| match *name {
            "object" if self.properties.is_empty() => "a table".to_owned(),
            "object" => {
                let keys: Vec<&str> = self.properties.keys().copied().collect();
                format!("a table {{ {} }}", keys.join(", "))
            }
            "array" => "a list".to_owned(),
            "string" if self.is_date() => "a date YYYY-MM-DD".to_owned(),
            "string" => "a text".to_owned(),
            "boolean" => "true or false".to_owned(),
            "integer" => format!("a whole number{}", self.range_suffix()),
            _ => format!("a number{}", self.range_suffix()),
        };
        self.types.iter().map(named).collect::<Vec<_>>().join(" or ")
    }

    fn range_suffix(&self) -> String {
        self.range().map_or_else(String::new, |range| format!(" {range}"))
    }

    pub fn range(&self) -> Option<String> {
        let mut parts = Vec::new();
        for (keyword, sign) in
            [("exclusiveMinimum", "> "), ("minimum", ">= "), ("exclusiveMaximum", "< "), ("maximum", "<= ")]
        {
            if let Some(limit) = self.number(keyword) {
                parts.push(format!("{sign}{}", shown_number(limit)));
            }
        }
        if let Some(hole) = self.keyword("not").and_then(|not| not.get("const")) {
            parts.push(format!("not {hole}"));
        }
        (!parts.is_empty()).then(|| parts.join(" and "))
    }

    pub fn contains(&self, value: f64) -> bool {
        self.number("minimum").is_none_or(|limit| value >= limit)
            && self.number("exclusiveMinimum").is_none_or(|limit| value > limit)
            && self.number("maximum").is_none_or(|limit| value <= limit)
            && self.number("exclusiveMaximum").is_none_or(|limit| value < limit)
            && self.keyword("not").and_then(|not| not.get("const")?.as_f64()).is_none_or(|hole| value != hole)
    }

    pub fn way_out(&self) -> Option<String> {
        self.keyword("x-way-out").and_then(Value::as_str).map(str::to_owned)
    }
}

/// Words in quotes, separated by commas.
pub(super) fn listed(words: &[&str]) -> String {
    words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ")
}
