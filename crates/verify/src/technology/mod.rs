//! 45-grinding-technology, block `cases`: stock, strokes, removal, wear, time, life, cost and the fastest cycle.

mod compare;
mod engagement;
mod input;
mod removal;
mod times;

use super::ledger::Ledger;
use super::reference::{self, Reference};
use grinding_technology::TechnologyError;
use input::Input;
use serde_json::Value;

/// Block `cases`.
pub(super) fn cases(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    for mut case in reference::cases("cases", block, ledger) {
        let Some(input) = reference::read::<Input>(&case.name, case.input, ledger) else { continue };
        let to = compare::Shares::of(file.tolerances(), input.stock_is_constant());
        let mut check = || -> Result<(), TechnologyError> {
            let cycle = input.cycle()?;
            engagement::check(&cycle, &input, &mut case.expected, &to, ledger);
            removal::check(&cycle, &input, &mut case.expected, &to, ledger);
            times::check(&cycle, &input, &mut case.expected, &to, ledger)
        };
        if let Err(error) = check() {
            case.expected.refused(&error, ledger);
        }
        case.expected.finish(ledger);
    }
}
