//! Block `table`: slopes, values and derivatives of a coupling by a table.

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::check_each;
use electronic_gearbox::Error;
use electronic_gearbox::coupling::{CubicTable, EndRule, solve_slopes};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    x0_mm: f64,
    h_mm: f64,
    y_um: Vec<f64>,
    kind: Kind,
    x_mm: Vec<f64>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Kind {
    Natural,
    Periodic,
}

/// Block `table`.
pub(crate) fn table(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each("table", block, ["tolerance_abs"], ledger, |input: &Input, [tolerance], expected, ledger| {
        let ends = match input.kind {
            Kind::Natural => EndRule::Natural,
            Kind::Periodic => EndRule::Periodic,
        };
        let values = &input.y_um;
        let (mut slopes, mut workspace) = (vec![0.0; values.len()], vec![0.0; 2 * values.len()]);
        solve_slopes(values, input.h_mm, ends, &mut slopes, &mut workspace)?;
        let table = CubicTable::new(input.x0_mm, input.h_mm, values, &slopes, ends)?;
        let places = || input.x_mm.iter();
        let heights = places().map(|x| table.value(*x)).collect::<Result<Vec<f64>, Error>>()?;
        let derivatives = places().map(|x| table.derivative(*x)).collect::<Result<Vec<f64>, Error>>()?;
        expected.list("slope_um_per_mm", &slopes, tolerance, ledger);
        expected.list("value_um", &heights, tolerance, ledger);
        expected.list("derivative_um_per_mm", &derivatives, tolerance, ledger);
        Ok(())
    });
}
