//! 25-modifications: decompositions of polynomials into what worm, dresser and motion carry, in closed form.

use super::expected::Expected;
use super::gear_sets::{Set, entries, named};
use super::ledger::Ledger;
use super::reference::{Reference, Tolerances};
use super::terms::{Coefficient, coefficients, polynomial, powers};
use contact::DiagonalLine;
use foundation::geometry::Flank;
use foundation::modification::{CornerProfile, Modification, ModificationSpec, NoFiles, TriangularSpec};
use foundation::numerics::Polynomial2;
use generating::{
    FlankLines, Gauge, GeneratingError, QuadraticDecomposition, decompose_diagonal, decompose_quadratic,
    decompose_radial, product_functions, radial_residual,
};
use metrology::{Characteristics, Topography};
use serde_json::Value;

const UM: f64 = 1e-3;

/// Distance of the farthest field corner from the origin of centred variables, mm.
fn centred_radius(lines: &FlankLines) -> f64 {
    let half = |[a, b]: [f64; 2]| 0.5 * (b - a);
    half(lines.roll).hypot(half(lines.face))
}

/// The same from the origin of raw variables (w, z), mm.
pub(super) fn raw_radius(lines: &FlankLines) -> f64 {
    lines.corners().map(|(w, z)| w.hypot(z)).into_iter().fold(0.0, f64::max)
}

/// Block `decomposition_clpk`.
pub(super) fn decomposition_clpk(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    entries("decomposition_clpk", block, ledger, |item, ledger| {
        item.informative(&["reconstruction_error_um"]);
        let relative = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null)).get("relative");
        let Some((set, flank)) = named(file, item, ledger) else { return Ok(()) };
        let Some(mut input) = item.object("input", ledger) else { return Ok(()) };
        let a = polynomial(item.case(), input.take("a_um_per_mm_power"), ['u', 'y'], ledger);
        let keys = ["K_ZV1", "tan_rho_F1", "p2_um_per_mm2"].map(|key| input.given(key, ledger));
        let place = input.given_text("u_squared_carried_by", ledger);
        input.finish(ledger);
        let (Some(a), [Some(ratio), Some(t_1), Some(p_2)], Some(place)) = (a, keys, place) else {
            return Ok(());
        };
        let p_2 = p_2 * UM;
        let share = match place {
            "profile" => a.coefficient(2, 0),
            "diagonal" => 0.0,
            _ => p_2,
        };
        ledger.number(item.case(), "input.p2_um_per_mm2", p_2, share, relative * p_2.abs());
        let lines = set.lines(flank, t_1)?;
        let parts = decompose_diagonal(&a, lines.work_direction(ratio), lines.t_k, p_2, 0.0);
        let Some(mut expected) = item.object("expected", ledger) else { return Ok(()) };
        let directions = [("tan_rho_F2", parts.t), ("tan_rho_K", parts.t_k)];
        expected.numbers(&directions, relative, ledger);
        let mut actual = powers("K0", 0, &parts.constant);
        actual.extend(powers("K1", 1, &parts.linear));
        actual.extend(powers("KK", 0, &parts.kinematic));
        actual.extend(powers("p", 0, &parts.profile));
        coefficients(&mut expected, "um_per_mm_power", &actual, centred_radius(&lines), relative, ledger);
        expected.finish(ledger);
        Ok(())
    });
}

/// Block `radial_class`.
pub(super) fn radial_class(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    entries("radial_class", block, ledger, |item, ledger| {
        let relative = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null)).get("relative");
        let Some((set, flank)) = named(file, item, ledger) else { return Ok(()) };
        let Some(mut input) = item.object("input", ledger) else { return Ok(()) };
        let a = polynomial(item.case(), input.take("a_um_per_mm_power"), ['u', 'y'], ledger);
        input.finish(ledger);
        let Some(a) = a else { return Ok(()) };
        let lines = set.lines(flank, 0.0)?;
        let parts = decompose_radial(&a, lines.t_k);
        let Some(mut expected) = item.object("expected", ledger) else { return Ok(()) };
        let radius = centred_radius(&lines);
        let mut actual = powers("KK", 0, &parts.kinematic);
        actual.extend(powers("p", 0, &parts.profile));
        coefficients(&mut expected, "um_per_mm_power", &actual, radius, relative, ledger);
        let [r_11, r_21, r_12] = radial_residual(&a, lines.t_k);
        let residual: [Coefficient; 3] =
            [("u1y1".into(), 2, r_11), ("u2y1".into(), 3, r_21), ("u1y2".into(), 3, r_12)];
        coefficients(&mut expected, "residual_um_per_mm_power", &residual, radius, relative, ledger);
        let left = Polynomial2::from_terms([(1, 1, r_11), (2, 1, r_21), (1, 2, r_12)]);
        let twist = corner_twist(&left, &lines) / UM;
        expected.number("residual_corner_twist_S_um", twist, relative * twist.abs(), ledger);
        expected.finish(ledger);
        Ok(())
    });
}

