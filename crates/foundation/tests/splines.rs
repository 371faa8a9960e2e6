//! Splines and polynomials: reproduction, continuity, derivatives, refusals.

use foundation::numerics::{CubicSpline, Jet2, Polynomial2, SplineError, TensorSpline, fit_tensor_spline};

const UNEVEN: [f64; 7] = [-2.0, -1.4, -0.1, 0.3, 1.9, 2.0, 3.5];

fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * (1.0 + a.abs().max(b.abs())), "{a} against {b}");
}

fn close_jets(a: Jet2, b: Jet2, tolerance: f64) {
    let list = |j: Jet2| [j.f, j.fu, j.fv, j.fuu, j.fuv, j.fvv];
    for (x, y) in list(a).into_iter().zip(list(b)) {
        close(x, y, tolerance);
    }
}

#[test]
fn a_cubic_is_reproduced_with_all_derivatives_also_beyond_the_knots() {
    let cubic =
        |x: f64| [2.0 - x + 0.5 * x * x - 0.3 * x * x * x, -1.0 + x - 0.9 * x * x, 1.0 - 1.8 * x, -1.8];
    for knots in [&UNEVEN[..], &UNEVEN[..4], &UNEVEN[..5], &[0.0, 0.5, 1.0, 1.5, 2.0, 2.5]] {
        let values: Vec<f64> = knots.iter().map(|x| cubic(*x)[0]).collect();
        let spline = CubicSpline::new(knots, &values).unwrap();
        for i in 0..=60 {
            let x = -4.0 + 0.15 * f64::from(i);
            for (found, expected) in spline.derivatives(x).into_iter().zip(cubic(x)) {
                close(found, expected, 1e-11);
            }
            close(spline.value(x), cubic(x)[0], 1e-12);
        }
    }
}

#[test]
fn a_spline_passes_through_its_values_and_is_c2_with_not_a_knot_ends() {
    let values = [0.4, -1.0, 2.0, 0.3, 0.0, 5.0, -2.0];
    let spline = CubicSpline::new(&UNEVEN, &values).unwrap();
    assert_eq!(spline.domain(), [-2.0, 3.5]);
    for (x, y) in UNEVEN.iter().zip(values) {
        close(spline.value(*x), y, 1e-12);
    }
    let step = 1e-9;
    for i in 1..6 {
        let (left, right) = (spline.derivatives(UNEVEN[i] - step), spline.derivatives(UNEVEN[i]));
        for k in 0..3 {
            close(left[k] + step * left[k + 1], right[k], 1e-9);
        }
        let jump = (left[3] - right[3]).abs();
        if i == 1 || i == 5 {
            assert!(jump < 1e-8 * right[3].abs(), "knot {i} is felt: {jump}");
        } else {
            assert!(jump > 1e-3);
        }
    }
}

#[test]
fn a_bicubic_is_reproduced_with_all_derivatives() {
    let bicubic = Polynomial2::from_terms([
        (0, 0, 1.0),
        (1, 0, -0.4),
        (3, 0, 0.2),
        (0, 3, -0.1),
        (2, 2, 0.3),
        (3, 3, 0.05),
        (1, 2, -0.7),
    ]);
    let even: Vec<f64> = (0..6).map(|i| 0.8 * f64::from(i)).collect();
    let table = |u: &[f64], v: &[f64]| -> Vec<Vec<f64>> {
        u.iter().map(|a| v.iter().map(|b| bicubic.value(*a, *b)).collect()).collect()
    };
    for (u, v) in [(&UNEVEN[..], &even[..]), (&even[..], &UNEVEN[..]), (&even[..4], &UNEVEN[..4])] {
        let spline = TensorSpline::new(u, v, &table(u, v)).unwrap();
        for i in -3..=30 {
            for j in -3..=30 {
                let (a, b) = (0.13 * f64::from(i), 0.11 * f64::from(j));
                close_jets(spline.jet(a, b), bicubic.jet(a, b), 1e-9);
                close(spline.value(a, b), bicubic.value(a, b), 1e-11);
            }
        }
    }
}

#[test]
fn a_tensor_spline_is_c2_across_its_cells() {
    let v = [0.0, 1.0, 2.5, 3.0, 4.0];
    let table: Vec<Vec<f64>> =
        UNEVEN.iter().map(|a| v.iter().map(|b| (3.0 * a + b).sin() + a * b).collect()).collect();
    let spline = TensorSpline::new(&UNEVEN, &v, &table).unwrap();
    assert_eq!(spline.domain(), [[-2.0, 3.5], [0.0, 4.0]]);
    for (i, a) in UNEVEN.iter().enumerate() {
        for (j, b) in v.iter().enumerate() {
            close(spline.value(*a, *b), table[i][j], 1e-12);
            let [low, high] = [-1e-11, 1e-11].map(|step| spline.jet(a + step, b + step));
            close_jets(low, high, 1e-7);
        }
    }
}

