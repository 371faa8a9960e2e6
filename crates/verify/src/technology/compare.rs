//! Tolerances of the file as shares, and comparison of nested lists with them.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use serde_json::Value;

/// Numbers near zero are compared to this.
const NEAR_ZERO: f64 = 1e-9;
/// Rates and volumes of constant stock.
const CONSTANT: f64 = 1e-6;

/// Shares of the expected value, or of the largest one.
pub(super) struct Shares {
    pub relative: f64,
    pub a_um: f64,
    pub gap_um: f64,
    pub rate: f64,
    pub constant_rate: f64,
    pub specific_rate: f64,
    pub volume: f64,
    pub wear: f64,
    pub parts: f64,
    pub time: f64,
    pub optimum_time: f64,
}

impl Shares {
    pub fn of(tol: Tolerances<'_>, constant: bool) -> Self {
        let of_stock = |key: &str| if constant { CONSTANT } else { tol.get(key) };
        Self {
            relative: tol.get("relative"),
            a_um: tol.get("a_um"),
            gap_um: tol.get("gap_um"),
            rate: tol.get("Q_w_relative_to_largest"),
            constant_rate: CONSTANT,
            specific_rate: of_stock("Q_w_prime_relative_to_largest"),
            volume: of_stock("volume_relative"),
            wear: tol.get("V_w_prime_relative_to_largest"),
            parts: tol.get("parts_relative"),
            time: tol.get("time_relative"),
            optimum_time: tol.get("optimum_time_relative"),
        }
    }
}

/// A share of the expected value, never below what counts as zero.
pub(super) fn share(share: f64) -> impl Fn(f64) -> f64 {
    move |expected: f64| (share * expected.abs()).max(NEAR_ZERO)
}

/// Compares a number to a share of it.
pub(super) fn number(item: &mut Expected<'_>, key: &str, actual: f64, by: f64, ledger: &mut Ledger) {
    let expected = item.peek(key).and_then(Value::as_f64).unwrap_or(0.0);
    item.number(key, actual, share(by)(expected), ledger);
}

/// Compares several numbers to a share of each.
pub(super) fn numbers(item: &mut Expected<'_>, pairs: &[(&str, f64)], by: f64, ledger: &mut Ledger) {
    for &(key, actual) in pairs {
        number(item, key, actual, by, ledger);
    }
}

/// Compares a whole number to a share of it, at least 1.
pub(super) fn count(item: &mut Expected<'_>, key: &str, actual: f64, by: f64, ledger: &mut Ledger) {
    let expected = item.peek(key).and_then(Value::as_f64).unwrap_or(0.0);
    item.number(key, actual, (by * expected).max(1.0), ledger);
}

/// Compares a table to one tolerance, or to a share of its largest element where `to_largest`.
pub(super) fn table(
    item: &mut Expected<'_>,
    key: &str,
    rows: &[Vec<f64>],
    (tolerance, to_largest): (f64, bool),
    ledger: &mut Ledger,
) {
    let flat: Vec<f64> = rows.iter().flatten().copied().collect();
    let largest = item.peek(key).map_or(0.0, largest_of);
    let tolerance = if to_largest { (tolerance * largest).max(NEAR_ZERO) } else { tolerance };
    let columns = rows.first().map_or(1, Vec::len);
    item.table(key, (&flat, columns), tolerance, ledger);
}

/// Largest absolute number in nested lists.
pub(super) fn largest_of(value: &Value) -> f64 {
    match value {
        Value::Array(list) => list.iter().map(largest_of).fold(0.0, f64::max),
        other => other.as_f64().map_or(0.0, f64::abs),
    }
}

/// Compares tables `[space][row][column]`, one for each listed space.
pub(super) fn tables(
    item: &mut Expected<'_>,
    key: &str,
    actual: &[Vec<Vec<f64>>],
    (tolerance, to_largest): (f64, bool),
    ledger: &mut Ledger,
) {
    let Some(value) = item.take(key) else { return };
    let (case, name) = (item.case().to_owned(), item.name(key));
    let tolerance = if to_largest { (tolerance * largest_of(value)).max(NEAR_ZERO) } else { tolerance };
    let Some(list) = value.as_array().filter(|list| list.len() == actual.len()) else {
        ledger.fail(&case, &name, value.clone(), format!("{} tables", actual.len()).into());
        return;
    };
    for (k, (expected, actual)) in list.iter().zip(actual).enumerate() {
        let rows = expected.as_array().map_or(0, Vec::len);
        if rows != actual.len() {
            ledger.fail(
                &case,
                &format!("{name}[{k}]"),
                expected.clone(),
                format!("{} rows", actual.len()).into(),
            );
            continue;
        }
        for (i, (expected, actual)) in expected.as_array().into_iter().flatten().zip(actual).enumerate() {
            let row = super::super::expected::numbers(expected).filter(|row| row.len() == actual.len());
            let name = format!("{name}[{k}][{i}]");
            let Some(row) = row else {
                let found = format!("a row of {} numbers", actual.len());
                ledger.fail(&case, &name, expected.clone(), found.into());
                continue;
            };
            for (j, (expected, actual)) in row.iter().zip(actual).enumerate() {
                ledger.number(&case, &format!("{name}[{j}]"), *expected, *actual, tolerance);
            }
        }
    }
}
