//! Block `synchroniser`: the way into the wanted tooth space.

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::check_each;
use electronic_gearbox::coupling::shortest_move;
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    c_now_deg: f64,
    c_target_deg: f64,
    tooth_pitch_deg: f64,
}

/// Block `synchroniser`.
pub(crate) fn synchroniser(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each(
        "synchroniser",
        block,
        ["tolerance_abs"],
        ledger,
        |input: &Input, [tolerance], expected, ledger| {
            let way = shortest_move(input.c_now_deg, input.c_target_deg, input.tooth_pitch_deg)?;
            expected.number("move_deg", way, tolerance, ledger);
            Ok(())
        },
    );
}
