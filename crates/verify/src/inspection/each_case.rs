//! The cases of a block, `{name, note?, input, expected, tolerance}`, each with its own tolerances.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object};
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use serde_json::Value;

/// Runs `check` over every case with its input, its tolerances and the case itself, of which it takes `expected`.
pub(super) fn each_case(
    block: &str,
    list: &Value,
    ledger: &mut Ledger,
    mut check: impl FnMut(&mut Expected<'_>, Tolerances<'_>, &mut Expected<'_>, &mut Ledger) -> Checked,
) {
    let Some(items) = list.as_array() else {
        return ledger.fail(block, block, list.clone(), "a list of cases is needed here".into());
    };
    for (k, item) in items.iter().enumerate() {
        let name = item["name"].as_str().map_or_else(|| format!("{block}[{k}]"), str::to_owned);
        let case = Expected::new(&name, "", item, ledger);
        check_object(case, ledger, |case, ledger| {
            case.informative(&["name", "tolerance"]);
            let input = case.object("input", ledger).ok_or("input is missing")?;
            let tolerances = Tolerances::of(item);
            // The outcome of the case is its own; what nobody asked for in its input is a failure either way.
            let mut outcome = Ok(());
            check_object(input, ledger, |input, ledger| {
                outcome = check(input, tolerances, case, ledger);
                Ok(())
            });
            outcome
        });
    }
}
