//! 10-gears: base data, points, deviations, thickness and its measures, and the refusals of impossible bodies.

use super::bodies::{BaseTolerances, Body, base_data};
use super::expected::{Expected, numbers};
use super::ledger::Ledger;
use super::reference::{self, Reference, Tolerances};
use foundation::geometry::Gear;
use nalgebra::Vector3;
use serde_json::Value;

const UM: f64 = 1e-3;

/// Block `cases`.
pub(super) fn cases(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check("cases", block, file.tolerances(), ledger);
}

/// The same cases as block `gears` of a contact file, with tolerances of their own.
pub(super) fn gears_block(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check("gears", block, Tolerances::table(&file.root["gears_tolerance"]), ledger);
}

fn check(block_name: &str, block: &Value, tol: Tolerances<'_>, ledger: &mut Ledger) {
    for mut case in reference::cases(block_name, block, ledger) {
        let Some(body) = reference::read::<Body>(&case.name, case.input, ledger) else { continue };
        match body.gear() {
            Ok(gear) => one(&gear, &mut case.expected, tol, ledger),
            Err(error) => case.expected.refused(&error, ledger),
        }
        case.expected.finish(ledger);
    }
}

fn one(gear: &Gear, expected: &mut Expected<'_>, tol: Tolerances<'_>, ledger: &mut Ledger) {
    let (length, angle) = (tol.get("length_mm"), tol.get("angle_deg"));
    // Slopes and rotations per length are pure numbers of geometry, held like direction cosines.
    let base = BaseTolerances { length, angle_deg: angle, ratio: tol.get("normal") };
    base_data(expected, gear, base, ledger);
    expected.optional("r_pointed_mm", gear.pointed_radius(0.0), length, ledger);
    for item in expected.objects("points", ledger) {
        point(gear, item, tol, ledger);
    }
    for item in expected.objects("signed_deviation", ledger) {
        deviation(gear, item, tol, ledger);
    }
    for mut item in expected.objects("thickness", ledger) {
        if let (Some(r), Some(z)) = (item.given("r_mm", ledger), item.given("z_mm", ledger)) {
            match gear.transverse_thickness(r, z) {
                Ok(s_t) => item.number("s_t_mm", s_t, length, ledger),
                Err(error) => item.refused(&error, ledger),
            }
        }
        item.finish(ledger);
    }
    for mut item in expected.objects("over_balls", ledger) {
        if let (Some(ball), Some(z)) = (item.given("D_M_mm", ledger), item.given("z_mm", ledger)) {
            match gear.over_balls(ball, z) {
                Ok(m) => {
                    let values = [
                        ("r_K_mm", m.centre_radius),
                        ("M_mm", m.size),
                        ("w_left_mm", m.contact_w.left),
                        ("w_right_mm", m.contact_w.right),
                        ("z_left_mm", m.contact_z.left),
                        ("z_right_mm", m.contact_z.right),
                    ];
                    item.numbers(&values, length, ledger);
                }
                Err(error) => item.refused(&error, ledger),
            }
        }
        item.finish(ledger);
    }
    for mut item in expected.objects("span", ledger) {
        if let Some(k) = item.given("k", ledger) {
            let whole = k.fract() == 0.0 && (1.0..1e6).contains(&k);
            match gear.span(if whole { k as u32 } else { 0 }) {
                _ if !whole => item.refused(&"k must be a whole number of teeth", ledger),
                Ok(m) => {
                    let values = [
                        ("W_mm", m.length),
                        ("r_contact_mm", m.contact_radius),
                        ("b_min_mm", m.least_face_width),
                    ];
                    item.numbers(&values, length, ledger);
                }
                Err(error) => item.refused(&error, ledger),
            }
        }
        item.finish(ledger);
    }
    for mut item in expected.objects("rack_roll", ledger) {
        let given = (item.given_flank(ledger), item.given("h_mm", ledger), item.given("z_mm", ledger));
        if let (Some(flank), Some(h), Some(z)) = given {
            item.number("w_mm", gear.roll_of_rack_height(flank, h, z), length, ledger);
        }
        item.finish(ledger);
    }
}