/// Twist of a polynomial in (u, y) over the corners of the field, transverse, mm, positive = removed.
fn corner_twist(p: &Polynomial2, lines: &FlankLines) -> f64 {
    let thirds = |[a, b]: [f64; 2]| vec![a, 0.5 * (a + b), b];
    let (w, z) = (thirds(lines.roll), thirds(lines.face));
    let f = w.iter().flat_map(|w| z.iter().map(move |z| p.value(w - lines.w_m, z - lines.z_m))).collect();
    Topography::new(w.clone(), z.clone(), f).map_or(f64::NAN, |t| Characteristics::of(&t, 1.0).twist_corner)
}

/// The coefficients of class {C, L, Q, K} as the files name them.
pub(super) fn quadratic_coefficients(parts: &QuadraticDecomposition) -> Vec<Coefficient> {
    let mut all = powers("K0", 0, &parts.constant);
    all.extend(powers("K1", 1, &parts.linear));
    all.extend(powers("K2", 2, &parts.quadratic));
    all.extend(powers("KK", 0, &parts.kinematic));
    all
}

/// The free choice of a decomposition: keys `K_F10_mode` and those it needs. What `centred` implies is compared.
pub(super) fn gauge(
    input: &mut Expected<'_>,
    lines: &FlankLines,
    ledger: &mut Ledger,
) -> Option<(Gauge, Option<[f64; 2]>)> {
    let mode = input.given_text("K_F10_mode", ledger)?;
    let k_20 = input.given_optional("K_F20_um_per_mm2", ledger).unwrap_or(0.0) * UM;
    let [k_10, k_k0] = ["K_F10_um_per_mm", "K_KF0_um"].map(|key| input.given(key, ledger));
    let (k_10, k_k0) = (k_10? * UM, k_k0? * UM);
    match mode {
        "centred" => Some((Gauge::Centred { w_m: lines.w_m, k_20 }, Some([k_10, k_k0]))),
        "given" => Some((Gauge::Given { k_10, k_20, k_k0 }, None)),
        other => {
            ledger.fail(input.case(), "K_F10_mode", other.into(), "centred or given is needed here".into());
            None
        }
    }
}

/// Compares the free coefficients that a gauge implies, where the file lists them among the inputs.
pub(super) fn implied(
    case: &str,
    listed: Option<[f64; 2]>,
    parts: &QuadraticDecomposition,
    tolerance: f64,
    radius: f64,
    ledger: &mut Ledger,
) {
    let Some([k_10, k_k0]) = listed else { return };
    let largest = (k_10 * radius).abs().max(k_k0.abs());
    ledger.number(
        case,
        "K_F10_um_per_mm",
        k_10 / UM,
        parts.linear[0] / UM,
        tolerance * largest / UM / radius,
    );
    ledger.number(case, "K_KF0_um", k_k0 / UM, parts.kinematic[0] / UM, tolerance * largest / UM);
}

/// A flank of a file's gear and the numbers of its dressed lines along axial sections.
pub(super) fn axial(set: &Set, flank: Flank) -> Result<FlankLines, GeneratingError> {
    let line = set.worm_line(flank)?;
    set.lines(flank, line.rho.tan())
}

/// Block `waviness`: amplitude polynomial times sine as three functions of X.
pub(super) fn waviness(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let list = Value::Array(vec![block.clone()]);
    entries("waviness", &list, ledger, |item, ledger| {
        item.informative(&["reconstruction_error_um"]);
        let Some((set, flank)) = named(file, item, ledger) else { return Ok(()) };
        let tolerance = item.given("tolerance_um", ledger);
        let x = item.given_list("X_F2_mm", ledger);
        let spec = item.take("spec").unwrap_or(&Value::Null);
        let (Some(tolerance), Some(x)) = (tolerance, x) else { return Ok(()) };
        let ModificationSpec::Waviness(wave) = ModificationSpec::from_json(spec)? else {
            item.refused(&"the kind must be waviness", ledger);
            return Ok(());
        };
        let lines = axial(&set, flank)?;
        let rho = wave.rho_deg.to_radians();
        let t = rho.tan();
        let half = |[a, b]: [f64; 2]| 0.5 * (b - a);
        let square = |scale: f64, du: f64, factor: f64, profile: bool| {
            let (a, b) = if profile { (1.0 / scale, 0.0) } else { (0.0, 1.0 / scale) };
            let line = Polynomial2::linear(a, b, -du / scale);
            line.multiply(&line).scale(factor)
        };
        let amplitude = Polynomial2::constant(wave.amp_0_um)
            .add(&square(half(lines.roll), lines.w_m, wave.amp_uu_um, true))
            .add(&square(half(lines.face), lines.z_m, wave.amp_vv_um, false));
        let functions: Vec<[f64; 3]> = x
            .iter()
            .map(|&x| {
                // X of a direction is the same for rho and rho + 180 deg up to its sign.
                let along = x * rho.cos().signum();
                let phase =
                    2.0 * std::f64::consts::PI * along / wave.wavelength_mm + wave.phase_deg.to_radians();
                product_functions(&amplitude, t, x, phase.sin())
            })
            .collect();
        for (i, key) in ["F_FtC_um", "F_FtL_um_per_mm", "F_FtQ_um_per_mm2"].into_iter().enumerate() {
            let values: Vec<f64> = functions.iter().map(|f| f[i]).collect();
            item.list(key, &values, tolerance, ledger);
        }
        let ratio =
            set.pair.flanks[flank].ratio_of_directions(set.worm_line(flank)?, DiagonalLine { rho })?;
        item.number("K_ZV1", ratio, tolerance, ledger);
        Ok(())
    });
}

