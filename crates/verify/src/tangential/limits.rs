//! Blocks `undercut` and `twist_conventional`: where the envelope folds, and what radial feed leaves of a helix crowning.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::{Outcome, Setup, UM, given_settings, given_sign, name_in_files, with_setup};
use contact::Measure;
use foundation::geometry::Flank;
use serde_json::Value;
use tangential_dressing::{
    EdgeAmounts, FitGrid, ProfileKind, RollGrid, TangentialError, TangentialFlank, TangentialSettings,
    Variable,
};

/// Block `undercut`: settings that must be refused at one point.
pub(crate) fn undercut(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(list) = block.as_array() else {
        ledger.fail("undercut", "undercut", block.clone(), "a list is needed here".into());
        return;
    };
    for (k, entry) in list.iter().enumerate() {
        with_setup(&format!("undercut[{k}]"), file, entry, ledger, |setup, item, ledger| {
            let settings = given_settings(item)?;
            let wanted = (
                item.given_flank(ledger),
                item.given("R", ledger),
                item.given("Z", ledger),
                item.given("kappa", ledger),
            );
            let (Some(flank), Some(radius), Some(z), Some(kappa)) = wanted else { return Ok(()) };
            let model = setup.input.model(ProfileKind::Conjugate, kappa)?;
            let ground = TangentialFlank::new(&model, flank, &[flank], &settings, Measure::Arc);
            let found =
                ground.solve_beyond_tool(&RollGrid { w: vec![setup.roll(flank, radius)?], z: vec![z] });
            let found = found.err().map_or(Value::Null, |error| name_in_files(&error).into());
            let expected = item.take("error").cloned().unwrap_or(Value::Null);
            ledger.equal(item.case(), "error", expected, found);
            Ok(())
        });
    }
}

/// Block `twist_conventional`.
pub(crate) fn twist_conventional(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    with_setup("twist_conventional", file, block, ledger, |setup, item, ledger| {
        let factor = setup.model.natural_twist(Flank::Left);
        let within = setup.tolerances.get("machine_rel") * factor.abs();
        item.number("closed_form_factor", factor, within, ledger);
        for mut case in item.objects("cases", ledger) {
            if let Err(error) = crowned(setup, &mut case, ledger) {
                case.refused(&error, ledger);
            }
            case.finish(ledger);
        }
        Ok(())
    });
}

fn crowned(setup: &Setup<'_>, case: &mut Expected<'_>, ledger: &mut Ledger) -> Outcome {
    let (flank, crowning) = (given_sign(case, ledger), case.given("C_um", ledger));
    let (Some(flank), Some(crowning)) = (flank, crowning.map(|c| c * UM)) else { return Ok(()) };
    let model = &setup.model;
    let settings = model.radial_feed_settings(flank, crowning);
    let amount = settings.value(&"dist2".parse::<Variable>()?);
    case.number("dist2", amount, setup.tolerances.get("machine_rel") * amount.abs(), ledger);
    let twist = setup.tolerances.get("twist_um");
    case.number("closed_twist_um", model.natural_twist(flank) * crowning / UM, twist, ledger);
    let [radii, _] = setup.points()?;
    let grid = FitGrid::Radii(radii.len());
    let found = model.radial_feed(flank, crowning, Measure::Arc, grid);
    let expected = case.take("error").cloned();
    match (expected, found) {
        (None, Ok(found)) => {
            let places = grid.of(model, flank);
            let columns = places.z.len();
            case.number("simulated_twist_um", found.twist / UM, twist, ledger);
            let in_um: Vec<f64> = found.deviations.iter().map(|m| m / UM).collect();
            let within = setup.tolerances.get("forward_m_um");
            case.table("m_um", (&in_um, columns), within, ledger);
            let pure = EdgeAmounts { lead_crowning: crowning, ..EdgeAmounts::default() };
            let apart = places.points().zip(&found.deviations);
            let apart =
                apart.map(|((w, z), m)| (m - pure.value(model, flank, w, z)).abs()).fold(0.0, f64::max);
            case.number("max_dev_from_pure_crowning_um", apart / UM, twist, ledger);
        }
        (None, Err(error)) => return Err(error.into()),
        (Some(expected), Ok(_)) => ledger.equal(case.case(), "error", expected, Value::Null),
        (Some(expected), Err(TangentialError::Undercut { .. } | TangentialError::NotSettled { .. })) => {
            let found = folded(setup, flank, &settings, &grid.of(model, flank));
            ledger.equal(case.case(), "error", expected, found.into());
        }
        (Some(expected), Err(error)) => {
            ledger.equal(case.case(), "error", expected, name_in_files(&error).into());
        }
    }
    Ok(())
}

/// The refusal as the files put it: how many points fold and which is the first.
fn folded(setup: &Setup<'_>, flank: Flank, settings: &TangentialSettings, grid: &RollGrid) -> String {
    let ground = TangentialFlank::new(&setup.model, flank, &[flank], settings, Measure::Arc);
    let folds = |&(w, z): &(f64, f64)| {
        let found = ground.solve_beyond_tool(&RollGrid { w: vec![w], z: vec![z] });
        matches!(found, Err(TangentialError::Undercut { .. } | TangentialError::NotSettled { .. }))
    };
    let points: Vec<(f64, f64)> = grid.points().filter(folds).collect();
    let (w, z) = points.first().copied().unwrap_or((f64::NAN, f64::NAN));
    format!(
        "Undercut: undercut or no contact: {} of {} points (first R={:.4} Z={z:.4})",
        points.len(),
        grid.count(),
        setup.model.radius(flank, w),
    )
}
