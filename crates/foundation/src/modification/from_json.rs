//! Typed errors for descriptions that don't parse: which key, which value, what is allowed. The JSON schema that
//! the description types generate is the only list of kinds and keys consulted.

use serde::Deserialize;
use serde_json::{Map, Value};

use super::error::ModificationError;
use super::spec::ModificationSpec;

impl ModificationSpec {
    /// Reads one description from JSON (or from TOML converted to it).
    ///
    /// # Errors
    /// `UnknownModification` for a kind that doesn't exist (with the nearest one), `InvalidModification` for a
    /// missing or unknown key and for a value of the wrong type.
    pub fn from_json(value: &Value) -> Result<Self, ModificationError> {
        Self::deserialize(value).map_err(|error| diagnose(value, &error))
    }
}

fn invalid(kind: &str, key: &str, value: String, allowed: String) -> ModificationError {
    ModificationError::InvalidModification { kind: kind.into(), key: key.into(), value, allowed }
}

fn diagnose(value: &Value, error: &serde_json::Error) -> ModificationError {
    let Some(table) = value.as_object() else {
        return invalid("modification", "entry", value.to_string(), "a table with the key kind".into());
    };
    let Some(kind) = table.get("kind").and_then(Value::as_str) else {
        let found = table.get("kind").map_or("missing".into(), Value::to_string);
        return invalid("modification", "kind", found, "the name of a modification".into());
    };

    let schema = schemars::schema_for!(ModificationSpec).to_value();
    let variants = schema["oneOf"].as_array().map(Vec::as_slice).unwrap_or_default();
    let name = |variant: &Value| variant["properties"]["kind"]["const"].as_str().map(str::to_owned);
    let kinds: Vec<String> = variants.iter().filter_map(name).collect();
    let Some(variant) = variants.iter().find(|variant| name(variant).as_deref() == Some(kind)) else {
        let nearest = nearest(kind, &kinds);
        return ModificationError::UnknownModification {
            kind: kind.into(),
            nearest,
            allowed: kinds.join(", "),
        };
    };

    let keys: Vec<String> =
        variant["properties"].as_object().map(|p| p.keys().cloned().collect()).unwrap_or_default();
    if let Some(key) = table.keys().find(|key| !keys.contains(key)) {
        let allowed = format!("{} (did you mean {}?)", keys.join(", "), nearest(key, &keys));
        return invalid(kind, key, "an unknown key".into(), allowed);
    }
    let required = variant["required"].as_array().map(Vec::as_slice).unwrap_or_default();
    if let Some(key) = required.iter().filter_map(Value::as_str).find(|key| !table.contains_key(*key)) {
        let meaning = variant["properties"][key]["description"].as_str().unwrap_or("a value");
        return invalid(kind, key, "missing".into(), meaning.trim_end_matches('.').into());
    }
    let children = table.get("children").and_then(Value::as_array).map(Vec::as_slice).unwrap_or_default();
    if let Some(error) = children.iter().find_map(|child| ModificationSpec::from_json(child).err()) {
        return error;
    }
    let key = culprit(table, error).unwrap_or("kind");
    invalid(kind, key, table[key].to_string(), error.to_string())
}

/// The key without which the parser no longer complains of the same thing.
fn culprit<'a>(table: &'a Map<String, Value>, error: &serde_json::Error) -> Option<&'a str> {
    let complaint = error.to_string();
    table.keys().filter(|key| *key != "kind").map(String::as_str).find(|key| {
        let mut rest = table.clone();
        rest.remove(*key);
        ModificationSpec::deserialize(&Value::Object(rest)).err().is_none_or(|e| e.to_string() != complaint)
    })
}

/// The name spelled most like `word`.
fn nearest(word: &str, names: &[String]) -> String {
    let likeness = |name: &&String| (strsim::jaro_winkler(word, name) * 1e6) as u64;
    names.iter().max_by_key(likeness).cloned().unwrap_or_default()
}
