//! 30-dressing: worm, dresser, dressed profiles, conditions and motions of dressing. A case carries its blocks beside its input.

pub(super) mod bodies;
mod compensation;
mod conditions;
mod corrections;
mod crowned;
mod crowning_range;
mod limits;
mod machine;
mod motion;
mod other_worms;
mod profiles;
mod search;
mod strokes;

use super::expected::Expected;
use super::ledger::Ledger;
use super::reference::Reference;
use bodies::Bodies;
use serde_json::Value;

const UM: f64 = 1e-3;

/// Block `cases`.
pub(crate) fn cases(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(items) = block.as_array() else {
        ledger.fail("cases", "cases", block.clone(), "a list of cases is needed here".into());
        return;
    };
    for (k, item) in items.iter().enumerate() {
        let name = [&item["name"], &item["input"]["name"]].into_iter().find_map(Value::as_str);
        let name = name.map_or_else(|| format!("cases[{k}]"), str::to_owned);
        let mut case = Expected::new(&name, "", item, ledger);
        case.informative(&["name", "note"]);
        if let Some(mut input) = case.object("input", ledger) {
            match Bodies::read(&mut input, ledger) {
                Some(Ok(bodies)) => one(&bodies, &mut case, ledger),
                Some(Err(error)) => case.refused(&error, ledger),
                None => case.refused(&"the input is incomplete", ledger),
            }
            input.finish(ledger);
        } else {
            case.refused(&"the case has no input", ledger);
        }
        case.finish(ledger);
    }
}

fn one(bodies: &Bodies, case: &mut Expected<'_>, ledger: &mut Ledger) {
    bodies.worm_block(case, ledger);
    bodies.kinematics_block(case, ledger);
    if let Some(mut block) = case.object("dresser", ledger) {
        profiles::dresser(bodies, &mut block, ledger);
        block.finish(ledger);
    }
    for item in case.objects("profile", ledger) {
        checked(item, ledger, |item, ledger| profiles::profile(bodies, item, ledger));
    }
    for item in case.objects("three_point", ledger) {
        checked(item, ledger, |item, ledger| conditions::three_point(bodies, item, ledger));
    }
    for item in case.objects("conditions", ledger) {
        checked(item, ledger, |item, ledger| conditions::conditions(bodies, item, ledger));
    }
    let relative = case
        .peek("profile")
        .and_then(|list| list.as_array()?.iter().find_map(|p| p["tolerance"]["jacobian_rel"].as_f64()))
        .unwrap_or(f64::NAN);
    if let Some(item) = case.object("conditioning", ledger) {
        checked(item, ledger, |item, ledger| conditions::conditioning(bodies, relative, item, ledger));
    }
    if let Some(item) = case.object("topological", ledger) {
        checked(item, ledger, |item, ledger| motion::topological(bodies, item, ledger));
    }
    for item in case.objects("other_diameter", ledger) {
        checked(item, ledger, |item, ledger| other_worms::other_diameter(bodies, item, ledger));
    }
    if let Some(item) = case.object("search", ledger) {
        checked(item, ledger, |item, ledger| search::search(bodies, item, ledger));
    }
    if let Some(item) = case.object("undermining", ledger) {
        checked(item, ledger, |item, ledger| limits::undermining(bodies, item, ledger));
    }
    if let Some(item) = case.object("left_out_threads", ledger) {
        checked(item, ledger, |item, ledger| limits::left_out_threads(bodies, item, ledger));
    }
    if let Some(item) = case.object("multi_stroke", ledger) {
        checked(item, ledger, |item, ledger| strokes::multi_stroke(bodies, item, ledger));
    }
    if let Some(item) = case.object("axis_deviation", ledger) {
        checked(item, ledger, |item, ledger| strokes::axis_deviation(bodies, item, ledger));
    }
    let tolerance = case.peek("dresser").map_or(&Value::Null, |dresser| &dresser["left"]["tolerance"]);
    if let Some(item) = case.object("parallel_axes", ledger) {
        checked(item, ledger, |item, ledger| profiles::parallel_axes(bodies, tolerance, item, ledger));
    }
    if let Some(item) = case.object("machine", ledger) {
        checked(item, ledger, machine::machine);
    }
    if let Some(item) = case.object("limits", ledger) {
        checked(item, ledger, |item, ledger| crowning_range::limits(bodies, item, ledger));
    }
    if let Some(item) = case.object("compensation", ledger) {
        checked(item, ledger, |item, ledger| compensation::compensation(bodies, item, ledger));
    }
}

/// Runs the comparison of a block; an error of the library is a failure of the whole block.
fn checked<E: std::fmt::Display>(
    mut item: Expected<'_>,
    ledger: &mut Ledger,
    check: impl FnOnce(&mut Expected<'_>, &mut Ledger) -> Result<(), E>,
) {
    if let Err(error) = check(&mut item, ledger) {
        item.refused(&error, ledger);
    }
    item.finish(ledger);
}
