//! Coefficients, couplings, ratios of leads, tables and phase moves against the reference numbers of `tests/reference/70-gearbox.json`.

use electronic_gearbox::Sign;
use electronic_gearbox::coefficient::{Coefficient, CouplingSigns, Couplings, GearGeometry};
use electronic_gearbox::coupling::{CubicTable, EndRule, best_rational, dyadic, shortest_move, solve_slopes};
use serde_json::Value;

const REFERENCE: &str = include_str!("../../../tests/reference/70-gearbox.json");

/// The cases of a block: input, expected, tolerances.
fn block(name: &str) -> Vec<Value> {
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    let cases = reference[name].as_array().unwrap().clone();
    assert!(!cases.is_empty(), "{name}");
    cases
}

/// A number, or a number written as text.
fn number(value: &Value) -> f64 {
    match value {
        Value::String(text) => text.parse().unwrap(),
        other => other.as_f64().unwrap(),
    }
}

fn whole(value: &Value) -> i64 {
    match value {
        Value::String(text) => text.parse().unwrap(),
        other => other.as_i64().unwrap(),
    }
}

fn list(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

fn small(value: &Value) -> u32 {
    whole(value).try_into().unwrap()
}

fn gear(input: &Value, teeth: &str, helix: &str, pressure_angle_deg: f64) -> GearGeometry {
    let teeth = whole(&input[teeth]).try_into().unwrap();
    let helix = number(&input[helix]).to_radians();
    GearGeometry::new(number(&input["m_n_mm"]), teeth, helix, pressure_angle_deg.to_radians()).unwrap()
}

/// Every expected quantity of a case has to be among those found, within a relative tolerance of its own or the case's.
fn compare(case: &Value, found: &[(&str, f64)]) {
    let expected = case["expected"].as_object().unwrap();
    assert_eq!(expected.len(), found.len(), "{expected:?}");
    for (name, value) in found {
        let wanted = number(&expected[*name]);
        let tolerance = match *name {
            "b_error_rel" => number(&case["tolerance_b_error_abs"]),
            _ => number(&case["tolerance_rel"]) * wanted.abs(),
        };
        assert!((value - wanted).abs() <= tolerance, "{name}: {value} instead of {wanted}");
    }
}

#[test]
fn coefficients_are_those_of_the_reference() {
    for case in block("coefficients") {
        let input = &case["input"];
        let gear = gear(input, "z", "beta_deg", number(&input["alpha_n_deg"]));
        let pulses = small(&input["pulses_per_rev"]);
        let coefficient = Coefficient::new(&gear, pulses, number(&input["q_per_m"]), Sign::Plus).unwrap();
        assert_eq!(i64::from(coefficient.word()), whole(&case["expected"]["B18"]));
        compare(
            &case,
            &[
                ("lead_mm", gear.lead().unwrap()),
                ("b", coefficient.exact()),
                ("B18", f64::from(coefficient.word())),
                ("hand", coefficient.hand().as_f64()),
                ("b_error_rel", coefficient.relative_error()),
                ("flank_um_per_rad", gear.flank_per_angle()),
                ("flank_um_per_um_axial", gear.flank_per_axial()),
                ("flank_um_per_work_pulse", gear.flank_per_work_pulse(pulses).unwrap()),
            ],
        );
    }
}

#[test]
fn couplings_are_those_of_the_reference() {
    for case in block("couplings") {
        let input = &case["input"];
        let workpiece = gear(input, "z2", "beta2_deg", 20.0);
        let worm_helix = number(&input["beta1_deg"]).to_radians();
        let couplings =
            Couplings::new(&workpiece, small(&input["z1"]), worm_helix, CouplingSigns::default()).unwrap();
        compare(
            &case,
            &[
                ("dC_dB", couplings.worm_turn),
                ("dC_dZ_deg_per_mm", couplings.feed),
                ("dC_dV_deg_per_mm", couplings.shift),
            ],
        );
    }
}

#[test]
fn ratios_of_leads_are_those_of_the_reference() {
    for case in block("ratio_of_lead") {
        let (input, expected) = (&case["input"], &case["expected"]);
        let ratio = 360.0 * gear(input, "z", "beta_deg", 20.0).turns_per_millimetre();
        let binary = dyadic(ratio).unwrap();
        assert_eq!(i64::from(binary.shift()), whole(&expected["shift"]));
        let wanted = whole(&expected["n"]);
        let error = (binary.numerator() - wanted) as f64 / wanted as f64;
        assert!(error.abs() <= number(&case["tolerance_n_rel"]), "{error}");
        // Reading a number from JSON rounds in its last digit.
        let bound = binary.error_bound() / number(&expected["error_abs_upper"]);
        assert!((bound - 1.0).abs() < 1e-15, "{bound}");

        let best = best_rational(ratio, 1_000_000).unwrap();
        assert_eq!(best.ratio().numerator(), whole(&expected["rational_num"]));
        assert_eq!(best.ratio().denominator(), whole(&expected["rational_den"]));
        let wanted = number(&expected["rational_error"]);
        let tolerance = number(&case["tolerance_rational_error_rel"]) * wanted;
        assert!((best.error().abs() - wanted).abs() <= tolerance, "{best:?}");
    }
}

#[test]
fn tables_are_those_of_the_reference() {
    for case in block("table") {
        let (input, expected) = (&case["input"], &case["expected"]);
        let ends = match input["kind"].as_str().unwrap() {
            "natural" => EndRule::Natural,
            "periodic" => EndRule::Periodic,
            other => panic!("{other}"),
        };
        let (values, spacing) = (list(&input["y_um"]), number(&input["h_mm"]));
        let (mut slopes, mut workspace) = (vec![0.0; values.len()], vec![0.0; 2 * values.len()]);
        solve_slopes(&values, spacing, ends, &mut slopes, &mut workspace).unwrap();
        let table = CubicTable::new(number(&input["x0_mm"]), spacing, &values, &slopes, ends).unwrap();
        let places = list(&input["x_mm"]);
        let at = |of: &dyn Fn(f64) -> f64| places.iter().map(|&x| of(x)).collect::<Vec<f64>>();
        let found = [
            ("slope_um_per_mm", slopes.clone()),
            ("value_um", at(&|x| table.value(x).unwrap())),
            ("derivative_um_per_mm", at(&|x| table.derivative(x).unwrap())),
        ];
        assert_eq!(expected.as_object().unwrap().len(), found.len());
        for (name, found) in found {
            let wanted = list(&expected[name]);
            assert_eq!(found.len(), wanted.len(), "{name}");
            for (place, (found, wanted)) in found.iter().zip(&wanted).enumerate() {
                let error = (found - wanted).abs();
                assert!(
                    error <= number(&case["tolerance_abs"]),
                    "{name} {place}: {found} instead of {wanted}"
                );
            }
        }
    }
}

#[test]
fn phase_moves_are_those_of_the_reference() {
    for case in block("synchroniser") {
        let input = &case["input"];
        let [position, target, pitch] =
            ["c_now_deg", "c_target_deg", "tooth_pitch_deg"].map(|name| number(&input[name]));
        let way = shortest_move(position, target, pitch).unwrap();
        let wanted = number(&case["expected"]["move_deg"]);
        assert!((way - wanted).abs() <= number(&case["tolerance_abs"]), "{way} instead of {wanted}");
    }
}
