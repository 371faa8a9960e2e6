//! 20-generating-contact, block `cases`: contact relations of worm and workpiece for every combination of cylinder and
//! cone.

use super::bodies::{BaseTolerances, Body, ChainInput, base_data};
use super::expected::Expected;
use super::ledger::Ledger;
use super::reference::{self, Reference, Tolerances};
use super::step_simulation::StepSimulation;
use contact::{ContactError, DiagonalLine, DiagonalRatio, ExactContact, FlankPair, ModifiedThread, Pair};
use foundation::geometry::{Flank, GeometryError};
use foundation::kinematics::MotionLaw;
use foundation::numerics::Polynomial2;
use serde::Deserialize;
use serde_json::Value;
use std::f64::consts::PI;

const UM: f64 = 1e-3;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    worm: Body,
    work: Body,
    chain: ChainInput,
    /// The common rack: a consequence of the bodies, compared with what the library finds.
    rack: RackInput,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RackInput {
    m_n_mm: f64,
    beta_w2_deg: f64,
    r_w2_mm: f64,
    alpha_n_left_deg: f64,
    alpha_n_right_deg: f64,
}

impl Input {
    fn pair(&self) -> Result<Pair, ContactError> {
        let body = |b: &Body| -> Result<_, GeometryError> { b.gear() };
        Pair::new(body(&self.worm)?, body(&self.work)?, self.chain.chain())
    }
}

/// Block `cases`.
pub(super) fn cases(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let tol = file.tolerances();
    for mut case in reference::cases("cases", block, ledger) {
        let Some(input) = reference::read::<Input>(&case.name, case.input, ledger) else { continue };
        match input.pair() {
            Ok(pair) => {
                rack(&case.name, &input.rack, &pair, tol, ledger);
                one(&pair, &mut case.expected, tol, ledger);
            }
            Err(error) => case.expected.refused(&error, ledger),
        }
        case.expected.finish(ledger);
    }
}

fn rack(case: &str, rack: &RackInput, pair: &Pair, tol: Tolerances<'_>, ledger: &mut Ledger) {
    let (_, r_w2) = pair.rack_radii();
    let (length, angle) = (tol.get("contact_mm"), tol.get("rho_deg"));
    let left = &pair.flanks.left;
    ledger.number(case, "rack.m_n_mm", rack.m_n_mm, left.operating_module, length);
    ledger.number(case, "rack.beta_w2_deg", rack.beta_w2_deg, left.operating_beta_w2.to_degrees(), angle);
    ledger.number(case, "rack.r_w2_mm", rack.r_w2_mm, r_w2, length);
    for (flank, expected) in [(Flank::Left, rack.alpha_n_left_deg), (Flank::Right, rack.alpha_n_right_deg)] {
        let found = pair.flanks[flank].operating_alpha_n.to_degrees();
        ledger.number(case, &format!("rack.alpha_n_{flank}_deg"), expected, found, angle);
    }
}

fn one(pair: &Pair, expected: &mut Expected<'_>, tol: Tolerances<'_>, ledger: &mut Ledger) {
    let (r_w1, r_w2) = pair.rack_radii();
    expected.number("delta_y_mm", pair.backlash_free_gap(r_w1, r_w2), tol.get("delta_y_mm"), ledger);
    let base = BaseTolerances {
        length: tol.get("contact_mm"),
        angle_deg: tol.get("rho_deg"),
        ratio: tol.get("coefficient"),
    };
    for (key, gear) in [("worm", &pair.worm), ("work", &pair.work)] {
        if let Some(mut body) = expected.object(key, ledger) {
            base_data(&mut body, gear, base, ledger);
            body.finish(ledger);
        }
    }
    for flank in Flank::BOTH {
        if let Some(mut side) = expected.object(flank.name(), ledger) {
            relations(&pair.flanks[flank], &mut side, tol, ledger);
            if let Some(item) = side.object("diagonal", ledger) {
                refusable(item, ledger, |item, ledger| diagonal(&pair.flanks[flank], item, tol, ledger));
            }
            if let Some(item) = side.object("working_area", ledger) {
                refusable(item, ledger, |item, ledger| working_area(&pair.flanks[flank], item, tol, ledger));
            }
            if let Some(item) = side.object("step_error", ledger) {
                refusable(item, ledger, |item, ledger| step_error(pair, flank, item, tol, ledger));
            }
            if let Some(item) = side.object("modification", ledger) {
                refusable(item, ledger, |item, ledger| modification(pair, flank, item, tol, ledger));
            }
            side.finish(ledger);
        }
    }
    for item in expected.objects("contacts", ledger) {
        contact(pair, item, tol, ledger);
    }
}

