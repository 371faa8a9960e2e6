//! Blocks `left` and `right`: nominal contact, exact sensitivities, single variables at a finite value, sets of variables.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::{Outcome, Setup, UM, given_settings, name_in_files, with_setup};
use contact::Measure;
use foundation::geometry::Flank;
use serde_json::Value;
use std::error::Error;
use tangential_dressing::{
    FlankPoint, ProfileKind, RollGrid, TangentialError, TangentialFlank, TangentialModel, TangentialSettings,
    Variable,
};

/// Value of the single variable in `table3_linear_um` and `table3_finite_um`
/// (`docs/mathematics/tangential-dressing.md#how-it-is-verified`), mm.
const DELTA: f64 = -0.05;
/// A sensitivity whose column is below this is zero but for rounding, mm/mm.
const NOTHING: f64 = 1e-6;

/// Block `left`.
pub(crate) fn left(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    with_setup("left", file, block, ledger, |setup, item, ledger| side(setup, Flank::Left, item, ledger));
}

/// Block `right`.
pub(crate) fn right(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    with_setup("right", file, block, ledger, |setup, item, ledger| side(setup, Flank::Right, item, ledger));
}

/// One flank ground alone.
fn ground<'m>(
    model: &'m TangentialModel,
    flank: Flank,
    settings: &TangentialSettings,
    measure: Measure,
) -> TangentialFlank<'m> {
    TangentialFlank::new(model, flank, &[flank], settings, measure)
}

fn side(setup: &Setup<'_>, flank: Flank, item: &mut Expected<'_>, ledger: &mut Ledger) -> Outcome {
    let grid = setup.grid(flank)?;
    let plain = ground(&setup.model, flank, &TangentialSettings::default(), Measure::Arc);
    let points = plain.solve(&grid)?;
    let largest = points.iter().map(|p| p.deviation.abs()).fold(0.0, f64::max);
    let tolerance = |key: &str| setup.tolerances.get(key);
    item.number("max_abs_m", largest, tolerance("m_nominal_mm"), ledger);
    type Pick = fn(&FlankPoint) -> f64;
    let picks: [(&str, Pick, &str); 5] = [
        ("s", |p| p.height, "contact_s_xD_z_mm"),
        ("x_D", |p| p.position, "contact_s_xD_z_mm"),
        ("z", |p| p.feed, "contact_s_xD_z_mm"),
        ("theta", |p| p.dresser_angle, "contact_theta_phi_rad"),
        ("phi_1", |p| p.worm_angle, "contact_theta_phi_rad"),
    ];
    for (key, pick, within) in picks {
        item.list(key, &points.iter().map(pick).collect::<Vec<_>>(), tolerance(within), ledger);
    }
    sensitivities(setup, &plain, &grid, item, ledger)?;
    if let Some(mut entries) = item.object("table3_finite_um", ledger) {
        for (key, variable) in variables(item.peek("table3_finite_um"))? {
            let mut settings = TangentialSettings::default();
            settings.set(&variable, DELTA);
            let flank = ground(&setup.model, flank, &settings, Measure::Arc);
            finite(&flank, &grid, &mut entries, key, tolerance("table3_um"), ledger);
        }
        entries.finish(ledger);
    }
    if item.peek("straight_profile_m_um").is_some() {
        let model = setup.input.model(ProfileKind::Straight, setup.input.kappa)?;
        // The unmodified flank is the same in every section.
        let middle = RollGrid { w: grid.w.clone(), z: vec![0.0] };
        let flank = ground(&model, flank, &TangentialSettings::default(), Measure::Arc);
        let found: Vec<f64> = flank.deviations(&middle)?.iter().map(|m| m / UM).collect();
        item.list("straight_profile_m_um", &found, tolerance("forward_m_um"), ledger);
    }
    for mut entry in item.objects("forward", ledger) {
        if let Err(error) = forward(setup, flank, &grid, &mut entry, ledger) {
            entry.refused(&error, ledger);
        }
        entry.finish(ledger);
    }
    Ok(())
}

/// Design variables that the keys of an object name: `Fp1` or, with the number of the source, `v1_Fp1`.
fn variables(value: Option<&Value>) -> Result<Vec<(&String, Variable)>, Box<dyn Error>> {
    let keys = value.and_then(Value::as_object).into_iter().flat_map(|map| map.keys());
    let one = |key| -> Result<_, Box<dyn Error>> {
        let (_, name) = String::as_str(key).rsplit_once('_').unwrap_or(("", key));
        Ok((key, name.parse::<Variable>()?))
    };
    keys.map(one).collect()
}

