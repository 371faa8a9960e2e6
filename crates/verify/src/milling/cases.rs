//! Block `cases`: every quantity that a case of milling expects.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object, number};
use super::super::ledger::Ledger;
use super::super::reference::{Reference, read};
use super::case::MilledCase;
use super::cutter::Tool;
use super::{columns, flank, residual};
use serde_json::Value;

/// Block `cases`.
pub(crate) fn cases(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(cases) = block.as_object() else {
        return ledger.fail("cases", "cases", block.clone(), "a table of cases is needed here".into());
    };
    for (name, value) in cases {
        let expected = Expected::new(name, "", value, ledger);
        check_object(expected, ledger, |expected, ledger| case(name, value, expected, ledger));
    }
}

fn case(name: &str, value: &Value, expected: &mut Expected<'_>, ledger: &mut Ledger) -> Checked {
    expected.informative(&["input", "tool"]);
    let height = number(expected, "contact_height_mm", ledger)?;
    let tool = read::<Tool>(name, &value["tool"], ledger).ok_or("the cutter cannot be read")?;
    let case = MilledCase::of(&value["input"], &tool, height)?;
    // The file states no tolerances beside the parameters that follow from the drawing: those of the flank's points hold.
    let stated = |key: &str| value["flank_points"][key].as_f64().unwrap_or(f64::NAN);
    let tolerances = [stated("tolerance_mm"), stated("tolerance_n")];
    flank::derived(&case, tolerances, expected, ledger);
    flank::range(&case, expected, ledger)?;
    flank::points(&case, expected, ledger);
    columns::columns(&case, expected, ledger);
    columns::grids(&case, value, expected, ledger);
    if let Some(object) = expected.object("residual", ledger) {
        check_object(object, ledger, |object, ledger| residual::residual(&case, object, ledger));
    }
    Ok(())
}
