//! Expected values of a case that know which of them were asked for: what is not computed is an error, never a skip.

use super::ledger::Ledger;
use serde_json::{Map, Value};
use std::collections::BTreeSet;

/// A JSON object of expected quantities, its path and the keys already dealt with.
pub(super) struct Expected<'a> {
    case: String,
    path: String,
    map: Option<&'a Map<String, Value>>,
    seen: BTreeSet<&'a str>,
}

impl<'a> Expected<'a> {
    /// The quantities of `value` (an object) in `case`, reported under `path`.
    pub fn new(case: &str, path: &str, value: &'a Value, ledger: &mut Ledger) -> Self {
        let map = value.as_object();
        if map.is_none() {
            ledger.fail(case, path, value.clone(), "an object of expected quantities is needed here".into());
        }
        Self { case: case.into(), path: path.into(), map, seen: BTreeSet::new() }
    }

    /// Name of the case.
    pub fn case(&self) -> &str {
        &self.case
    }

    /// Gives the case another name in the report.
    pub fn rename(&mut self, case: &str) {
        self.case = case.into();
    }

    /// The name of a quantity in the report, with its path inside the case.
    pub fn name(&self, key: &str) -> String {
        if self.path.is_empty() { key.into() } else { format!("{}.{key}", self.path) }
    }