/// Runs the comparison of a block; an error of the library or a missing input is a failure of the whole block.
fn refusable(
    mut item: Expected<'_>,
    ledger: &mut Ledger,
    check: impl FnOnce(&mut Expected<'_>, &mut Ledger) -> Result<(), ContactError>,
) {
    if let Err(error) = check(&mut item, ledger) {
        item.refused(&error, ledger);
    }
    item.finish(ledger);
}

fn relations(f: &FlankPair, side: &mut Expected<'_>, tol: Tolerances<'_>, ledger: &mut Ledger) {
    let angles = [
        ("operating_alpha_n_deg", f.operating_alpha_n),
        ("operating_beta_w1_deg", f.operating_beta_w1),
        ("operating_beta_w2_deg", f.operating_beta_w2),
        ("rho_KF1_deg", f.contact_path()[0].rho),
        ("rho_KF2_deg", f.contact_path()[1].rho),
    ];
    side.numbers(&angles.map(|(key, x)| (key, x.to_degrees())), tol.get("rho_deg"), ledger);
    let coefficients = [
        ("C_Fw1", f.c_w1),
        ("C_FzV11", f.c_zv11),
        ("C_FzV21", f.c_zv21),
        ("C_Fw2", f.c_w2),
        ("C_FzV12", f.c_zv12),
        ("C_FzV22", f.c_zv22),
        ("Chat_Fw1", f.hat_w1),
        ("Chat_Fw2", f.hat_w2),
        ("Chat_FzV1", f.hat_zv1),
        ("Chat_FzV2", f.hat_zv2),
    ];
    side.numbers(&coefficients, tol.get("coefficient"), ledger);
    let constants = [("C_Fc1_mm", f.c_c1), ("C_Fc2_mm", f.c_c2), ("Chat_Fc_mm", f.hat_c)];
    side.numbers(&constants, tol.get("coefficient_mm"), ledger);
    let couplings = [("k_V1_rad_per_mm", f.shift_coupling), ("k_V2_rad_per_mm", f.feed_coupling)];
    side.numbers(&couplings, tol.get("coupling_rad_per_mm"), ledger);
    side.periodic("k_0_mod_2pi_rad", f.phase, 2.0 * PI, tol.get("k_0_rad"), ledger);
}

fn diagonal(
    f: &FlankPair,
    item: &mut Expected<'_>,
    tol: Tolerances<'_>,
    ledger: &mut Ledger,
) -> Result<(), ContactError> {
    let given = ["rho_1_deg", "rho_2_deg", "z_V01_mm"].map(|key| item.given(key, ledger));
    let [Some(rho_1), Some(rho_2), Some(shift_origin)] = given else { return Ok(()) };
    let worm = DiagonalLine { rho: rho_1.to_radians() };
    let work = DiagonalLine { rho: rho_2.to_radians() };
    let ratio = f.ratio_of_directions(worm, work)?;
    item.number("K_ZV1", ratio, tol.get("K_ZV1"), ledger);
    let ratio = DiagonalRatio { ratio, shift_origin };
    let map = f.line_map(worm, work, ratio)?;
    item.number("X2_slope", map.slope, tol.get("coefficient"), ledger);
    item.number("X2_offset_mm", map.offset, tol.get("X_map_mm"), ledger);
    for mut line in item.objects("lines", ledger) {
        if let Some(x_1) = line.given("X_1_mm", ledger) {
            let (p, q) = f.roll_along_line(worm, x_1, ratio)?;
            line.number("X_2_mm", map.slope * x_1 + map.offset, tol.get("X_map_mm"), ledger);
            line.number("p", p, tol.get("coefficient"), ledger);
            line.number("q_mm", q, tol.get("X_map_mm"), ledger);
        }
        line.finish(ledger);
    }
    for mut point in item.objects("point_map", ledger) {
        if let (Some(w_2), Some(z_2)) = (point.given("w_2_mm", ledger), point.given("z_2_mm", ledger)) {
            let at = f.point_map(w_2, z_2, ratio)?;
            let values =
                [("w_1_mm", at.w_1), ("z_1_mm", at.z_1), ("z_V1_mm", at.shift), ("z_V2_mm", at.feed)];
            point.numbers(&values, tol.get("contact_mm"), ledger);
        }
        point.finish(ledger);
    }
    Ok(())
}

fn working_area(
    f: &FlankPair,
    item: &mut Expected<'_>,
    tol: Tolerances<'_>,
    ledger: &mut Ledger,
) -> Result<(), ContactError> {
    let keys = ["w_2_from_mm", "w_2_to_mm", "z_2_from_mm", "z_2_to_mm", "K_ZV1", "z_V01_mm"];
    let [Some(w_from), Some(w_to), Some(z_from), Some(z_to), Some(ratio), Some(shift_origin)] =
        keys.map(|key| item.given(key, ledger))
    else {
        return Ok(());
    };
    let area = f.working_area([w_from, w_to], [z_from, z_to], DiagonalRatio { ratio, shift_origin })?;
    let values = [
        ("z_V2_min_mm", area.feed[0]),
        ("z_V2_max_mm", area.feed[1]),
        ("z_1_min_mm", area.z_1[0]),
        ("z_1_max_mm", area.z_1[1]),
        ("w_1_min_mm", area.w_1[0]),
        ("w_1_max_mm", area.w_1[1]),
        ("r_1_needed_mm", area.worm_radius),
    ];
    item.numbers(&values, tol.get("contact_mm"), ledger);
    Ok(())
}

fn step_error(
    pair: &Pair,
    flank: Flank,
    item: &mut Expected<'_>,
    tol: Tolerances<'_>,
    ledger: &mut Ledger,
) -> Result<(), ContactError> {
    let given = ["w_2_mm", "K_ZV1", "feed_step_mm", "roll_step_mm"].map(|key| item.given(key, ledger));
    let [Some(w_2), Some(ratio), Some(feed_step), Some(roll_step)] = given else { return Ok(()) };
    let f = &pair.flanks[flank];
    // The files take the marks at the contact of zero feeds.
    let w_1 = f.worm_roll(w_2, 0.0, 0.0);
    let curvature = f.relative_curvature(w_1, w_2, ratio);
    let marks = [
        ("feed_mark_predicted_um", curvature.feed_mark(feed_step) / UM),
        ("facet_predicted_um", curvature.facet(roll_step) / UM),
    ];
    item.numbers(&marks, tol.get("coefficient"), ledger);
    let motion = pair.motion(MotionLaw::polynomial(0.0, vec![0.0, ratio]));
    let simulation = StepSimulation::new(pair, flank, &motion, w_2);
    for (key, height) in [
        ("feed_mark_simulated_um", simulation.feed_mark(feed_step) / UM),
        ("facet_simulated_um", simulation.facet(roll_step) / UM),
    ] {
        item.number(key, height, tol.get("residue_relative") * height.abs(), ledger);
    }
    Ok(())
}

/// Terms c0, c1, c2 of F_1C(X_1), um and mm.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LineFunction {
    c0: f64,
    c1_per_mm: f64,
    c2_per_mm2: f64,
}