fn point(gear: &Gear, mut item: Expected<'_>, tol: Tolerances<'_>, ledger: &mut Ledger) {
    let given = (item.given_flank(ledger), item.given("w_mm", ledger), item.given("z_mm", ledger));
    if let (Some(flank), Some(w), Some(z)) = given {
        let f = gear.flank(flank);
        let frame = f.frame(w, z);
        let (length, normal, kappa) = (tol.get("length_mm"), tol.get("normal"), tol.get("kappa_per_mm"));
        item.number("r_mm", f.radius(w), length, ledger);
        item.number("roll_angle_deg", f.roll_angle(w).to_degrees(), tol.get("angle_deg"), ledger);
        item.list("P_mm", f.point_in(&frame, w, z).as_slice(), length, ledger);
        item.list("n", frame.n.as_slice(), normal, ledger);
        let [kappa_1, kappa_2] = f.principal_curvatures(w);
        item.numbers(&[("kappa_1_per_mm", kappa_1), ("kappa_2_per_mm", kappa_2)], kappa, ledger);
        item.list("dir_1", frame.e_r.as_slice(), normal, ledger);
    }
    item.finish(ledger);
}

/// X against the flank, and back: the foot with its deviation must give X again.
fn deviation(gear: &Gear, mut item: Expected<'_>, tol: Tolerances<'_>, ledger: &mut Ledger) {
    let Some(flank) = item.given_flank(ledger) else { return };
    let Some(x) = item.take("X_mm").and_then(numbers).filter(|x| x.len() == 3) else {
        ledger.fail(item.case(), "signed_deviation.X_mm", Value::Null, "three coordinates are needed".into());
        return;
    };
    let x = Vector3::from_column_slice(&x);
    let f = gear.flank(flank);
    let d = f.deviation(&x);
    let again = f.point(d.w, d.z) + f.normal(d.w, d.z) * d.f_n;
    // The nearest tooth need not be the one whose space is centred on +y.
    let pitch = 2.0 * std::f64::consts::PI / gear.tooth_count();
    let turn = again.x.atan2(again.y) - x.x.atan2(x.y);
    let apart = (turned(&again, pitch * (turn / pitch).round()) - x).norm();
    ledger.number(item.case(), "signed_deviation round trip", 0.0, apart, tol.get("length_mm"));
    item.number("f_n_um", d.f_n / UM, tol.get("f_n_um"), ledger);
    item.numbers(&[("w_mm", d.w), ("z_mm", d.z)], tol.get("length_mm"), ledger);
    item.finish(ledger);
}

fn turned(p: &Vector3<f64>, angle: f64) -> Vector3<f64> {
    let (s, c) = angle.sin_cos();
    Vector3::new(c * p.x - s * p.y, s * p.x + c * p.y, p.z)
}

/// Block `errors`: bodies that must be refused, with the name of the refusal.
pub(super) fn errors(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(list) = block.as_array() else {
        ledger.fail("errors", "errors", block.clone(), "a list is needed here".into());
        return;
    };
    for (k, item) in list.iter().enumerate() {
        let case = format!("errors[{k}]");
        let mut expected = Expected::new(&case, "", item, ledger);
        let input = expected.take("input").unwrap_or(&Value::Null);
        if let Some(body) = reference::read::<Body>(&case, input, ledger) {
            let found = match body.gear() {
                Ok(_) => Value::Null,
                Err(error) => Value::from(name_in_files(error.code())),
            };
            let wanted = expected.take("error").cloned().unwrap_or(Value::Null);
            ledger.equal(&case, "error", wanted, found);
        }
        expected.finish(ledger);
    }
}

/// The files' spelling of a code: snake case, and their own name for bad numbers.
fn name_in_files(code: &str) -> String {
    if code == "invalid-number" { "bad_input".into() } else { code.replace('-', "_") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_spelled_as_in_the_files() {
        assert_eq!(name_in_files("invalid-number"), "bad_input");
        assert_eq!(name_in_files("pressure-angle-not-positive"), "pressure_angle_not_positive");
    }
}