    /// Marks a key as dealt with and returns its value.
    pub fn take(&mut self, key: &str) -> Option<&'a Value> {
        let (key, value) = self.map?.get_key_value(key)?;
        self.seen.insert(key);
        Some(value)
    }

    /// The value of a key without marking it as dealt with.
    pub fn peek(&self, key: &str) -> Option<&'a Value> {
        self.map?.get(key)
    }

    /// Keys that say something about the figures but expect nothing of the library.
    pub fn informative(&mut self, keys: &[&str]) {
        for key in keys {
            self.take(key);
        }
    }

    /// A number that stands among the expected ones as input (a coordinate). Absent or no number: a failure and `None`.
    pub fn given(&mut self, key: &str, ledger: &mut Ledger) -> Option<f64> {
        let value = self.take(key).and_then(Value::as_f64);
        if value.is_none() {
            ledger.fail(&self.case, &self.name(key), Value::Null, "a number is needed here as input".into());
        }
        value
    }

    /// A number that may stand among the expected ones as input. `None` where it is absent; anything else than a number fails.
    pub fn given_optional(&mut self, key: &str, ledger: &mut Ledger) -> Option<f64> {
        self.peek(key)?;
        self.given(key, ledger)
    }

    /// A text that stands among the expected quantities as input.
    pub fn given_text(&mut self, key: &str, ledger: &mut Ledger) -> Option<&'a str> {
        let value = self.take(key).and_then(Value::as_str);
        if value.is_none() {
            ledger.fail(&self.case, &self.name(key), Value::Null, "a text is needed here as input".into());
        }
        value
    }

    /// The flank named by the key `flank`.
    pub fn given_flank(&mut self, ledger: &mut Ledger) -> Option<foundation::geometry::Flank> {
        let text = self.given_text("flank", ledger)?;
        let flank = foundation::geometry::Flank::BOTH.into_iter().find(|f| f.name() == text);
        if flank.is_none() {
            ledger.fail(&self.case, &self.name("flank"), text.into(), "left or right is needed here".into());
        }
        flank
    }

    /// A list of numbers that stands among the expected quantities as input.
    pub fn given_list(&mut self, key: &str, ledger: &mut Ledger) -> Option<Vec<f64>> {
        let list = self.take(key).and_then(numbers);
        if list.is_none() {
            ledger.fail(&self.case, &self.name(key), Value::Null, "a list of numbers is needed here".into());
        }
        list
    }

    fn expected_number(&mut self, key: &str, actual: f64, ledger: &mut Ledger) -> Option<f64> {
        let value = self.take(key)?;
        let number = value.as_f64();
        if number.is_none() {
            ledger.fail(&self.case, &self.name(key), value.clone(), actual.to_string().into());
        }
        number
    }

    /// Compares a number, if the file expects it.
    pub fn number(&mut self, key: &str, actual: f64, tolerance: f64, ledger: &mut Ledger) {
        if let Some(expected) = self.expected_number(key, actual, ledger) {
            ledger.number(&self.case, &self.name(key), expected, actual, tolerance);
        }
    }

    /// Compares a number that is the better the smaller it is: it may exceed the expected one by the tolerance.
    pub fn at_most(&mut self, key: &str, actual: f64, tolerance: f64, ledger: &mut Ledger) {
        if let Some(expected) = self.expected_number(key, actual, ledger) {
            ledger.at_most(&self.case, &self.name(key), expected, actual, tolerance);
        }
    }

    /// Compares a whole number exactly; the file gives it as a number or, where other readers would round it, as a text.
    pub fn whole(&mut self, key: &str, actual: i64, ledger: &mut Ledger) {
        if let Some(value) = self.take(key) {
            ledger.equal(&self.case, &self.name(key), value.clone(), whole_like(value, actual));
        }
    }

    /// Compares a list of whole numbers exactly, element by element.
    pub fn wholes(&mut self, key: &str, actual: &[i64], ledger: &mut Ledger) {
        let Some(value) = self.take(key) else { return };
        let name = self.name(key);
        match value.as_array().filter(|list| list.len() == actual.len()) {
            Some(list) => {
                for (k, (e, &a)) in list.iter().zip(actual).enumerate() {
                    ledger.equal(&self.case, &format!("{name}[{k}]"), e.clone(), whole_like(e, a));
                }
            }
            None => {
                let found = format!("a list of {} whole numbers", actual.len());
                ledger.fail(&self.case, &name, value.clone(), found.into());
            }
        }
    }

    /// Compares a text, if the file expects it.
    pub fn text(&mut self, key: &str, actual: &str, ledger: &mut Ledger) {
        if let Some(value) = self.take(key) {
            ledger.equal(&self.case, &self.name(key), value.clone(), actual.into());
        }
    }

    /// Compares several numbers to one tolerance.
    pub fn numbers(&mut self, pairs: &[(&str, f64)], tolerance: f64, ledger: &mut Ledger) {
        for &(key, actual) in pairs {
            self.number(key, actual, tolerance, ledger);
        }
    }

    /// Compares a number modulo a period.
    pub fn periodic(&mut self, key: &str, actual: f64, period: f64, tolerance: f64, ledger: &mut Ledger) {
        if let Some(expected) = self.expected_number(key, actual, ledger) {
            ledger.periodic((&self.case, &self.name(key)), expected, actual, period, tolerance);
        }
    }

    /// Compares a number that may not exist (`null` in the file).
    pub fn optional(&mut self, key: &str, actual: Option<f64>, tolerance: f64, ledger: &mut Ledger) {
        let Some(value) = self.take(key) else { return };
        match (value.as_f64(), actual) {
            (Some(expected), Some(actual)) => {
                ledger.number(&self.case, &self.name(key), expected, actual, tolerance);
            }
            (_, actual) => {
                ledger.equal(
                    &self.case,
                    &self.name(key),
                    value.clone(),
                    actual.map_or(Value::Null, Value::from),
                );
            }
        }
    }

    /// Compares a list of numbers element by element, each to its own tolerance made from the expected one.
    pub fn list_to(
        &mut self,
        key: &str,
        actual: &[f64],
        tolerance: impl Fn(f64) -> f64,
        ledger: &mut Ledger,
    ) {
        let Some(value) = self.take(key) else { return };
        let name = self.name(key);
        match numbers(value).filter(|expected| expected.len() == actual.len()) {
            Some(expected) => {
                for (k, (e, a)) in expected.iter().zip(actual).enumerate() {
                    ledger.number(&self.case, &format!("{name}[{k}]"), *e, *a, tolerance(*e));
                }
            }
            None => {
                let found = format!("a list of {} numbers", actual.len());
                ledger.fail(&self.case, &name, value.clone(), found.into());
            }
        }
    }

    /// Compares a list of numbers element by element.
    pub fn list(&mut self, key: &str, actual: &[f64], tolerance: f64, ledger: &mut Ledger) {
        self.list_to(key, actual, |_| tolerance, ledger);
    }

    /// Compares a list to a share of its largest expected element.
    pub fn list_relative_to_largest(&mut self, key: &str, actual: &[f64], share: f64, ledger: &mut Ledger) {
        let expected = self.map.and_then(|m| m.get(key)).and_then(numbers).unwrap_or_default();
        let largest = expected.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        self.list(key, actual, share * largest, ledger);
    }

    /// Takes a table `[row][column]` with that many rows and columns as one list; another shape is a failure and `None`.
    pub fn take_table(
        &mut self,
        key: &str,
        [rows, columns]: [usize; 2],
        ledger: &mut Ledger,
    ) -> Option<Vec<&'a Value>> {
        let value = self.take(key)?;
        let table: Option<Vec<&Vec<Value>>> =
            value.as_array().and_then(|list| list.iter().map(Value::as_array).collect());
        let fits =
            |table: &Vec<&Vec<Value>>| table.len() == rows && table.iter().all(|row| row.len() == columns);
        let table = table.filter(fits).map(|table| table.into_iter().flatten().collect());
        if table.is_none() {
            let found = format!("a table of {rows} rows and {columns} columns");
            ledger.fail(&self.case, &self.name(key), value.clone(), found.into());
        }
        table
    }

    /// Compares a table `[row][column]` with values in that order.
    pub fn table(
        &mut self,
        key: &str,
        (actual, columns): (&[f64], usize),
        tolerance: f64,
        ledger: &mut Ledger,
    ) {
        let rows = actual.len() / columns.max(1);
        let Some(expected) = self.take_table(key, [rows, columns], ledger) else { return };
        for (k, (expected, &actual)) in expected.into_iter().zip(actual).enumerate() {
            let name = self.name(&format!("{key}[{}][{}]", k / columns, k % columns));
            match expected.as_f64() {
                Some(number) => ledger.number(&self.case, &name, number, actual, tolerance),
                None => ledger.fail(&self.case, &name, expected.clone(), actual.into()),
            }
        }
    }

    /// An object inside this one.
    pub fn object(&mut self, key: &str, ledger: &mut Ledger) -> Option<Expected<'a>> {
        let value = self.take(key)?;
        Some(Expected::new(&self.case, &self.name(key), value, ledger))
    }

    /// The objects of a list inside this one.
    pub fn objects(&mut self, key: &str, ledger: &mut Ledger) -> Vec<Expected<'a>> {
        let Some(value) = self.take(key) else { return Vec::new() };
        let name = self.name(key);
        let Some(list) = value.as_array() else {
            ledger.fail(&self.case, &name, value.clone(), "a list is needed here".into());
            return Vec::new();
        };
        list.iter()
            .enumerate()
            .map(|(k, item)| Expected::new(&self.case, &format!("{name}[{k}]"), item, ledger))
            .collect()
    }

    /// Reports that this object cannot be compared because the library refused its input.
    pub fn refused(&mut self, error: &dyn std::fmt::Display, ledger: &mut Ledger) {
        let keys: Vec<&str> = self.map.iter().flat_map(|m| m.keys()).map(String::as_str).collect();
        self.informative(&keys);
        ledger.fail(&self.case, &self.path, "computed values".into(), error.to_string().into());
    }

    /// Ends the object: every key that was not asked for is a failure.
    pub fn finish(self, ledger: &mut Ledger) {
        for (key, value) in self.map.into_iter().flatten() {
            if !self.seen.contains(key.as_str()) {
                let quantity = format!("unknown quantity {}", self.name(key));
                ledger.fail(&self.case, &quantity, value.clone(), Value::Null);
            }
        }
    }
}

/// A whole number written as the file writes it: as text beside a text, else as number.
fn whole_like(written: &Value, whole: i64) -> Value {
    if written.is_string() { whole.to_string().into() } else { whole.into() }
}

/// A JSON list of numbers.
pub(super) fn numbers(value: &Value) -> Option<Vec<f64>> {
    value.as_array()?.iter().map(Value::as_f64).collect()
}