fn modification(
    pair: &Pair,
    flank: Flank,
    item: &mut Expected<'_>,
    tol: Tolerances<'_>,
    ledger: &mut Ledger,
) -> Result<(), ContactError> {
    let f = &pair.flanks[flank];
    let keys = ["rho_1_deg", "K_ZV1", "z_V01_mm", "F_Ft1L_um_per_mm"];
    let constant = item.take("F_Ft1C_um").unwrap_or(&Value::Null);
    let constant = reference::read::<LineFunction>(item.case(), constant, ledger);
    let ([Some(rho_1), Some(ratio), Some(shift_origin), Some(linear)], Some(constant)) =
        (keys.map(|key| item.given(key, ledger)), constant)
    else {
        return Ok(());
    };
    // f_n1 = cos(beta_b1) (c0 + c1 X_1 + c2 X_1^2 + F_1L w_1) with X_1 = w_1 sin(rho_1) + z_1 cos(rho_1)
    let (sin, cos) = rho_1.to_radians().sin_cos();
    let x_1 = Polynomial2::linear(sin, cos, 0.0);
    let transverse = Polynomial2::linear(linear, 0.0, constant.c0)
        .add(&x_1.scale(constant.c1_per_mm))
        .add(&x_1.multiply(&x_1).scale(constant.c2_per_mm2));
    let normal = transverse.scale(UM * f.worm.base_helix_angle.cos());
    let thread = ModifiedThread::new(f.worm, &normal);
    let motion = pair.motion(MotionLaw::polynomial(0.0, vec![shift_origin, ratio]));
    let exact = ExactContact::new(pair, flank, &motion, &thread);
    let tolerance = tol.get("simulated_um");
    for mut point in item.objects("points", ledger) {
        if let (Some(w_2), Some(z_2)) = (point.given("w_2_mm", ledger), point.given("z_2_mm", ledger)) {
            let at = f.point_map(w_2, z_2, DiagonalRatio { ratio, shift_origin })?;
            let jet = normal.jet(at.w_1, at.z_1);
            let curvature = f.relative_curvature(at.w_1, w_2, ratio);
            let values = [
                ("f_n2_first_order_um", -jet.f / UM),
                ("second_order_um", curvature.second_order(jet.fu, jet.fv) / UM),
                ("f_n2_simulated_um", exact.solve(w_2, z_2)?.f_n / UM),
            ];
            point.numbers(&values, tolerance, ledger);
        }
        point.finish(ledger);
    }
    Ok(())
}