/// (s_w, s_z) of the corner at which a relief is deepest.
fn corner_signs(relief: &TriangularSpec) -> [f64; 2] {
    let sign = |positive: bool| if positive { 1.0 } else { -1.0 };
    [sign(relief.corner_profile == CornerProfile::Tip), sign(relief.corner_face.is_datum())]
}

/// tan(rho_2) of the lines on which a relief is constant: x = 1 + s_w (w - w_c)/L_w + s_z (z - z_c)/L_z.
pub(super) fn relief_direction(relief: &TriangularSpec) -> f64 {
    let [s_w, s_z] = corner_signs(relief);
    s_w * s_z * relief.length_z_mm / relief.length_w_mm
}

/// Block `figure_29_31`: a relief along one direction together with polynomials, split into motion and worm.
pub(super) fn figure_29_31(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let list = Value::Array(vec![block.clone()]);
    entries("figure_29_31", &list, ledger, |item, ledger| {
        item.informative(&["reconstruction_error_um"]);
        let Some((set, flank)) = named(file, item, ledger) else { return Ok(()) };
        let tolerance = item.given("tolerance_um", ledger);
        let points = (item.given_list("points_w_mm", ledger), item.given_list("points_z_mm", ledger));
        let specs = item.take("specs").and_then(Value::as_array).cloned().unwrap_or_default();
        let (Some(tolerance), (Some(w), Some(z))) = (tolerance, points) else { return Ok(()) };
        let specs = specs.iter().map(ModificationSpec::from_json).collect::<Result<Vec<_>, _>>()?;
        let lines = axial(&set, flank)?;
        let field = set.field(flank)?;
        let total = Modification::for_flank(&specs, flank, &field, &NoFiles)?;
        let relief = specs.iter().find_map(|spec| match spec {
            ModificationSpec::TriangularEndRelief(relief) => Some(relief),
            _ => None,
        });
        let Some(relief) = relief else {
            item.refused(&"a triangular end relief must be among the modifications", ledger);
            return Ok(());
        };
        let [s_w, s_z] = corner_signs(relief);
        let corner = |ends: [f64; 2], sign: f64| ends[usize::from(sign > 0.0)];
        let (w_c, z_c) = (corner(lines.roll, s_w), corner(lines.face, s_z));
        let t = relief_direction(relief);
        let line = DiagonalLine { rho: t.atan() };
        let ratio = set.pair.flanks[flank].ratio_of_directions(set.worm_line(flank)?, line)?;
        let mm = tolerance;
        item.number("tan_rho_F2", t, mm, ledger);
        item.number("rho_F2_deg", line.rho.to_degrees(), mm, ledger);
        item.number("K_ZV1", ratio, mm, ledger);
        let start = line.coordinate(w_c - s_w * relief.length_w_mm, z_c);
        item.number("X_F2_start_of_relief_mm", start, mm, ledger);
        let smooth = total
            .terms()
            .iter()
            .filter_map(Modification::polynomial)
            .fold(Polynomial2::constant(0.0), |sum, p| sum.add(&p))
            .shifted(-lines.w_m, -lines.z_m);
        let Some((gauge, listed)) = gauge(item, &lines, ledger) else { return Ok(()) };
        let parts = decompose_quadratic(&smooth, lines.work_direction(ratio), lines.t_k, gauge);
        let radius = raw_radius(&lines);
        implied(item.case(), listed, &parts, tolerance, radius, ledger);
        let actual = quadratic_coefficients(&parts);
        coefficients(item, "K_um_per_mm_power", &actual, radius, tolerance, ledger);
        let points: Vec<(f64, f64)> = w.into_iter().zip(z).collect();
        let whole = points.iter().map(|&(w, z)| total.value(w, z)).collect::<Result<Vec<_>, _>>()?;
        let kinematic: Vec<f64> = points.iter().map(|&(w, z)| parts.kinematic_value(w, z)).collect();
        let um = |values: &mut dyn Iterator<Item = f64>| values.map(|f| f / UM).collect::<Vec<_>>();
        item.list("total_f_t_um", &um(&mut whole.iter().copied()), tolerance, ledger);
        item.list("kinematic_part_f_t_um", &um(&mut kinematic.iter().copied()), tolerance, ledger);
        let worm = um(&mut whole.iter().zip(&kinematic).map(|(f, k)| f - k));
        item.list("worm_part_f_t_um", &worm, tolerance, ledger);
        Ok(())
    });
}
