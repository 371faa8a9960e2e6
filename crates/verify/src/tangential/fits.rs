//! Blocks `examples` and `two_flank_same_motions`: the listed variables leave the listed residuals, and a fit finds as good ones.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::{Outcome, Setup, UM, given_settings, given_sign, given_variables, with_setup};
use contact::Measure;
use foundation::geometry::Flank;
use serde_json::Value;
use std::error::Error;
use tangential_dressing::{
    EdgeAmounts, FitGrid, FitLimits, FitMethod, FitTask, Judged, ProfileKind, TangentialError,
    TangentialModel, TangentialSettings, Variable, Weights,
};

/// The grid of the source, that of own fits, and the one between whose points nothing hides.
const COARSE: FitGrid = FitGrid::Radii(5);
const OWN: FitGrid = FitGrid::Graded(9);
const DENSE: FitGrid = FitGrid::Radii(41);
/// Agreement of determinant ratios and of singular values (as a share of the largest), for which the files state no tolerance. The
/// listed singular values belong to the variables before the last step, whose change is below the loop's limit of 1e-6 of the rms.
const RATIO: f64 = 1e-6;
const SINGULAR: f64 = 1e-4;
/// Where a flank is dressed beyond the profile, each source continues it in its own way: residual (um), place (mm) and ratio then agree
/// only so far.
const CONTINUED_UM: f64 = 1e-2;
const CONTINUED_MM: f64 = 1e-2;
const CONTINUED_RATIO: f64 = 1e-3;

/// Ways to a fit, tried until one is as good as the file's: sets with local minima do not find the same one by every way.
const WAYS: [(FitMethod, usize); 4] =
    [(FitMethod::Plain, 1), (FitMethod::Plain, 8), (FitMethod::Damped, 1), (FitMethod::GaussNewton, 1)];

/// `target_mm`: amounts removed at the edges, mm.
fn amounts(target: &Value) -> Result<EdgeAmounts, Box<dyn Error>> {
    let table = target.as_object().ok_or("target_mm needs amounts at the edges")?;
    let mut amounts = EdgeAmounts::default();
    for (key, value) in table {
        let place = match key.as_str() {
            "r1" => &mut amounts.pressure_angle,
            "r2" => &mut amounts.profile_crowning,
            "z1" => &mut amounts.lead_conical,
            "z2" => &mut amounts.lead_crowning,
            _ => return Err(format!("unknown amount {key}").into()),
        };
        *place = value.as_f64().ok_or_else(|| format!("{key} needs a number"))?;
    }
    Ok(amounts)
}

/// Block `examples`: one flank by itself.
pub(crate) fn examples(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let sets = ["paper9", "small_set", "small_set_kappa0"];
    for (name, entry) in block.as_object().into_iter().flatten() {
        with_setup(name, file, entry, ledger, |setup, item, ledger| {
            let Some(flank) = given_sign(item, ledger) else { return Ok(()) };
            let target = amounts(item.take("target_mm").unwrap_or(&Value::Null))?;
            for (set, of_source) in sets.into_iter().zip([true, false, false]) {
                let Some(mut entry) = item.object(set, ledger) else { continue };
                let fitted = one_flank(setup, flank, target, of_source, &mut entry, ledger);
                if let Err(error) = fitted {
                    entry.refused(&error, ledger);
                }
                entry.finish(ledger);
            }
            Ok(())
        });
    }
    if !block.is_object() {
        ledger.fail("examples", "examples", block.clone(), "an object of examples is needed here".into());
    }
}

