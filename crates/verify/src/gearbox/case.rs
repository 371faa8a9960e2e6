//! The cases of a block: a list of `{name?, note?, input, expected, tolerance...}`, or a single one.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::read;
use super::refusal::Refusal;
use serde::de::DeserializeOwned;
use serde_json::Value;

/// Runs `check` over every case with its input, the tolerances of these names and the expected quantities. What `check` refuses has to be
/// expected as `error`; such a case needs no tolerances.
pub(super) fn check_each<Input: DeserializeOwned, const N: usize>(
    block: &str,
    list: &Value,
    tolerances: [&str; N],
    ledger: &mut Ledger,
    mut check: impl FnMut(&Input, [f64; N], &mut Expected<'_>, &mut Ledger) -> Result<(), Refusal>,
) {
    let items = match list {
        Value::Array(items) => items.as_slice(),
        Value::Object(_) => std::slice::from_ref(list),
        _ => return ledger.fail(block, block, list.clone(), "a list of cases is needed here".into()),
    };
    for (k, item) in items.iter().enumerate() {
        let unnamed = || if list.is_array() { format!("{block}[{k}]") } else { block.to_owned() };
        let name = item["name"].as_str().map_or_else(unnamed, str::to_owned);
        let mut case = Expected::new(&name, "", item, ledger);
        case.informative(&["name", "note", "input"]);
        let bad = item["expected"].get("error").is_some();
        let tolerances = tolerances.map(|key| {
            let given = if bad { case.given_optional(key, ledger) } else { case.given(key, ledger) };
            given.unwrap_or(f64::NAN)
        });
        match (read::<Input>(&name, &item["input"], ledger), case.object("expected", ledger)) {
            (Some(input), Some(mut expected)) => {
                let checked = check(&input, tolerances, &mut expected, ledger);
                expected.rename(&name);
                match checked {
                    Ok(()) if bad => {
                        ledger.equal(&name, "error", item["expected"]["error"].clone(), "accepted".into());
                        expected.informative(&["error"]);
                    }
                    Ok(()) => {}
                    Err(refusal) => refusal.compare(&mut expected, ledger),
                }
                expected.finish(ledger);
            }
            (_, None) => ledger.fail(&name, "expected", Value::Null, "the case expects nothing".into()),
            // The unreadable input is a failure already.
            (None, Some(_)) => {}
        }
        case.finish(ledger);
    }
}

/// Whole numbers are compared exactly: a file that allows them a tolerance asks for something else.
pub(super) fn require_exact(case: &str, tolerance: f64, ledger: &mut Ledger) {
    ledger.number(case, "tolerance", 0.0, tolerance, 0.0);
}
