//! 25-modifications: what worm functions and motions leave on the flank, by the exact contact and by the local envelope.

use super::decompositions::{gauge, implied, quadratic_coefficients, raw_radius};
use super::expected::Expected;
use super::gear_sets::{Set, entries, named};
use super::ledger::Ledger;
use super::reference::{Reference, Tolerances};
use super::terms::{Coefficient, coefficients, polynomial as read_polynomial};
use contact::{ContactError, ExactContact, ModifiedThread, ThreadFunction, Unmodified};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use foundation::numerics::Polynomial2;
use generating::{
    ClassFit, FlankLines, Gauge, GeneratingError, LocalEnvelope, QuadraticWorm,
    constant_only_profile_crowning, decompose_quadratic, kinematic_compliance, motion_of_flanks,
    natural_twist as first_order_twist,
};
use metrology::{Characteristics, Topography};
use serde_json::Value;

const UM: f64 = 1e-3;

type Points = Vec<(f64, f64)>;

fn points(item: &mut Expected<'_>, ledger: &mut Ledger) -> Option<Points> {
    let (w, z) = (item.given_list("points_w_mm", ledger), item.given_list("points_z_mm", ledger));
    Some(w?.into_iter().zip(z?).collect())
}

fn um(values: &[f64]) -> Vec<f64> {
    values.iter().map(|f| f / UM).collect()
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The exact flank at some points, normal, mm.
fn ground<F: ThreadFunction>(
    set: &Set,
    flank: Flank,
    motion: &GeneratingMotion,
    function: &F,
    points: &[(f64, f64)],
) -> Result<Vec<f64>, ContactError> {
    let thread = ModifiedThread::new(set.pair.flanks[flank].worm, function);
    let exact = ExactContact::new(&set.pair, flank, motion, &thread);
    points.iter().map(|&(w, z)| exact.solve(w, z).map(|s| s.f_n)).collect()
}

/// Worm and motion of one flank ground alone that make the polynomial `a` in (w, z) to first order: Delta_d carries F_K.
fn quadratic_plan(
    set: &Set,
    lines: FlankLines,
    a: &Polynomial2,
    [ratio, shift_origin]: [f64; 2],
    gauge: Gauge,
) -> (QuadraticWorm, GeneratingMotion) {
    let parts = decompose_quadratic(a, lines.work_direction(ratio), lines.t_k, gauge);
    let mut motion = set.pair.motion(MotionLaw::polynomial(0.0, vec![shift_origin, ratio]));
    let normal = parts.normal_motion(&lines).map(|f| f / lines.sin_an);
    motion.delta_d = MotionLaw::polynomial(0.0, normal.to_vec());
    (QuadraticWorm { lines, shift: motion.shift.clone(), parts }, motion)
}

/// Block `polynomial`.
pub(super) fn polynomial(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    entries("polynomial", block, ledger, |item, ledger| {
        item.informative(&["reconstruction_error_um", "C_alpha_um", "twist_um"]);
        let relative = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null)).get("relative");
        let Some((set, flank)) = named(file, item, ledger) else { return Ok(()) };
        let crowning = item.given("C_beta_um", ledger);
        let Some(mut input) = item.object("input", ledger) else { return Ok(()) };
        let a = read_polynomial(item.case(), input.take("A_um_per_mm_power"), ['w', 'z'], ledger);
        let [ratio, t_1] = ["K_ZV1", "tan_rho_F1"].map(|key| input.given(key, ledger));
        let (Some(crowning), Some(a), Some(ratio), Some(t_1)) = (crowning, a, ratio, t_1) else {
            return Ok(());
        };
        let lines = set.lines(flank, t_1)?;
        let gauge = gauge(&mut input, &lines, ledger);
        input.finish(ledger);
        let Some((gauge, listed)) = gauge else { return Ok(()) };
        let t = lines.work_direction(ratio);
        let parts = decompose_quadratic(&a, t, lines.t_k, gauge);
        let radius = raw_radius(&lines);
        implied(item.case(), listed, &parts, relative, radius, ledger);
        if let Some(mut expected) = item.object("expected", ledger) {
            expected.numbers(&[("tan_rho_F2", t), ("tan_rho_K", lines.t_k)], relative, ledger);
            let degrees = t.atan().to_degrees();
            expected.number("rho_F2_deg", degrees, relative * degrees.abs(), ledger);
            let actual = quadratic_coefficients(&parts);
            coefficients(&mut expected, "K_um_per_mm_power", &actual, radius, relative, ledger);
            let unwanted = constant_only_profile_crowning(&lines, crowning, t);
            expected.number(
                "unwanted_profile_crowning_constant_only_um",
                unwanted,
                relative * crowning.abs(),
                ledger,
            );
            expected.finish(ledger);
        }
        if let Some(mut block) = item.object("ground", ledger) {
            if let Err(error) = ground_polynomial(&set, flank, lines, &a, (ratio, gauge), &mut block, ledger)
            {
                block.refused(&error, ledger);
            }
            block.finish(ledger);
        }
        Ok(())
    });
}

