//! Target, produced and measured flank on one grid.

use metrology::Topography;
use metrology::areal::{ArealDegree, ArealField, Comparison, Difference};

fn field() -> ArealField {
    ArealField::new([9.0, 19.5], [-12.0, 12.0]).unwrap()
}

fn flank(surface: impl Fn(f64, f64) -> f64) -> Topography {
    let (w, z) = field().grid([25, 31]);
    let f = w.iter().flat_map(|&w| z.iter().map(move |&z| (w, z)));
    let f = f.map(|(w, z)| 1e-3 * surface(field().u(w), field().v(z))).collect();
    Topography::new(w, z, f).unwrap()
}

fn compare(produced: &Topography, measured: &Topography) -> Comparison {
    let target = flank(|_, v| -5.0 * v * v);
    Comparison::new([&target, produced, measured], &field(), ArealDegree::Second, 2e-3).unwrap()
}

#[test]
fn a_model_that_explains_the_part_is_told_from_one_that_does_not() {
    let produced = flank(|u, v| -5.0 * v * v + 3.0 * u * v - 2.0 * u);
    // As produced, but for thickness and a little waviness.
    let measured = flank(|u, v| -5.0 * v * v + 3.0 * u * v - 2.0 * u + 4.0 + 0.2 * (9.0 * u + 4.0 * v).sin());
    let found = compare(&produced, &measured);
    assert!(
        found.correlation.unwrap() > 0.99 && found.model_explains(0.5e-3) && !found.model_explains(0.1e-3)
    );
    // The mean is told by itself.
    assert!((found.measured.mean - 4e-3).abs() < 0.1e-3 && found.measured.largest < 5.5e-3);
    assert!((found.measured.fit.features().twist + 12e-3).abs() < 0.1e-3);
    assert!((found.measured.fit.features().profile_slope + 4e-3).abs() < 0.3e-3);
    assert_eq!(found.model.within_tolerance, 1.0);
    assert!(found.measured.within_tolerance < 0.9 && found.measured.within_tolerance > 0.5);
    assert!(found.measured.fit.explained_share > 0.98);
    // Another error than the model predicts.
    let other = compare(&produced, &flank(|u, v| -5.0 * v * v + 3.0 * v - u * v));
    assert!(other.correlation.unwrap() < 0.5 && !other.model_explains(1.0));
    // A model that predicts no deviation has nothing to correlate with.
    let ideal = flank(|_, v| -5.0 * v * v);
    assert!(compare(&ideal, &measured).correlation.is_none());
}

#[test]
fn gaps_are_left_out_and_other_grids_refused() {
    let produced = flank(|u, _| u);
    let mut measured = flank(|u, v| u + 0.1 * v);
    measured.f[5] = f64::NAN;
    let found = compare(&produced, &measured);
    assert_eq!(found.measured.fit.points, 25 * 31 - 1);
    assert!(found.correlation.unwrap().is_finite() && found.model.rms.is_finite());
    let mut other = measured.clone();
    other.w[0] -= 0.1;
    let refused =
        Comparison::new([&produced, &produced, &other], &field(), ArealDegree::Second, 2e-3).unwrap_err();
    assert_eq!(refused.code(), "other-shape");
    let refused = Difference::new(&produced, &field(), ArealDegree::Second, 0.0).unwrap_err();
    assert_eq!(refused.code(), "invalid-number");
}
