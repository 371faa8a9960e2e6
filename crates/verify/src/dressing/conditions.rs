//! Blocks `three_point`, `conditions` and `conditioning`: corrections that fulfil conditions on the dressed worm.

use super::super::expected::{Expected, numbers};
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use super::bodies::Bodies;
use super::crowned::{crowned, middle_of, three_points};
use super::profiles::profile_rolls;
use super::{UM, corrections, limits};
use dressing::{
    Condition, ConditionSolver, DressedProfile, DressingError, PathReason, ProfilePoint, TiltChart,
    head_gradient, stretch,
};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;
use serde_json::Value;

/// Allowed difference of the share of the target that a path without solution reaches.
const FRACTION: f64 = 1e-2;

/// One entry of block `three_point`: a profile crowning of the gear by three points and the radius map, left flank.
pub(super) fn three_point(
    bodies: &Bodies,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let (Some(amount), Some(w)) = (item.given("c_alpha_V_um", ledger), item.given_list("w_mm", ledger))
    else {
        return Ok(());
    };
    let middle = middle_of(bodies, amount);
    let dk = crowned(bodies, amount)?;
    let (relative, absolute) =
        (tolerances.get("DK_rel"), [tolerances.get("DK_abs_deg"), tolerances.get("DK_abs_mm")]);
    let within = |angle: bool, x: f64| f64::max(relative * x.abs(), absolute[usize::from(!angle)]);
    corrections::compare(item, &dk, |j, x| within(j < 2, x), ledger);
    tilt_chart(bodies, &dk, within, item, ledger);
    limits::of_three_points(bodies, &dk, tolerances, item, ledger)?;
    let profile = DressedProfile::new(&bodies.tool, Flank::Left, dk);
    let points = profile.at_rolls(&w)?;
    let list = |of: fn(&ProfilePoint) -> f64| points.iter().map(of).collect::<Vec<f64>>();
    let um = tolerances.get("um");
    item.list("f_n_um", &list(|p| p.f / UM), um, ledger);
    item.list("r_A_mm", &list(|p| p.r_a), absolute[1], ledger);
    // The contact line through (w_m, b = 0).
    let shift = profile.at_roll(bodies.range.middle())?.b;
    item.number("v_zS_for_w_mid_b0_mm", shift, within(false, shift), ledger);
    let (w_m, half) = (bodies.range.middle(), 0.5 * bodies.range.length());
    let parabola = |w: f64| middle * (1.0 - ((w - w_m) / half).powi(2));
    let apart = points.iter().map(|p| (p.f - parabola(p.w)).abs()).fold(0.0, f64::max);
    item.number("deviation_from_parabola_um", apart / UM, um, ledger);
    item.number("stretch_P", stretch(&bodies.tool, Flank::Left, dk)?, tolerances.get("P"), ledger);
    Ok(())
}

/// The corrected kinematics in the chart without pole, and back.
fn tilt_chart(
    bodies: &Bodies,
    dk: &DressingCorrection,
    within: impl Fn(bool, f64) -> f64,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) {
    let Some(mut table) = item.object("tilt_chart", ledger) else { return };
    let chain = &bodies.tool.flanks.left.chain;
    let nominal = [chain.worm_angle, chain.crossing_angle, chain.centre_distance, chain.offset];
    let absolute: [f64; 4] = std::array::from_fn(|j| nominal[j] + dk[j]);
    let chart = TiltChart::from_kinematics(absolute, chain.screw_parameter);
    for (key, angle, value) in [
        ("phi_S_deg", true, chart.phi.to_degrees()),
        ("gamma_deg", true, chart.gamma.to_degrees()),
        ("d_mm", false, chart.d),
        ("tau_deg", true, chart.tau.to_degrees()),
    ] {
        table.number(key, value, within(angle, value), ledger);
    }
    table.finish(ledger);
}

/// A row of block `conditions`: ["f", side, w, f], ["map", side, t, w], ["head", t, r] or ["fix", j, x]; side +1 = left.
fn row(value: &Value) -> Option<Condition> {
    let row = value.as_array()?;
    let kind = row.first()?.as_str()?;
    let x = numbers(&Value::Array(row[1..].to_vec()))?;
    let flank = |side: f64| Flank::BOTH.into_iter().find(|f| f.sign() == side);
    match (kind, x.as_slice()) {
        ("f", &[side, w, f]) => Some(Condition::Point { flank: flank(side)?, w, f }),
        ("map", &[side, t, w]) => Some(Condition::Map { flank: flank(side)?, t, w }),
        ("head", &[t, r]) => Some(Condition::Head { t, r }),
        ("fix", &[j, x]) => {
            let j = (0..4).find(|&k| k as f64 == j)?;
            Some(Condition::Fixed { j, x })
        }
        _ => None,
    }
}