#[test]
fn bad_knots_and_values_are_refused() {
    let ok = [0.0, 1.0, 2.0, 3.0];
    let new = |x: &[f64], y: &[f64]| CubicSpline::new(x, y).unwrap_err();
    assert_eq!(new(&ok[..3], &ok[..3]), SplineError::TooFewKnots { axis: 0, count: 3 });
    assert_eq!(new(&[0.0, 1.0, 1.0, 2.0], &ok), SplineError::NotAscending { axis: 0, index: 2 });
    assert_eq!(new(&[0.0, 1.0, f64::NAN, 2.0], &ok), SplineError::KnotNotFinite { axis: 0, index: 2 });
    assert_eq!(new(&ok, &ok[..2]), SplineError::ShapeMismatch { expected: 4, found: 2 });
    assert!(matches!(new(&ok, &[0.0, f64::INFINITY, 0.0, 0.0]), SplineError::ValueNotFinite { .. }));
    assert!(matches!(new(&ok, &[0.0, 1e308, -1e308, 0.0]), SplineError::ValueNotFinite { .. }));

    let table = vec![vec![0.0; 4]; 4];
    let tensor = |u: &[f64], v: &[f64], f: &[Vec<f64>]| TensorSpline::new(u, v, f).unwrap_err();
    assert_eq!(tensor(&ok, &ok[..2], &table), SplineError::TooFewKnots { axis: 1, count: 2 });
    assert_eq!(tensor(&[3.0, 2.0, 1.0, 0.0], &ok, &table), SplineError::NotAscending { axis: 0, index: 1 });
    assert_eq!(tensor(&ok, &ok, &table[..3]), SplineError::ShapeMismatch { expected: 16, found: 12 });
    let mut bad = table.clone();
    bad[1][2] = f64::NAN;
    assert_eq!(tensor(&ok, &ok, &bad), SplineError::ValueNotFinite { index: 6 });
}

#[test]
fn a_fitted_spline_reproduces_a_bicubic_and_refuses_a_cloud_with_holes() {
    let bicubic = Polynomial2::from_terms([(0, 0, 1.0), (3, 1, -0.4), (1, 3, 0.2), (2, 2, 0.1)]);
    let points: Vec<[f64; 3]> = (0..400)
        .map(|i| {
            // A low-discrepancy scatter over [0, 3] x [-1, 1].
            let u = 3.0 * (f64::from(i) * 0.754_878).fract();
            let v = 2.0 * (f64::from(i) * 0.569_840).fract() - 1.0;
            [u, v, bicubic.value(u, v)]
        })
        .collect();
    let spline = fit_tensor_spline(&points, [4, 3]).unwrap();
    for [u, v, _] in &points {
        close_jets(spline.jet(*u, *v), bicubic.jet(*u, *v), 1e-8);
    }
    let corner: Vec<_> = points.iter().copied().filter(|p| p[0] < 0.5 || p[0] > 2.9).collect();
    assert!(matches!(fit_tensor_spline(&corner, [6, 1]), Err(SplineError::RankDeficient { .. })));
    assert_eq!(
        fit_tensor_spline(&points[..15], [1, 1]),
        Err(SplineError::RankDeficient { points: 15, coefficients: 16 })
    );
}

#[test]
fn polynomials_form_a_ring_and_can_be_moved() {
    let p = Polynomial2::from_terms([(0, 0, 1.0), (2, 1, 0.5), (0, 3, -2.0), (2, 1, 0.25)]);
    let q = Polynomial2::linear(2.0, -1.0, 0.5);
    assert_eq!(p.coefficient(2, 1), 0.75);
    assert_eq!(p.coefficient(9, 9), 0.0);
    assert_eq!(p.degree(), 3);
    for (u, v) in [(0.3, -1.2), (2.0, 0.7), (-1.5, 1.1)] {
        let (a, b) = (p.jet(u, v), q.jet(u, v));
        close_jets(p.add(&q).jet(u, v), a + b, 1e-13);
        close_jets(p.multiply(&q).jet(u, v), a * b, 1e-13);
        close_jets(p.scale(-3.0).jet(u, v), a * -3.0, 1e-13);
        close_jets(p.shifted(0.4, -0.9).jet(u, v), p.jet(u + 0.4, v - 0.9), 1e-13);
        close_jets(p.mirrored_v().jet(u, v), p.jet(u, -v).mirrored_v(), 1e-13);
        close(p.value(u, v), 1.0 + 0.75 * u * u * v - 2.0 * v * v * v, 1e-13);
        close(a.fuv, 1.5 * u, 1e-13);
        close(a.fvv, -12.0 * v, 1e-13);
        close(a.fuu, 1.5 * v, 1e-13);
    }
}
