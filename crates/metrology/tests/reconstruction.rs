//! Surfaces from traces: what they see exactly, what they cannot see, refusals and warnings.

use foundation::numerics::equidistant;
use metrology::areal::{ArealDegree, ArealField, ArealFit, Reconstruction, Trace, Zeros};

fn field() -> ArealField {
    ArealField::new([9.0, 19.5], [-12.0, 12.0]).unwrap()
}

type Surface = dyn Fn(f64, f64) -> f64;

/// Traces of a surface over (u, v) at these u and v, each with a zero of its own.
fn traces(surface: &Surface, u: &[f64], v: &[f64], zero: f64, samples: usize) -> [Vec<Trace>; 2] {
    let field = field();
    let (w_of, z_of) = (|u: f64| 14.25 + 5.25 * u, |v: f64| 12.0 * v);
    let (along_w, along_z) = (equidistant(field.roll(), samples), equidistant(field.face(), samples));
    let profile = |(k, &v): (usize, &f64)| {
        let f: Vec<f64> = along_w.iter().map(|&w| surface(field.u(w), v) + zero * (1.0 + k as f64)).collect();
        Trace::new(z_of(v), &along_w, &f).unwrap()
    };
    let lead = |(k, &u): (usize, &f64)| {
        let f: Vec<f64> = along_z.iter().map(|&z| surface(u, field.v(z)) - zero * k as f64).collect();
        Trace::new(w_of(u), &along_z, &f).unwrap()
    };
    [v.iter().enumerate().map(profile).collect(), u.iter().enumerate().map(lead).collect()]
}

/// Largest difference between surface and reconstruction on a grid of samples, about the mean difference.
fn error(surface: &Surface, u: &[f64], v: &[f64]) -> f64 {
    let [profiles, leads] = traces(surface, u, v, 3.7, 401);
    let found = Reconstruction::new(profiles, leads, Zeros::Free).unwrap();
    let (w, z) = field().grid([9, 11]);
    let grid = found.on_grid(w.clone(), z.clone()).unwrap();
    let apart: Vec<f64> =
        (0..grid.f.len()).map(|k| grid.f[k] - surface(field().u(w[k / 11]), field().v(z[k % 11]))).collect();
    let mean = apart.iter().sum::<f64>() / apart.len() as f64;
    apart.iter().fold(0.0, |m: f64, x| m.max((x - mean).abs()))
}

const THREE: [f64; 3] = [-0.8, 0.0, 0.8];

#[test]
fn everything_of_its_class_is_seen_whatever_the_zeros() {
    // u^a h(v), a < 3, and v^b g(u), b < 3.
    let rich = |u: f64, v: f64| (1.0 + u - 2.0 * u * u) * (3.0 * v).sin() + (v + v * v) * (2.5 * u).exp();
    // Straight lines between 401 samples are the limit: h^2/8 times the curvature.
    assert!(error(&rich, &THREE, &THREE) < 3e-3, "{}", error(&rich, &THREE, &THREE));
    let second = |u: f64, v: f64| 2.0 * u - v + u * v + 0.0 * u * u;
    assert!(error(&second, &[0.0], &[-0.8, 0.8]) < 1e-12);
    assert!(error(&second, &[-0.8, 0.8], &[0.0]) < 1e-12);
}

#[test]
fn what_vanishes_on_all_traces_is_lost() {
    // One profile and one lead know nothing of the twist: S/4 at the corners.
    let twist = |u: f64, v: f64| -1.75 * u * v;
    assert!((error(&twist, &[0.0], &[0.0]) - 1.75).abs() < 1e-12);
    let [profiles, leads] = traces(&twist, &[0.0], &[0.0], 0.0, 61);
    let surface = Reconstruction::new(profiles, leads, Zeros::Free).unwrap();
    let (w, z) = field().grid([9, 11]);
    let grid = surface.on_grid(w, z).unwrap();
    let features = ArealFit::of_grid(&grid, &field(), ArealDegree::Second).unwrap().features();
    assert!(features.twist.abs() < 1e-12);
    let hidden = |u: f64, v: f64| {
        THREE.iter().map(|a| u - a).product::<f64>() * THREE.iter().map(|a| v - a).product::<f64>()
    };
    let largest = (0.36f64).powi(2);
    assert!((error(&hidden, &THREE, &THREE) - largest).abs() < 1e-4);
}