/// One entry of block `conditions`.
pub(super) fn conditions(
    bodies: &Bodies,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    let name = item.given_text("name", ledger).unwrap_or_default();
    let case = format!("{} conditions {name}", item.case());
    item.rename(&case);
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let rows = item.take("conditions").and_then(Value::as_array);
    let rows: Option<Vec<Condition>> = rows.and_then(|rows| rows.iter().map(row).collect());
    let Some(rows) = rows else {
        item.refused(&"the conditions cannot be read", ledger);
        return Ok(());
    };
    let solver = ConditionSolver::new(&bodies.tool, bodies.reference_radius);
    let found = solver.solve(&rows, &[0.0; 4]);
    if item.peek("error").is_some() {
        refusal(found, item, ledger);
        return Ok(());
    }
    let dk = found?;
    let relative = tolerances.get("DK_rel");
    // A component that a row fixes is exact up to rounding: it is held to the size of the whole correction in the solver's
    // scaled unknowns.
    let fixed = |j: usize| rows.iter().any(|row| matches!(row, Condition::Fixed { j: k, .. } if *k == j));
    let scale = solver.scale();
    let size = (0..4).map(|j| (dk[j] / scale[j]).powi(2)).sum::<f64>().sqrt();
    let tolerance = |j: usize, x: f64| {
        let own = if fixed(j) { corrections::in_file_units(j, size * scale[j]) } else { x.abs() };
        relative * own
    };
    corrections::compare(item, &dk, tolerance, ledger);
    let um = tolerances.get("um");
    for flank in Flank::BOTH {
        let key = format!("f_{flank}_um");
        if item.peek(&key).is_some() {
            let points = DressedProfile::new(&bodies.tool, flank, dk).at_rolls(&profile_rolls(bodies))?;
            item.list(&key, &points.iter().map(|p| p.f / UM).collect::<Vec<_>>(), um, ledger);
        }
    }
    let (radius, _) = head_gradient(&bodies.tool, 0.0, &dk)?;
    item.number("head_radius_mm", radius, um * UM, ledger);
    Ok(())
}

/// Conditions that no correction fulfils: the error, why the path ended and how far it came.
fn refusal(found: Result<DressingCorrection, DressingError>, item: &mut Expected<'_>, ledger: &mut Ledger) {
    let (name, status, reached) = match &found {
        Ok(_) => (Value::Null, Value::Null, f64::NAN),
        Err(DressingError::NoZero { fraction, reason, .. }) => {
            // The series of the files have no end: beyond it their paths run on until rounding turns them, which they call a fold.
            let ended = if *reason == PathReason::OutOfDresser { PathReason::Fold } else { *reason };
            ("NoZero".into(), ended.to_string().replace(' ', "_").into(), *fraction)
        }
        Err(other) => (other.code().into(), Value::Null, f64::NAN),
    };
    let case = item.case().to_owned();
    let mut equal = |key: &str, actual: Value| {
        if let Some(expected) = item.take(key) {
            ledger.equal(&case, key, expected.clone(), actual);
        }
    };
    equal("error", name);
    equal("status", status);
    item.number("reached_fraction", reached, FRACTION, ledger);
}

/// Block `conditioning`: singular values of the scaled rows at DK = 0.
pub(super) fn conditioning(
    bodies: &Bodies,
    relative: f64,
    item: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), DressingError> {
    item.informative(&["scale"]);
    let solver = ConditionSolver::new(&bodies.tool, bodies.reference_radius);
    let range = bodies.range;
    let four = std::array::from_fn(|k| Condition::Point {
        flank: Flank::Left,
        w: range.w_nf + range.length() * k as f64 / 3.0,
        f: 0.0,
    });
    for (key, rows) in [("sigma_four_point", &four), ("sigma_three_point_map", &three_points(bodies, 0.0))] {
        let sigma = solver.singular_values(rows, &[0.0; 4])?;
        // The block states no tolerance: rows known to the relative tolerance of the derivatives leave every singular value
        // uncertain by that share of the largest.
        item.list_relative_to_largest(key, &sigma, relative, ledger);
    }
    Ok(())
}