fn contact(pair: &Pair, mut item: Expected<'_>, tol: Tolerances<'_>, ledger: &mut Ledger) {
    let flank = item.given_flank(ledger);
    let given = ["z_V1_mm", "z_V2_mm", "w_2_mm"].map(|key| item.given(key, ledger));
    if let (Some(flank), [Some(shift), Some(feed), Some(w_2)]) = (flank, given) {
        let f = &pair.flanks[flank];
        let w_1 = f.worm_roll(w_2, shift, feed);
        let (z_1, z_2) = (f.worm_z(w_1, shift, feed), f.work_z(w_2, shift, feed));
        item.numbers(&[("w_1_mm", w_1), ("z_1_mm", z_1), ("z_2_mm", z_2)], tol.get("contact_mm"), ledger);
        let pitch = |teeth: f64| 2.0 * PI / teeth;
        let angles = [
            ("phi_1_mod_pitch_rad", f.worm_angle(w_1, z_1), pitch(pair.worm.tooth_count())),
            ("phi_2_mod_pitch_rad", f.work_angle(w_2, z_2), pitch(pair.work.tooth_count())),
        ];
        for (key, found, period) in angles {
            item.periodic(key, found, period, tol.get("phi_rad"), ledger);
        }
    }
    item.finish(ledger);
}