/// `sensitivity_per_mm_or_rad` and what it makes of a small amount.
fn sensitivities(
    setup: &Setup<'_>,
    plain: &TangentialFlank<'_>,
    grid: &RollGrid,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Outcome {
    let columns = grid.z.len();
    for (block, amount, share) in [
        ("sensitivity_per_mm_or_rad", 1.0, Some(setup.tolerances.get("sensitivity_rel_of_max"))),
        ("table3_linear_um", DELTA / UM, None),
    ] {
        let named = variables(item.peek(block))?;
        let Some(mut entries) = item.object(block, ledger) else { continue };
        let (keys, named): (Vec<_>, Vec<_>) = named.into_iter().unzip();
        let (_, by) = plain.linearised(grid, &named)?;
        for (j, key) in keys.into_iter().enumerate() {
            let found: Vec<f64> = by.column(j).iter().map(|by| amount * by).collect();
            let largest = by.column(j).amax().max(NOTHING);
            let within = share.map_or(setup.tolerances.get("table3_um"), |share| share * largest);
            entries.table(key, (&found, columns), within, ledger);
        }
        entries.finish(ledger);
    }
    Ok(())
}

/// A table with `null` where the flank is undercut: every point by itself, for one that cannot be must not hide the others.
fn finite(
    flank: &TangentialFlank<'_>,
    grid: &RollGrid,
    entries: &mut Expected<'_>,
    key: &str,
    tolerance: f64,
    ledger: &mut Ledger,
) {
    let Some(expected) = entries.take_table(key, [grid.w.len(), grid.z.len()], ledger) else { return };
    for (k, ((w, z), expected)) in grid.points().zip(expected).enumerate() {
        let name = entries.name(&format!("{key}[{}][{}]", k / grid.z.len(), k % grid.z.len()));
        let found = flank.solve_beyond_tool(&RollGrid { w: vec![w], z: vec![z] });
        let found = found.map(|points| points[0].deviation / UM);
        match (expected.as_f64(), found) {
            (Some(expected), Ok(found)) => ledger.number(entries.case(), &name, expected, found, tolerance),
            (None, Err(TangentialError::Undercut { .. } | TangentialError::NotSettled { .. })) => {
                ledger.equal(entries.case(), &name, expected.clone(), Value::Null);
            }
            (_, Ok(found)) => ledger.fail(entries.case(), &name, expected.clone(), found.into()),
            (_, Err(error)) => {
                ledger.fail(entries.case(), &name, expected.clone(), name_in_files(&error).into());
            }
        }
    }
}

/// One set of variables in both measures, and what an independent envelope of bodies found for some of its points.
fn forward(
    setup: &Setup<'_>,
    flank: Flank,
    grid: &RollGrid,
    entry: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Outcome {
    // How well two sources agreed when the file was made.
    entry.informative(&["name", "brute_minus_kernel_max_um"]);
    let settings = given_settings(entry)?;
    let within = setup.tolerances.get("forward_m_um");
    let columns = grid.z.len();
    let mut by_arc = Vec::new();
    for (measure, key) in [(Measure::Arc, "m_arc_um"), (Measure::Ray, "m_ray_um")] {
        let points = ground(&setup.model, flank, &settings, measure).solve(grid)?;
        let found: Vec<f64> = points.iter().map(|p| p.deviation / UM).collect();
        entry.table(key, (&found, columns), within, ledger);
        if measure == Measure::Arc {
            let positions: Vec<f64> = points.iter().map(|p| p.position).collect();
            entry.list("x_D", &positions, setup.tolerances.get("contact_s_xD_z_mm"), ledger);
            by_arc = found;
        }
    }
    let Some(points) = entry.peek("brute_force_um") else { return Ok(()) };
    let Some(mut brute) = entry.object("brute_force_um", ledger) else { return Ok(()) };
    // The model is held against these numbers here; that the referee of this library finds them from bodies and motions alone is the
    // test `tangential_referee`.
    for place in points.as_object().into_iter().flat_map(|map| map.keys()) {
        let indices = place.split_once(',').and_then(|(i, j)| Some((i.parse().ok()?, j.parse().ok()?)));
        let at = indices.filter(|(i, j): &(usize, usize)| *i < grid.w.len() && *j < columns);
        if let Some((i, j)) = at {
            brute.number(place, by_arc[i * columns + j], setup.tolerances.get("brute_force_um"), ledger);
        }
    }
    brute.finish(ledger);
    Ok(())
}
