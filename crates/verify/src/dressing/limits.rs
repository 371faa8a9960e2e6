//! Clearances of `three_point` and the blocks `undermining` and `left_out_threads`: how close the dresser comes to flanks that
//! it does not dress.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::bodies::{Bodies, OtherWorm};
use super::crowned::crowned;
use dressing::{DresserSection, DressingError, ThreadSpace, WormFlank};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;
use generating::GeneratingError;
use serde_json::Value;

/// Tip land at which the files list the clearance of a profile crowning, mm.
const LISTED_LAND: f64 = 1.0;
/// The largest tip land of the files is that without collision, mm of clearance.
const TOUCHING: f64 = 0.0;

/// Clearance and largest tip land of one entry of `three_point`.
pub(super) fn of_three_points(
    bodies: &Bodies,
    dk: &DressingCorrection,
    tolerances: Tolerances<'_>,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    let section = DresserSection::new(&bodies.tool, Flank::Left, bodies.tip_radius)?;
    let clearance = section.counter_flank_clearance(dk, LISTED_LAND, ThreadSpace::default())?;
    item.number("counter_flank_clearance_tip1mm_mm", clearance, tolerances.get("clearance_mm"), ledger);
    let land = section.largest_tip_land(dk, TOUCHING, ThreadSpace::default())?;
    item.optional("max_tip_width_mm", land, tolerances.get("tip_width_mm"), ledger);
    Ok(())
}

/// Block `undermining`: the same dresser in the same kinematics on a smaller worm.
pub(super) fn undermining(
    bodies: &Bodies,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), GeneratingError> {
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let keys = ["c_alpha_V_um", "smaller_d_S_mm", "tip_land_mm", "B_mm"];
    let [Some(amount), Some(diameter), Some(land), Some(width)] = keys.map(|key| item.given(key, ledger))
    else {
        return Ok(());
    };
    let planes = [-0.5 * width, 0.0, 0.5 * width];
    let mm = tolerances.get("mm");
    item.list("b_mm", &planes, mm, ledger);
    let smaller = bodies.with(OtherWorm { diameter, ..bodies.own_worm() }, 2.0 * bodies.tip_radius)?;
    let other = smaller.worm.flanks().map(|_, &flank| WormFlank { flank, range: smaller.range });
    let section = DresserSection::new(&bodies.tool, Flank::Left, bodies.tip_radius)?;
    let found = section.undermining(&crowned(bodies, amount)?, land, &other, &planes)?;
    for (flank, at) in found.iter() {
        let least: Vec<f64> = at.iter().map(|at| at.map_or(f64::INFINITY, |at| at.f)).collect();
        item.list(&format!("min_f_{flank}_mm"), &least, mm, ledger);
    }
    Ok(())
}

/// Block `left_out_threads`: the largest tip land over the number of threads left out.
pub(super) fn left_out_threads(
    bodies: &Bodies,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let mm = tolerances.get("mm");
    let Some(amount) = item.given("c_alpha_V_um", ledger) else { return Ok(()) };
    let Some(mut lands) = item.object("max_tip_width_mm", ledger) else { return Ok(()) };
    let section = DresserSection::new(&bodies.tool, Flank::Left, bodies.tip_radius)?;
    let dk = crowned(bodies, amount)?;
    for left_out in 0..bodies.own_worm().threads.unsigned_abs() {
        let key = left_out.to_string();
        if lands.peek(&key).is_some() {
            let land = section.largest_tip_land(&dk, TOUCHING, left_out.into())?;
            lands.optional(&key, land, mm, ledger);
        }
    }
    lands.finish(ledger);
    Ok(())
}
