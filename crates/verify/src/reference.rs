//! What a check sees of the file: the whole content, the tolerances it states, where data files may lie.

use super::VerifyOptions;
use super::expected::Expected;
use super::ledger::Ledger;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};
use std::path::PathBuf;

/// A reference file under check.
pub(super) struct Reference<'a> {
    /// The whole file.
    pub root: &'a Value,
    options: &'a VerifyOptions,
}

impl<'a> Reference<'a> {
    pub fn new(root: &'a Value, options: &'a VerifyOptions) -> Self {
        Self { root, options }
    }

    /// A data file that a case names, where it is found first.
    pub fn data_file(&self, name: &str) -> Option<PathBuf> {
        self.options.data_directories.iter().map(|dir| dir.join(name)).find(|path| path.is_file())
    }

    /// The paths on which a data file is looked for, in their order.
    pub fn data_paths(&self, name: &str) -> Vec<String> {
        self.options.data_directories.iter().map(|dir| dir.join(name).display().to_string()).collect()
    }

    /// The file's common tolerances.
    pub fn tolerances(&self) -> Tolerances<'a> {
        Tolerances::of(self.root)
    }
}

/// The tolerances that a file or block states under `tolerance`.
#[derive(Clone, Copy)]
pub(super) struct Tolerances<'a>(Option<&'a Map<String, Value>>);

impl<'a> Tolerances<'a> {
    /// The table `tolerance` of a file or block.
    pub fn of(value: &'a Value) -> Self {
        Self(value.get("tolerance").and_then(Value::as_object))
    }

    /// A table that is itself the tolerances.
    pub fn table(value: &'a Value) -> Self {
        Self(value.as_object())
    }

    /// A table of tolerances inside this one.
    pub fn inside(&self, key: &str) -> Self {
        Self(self.0.and_then(|m| m.get(key)).and_then(Value::as_object))
    }

    /// The tolerance of that name; NaN, which nothing passes, if the file does not state it.
    pub fn get(&self, key: &str) -> f64 {
        self.0.and_then(|m| m.get(key)).and_then(Value::as_f64).unwrap_or(f64::NAN)
    }
}

/// One case of a block: its name, its input and its expected quantities.
pub(super) struct Case<'a> {
    pub name: String,
    pub input: &'a Value,
    pub expected: Expected<'a>,
}

/// The cases of a list `[{name, input, expected, note?}, ...]`. Anything else inside a case is an unknown quantity.
pub(super) fn cases<'a>(block: &str, list: &'a Value, ledger: &mut Ledger) -> Vec<Case<'a>> {
    let Some(items) = list.as_array() else {
        ledger.fail(block, block, list.clone(), "a list of cases is needed here".into());
        return Vec::new();
    };
    let mut cases = Vec::new();
    for (k, item) in items.iter().enumerate() {
        let name = item["name"].as_str().map_or_else(|| format!("{block}[{k}]"), str::to_owned);
        let mut outer = Expected::new(&name, "", item, ledger);
        outer.informative(&["name", "note", "input"]);
        match outer.take("expected") {
            Some(value) => {
                let expected = Expected::new(&name, "", value, ledger);
                cases.push(Case { name, input: &item["input"], expected });
            }
            None => ledger.fail(&name, "expected", Value::Null, "the case expects nothing".into()),
        }
        outer.finish(ledger);
    }
    cases
}

/// Reads an input; a failure names the case and what is wrong.
pub(super) fn read<T: DeserializeOwned>(case: &str, value: &Value, ledger: &mut Ledger) -> Option<T> {
    match T::deserialize(value) {
        Ok(input) => Some(input),
        Err(error) => {
            ledger.fail(case, "input", value.clone(), error.to_string().into());
            None
        }
    }
}
