//! Areal fits: features of known surfaces, both ways of fitting, uncertainties, refusals.

use metrology::Topography;
use metrology::areal::{ArealDegree, ArealError, ArealField, ArealFit, ArealPoint};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

const COEFFICIENTS: [f64; 10] = [1.0, 2.0, -3.0, -2.0, -1.75, -3.5, 0.4, -0.3, 0.2, 0.1];

fn field() -> ArealField {
    ArealField::new([9.0, 19.5], [-12.0, 12.0]).unwrap()
}

/// Sum of Legendre products, written out.
fn surface(u: f64, v: f64, terms: usize) -> f64 {
    let p = |x: f64| [1.0, x, 1.5 * x * x - 0.5, 2.5 * x * x * x - 1.5 * x];
    let (p, q) = (p(u), p(v));
    let places = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)];
    places.iter().zip(COEFFICIENTS).take(terms).map(|(&(i, j), a)| a * p[i] * q[j]).sum()
}

fn on_grid(w: &[f64], z: &[f64], terms: usize, noise: impl FnMut() -> f64) -> Topography {
    let (field, mut noise) = (field(), noise);
    let values = w.iter().flat_map(|&w| z.iter().map(move |&z| (w, z)));
    let f = values.map(|(w, z)| surface(field.u(w), field.v(z), terms) + noise()).collect();
    Topography::new(w.to_vec(), z.to_vec(), f).unwrap()
}

fn points(grid: &Topography) -> Vec<ArealPoint> {
    let n = grid.z.len();
    let at = |k: usize| ArealPoint { w: grid.w[k / n], z: grid.z[k % n], f: grid.f[k], weight: 1.0 };
    (0..grid.f.len()).map(at).collect()
}

#[test]
fn features_of_scattered_points_are_those_of_their_surface() {
    let field = field();
    let scattered: Vec<ArealPoint> = (0..60)
        .map(|k| {
            let k = f64::from(k);
            let (w, z) = (9.0 + 10.5 * (0.618 * k).fract(), -12.0 + 24.0 * (0.414 * k + 0.1).fract());
            ArealPoint { w, z, f: surface(field.u(w), field.v(z), 10), weight: 1.0 + (0.3 * k).fract() }
        })
        .collect();
    let fit = ArealFit::of_points(&scattered, &field, ArealDegree::Third).unwrap();
    for (found, wanted) in fit.coefficients().iter().zip(COEFFICIENTS) {
        assert!((found - wanted).abs() < 1e-12, "{found} {wanted}");
    }
    let f = fit.features();
    let wanted = [1.0, 4.0, -6.0, 3.0, 5.25, 7.0];
    for (found, wanted) in f.values().iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-12, "{f:?}");
    }
    assert!(fit.residual_rms < 1e-12 && fit.form < 1e-11 && fit.explained_share > 1.0 - 1e-12);
    assert_eq!(fit.degree().order(), 3);
}

#[test]
fn orthogonal_polynomials_give_the_same_fit_as_householder() {
    // Uneven lines, noise, both degrees.
    let w: Vec<f64> = (0..14).map(|i| 9.0 + 10.5 * (f64::from(i) / 13.0).powf(1.4)).collect();
    let z: Vec<f64> = (0..11).map(|j| -11.0 + 22.5 * (f64::from(j) / 10.0).powf(0.8)).collect();
    let mut k = 0.0;
    let grid = on_grid(&w, &z, 10, || {
        k += 1.0;
        0.3 * f64::sin(k * k)
    });
    for degree in [ArealDegree::Second, ArealDegree::Third] {
        let tensor = ArealFit::of_grid(&grid, &field(), degree).unwrap();
        let plain = ArealFit::of_points(&points(&grid), &field(), degree).unwrap();
        for (a, b) in tensor.coefficients().iter().zip(plain.coefficients()) {
            assert!((a - b).abs() < 1e-12, "{a} {b}");
        }
        for (a, b) in tensor.uncertainties(1.0).values().iter().zip(plain.uncertainties(1.0).values()) {
            assert!((a - b).abs() < 1e-12, "{a} {b}");
        }
    }
    // A gap sends the grid the other way; without noise nothing changes but the number of points.
    let mut holed = on_grid(&w, &z, 6, || 0.0);
    holed.f[17] = f64::NAN;
    let fit = ArealFit::of_grid(&holed, &field(), ArealDegree::Second).unwrap();
    assert_eq!(fit.points, 14 * 11 - 1);
    assert!((fit.features().twist - 7.0).abs() < 1e-12);
}