fn ground_polynomial(
    set: &Set,
    flank: Flank,
    lines: FlankLines,
    a: &Polynomial2,
    (ratio, gauge): (f64, Gauge),
    block: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Result<(), GeneratingError> {
    // How well two derivations of the mapping agreed when the file was made.
    block.informative(&["mapping_consistency_um"]);
    let numbers = ["z_V01_mm", "tolerance_um"].map(|key| block.given(key, ledger));
    let ([Some(shift_origin), Some(tolerance)], Some(points)) = (numbers, points(block, ledger)) else {
        return Ok(());
    };
    let (worm, motion) = quadratic_plan(set, lines, a, [ratio, shift_origin], gauge);
    let exact = ground(set, flank, &motion, &worm, &points)?;
    let target: Vec<f64> = points.iter().map(|&(w, z)| lines.cos_b2 * a.value(w, z)).collect();
    let model = LocalEnvelope::new(&set.pair.flanks[flank], &motion, &worm);
    let collect = |f: &dyn Fn(f64, f64) -> Result<f64, GeneratingError>| {
        points.iter().map(|&(w, z)| f(w, z)).collect::<Result<Vec<_>, _>>()
    };
    let second = collect(&|w, z| model.second_order(w, z))?;
    let local = collect(&|w, z| model.value(w, z))?;
    for (key, values) in
        [("ground_f_n_um", &exact), ("target_f_n_um", &target), ("second_order_f_n_um", &second)]
    {
        block.list(key, &um(values), tolerance, ledger);
    }
    let zero = vec![0.0; target.len()];
    let largest = [
        ("max_target_um", largest_difference(&target, &zero)),
        ("max_error_first_order_um", largest_difference(&exact, &target)),
        ("max_error_second_order_um", largest_difference(&exact, &second)),
        ("max_error_local_envelope_um", largest_difference(&exact, &local)),
    ];
    block.numbers(&largest.map(|(key, x)| (key, x / UM)), tolerance, ledger);
    Ok(())
}

/// Points on which the file's commands were fitted and judged, over profile and face width.
const FIT_POINTS: usize = 7;
/// Corrections after which the command is listed.
const ROUNDS: usize = 4;

/// Block `precompensation`: the local envelope corrects the command, the exact contact judges it.
pub(super) fn precompensation(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    entries("precompensation", block, ledger, |item, ledger| {
        item.informative(&["C_beta_um", "C_alpha_um", "twist_um"]);
        let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
        let Some((set, flank)) = named(file, item, ledger) else { return Ok(()) };
        let ratio = item.given("K_ZV1", ledger);
        let target = read_polynomial(item.case(), item.peek("target_um_per_mm_power"), ['w', 'z'], ledger);
        item.informative(&["target_um_per_mm_power"]);
        let (Some(ratio), Some(target)) = (ratio, target) else { return Ok(()) };
        let line = set.worm_line(flank)?;
        let lines = set.lines(flank, line.rho.tan())?;
        let even = |[a, b]: [f64; 2], k: usize| a + (b - a) * k as f64 / (FIT_POINTS - 1) as f64;
        let points: Points = (0..FIT_POINTS * FIT_POINTS)
            .map(|k| (even(lines.roll, k / FIT_POINTS), even(lines.face, k % FIT_POINTS)))
            .collect();
        let centred: Points = points.iter().map(|(w, z)| (w - lines.w_m, z - lines.z_m)).collect();
        let fit = ClassFit::cubic(&centred);
        let gauge = Gauge::Centred { w_m: lines.w_m, k_20: 0.0 };
        let wanted: Vec<f64> = points.iter().map(|&(w, z)| target.value(w, z)).collect();
        let mut command = target.shifted(lines.w_m, lines.z_m);
        let mut errors = Vec::new();
        for round in 0..=ROUNDS {
            let raw = command.shifted(-lines.w_m, -lines.z_m);
            let (worm, motion) = quadratic_plan(&set, lines, &raw, [ratio, 0.0], gauge);
            let exact = ground(&set, flank, &motion, &worm, &points)?;
            let normal: Vec<f64> = wanted.iter().map(|f| f * lines.cos_b2).collect();
            errors.push(largest_difference(&exact, &normal) / UM);
            if round < ROUNDS {
                let model = LocalEnvelope::new(&set.pair.flanks[flank], &motion, &worm);
                let local = points.iter().map(|&(w, z)| model.value(w, z)).collect::<Result<Vec<_>, _>>()?;
                let left: Vec<f64> = wanted.iter().zip(&local).map(|(f, g)| f - g / lines.cos_b2).collect();
                command = command.add(&fit.fit(&left));
            }
        }
        let relative = tolerances.get("commanded_relative");
        let raw = command.shifted(-lines.w_m, -lines.z_m);
        let actual: Vec<Coefficient> = raw.terms().map(|(i, j, a)| (format!("w{i}z{j}"), i + j, a)).collect();
        coefficients(item, "commanded_um_per_mm_power", &actual, raw_radius(&lines), relative, ledger);
        let largest = wanted.iter().map(|f| (f * lines.cos_b2).abs()).fold(0.0, f64::max) / UM;
        item.number("max_target_um", largest, relative * largest, ledger);
        let settled = tolerances.get("error_after_three_iterations_um");
        let after_three = errors.get(3).copied().unwrap_or(f64::NAN);
        ledger.at_most(item.case(), "error after three iterations (um)", settled, after_three, 0.0);
        // An error of the flank is as certain as the command behind it.
        item.list("ground_error_um_by_iteration", &errors, relative * largest, ledger);
        Ok(())
    });
}

/// Block `natural_twist`.
pub(super) fn natural_twist(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    entries("natural_twist", block, ledger, |item, ledger| {
        // How well models and brute force agreed when the file was made.
        item.informative(&["measured"]);
        let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
        let Some((set, flank)) = named(file, item, ledger) else { return Ok(()) };
        let Some(mut input) = item.object("input", ledger) else { return Ok(()) };
        input.informative(&["apex", "law"]);
        let [amount, length] = ["C_beta_um", "L_beta_mm"].map(|key| input.given(key, ledger));
        input.finish(ledger);
        let (Some(mut expected), Some(amount), Some(length)) =
            (item.object("expected", ledger), amount, length)
        else {
            return Ok(());
        };
        let amount = amount * UM;
        let lines = FlankLines { face: [-0.5 * length, 0.5 * length], z_m: 0.0, ..set.lines(flank, 0.0)? };
        let closed = tolerances.get("closed_form_relative");
        let first = first_order_twist(&lines, amount);
        let q = kinematic_compliance(&set.pair.flanks[flank], lines.w_m)?;
        let factor = 1.0 / (1.0 - 8.0 * amount * lines.cos_b2 * q / (length * length));
        expected.number("z_V20_mm", first.apex_feed, closed * length, ledger);
        let amounts = [
            ("twist_first_order_um", first.twist / UM),
            ("profile_crowning_first_order_um", first.profile_crowning / UM),
        ];
        expected.numbers(&amounts, closed * amount.abs() / UM, ledger);
        expected.number("q_at_w_m_mm", q, closed * q, ledger);
        expected.number("amplitude_factor_at_w_m", factor, closed * factor, ledger);
        if let Err(error) =
            ground_crowning(&set, flank, &lines, (amount, first.apex_feed), &mut expected, tolerances, ledger)
        {
            expected.refused(&error, ledger);
        }
        expected.finish(ledger);
        Ok(())
    });
}

fn ground_crowning(
    set: &Set,
    flank: Flank,
    lines: &FlankLines,
    (amount, apex): (f64, f64),
    expected: &mut Expected<'_>,
    tolerances: Tolerances<'_>,
    ledger: &mut Ledger,
) -> Result<(), GeneratingError> {
    let Some(points) = points(expected, ledger) else { return Ok(()) };
    let half = 0.5 * (lines.face[1] - lines.face[0]);
    let height = -amount * lines.cos_b2 / lines.sin_an / (half * half);
    let mut motion = set.pair.motion(MotionLaw::zero());
    motion.delta_d = MotionLaw::polynomial(apex, vec![0.0, 0.0, height]);
    let f_n = ground(set, flank, &motion, &Unmodified, &points)?;
    let tolerance = tolerances.get("ground_um");
    expected.list("ground_f_n_um", &um(&f_n), tolerance, ledger);
    let distinct = |pick: fn(&(f64, f64)) -> f64| {
        let mut values: Vec<f64> = points.iter().map(pick).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    };
    let Some(flank) = Topography::new(distinct(|p| p.0), distinct(|p| p.1), f_n) else {
        ledger.fail(expected.case(), "points_w_mm", Value::Null, "the points are no grid [w][z]".into());
        return Ok(());
    };
    let found = Characteristics::of(&flank, lines.cos_b2);
    let values = [
        ("ground_crowning_um", found.helix_crowning),
        ("ground_twist_um", found.twist_fit),
        ("ground_profile_crowning_um", found.profile_crowning),
    ];
    expected.numbers(&values.map(|(key, x)| (key, x / UM)), tolerance, ledger);
    Ok(())
}

/// Block `two_flank_motion`.
pub(super) fn two_flank_motion(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    entries("two_flank_motion", block, ledger, |item, ledger| {
        // `measured`: how well models and brute force agreed when the file was made.
        item.informative(&["measured", "law"]);
        let relative = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null)).get("relative");
        let name = item.given_text("gear", ledger).unwrap_or_default();
        let Some(set) = Set::read(name, &file.root["gears"][name], ledger) else { return Ok(()) };
        let wanted = Flank::BOTH.map(|flank| item.given_list(flank.name(), ledger));
        let (Some(feeds), [Some(left), Some(right)]) = (item.given_list("z_V2_mm", ledger), wanted) else {
            return Ok(());
        };
        let lines = Sides::try_from_fn(|flank| set.lines(flank, 0.0))?;
        let (Some(left), Some(right)) = (normal_law(&left), normal_law(&right)) else {
            item.refused(&"amount, origin, half length and slope are needed per flank", ledger);
            return Ok(());
        };
        let (delta_d, delta_phi_2) = motion_of_flanks(&lines, &left, &right);
        let values =
            |law: &MotionLaw, unit: f64| feeds.iter().map(|&v| law.value(v) / unit).collect::<Vec<_>>();
        item.list_relative_to_largest("Delta_d_um", &values(&delta_d, UM), relative, ledger);
        item.list_relative_to_largest("Delta_phi_2_urad", &values(&delta_phi_2, 1e-6), relative, ledger);
        // k_0 is an angle of the worm: 2 pi is one pitch of the workpiece.
        let phase = |flank: Flank| set.pair.flanks[flank].phase / (2.0 * std::f64::consts::PI);
        let apart = phase(Flank::Left) - phase(Flank::Right);
        item.periodic("phase_difference_pitches", apart, 1.0, relative, ledger);
        Ok(())
    });
}

/// f_n(z_V2) = -amount ((z_V2 - z0)/half)^2 + slope z_V2 (um) as coefficients in mm.
fn normal_law(law: &[f64]) -> Option<[f64; 4]> {
    let &[amount, origin, half, slope] = law else { return None };
    let bend = -amount / (half * half);
    Some([bend * origin * origin, slope - 2.0 * bend * origin, bend, 0.0].map(|c| c * UM))
}
