//! The cases of a block of evaluations: `{name?, input, expected, tolerance}`, or `{name?, input, error}` for what must be refused.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::{Tolerances, read};
use metrology::inspection::InspectionError;
use serde::de::DeserializeOwned;
use serde_json::Value;

/// Runs `check` over every case with its input, its tolerances and the expected quantities.
pub(super) fn check_each<Input: DeserializeOwned>(
    block: &str,
    list: &Value,
    ledger: &mut Ledger,
    mut check: impl FnMut(&Input, Tolerances<'_>, &mut Expected<'_>, &mut Ledger) -> Result<(), InspectionError>,
) {
    each_case(block, list, ledger, |name, case, item, ledger| {
        let Some(mut expected) = case.object("expected", ledger) else {
            return ledger.fail(name, "expected", Value::Null, "the case expects nothing".into());
        };
        expected.rename(name);
        // An unreadable input is a failure already.
        let Some(input) = read::<Input>(name, &item["input"], ledger) else { return };
        if let Err(error) = check(&input, Tolerances::of(item), &mut expected, ledger) {
            expected.refused(&error, ledger);
        }
        expected.finish(ledger);
    });
}

/// Runs `evaluate` over every case; it must refuse with the error that the case names.
pub(super) fn check_refusals<Input: DeserializeOwned>(
    block: &str,
    list: &Value,
    ledger: &mut Ledger,
    mut evaluate: impl FnMut(&Input) -> Result<(), InspectionError>,
) {
    each_case(block, list, ledger, |name, case, item, ledger| {
        let wanted = case.take("error").unwrap_or(&Value::Null);
        let Some(input) = read::<Input>(name, &item["input"], ledger) else { return };
        let found = match evaluate(&input) {
            Ok(()) => Value::from("accepted"),
            Err(error) if wanted.as_str().is_some_and(|word| letters(word) == letters(error.code())) => {
                wanted.clone()
            }
            Err(error) => Value::from(format!("{}: {error}", error.code())),
        };
        ledger.equal(name, "error", wanted.clone(), found);
    });
}

/// Every case of the list with its name; anything else than a list fails.
fn each_case<'a>(
    block: &str,
    list: &'a Value,
    ledger: &mut Ledger,
    mut check: impl FnMut(&str, &mut Expected<'a>, &'a Value, &mut Ledger),
) {
    let Some(items) = list.as_array() else {
        return ledger.fail(block, block, list.clone(), "a list of cases is needed here".into());
    };
    for (k, item) in items.iter().enumerate() {
        let name = item["name"].as_str().map_or_else(|| format!("{block}[{k}]"), str::to_owned);
        let mut case = Expected::new(&name, "", item, ledger);
        case.informative(&["name", "note", "input", "tolerance"]);
        check(&name, &mut case, item, ledger);
        case.finish(ledger);
    }
}

/// Compares a yes or no, if the file expects it.
pub(super) fn flag(expected: &mut Expected<'_>, key: &str, actual: bool, ledger: &mut Ledger) {
    if let Some(value) = expected.take(key) {
        ledger.equal(expected.case(), &expected.name(key), value.clone(), actual.into());
    }
}

/// Deviations of a file in um as mm; `null` is a sample that was not measured.
pub(super) fn deviations_mm(um: &[Option<f64>]) -> Vec<f64> {
    um.iter().map(|f| f.map_or(f64::NAN, |f| f * 1e-3)).collect()
}

/// Numbers of a file in um as mm.
pub(super) fn mm(um: &[f64]) -> Vec<f64> {
    um.iter().map(|x| x * 1e-3).collect()
}

/// An error's name whether it is written `EmptyRange` or `empty-range`.
fn letters(name: &str) -> String {
    name.chars().filter(char::is_ascii_alphanumeric).collect::<String>().to_lowercase()
}
