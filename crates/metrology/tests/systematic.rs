//! What all teeth share, what the clamping adds, what is scatter.

use metrology::systematic::{
    Decision, SystematicOptions, TeethVariance, harmonic_left_in_mean, systematic_test,
};
use std::f64::consts::TAU;

fn angles(teeth: usize) -> Vec<f64> {
    (0..teeth).map(|k| TAU * k as f64 / teeth as f64).collect()
}

fn scatter(k: usize) -> f64 {
    2.0 * (43758.5453 * (12.9898 * (k as f64 + 1.0)).sin()).rem_euclid(1.0) - 1.0
}

fn readings(teeth: usize, value: impl Fn(usize) -> f64, repeat: f64) -> Vec<Vec<f64>> {
    (0..teeth).map(|k| (0..3).map(|r| value(k) + repeat * scatter(7 * k + r)).collect()).collect()
}

#[test]
fn decisions_follow_what_was_put_in() {
    let options = SystematicOptions::new(9.0, 0.2);
    let decide = |value: &dyn Fn(usize) -> f64| {
        systematic_test(&readings(8, value, 0.1), Some(&angles(8)), &options).unwrap()
    };
    let shared = decide(&|k| 5.0 + 0.3 * scatter(k));
    assert_eq!(shared.decision, Decision::Correct);
    assert!((shared.common - 5.0).abs() < 0.3 && shared.share > 0.98 && !shared.harmonic_removed);
    let small = decide(&|k| 0.8 + 0.1 * scatter(k));
    assert_eq!(small.decision, Decision::BelowDeadBand);
    let nothing = decide(&|k| 4.0 * scatter(k * k));
    assert_eq!(nothing.decision, Decision::NotSystematic);
    assert!(nothing.variance.within.unwrap().p < 1e-6, "teeth differ");
    // Run-out alone, and run-out over a shared error that would be lost in it.
    let swing = |k: usize| 6.0 * (TAU * k as f64 / 8.0 - 0.4).cos();
    let clamped = decide(&|k| swing(k) + 0.1 * scatter(k));
    assert_eq!(clamped.decision, Decision::FirstHarmonic);
    let harmonic = clamped.harmonic.unwrap();
    assert!((harmonic.amplitude - 6.0).abs() < 0.2 && (harmonic.phase - 0.4).abs() < 0.05);
    let both = decide(&|k| 1.5 + swing(k) + 0.1 * scatter(k));
    assert_eq!((both.decision, both.freedom), (Decision::Correct, 5.0));
    let blind = systematic_test(&readings(8, |k| 1.5 + swing(k), 0.1), None, &options).unwrap();
    assert_eq!(blind.decision, Decision::NotSystematic);
}

#[test]
fn evenly_spaced_teeth_cancel_run_out_in_the_mean() {
    let of = |z: f64, teeth: &[f64]| {
        let angles: Vec<f64> = teeth.iter().map(|k| TAU * (k - 1.0) / z).collect();
        harmonic_left_in_mean(&angles)
    };
    assert!(of(51.0, &[1.0, 18.0, 35.0]) < 1e-12);
    assert!((of(52.0, &[1.0, 12.0, 22.0, 33.0, 44.0]) - 0.027).abs() < 5e-4);
    assert!(of(51.0, &[1.0, 2.0, 3.0]) > 0.99);
}

#[test]
fn readings_without_scatter_have_limits_and_no_nan() {
    let same = systematic_test(&vec![vec![2.0, 2.0]; 3], None, &SystematicOptions::new(9.0, 0.0)).unwrap();
    assert_eq!((same.decision, same.p, same.variance.within.unwrap().f), (Decision::Correct, 0.0, 0.0));
    let zero =
        systematic_test(&vec![vec![0.0]; 6], Some(&angles(6)), &SystematicOptions::new(9.0, 0.0)).unwrap();
    assert_eq!((zero.decision, zero.t, zero.p, zero.share), (Decision::NotSystematic, 0.0, 1.0, 0.0));
    let teeth = TeethVariance::new(&[vec![1.0, 1.0], vec![3.0, 3.0]]).unwrap().within.unwrap();
    assert!(teeth.f.is_infinite() && teeth.p == 0.0);
    // Angles that tell no harmonic from a mean: all the same.
    let heap =
        systematic_test(&readings(6, scatter, 0.1), Some(&[0.3; 6]), &SystematicOptions::new(9.0, 0.0));
    assert!(heap.unwrap().harmonic.is_none());
}

#[test]
fn what_cannot_be_judged_is_refused() {
    let options = SystematicOptions::new(9.0, 0.2);
    let code = |y: &[Vec<f64>], angles: Option<&[f64]>, options: &SystematicOptions| {
        systematic_test(y, angles, options).unwrap_err().code()
    };
    assert_eq!(code(&[], None, &options), "too-few-teeth");
    assert_eq!(code(&[vec![1.0, 2.0]], None, &options), "too-few-teeth");
    assert_eq!(code(&[vec![1.0], vec![1.0, 2.0]], None, &options), "other-shape");
    assert_eq!(code(&[vec![], vec![]], None, &options), "other-shape");
    assert_eq!(code(&[vec![1.0], vec![f64::NAN]], None, &options), "invalid-number");
    assert_eq!(code(&[vec![1.0], vec![2.0]], Some(&[0.0]), &options), "other-shape");
    assert_eq!(code(&[vec![1.0], vec![2.0]], Some(&[0.0, f64::INFINITY]), &options), "invalid-number");
    for bad in [
        SystematicOptions { tolerance: 0.0, ..options },
        SystematicOptions { calibration: -1.0, ..options },
        SystematicOptions { dead_band: 2.0, ..options },
        SystematicOptions { level: 1.0, ..options },
    ] {
        assert_eq!(code(&[vec![1.0], vec![2.0]], None, &bad), "invalid-number");
    }
}