#[test]
fn uncertainties_on_grids_are_those_of_the_formulas() {
    let factors = [1.0, 2.0 * 3f64.sqrt(), 2.0 * 3f64.sqrt(), 1.5 * 5f64.sqrt(), 1.5 * 5f64.sqrt(), 12.0];
    let at = |n: usize| {
        let (w, z) = field().grid([n, n]);
        let fit = ArealFit::of_grid(&on_grid(&w, &z, 6, || 0.0), &field(), ArealDegree::Second).unwrap();
        let u = fit.uncertainties(1.0).values();
        std::array::from_fn::<f64, 6, _>(|k| u[k] * n as f64 / factors[k])
    };
    let small = at(8);
    for (k, factor) in [(0, 1.063), (1, 0.882), (2, 0.882), (3, 0.797), (4, 0.797), (5, 0.778)] {
        assert!((small[k] - factor).abs() < 1e-3, "{k}: {}", small[k]);
    }
    assert!(at(400).iter().all(|share| (share - 1.0).abs() < 0.01), "{:?}", at(400));
}

#[test]
fn features_scatter_as_their_uncertainties_say() {
    let (w, z) = field().grid([9, 13]);
    let (sigma, draws) = (0.4, 1500);
    let mut random = ChaCha8Rng::seed_from_u64(85);
    let mut squares = [0.0; 6];
    let wanted = [1.0, 4.0, -6.0, 3.0, 5.25, 7.0];
    let mut stated = [0.0; 6];
    for _ in 0..draws {
        let grid = on_grid(&w, &z, 6, || {
            let x: f64 = StandardNormal.sample(&mut random);
            sigma * x
        });
        let fit = ArealFit::of_grid(&grid, &field(), ArealDegree::Second).unwrap();
        let found = fit.features().values();
        (0..6).for_each(|k| squares[k] += (found[k] - wanted[k]).powi(2) / f64::from(draws));
        stated = fit.uncertainties(sigma).values();
    }
    for k in 0..6 {
        let ratio = squares[k].sqrt() / stated[k];
        assert!((0.94..1.06).contains(&ratio), "{k}: {ratio}");
    }
}

#[test]
fn what_determines_no_surface_is_refused() {
    let field = field();
    let code = |result: Result<ArealFit, ArealError>| result.unwrap_err().code();
    let at = |w: f64, z: f64| ArealPoint { w, z, f: 1.0, weight: 1.0 };
    let few: Vec<ArealPoint> = (0..5).map(|k| at(10.0 + f64::from(k), f64::from(k * k) - 8.0)).collect();
    assert_eq!(code(ArealFit::of_points(&few, &field, ArealDegree::Second)), "too-few-points");
    // Two profiles tell nothing of the helix crowning, whatever their number of points.
    let two: Vec<ArealPoint> =
        (0..40).map(|k| at(9.0 + 0.25 * f64::from(k / 2), if k % 2 == 0 { -9.0 } else { 9.0 })).collect();
    assert_eq!(code(ArealFit::of_points(&two, &field, ArealDegree::Second)), "degenerate-field");
    let (w, z) = field.grid([20, 2]);
    let grid = on_grid(&w, &z, 6, || 0.0);
    assert_eq!(code(ArealFit::of_grid(&grid, &field, ArealDegree::Second)), "degenerate-field");
    // NaN values are gaps: nothing but gaps is too few points.
    let gaps: Vec<ArealPoint> =
        (0..40).map(|k| ArealPoint { f: f64::NAN, ..at(f64::from(k), 0.0) }).collect();
    assert_eq!(code(ArealFit::of_points(&gaps, &field, ArealDegree::Second)), "too-few-points");
    let mut bad = points(&on_grid(&field.grid([4, 4]).0, &field.grid([4, 4]).1, 6, || 0.0));
    bad[3].weight = 0.0;
    assert_eq!(code(ArealFit::of_points(&bad, &field, ArealDegree::Second)), "invalid-number");
    bad[3] = ArealPoint { w: f64::INFINITY, weight: 1.0, ..bad[3] };
    assert_eq!(code(ArealFit::of_points(&bad, &field, ArealDegree::Second)), "invalid-number");
    for (roll, face) in [([9.0, 9.0], [0.0, 1.0]), ([1.0, 2.0], [3.0, 2.0]), ([f64::NAN, 2.0], [0.0, 1.0])] {
        let error = ArealField::new(roll, face).unwrap_err();
        assert_eq!(error.code(), "empty-range");
        assert!(!error.way_out().is_empty() && !error.to_string().is_empty());
    }
    let other = ArealField::new([19.5, 30.0], [-12.0, 12.0]).unwrap();
    assert_eq!(field.common(&other).unwrap_err().code(), "empty-range");
    let other = ArealField::new([10.0, 30.0], [-20.0, 5.0]).unwrap();
    assert_eq!(field.common(&other).unwrap(), ArealField::new([10.0, 19.5], [-12.0, 5.0]).unwrap());
}
