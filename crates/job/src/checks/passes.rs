//! Stock of passes in `[machine]`: each leaves less than the one before.

use crate::tables::Machine;
use crate::{Diagnostic, shown_number};

/// Lists of stock that do not fall.
pub fn falling_stock(machine: Option<&Machine>, findings: &mut Vec<Diagnostic>) {
    let Some(machine) = machine else { return };
    for (key, list) in [
        ("machine.roughing_stock_um", &machine.roughing_stock_um),
        ("machine.dressing_stock_um", &machine.dressing_stock_um),
    ] {
        let rises = list.windows(2).position(|pair| pair[1] >= pair[0]);
        let Some(k) = rises else { continue };
        findings.push(
            Diagnostic::with_code(
                "stroke-order",
                "a stroke leaves as much as the one before, or more: it takes nothing",
            )
            .field(format!("{key}[{}]", k + 1))
            .value(shown_number(list[k + 1]))
            .allowed(format!("below {} um, what the stroke before leaves", shown_number(list[k])))
            .way_out("order the list from the largest to the smallest"),
        );
    }
}