#[test]
fn the_mismatch_tells_traces_of_another_flank() {
    let surface = |u: f64, v: f64| 2.0 * u - v + u * v;
    let [mut profiles, leads] = traces(&surface, &THREE, &THREE, 3.7, 61);
    let good = Reconstruction::new(profiles.clone(), leads.clone(), Zeros::Free).unwrap();
    assert!(good.mismatch.unwrap().largest < 1e-12);
    assert_eq!(good.offsets()[0][1], 0.0);
    // The slope of one profile off by 2: nothing that a zero could take up.
    let along = equidistant(field().roll(), 61);
    let f: Vec<f64> = along.iter().map(|&w| surface(field().u(w), -0.8) + field().u(w)).collect();
    profiles[0] = Trace::new(-9.6, &along, &f).unwrap();
    let bad = Reconstruction::new(profiles.clone(), leads.clone(), Zeros::Free).unwrap().mismatch.unwrap();
    // Crossings at u = -0.8, 0, 0.8: the profile's u, less what the leads take up of it, in all nine.
    let left = [-0.8, 0.0, 0.8].map(|u: f64| (u * 2.0 / 3.0).powi(2) + 2.0 * (u / 3.0).powi(2));
    assert!((bad.rms - (left.iter().sum::<f64>() / 9.0).sqrt()).abs() < 1e-12, "{bad:?}");
    let absolute = Reconstruction::new(profiles, leads, Zeros::Absolute).unwrap();
    assert!(absolute.mismatch.is_none() && absolute.offsets().iter().flatten().all(|x| *x == 0.0));
}

#[test]
fn traces_without_a_surface_are_refused() {
    let surface = |u: f64, v: f64| u + v;
    let [profiles, leads] = traces(&surface, &THREE, &THREE, 0.0, 61);
    let code = |p: Vec<Trace>, h: Vec<Trace>| Reconstruction::new(p, h, Zeros::Free).unwrap_err().code();
    assert_eq!(code(Vec::new(), leads.clone()), "too-few-traces");
    assert_eq!(code(profiles.clone(), Vec::new()), "too-few-traces");
    let mut twice = profiles.clone();
    twice[2].position = twice[0].position + 5e-7;
    assert_eq!(code(twice, leads.clone()), "duplicate-trace");
    let mut twice = leads.clone();
    twice[1].position = twice[0].position;
    assert_eq!(code(profiles.clone(), twice), "duplicate-trace");
    let mut apart = leads.clone();
    apart[1].position = 25.0;
    assert_eq!(code(profiles, apart), "traces-do-not-cross");
    assert_eq!(Trace::new(0.0, &[1.0, 2.0], &[1.0]).unwrap_err().code(), "other-shape");
    assert_eq!(Trace::new(0.0, &[1.0, 2.0], &[1.0, f64::NAN]).unwrap_err().code(), "too-few-points");
    assert_eq!(Trace::new(0.0, &[1.0, f64::NAN], &[1.0, 2.0]).unwrap_err().code(), "invalid-number");
}

#[test]
fn a_surface_far_beyond_its_traces_is_warned_of() {
    let surface = |u: f64, v: f64| u + v;
    let outside = |u: &[f64], v: &[f64]| {
        let [profiles, leads] = traces(&surface, u, v, 0.0, 61);
        Reconstruction::new(profiles, leads, Zeros::Free).unwrap().outside(&field())
    };
    assert!(outside(&THREE, &THREE).is_empty());
    let found = outside(&THREE, &[-0.6, 0.6]);
    assert_eq!(found.len(), 1);
    assert!(found[0].along == "axial positions" && (found[0].share - 0.2).abs() < 1e-12);
    assert_eq!(outside(&[0.0], &[0.0]).len(), 2);
    // Beyond the ends of a trace there is no surface.
    let [profiles, leads] = traces(&surface, &THREE, &THREE, 0.0, 61);
    let surface = Reconstruction::new(profiles, leads, Zeros::Free).unwrap();
    assert!(surface.value(19.6, 0.0).is_none() && surface.value(19.5, 12.0).is_some());
    assert!(surface.on_grid(vec![8.0, 9.0], vec![0.0, 1.0]).unwrap().f[..2].iter().all(|f| f.is_nan()));
    assert_eq!(surface.on_grid(vec![9.0], vec![0.0, 1.0]).unwrap_err().code(), "other-shape");
}
