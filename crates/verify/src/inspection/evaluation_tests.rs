//! The checks of evaluations on small cases: right ones pass, and no changed expectation passes.

use super::super::VerifyOptions;
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use serde_json::{Value, json};

type Check = fn(&Reference<'_>, &Value, &mut Ledger);

/// A block of one case each.
fn cases() -> Vec<(Check, Value)> {
    // A step: 0, then 32 ones, then zeros up to a last one.
    let step: Vec<f64> = (0..101).map(|k| f64::from(u8::from((1..33).contains(&k) || k == 100))).collect();
    let range = |from: f64, to: f64| json!({"abscissa_first_mm": 0.0, "abscissa_last_mm": 10.0, "evaluation_start_mm": from, "evaluation_end_mm": to});
    let with_samples = |mut input: Value, f_um: Vec<f64>| {
        input["f_um"] = json!(f_um);
        input
    };
    vec![
        (
            super::traces,
            json!({
                "input": with_samples(range(0.0, 10.0), step),
                "expected": {
                    "n": 101, "undefined": 0, "F_um": 1.0, "ff_um": 2.190_448_456_610_367_2,
                    "fH_um": -1.190_448_456_610_367, "line_at_lo_um": 0.921_956_901_572_510_2,
                    "line_at_hi_um": -0.268_491_555_037_856_8, "crowning_um": -0.560_735_685_219_006_4,
                    "crowning_slope_um": -1.190_448_456_610_366_8, "form_parabola_um": 2.190_448_456_610_367,
                    "u_slope_factor": 0.341_294_940_570_381_2, "range_check_ff_above_F": true
                },
                "tolerance": {"um": 1e-9, "relative": 1e-9}
            }),
        ),
        (
            super::trace_errors,
            json!({"input": with_samples(range(2.0, 8.0), vec![1.0; 11]), "error": "TooFewSamples"}),
        ),
        (
            super::pitch,
            json!({
                "input": {"fp_um": [2.277, -1.87, -2.297, -5.003, -1.054, 4.439, 3.508], "k": null},
                "expected": {
                    "fp_max_um": 5.003, "fu_max_um": 5.493, "Rp_um": 9.442, "Fp_um": 10.224, "Fpk_um": 7.947, "k": 2,
                    "closure_um": 0.0, "index_min": 5, "index_max": 1, "harmonic1_um": 4.932_402_376_402_06,
                    "harmonic1_phase_deg": 59.262_202_160_832_786
                },
                "tolerance": {"um": 1e-9, "phase_deg": 1e-6}
            }),
        ),
        (
            super::thickness,
            json!({
                "input": {
                    "teeth": 24, "m_n_mm": 2.0, "alpha_n_deg": 20, "beta_deg": 20, "span_teeth": 4, "ball_mm": 3.5,
                    "profile_shift_x": 0.3
                },
                "expected": {
                    "W_k_mm": 21.877_919_870_728_093, "M_dK_mm": 57.037_771_139_199_165, "r_K_mm": 26.768_885_569_599_583,
                    "alpha_K_deg": 27.164_906_756_442_1, "x_from_rounded_span": 0.300_058_570_579_445_24,
                    "x_from_rounded_balls": 0.300_072_323_524_060_5
                },
                "tolerance": {"mm": 1e-9, "x": 1e-9}
            }),
        ),
        (
            super::tolerance_errors,
            json!({
                "input": {"teeth": 4, "m_n_mm": 3, "d_mm": 100, "b_mm": 30, "beta_deg": 0, "tolerance_class": 5},
                "error": "OutOfStandardRange"
            }),
        ),
        (
            super::classes,
            json!({
                "input": {
                    "values_um": {"fp": 4.2, "fHa": 3.9, "Fr": 12.0}, "teeth": 41, "m_n_mm": 2.5, "d_mm": 105.0,
                    "b_mm": 28.0, "beta_deg": 15.0
                },
                "expected": {"fp": 4, "fHa": 5, "Fr": 4, "overall": 5}
            }),
        ),
        (
            super::twist_from_traces,
            json!({
                "input": {
                    "fHalpha_low_um": 23.8, "fHalpha_high_um": 0.0, "z_low_mm": -6.5, "z_high_mm": 6.5, "L_b_mm": 15.0,
                    "fHbeta_inner_um": 0.8, "fHbeta_outer_um": -6.7, "w_inner_mm": 7.305, "w_outer_mm": 10.263,
                    "L_a_mm": 5.5518
                },
                "expected": {"S_alpha_um": 27.461_538_461_538_46, "S_beta_um": 14.076_572_008_113_59},
                "tolerance": {"um": 1e-9}
            }),
        ),
        (
            super::series,
            json!({
                "input": {
                    "values": [
                        6.91, 5.8, 6.22, 5.47, 3.91, 4.66, 7.33, 5.15, 5.55, 4.47, 5.41, 5.56, 5.71, 5.86, 5.3, 5.36,
                        5.92, 6.26, 5.79, 7.68
                    ],
                    "lower_limit": null, "upper_limit": 11.0
                },
                "expected": {
                    "n": 20, "mean": 5.716, "s": 0.896_433_870_517_243_5, "min": 3.91, "max": 7.68,
                    "sigma_moving_range": 0.755_158_627_530_534_4, "Cpk": 1.964_822_382_622_647_8,
                    "Cpk_lower95": 1.426_403_796_045_543_6, "outside_normal_ppm": 0.001_879_461_846_919_328_5,
                    "trend_per_part": 0.027_142_857_142_857_146, "trend_se": 0.035_137_100_410_783_46,
                    "trend_p": 0.449_852_441_775_722_9, "outside_3sigma_moving_range": 0
                },
                "tolerance": {"relative": 1e-9, "p": 1e-7}
            }),
        ),
    ]
}

fn failures(check: Check, case: &Value) -> Vec<String> {
    let options = VerifyOptions::default();
    let mut ledger = Ledger::default();
    check(&Reference::new(&Value::Null, &options), &json!([case]), &mut ledger);
    assert!(ledger.checks > 0 || !ledger.failures.is_empty(), "nothing was checked of {case}");
    ledger.failures.iter().map(|failure| format!("{failure:?}")).collect()
}

#[test]
fn right_cases_pass() {
    for (check, case) in cases() {
        assert_eq!(failures(check, &case), Vec::<String>::new());
    }
}

#[test]
fn every_changed_expectation_is_noticed() {
    let mut changes = 0;
    for (check, case) in cases() {
        for (key, value) in case["expected"].as_object().into_iter().flatten() {
            let mut changed = case.clone();
            changed["expected"][key] = match value {
                Value::Bool(flag) => json!(!flag),
                Value::Number(number) if number.is_i64() => json!(number.as_i64().unwrap() + 1),
                number => json!(number.as_f64().unwrap() * (1.0 + 1e-6) + 1e-7),
            };
            // Nothing is expected of a quantity that is not computed, but then it is unknown.
            assert!(!failures(check, &changed).is_empty(), "{key} of {case}");
            changes += 1;
        }
    }
    assert!(changes > 45, "{changes}");
}

#[test]
fn unknown_quantities_wrong_errors_and_missing_tolerances_are_noticed() {
    for (check, case) in cases() {
        let refused = case.get("error").is_some();
        let mut changed = case.clone();
        if refused {
            changed["error"] = json!("EmptyRange");
            assert!(!failures(check, &changed).is_empty(), "{case}");
            changed["error"] = json!("accepted");
        } else {
            changed["expected"]["colour"] = json!(1.0);
            assert!(!failures(check, &changed).is_empty(), "{case}");
            changed = case.clone();
            changed["input"]["colour"] = json!(1.0);
            assert!(!failures(check, &changed).is_empty(), "{case}");
            changed = case.clone();
            if changed.as_object_mut().unwrap().remove("tolerance").is_none() {
                continue;
            }
        }
        assert!(!failures(check, &changed).is_empty(), "{case}");
    }
}

#[test]
fn cases_that_should_be_refused_are_noticed_if_they_are_not() {
    let good =
        json!({"teeth": 30, "m_n_mm": 3, "d_mm": 100, "b_mm": 30, "beta_deg": 0, "tolerance_class": 5});
    let case = json!({"input": good, "error": "OutOfStandardRange"});
    assert!(failures(super::tolerance_errors, &case)[0].contains("accepted"));
}
