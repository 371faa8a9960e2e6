//! Block `compensation`: the correction that comes nearest to a profile of many points while the radius map holds.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::bodies::Bodies;
use super::{UM, corrections};
use dressing::{Compensation, Condition, DressingError, SoftCondition};
use foundation::geometry::Flank;
use serde_json::Value;

/// Block `compensation`, left flank, all points of the same weight.
pub(super) fn compensation(
    bodies: &Bodies,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let lists = ["w_mm", "wanted_f_um"].map(|key| item.given_list(key, ledger));
    let ([Some(w), Some(wanted)], Some(map)) = (lists, item.given("hard_map_w_mm", ledger)) else {
        return Ok(());
    };
    if w.len() != wanted.len() {
        item.refused(&"as many wanted values as points are needed", ledger);
        return Ok(());
    }
    let flank = Flank::Left;
    let soft = w
        .iter()
        .zip(&wanted)
        .map(|(&w, f)| SoftCondition { condition: Condition::Point { flank, w, f: f * UM }, weight: 1.0 });
    let hard = vec![Condition::Map { flank, t: map, w: map }];
    let found =
        Compensation::new(&bodies.tool, bodies.reference_radius, soft.collect(), hard).solve(&[0.0; 4])?;
    let relative = tolerances.get("DK_rel");
    corrections::compare(item, &found.dk, |_, x| relative * x.abs(), ledger);
    let um = tolerances.get("um");
    item.number("rms_um", found.rms / UM, um, ledger);
    item.list("residual_um", &found.residuals.iter().map(|r| r / UM).collect::<Vec<_>>(), um, ledger);
    Ok(())
}
