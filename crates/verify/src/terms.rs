//! Tables of polynomial coefficients in reference files: how they are read and compared.

use super::expected::Expected;
use super::ledger::Ledger;
use foundation::numerics::Polynomial2;
use serde_json::Value;

const UM: f64 = 1e-3;

/// A polynomial given as a table {"u0y2": -0.04, ...} in um/mm^(i+j) for the two `letters`; mm.
pub(super) fn polynomial(
    case: &str,
    value: Option<&Value>,
    letters: [char; 2],
    ledger: &mut Ledger,
) -> Option<Polynomial2> {
    let table = value.and_then(Value::as_object);
    let terms = table.and_then(|table| {
        let term = |(key, value): (&String, &Value)| {
            let (i, j) = key.strip_prefix(letters[0])?.split_once(letters[1])?;
            // Degrees beyond a few tens are no flank; the dense table behind them would not fit anywhere.
            let exponent = |text: &str| text.parse().ok().filter(|&n: &usize| n < 32);
            Some((exponent(i)?, exponent(j)?, value.as_f64()? * UM))
        };
        table.iter().map(term).collect::<Option<Vec<_>>>()
    });
    if terms.is_none() {
        let wanted = format!("coefficients like {}0{}2 are needed here", letters[0], letters[1]);
        ledger.fail(case, "input", value.cloned().unwrap_or_default(), wanted.into());
    }
    terms.map(Polynomial2::from_terms)
}

/// A named coefficient of a function: name in the file, degree, value in mm/mm^degree.
pub(super) type Coefficient = (String, usize, f64);

/// Coefficients prefix0, prefix1, ... of powers 0, 1, ... of a line coordinate; `degree` is that of the factor before them.
pub(super) fn powers(prefix: &str, degree: usize, values: &[f64]) -> Vec<Coefficient> {
    values.iter().enumerate().map(|(k, &x)| (format!("{prefix}{k}"), degree + k, x)).collect()
}

/// Compares a table of coefficients. A coefficient may differ by the share `relative` of the largest contribution that any
/// coefficient of the table makes at distance `radius` (mm) from the origin: single coefficients may vanish by symmetry.
pub(super) fn coefficients(
    outer: &mut Expected<'_>,
    key: &str,
    actual: &[Coefficient],
    radius: f64,
    relative: f64,
    ledger: &mut Ledger,
) {
    let Some(mut table) = outer.object(key, ledger) else { return };
    let weight = |degree: usize| radius.powi(degree as i32);
    let listed = |name: &str| table.peek(name).and_then(Value::as_f64).unwrap_or(0.0);
    let largest =
        actual.iter().map(|(name, degree, _)| listed(name).abs() * weight(*degree)).fold(0.0, f64::max);
    for (name, degree, value) in actual {
        table.number(name, value / UM, relative * largest / weight(*degree), ledger);
    }
    table.finish(ledger);
}
