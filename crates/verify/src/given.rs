//! What stands among the expected quantities as input, and vectors: read with a refusal instead of an absence.

use super::expected::{Expected, numbers};
use super::ledger::Ledger;
use nalgebra::Vector3;
use serde_json::Value;
use std::error::Error;
use std::ops::RangeInclusive;

/// What a check ends with: a refusal by the library, or an input that is no use, ends the object that it stands in.
pub(super) type Checked<T = ()> = Result<T, Box<dyn Error>>;

/// Largest number of lines, rays or samples in one direction that a file may ask for: beyond it a check takes minutes.
pub(super) const MOST: u64 = 2000;

/// Runs a check over an object; a refusal is a failure there, and so is every quantity that was not asked for.
pub(super) fn check_object<'a>(
    mut expected: Expected<'a>,
    ledger: &mut Ledger,
    check: impl FnOnce(&mut Expected<'a>, &mut Ledger) -> Checked,
) {
    expected.informative(&["note"]);
    if let Err(error) = check(&mut expected, ledger) {
        expected.refused(&error, ledger);
    }
    expected.finish(ledger);
}

/// The same over a whole block.
pub(super) fn check_block<'a>(
    block: &str,
    value: &'a Value,
    ledger: &mut Ledger,
    check: impl FnOnce(&mut Expected<'a>, &mut Ledger) -> Checked,
) {
    let expected = Expected::new(block, "", value, ledger);
    check_object(expected, ledger, check);
}

/// The same over every object of the list `items` in a block; the list must not be empty.
pub(super) fn check_items<'a>(
    block: &mut Expected<'a>,
    key: &str,
    ledger: &mut Ledger,
    mut check: impl FnMut(&mut Expected<'a>, &mut Ledger) -> Checked,
) -> Checked {
    let items = block.objects(key, ledger);
    if items.is_empty() {
        return Err(format!("{key}: a list that is not empty is needed here").into());
    }
    for item in items {
        check_object(item, ledger, &mut check);
    }
    Ok(())
}

/// A number given as input.
pub(super) fn number(expected: &mut Expected<'_>, key: &str, ledger: &mut Ledger) -> Checked<f64> {
    expected.given(key, ledger).ok_or_else(|| format!("{key} is missing").into())
}

/// A tolerance: a failure of its own if the file does not state it, and nothing passes then.
pub(super) fn tolerance(expected: &mut Expected<'_>, key: &str, ledger: &mut Ledger) -> f64 {
    expected.given(key, ledger).unwrap_or(f64::NAN)
}

/// A text given as input.
pub(super) fn text<'a>(expected: &mut Expected<'a>, key: &str, ledger: &mut Ledger) -> Checked<&'a str> {
    expected.given_text(key, ledger).ok_or_else(|| format!("{key} is missing").into())
}

/// Requires one of the ways of counting or measuring that a file may describe in words.
pub(super) fn requires(
    expected: &mut Expected<'_>,
    key: &str,
    known: &[&str],
    ledger: &mut Ledger,
) -> Checked<usize> {
    let found = text(expected, key, ledger)?;
    known
        .iter()
        .position(|known| *known == found)
        .ok_or_else(|| format!("{key}: {found:?} is unknown; known: {}", known.join(" | ")).into())
}

/// A list of numbers given as input.
pub(super) fn list(expected: &mut Expected<'_>, key: &str, ledger: &mut Ledger) -> Checked<Vec<f64>> {
    expected.given_list(key, ledger).ok_or_else(|| format!("{key} is missing").into())
}

/// So many numbers given as input.
pub(super) fn array<const N: usize>(
    expected: &mut Expected<'_>,
    key: &str,
    ledger: &mut Ledger,
) -> Checked<[f64; N]> {
    let found = list(expected, key, ledger)?;
    found.try_into().map_err(|_| format!("{key}: a list of {N} numbers is needed here").into())
}

/// A vector given as input.
pub(super) fn vector(expected: &mut Expected<'_>, key: &str, ledger: &mut Ledger) -> Checked<Vector3<f64>> {
    array::<3>(expected, key, ledger).map(Vector3::from)
}

/// Vectors given as input.
pub(super) fn vectors(expected: &mut Expected<'_>, key: &str) -> Checked<Vec<Vector3<f64>>> {
    let one = |value: &Value| Some(Vector3::from(<[f64; 3]>::try_from(numbers(value)?).ok()?));
    let found = expected.take(key).and_then(Value::as_array);
    let found = found.and_then(|list| list.iter().map(one).collect::<Option<Vec<_>>>());
    found.ok_or_else(|| format!("{key}: a list of vectors is needed here").into())
}

/// A whole number of a JSON value within bounds.
pub(super) fn whole(name: &str, value: Option<&Value>, allowed: RangeInclusive<u64>) -> Checked<usize> {
    let found = value.and_then(Value::as_u64).filter(|n| allowed.contains(n));
    let found = found.ok_or_else(|| format!("{name}: a whole number in {allowed:?} is needed here"))?;
    Ok(usize::try_from(found)?)
}

/// A whole number given as input.
pub(super) fn count(expected: &mut Expected<'_>, key: &str, allowed: RangeInclusive<u64>) -> Checked<usize> {
    let value = expected.take(key);
    whole(key, value, allowed)
}

/// Numbers of lines, [rows, columns], given as input.
pub(super) fn counts(
    expected: &mut Expected<'_>,
    key: &str,
    allowed: RangeInclusive<u64>,
) -> Checked<[usize; 2]> {
    let value = expected.take(key).and_then(Value::as_array).filter(|list| list.len() == 2);
    let list = value.ok_or_else(|| format!("{key}: two whole numbers are needed here"))?;
    Ok([whole(key, list.first(), allowed.clone())?, whole(key, list.get(1), allowed)?])
}

/// Compares a vector.
pub(super) fn compare_vector(
    expected: &mut Expected<'_>,
    key: &str,
    actual: &Vector3<f64>,
    tolerance: f64,
    ledger: &mut Ledger,
) {
    expected.list(key, actual.as_slice(), tolerance, ledger);
}

/// Compares a list of vectors.
pub(super) fn compare_vectors(
    expected: &mut Expected<'_>,
    key: &str,
    actual: &[Vector3<f64>],
    tolerance: f64,
    ledger: &mut Ledger,
) {
    let flat: Vec<f64> = actual.iter().flat_map(|v| [v.x, v.y, v.z]).collect();
    expected.table(key, (&flat, 3), tolerance, ledger);
}

/// Compares a list of pairs.
pub(super) fn compare_pairs(
    expected: &mut Expected<'_>,
    key: &str,
    actual: &[[f64; 2]],
    tolerance: f64,
    ledger: &mut Ledger,
) {
    expected.table(key, (actual.as_flattened(), 2), tolerance, ledger);
}

/// Compares a list of texts.
pub(super) fn compare_texts(expected: &mut Expected<'_>, key: &str, actual: &[&str], ledger: &mut Ledger) {
    let Some(value) = expected.take(key) else { return };
    let name = expected.name(key);
    match value.as_array().filter(|list| list.len() == actual.len()) {
        Some(list) => {
            for (k, (wanted, found)) in list.iter().zip(actual).enumerate() {
                ledger.equal(expected.case(), &format!("{name}[{k}]"), wanted.clone(), (*found).into());
            }
        }
        None => ledger.fail(expected.case(), &name, value.clone(), Value::from(actual)),
    }
}
