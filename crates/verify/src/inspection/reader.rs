//! Block `reader`: bytes of small files in all dialects and what must be read from them.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object};
use super::super::ledger::Ledger;
use super::super::reference::{Reference, cases};
use foundation::geometry::Flank;
use measured_files::inspection::{InspectionError, KlingelnbergFile, PitchRow, parse_klingelnberg};
use serde_json::{Map, Value, json};

/// Block `reader`.
pub(crate) fn reader(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    for case in cases("reader", block, ledger) {
        let input = case.input;
        check_object(case.expected, ledger, |expected, ledger| check(input, expected, ledger));
    }
}

fn check(input: &Value, expected: &mut Expected<'_>, ledger: &mut Ledger) -> Checked {
    let hex = input["hex"].as_str().ok_or("input.hex: a text is needed here")?;
    let found =
        parse_klingelnberg(&bytes(hex).ok_or("input.hex: pairs of hexadecimal digits are needed here")?);
    let error = found.as_ref().err().map_or(Value::Null, |error| name(error).into());
    let mut equal = |expected: &mut Expected<'_>, key: &str, actual: Value| {
        if let Some(wanted) = expected.take(key) {
            ledger.equal(
                expected.case(),
                &expected.name(key),
                numbers_as_doubles(wanted),
                numbers_as_doubles(&actual),
            );
        }
    };
    equal(expected, "error", error);
    let Ok(file) = found else { return Ok(()) };
    equal(expected, "kind", serde_json::to_value(file.kind)?);
    equal(expected, "encoding", file.encoding.name().into());
    equal(expected, "header_codes", file.header.keys().copied().collect());
    equal(expected, "traces", traces(&file));
    let results = file.results.iter().map(|(code, value)| (code.to_string(), json!(value)));
    equal(expected, "results", Value::Object(results.collect()));
    equal(expected, "pitch", pitch(&file));
    equal(expected, "unknown_lines", file.unknown_lines.iter().map(|line| line.line).collect());
    equal(expected, "warnings", file.warnings.iter().map(|w| w.kind.name()).collect());
    Ok(())
}

/// The name of an error as reference files spell it: that of its variant.
pub(super) fn name(error: &InspectionError) -> String {
    format!("{error:?}").chars().take_while(char::is_ascii_alphanumeric).collect()
}

fn bytes(hex: &str) -> Option<Vec<u8>> {
    let (pairs, rest) = hex.as_bytes().as_chunks::<2>();
    let digit = |b: u8| char::from(b).to_digit(16);
    let byte = |[a, b]: &[u8; 2]| u8::try_from(16 * digit(*a)? + digit(*b)?).ok();
    if rest.is_empty() { pairs.iter().map(byte).collect() } else { None }
}

fn defined(value: f64) -> Value {
    if value.is_nan() { Value::Null } else { value.into() }
}

fn traces(file: &KlingelnbergFile) -> Value {
    let one = |curve: &measured_files::inspection::Curve| {
        json!({
            "kind": curve.kind.name(),
            "tooth": curve.tooth,
            "tag": curve.tag,
            "flank": curve.flank.name(),
            "n": curve.values.len(),
            "position_mm": curve.position_mm,
            "values": curve.values.iter().map(|v| defined(*v)).collect::<Vec<_>>(),
        })
    };
    file.curves.iter().map(one).collect()
}

/// Only sides that have rows.
fn pitch(file: &KlingelnbergFile) -> Value {
    let row = |row: &PitchRow| {
        Value::from(vec![row.tooth.into(), defined(row.fp), defined(row.cumulative), defined(row.run_out)])
    };
    let mut sides = Map::new();
    for flank in Flank::BOTH {
        if !file.pitch[flank].is_empty() {
            sides.insert(flank.name().into(), file.pitch[flank].iter().map(row).collect());
        }
    }
    Value::Object(sides)
}

/// 1 and 1.0 are one number.
fn numbers_as_doubles(value: &Value) -> Value {
    match value {
        Value::Number(number) => number.as_f64().map_or(Value::Null, Value::from),
        Value::Array(list) => list.iter().map(numbers_as_doubles).collect(),
        Value::Object(map) => {
            Value::Object(map.iter().map(|(key, value)| (key.clone(), numbers_as_doubles(value))).collect())
        }
        other => other.clone(),
    }
}