/// One set of variables on one flank. That of the source is fitted on its grid with its weights.
fn one_flank(
    setup: &Setup<'_>,
    flank: Flank,
    target: EdgeAmounts,
    of_source: bool,
    entry: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Outcome {
    // How the file's own fit went.
    entry.informative(&["start", "iterations", "fixed"]);
    let listed = given_settings(entry)?;
    let free = match entry.peek("keys") {
        Some(_) => given_variables(entry)?,
        None => listed.values().iter().map(|(variable, _)| variable.clone()).collect(),
    };
    let kappa = entry.given_optional("kappa", ledger).unwrap_or(setup.input.kappa);
    let model = setup.input.model(ProfileKind::Conjugate, kappa)?;
    let wanted = |flank: Flank, w: f64, z: f64| target.value(&model, flank, w, z);
    let task = FitTask {
        model: &model,
        pass: &[flank],
        wanted: &wanted,
        fixed: held(&listed, &free),
        measure: Measure::Arc,
        grid: if of_source { COARSE } else { OWN },
        weights: if of_source { Weights::Source } else { Weights::Uniform },
        limits: FitLimits::SOURCE,
    };
    let coarse = &task.judge_beyond_tool(&listed, COARSE)?[0];
    let dense = &task.judge_beyond_tool(&listed, DENSE)?[0];
    let (from, to) = task.flank(flank, &listed).dresser().interval();
    let continued = |judged: &Judged| judged.points.iter().any(|p| p.height < from || p.height > to);
    let tolerance = |key: &str| setup.tolerances.get(key);
    let within = |stated: &str, beyond: f64| if continued(dense) { beyond } else { tolerance(stated) };

    let um = within("forward_m_um", CONTINUED_UM);
    let errors: Vec<f64> = coarse.error.iter().map(|e| e / UM).collect();
    entry.table("residual_5x5_um", (&errors, coarse.grid.z.len()), um, ledger);
    let residuals = [
        ("max_5x5_um", coarse.largest() / UM),
        ("rms_5x5_um", coarse.rms() / UM),
        ("max_41x41_um", dense.largest() / UM),
        ("rms_41x41_um", dense.rms() / UM),
    ];
    entry.numbers(&residuals, um, ledger);
    let millimetres = within("contact_s_xD_z_mm", CONTINUED_MM);
    entry.list("x_D_range_mm", &dense.positions(), millimetres, ledger);
    let ratio = if continued(dense) { CONTINUED_RATIO } else { RATIO };
    entry.number("min_det_ratio", dense.least_ratio(), ratio, ledger);
    if of_source {
        let rms = weighted_rms(&model, coarse);
        entry.number("rms_weighted_um", rms / UM, um, ledger);
        rounds(&task, &listed, &free, entry, ledger)?;
    }
    let keys = ["max_5x5_um", "rms_5x5_um", "max_41x41_um", "rms_41x41_um"];
    fitted(&task, &free, &keys, tolerance("fit_residual_factor"), entry, ledger)
}

/// What of some settings is not free.
fn held(settings: &TangentialSettings, free: &[Variable]) -> TangentialSettings {
    let mut held = TangentialSettings::default();
    for (variable, value) in settings.values().iter().filter(|(variable, _)| !free.contains(variable)) {
        held.set(variable, *value);
    }
    held
}

fn weighted_rms(model: &TangentialModel, judged: &Judged) -> f64 {
    let weight = |(w, z)| Weights::Source.at(model, judged.flank, w, z);
    let sum: f64 = judged.grid.points().zip(&judged.error).map(|(p, e)| (weight(p) * e).powi(2)).sum();
    (sum / judged.error.len() as f64).sqrt()
}

/// Singular values of the equilibrated matrix at the listed variables, and the rank where nothing is set yet.
fn rounds(
    task: &FitTask<'_>,
    listed: &TangentialSettings,
    free: &[Variable],
    entry: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Outcome {
    let values: Vec<f64> = free.iter().map(|variable| listed.value(variable)).collect();
    if entry.peek("singular_values_last").is_some() {
        let from_listed = task.fit(free, &values, FitMethod::Plain)?;
        let found = from_listed.rounds.first().map(|r| r.singular_values.clone()).unwrap_or_default();
        entry.list_relative_to_largest("singular_values_last", &found, SINGULAR, ledger);
    }
    // `null` where the file's fit did not start from nothing.
    let rank_is_listed = entry.peek("rank_first").is_some_and(|rank| !rank.is_null());
    if rank_is_listed || entry.peek("start").is_some_and(|start| start == "zero") {
        let from_nothing = task.fit(free, &vec![0.0; free.len()], FitMethod::Plain)?;
        let rank = from_nothing.rounds.first().map_or(f64::NAN, |round| round.rank as f64);
        entry.number("rank_first", rank, 0.0, ledger);
    } else {
        entry.informative(&["rank_first"]);
    }
    Ok(())
}

/// Residuals of the flanks of a pass, mm, in the order of the keys' grids.
fn residuals(
    task: &FitTask<'_>,
    settings: &TangentialSettings,
    keys: &[&str],
) -> Result<Vec<f64>, TangentialError> {
    let both = |grid: FitGrid| -> Result<[f64; 2], TangentialError> {
        let judged = task.judge_beyond_tool(settings, grid)?;
        let largest = judged.iter().map(Judged::largest).fold(0.0, f64::max);
        // All flanks have the same number of points.
        let mean = judged.iter().map(|j| j.rms().powi(2)).sum::<f64>() / judged.len() as f64;
        Ok([largest, mean.sqrt()])
    };
    let (coarse, dense) = (both(COARSE)?, both(DENSE)?);
    let one = |key: &&str| match *key {
        "max_5x5_um" => coarse[0],
        "rms_5x5_um" => coarse[1],
        "max_41x41_um" => dense[0],
        _ => dense[1],
    };
    Ok(keys.iter().map(one).collect())
}

/// Fits from nothing by the ways at hand and compares what the best of them leaves with the listed residuals.
fn fitted(
    task: &FitTask<'_>,
    free: &[Variable],
    keys: &[&str],
    factor: f64,
    entry: &Expected<'_>,
    ledger: &mut Ledger,
) -> Outcome {
    let listed: Option<Vec<f64>> = keys.iter().map(|key| entry.peek(key)?.as_f64()).collect();
    let listed = listed.ok_or("residuals are needed here for a fit to be held against")?;
    // By how much the worst residual exceeds its limit.
    let excess = |found: &[f64]| {
        let shares = found.iter().zip(&listed).map(|(found, listed)| found / UM / (factor * listed));
        shares.fold(0.0, |worst: f64, share| if share.is_nan() { f64::INFINITY } else { worst.max(share) })
    };
    let mut best: Option<(f64, Vec<f64>)> = None;
    let mut refused = None;
    for (method, steps) in WAYS {
        let found = task
            .fit_in_steps(free, &vec![0.0; free.len()], method, steps)
            .and_then(|fit| residuals(task, &task.fixed.with(free, &fit.values), keys));
        match found {
            Ok(found) if best.as_ref().is_none_or(|(least, _)| excess(&found) < *least) => {
                best = Some((excess(&found), found));
            }
            Ok(_) => {}
            Err(error) => refused = Some(error),
        }
        if best.as_ref().is_some_and(|(excess, _)| *excess <= 1.0) {
            break;
        }
    }
    let Some((_, found)) = best else {
        return Err(refused.map_or_else(|| "no fit".into(), Box::from));
    };
    for ((key, found), listed) in keys.iter().zip(found).zip(listed) {
        let name = format!("{key} of a fit");
        ledger.at_most(entry.case(), &name, listed, found / UM, (factor - 1.0) * listed);
    }
    Ok(())
}

/// Block `two_flank_same_motions`: `C10_...` asks of both flanks what the example `ex1_C10` asks of one.
pub(crate) fn two_flank_same_motions(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    for (name, entry) in block.as_object().into_iter().flatten() {
        with_setup(name, file, entry, ledger, |setup, item, ledger| {
            let (crowning, _) = name.split_once('_').unwrap_or((name, ""));
            let target = &file.root["examples"][format!("ex1_{crowning}")]["target_mm"];
            let target = amounts(item.take("target_mm").unwrap_or(target))?;
            two_flanks(setup, target, item, ledger)
        });
    }
    if !block.is_object() {
        let name = "two_flank_same_motions";
        ledger.fail(name, name, block.clone(), "an object of sets is needed here".into());
    }
}

fn two_flanks(
    setup: &Setup<'_>,
    target: EdgeAmounts,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Outcome {
    let (free, listed) = (given_variables(item)?, given_settings(item)?);
    let model = &setup.model;
    let wanted = |flank: Flank, w: f64, z: f64| target.value(model, flank, w, z);
    let task = FitTask {
        model,
        pass: &Flank::BOTH,
        wanted: &wanted,
        fixed: held(&listed, &free),
        measure: Measure::Arc,
        grid: OWN,
        weights: Weights::Uniform,
        limits: FitLimits::SOURCE,
    };
    let keys = ["max_41x41_um", "rms_41x41_um"];
    for (key, found) in keys.into_iter().zip(residuals(&task, &listed, &keys)?) {
        item.number(key, found / UM, setup.tolerances.get("forward_m_um"), ledger);
    }
    fitted(&task, &free, &keys, setup.tolerances.get("fit_residual_factor"), item, ledger)
}
