//! Derivatives against differences of the exact values, for every surface, plain and eased.

use super::cases::{Sample, between, bevel_gear, chances, cylindrical_gear, offset, reference, samples};
use foundation::geometry::{
    EaseOff, EaseOffAmounts, Flank, Helicoid, Mirrored, Modified, OffsetBase, SphericalInvolute, Surface,
    SurfaceJet,
};
use nalgebra::Vector3;
use std::sync::Arc;

/// Fourth-order central difference of a vector function.
fn difference(f: impl Fn(f64) -> Vector3<f64>, step: f64) -> Vector3<f64> {
    ((f(step) - f(-step)) * 8.0 - (f(2.0 * step) - f(-2.0 * step))) / (12.0 * step)
}

fn close(name: &str, what: &str, found: &Vector3<f64>, expected: &Vector3<f64>, unit: f64) {
    let error = (found - expected).norm() / unit;
    assert!(error < 1e-8, "{name}: {what} = {found:?}, differences {expected:?}, {error:e}");
}

/// Shares of the box that keep the differences' steps inside it and off the knots of grids and splines.
const SHARES: [f64; 5] = [0.03, 0.29, 0.47, 0.71, 0.96];

fn places(sample: &Sample, mut look: impl FnMut(f64, f64, [f64; 2])) {
    let spans = [sample.heights, sample.lengths].map(|[from, to]| to - from);
    for p in SHARES {
        for q in SHARES {
            look(between(sample.heights, p), between(sample.lengths, q), spans);
        }
    }
}

fn check_jet(name: &str, surface: &dyn Surface, a: f64, b: f64, spans: [f64; 2]) {
    let at: SurfaceJet = surface.jet(a, b);
    assert!((at.normal.norm() - 1.0).abs() < 1e-14, "{name}: |n|");
    for (what, v) in [("S_a", at.by_height), ("S_b", at.by_length)] {
        let lean = at.normal.dot(&v).abs() / v.norm();
        assert!(lean < 1e-14, "{name}: n.{what} = {lean:e}");
    }
    assert!((at.point - surface.point(a, b)).norm() < 1e-12, "{name}: point");
    let steps = spans.map(|span| 1e-3 * span);
    let size = 1.0 / spans[0] + 1.0 / spans[1];
    let unit = at.by_height.norm().max(at.by_length.norm());
    let point_a = difference(|h| surface.point(a + h, b), steps[0]);
    let point_b = difference(|h| surface.point(a, b + h), steps[1]);
    close(name, "S_a", &at.by_height, &point_a, unit);
    close(name, "S_b", &at.by_length, &point_b, unit);
    let normal_a = difference(|h| surface.jet(a + h, b).normal, steps[0]);
    let normal_b = difference(|h| surface.jet(a, b + h).normal, steps[1]);
    close(name, "n_a", &at.normal_by_height, &normal_a, size);
    close(name, "n_b", &at.normal_by_length, &normal_b, size);
}

#[test]
fn jets_of_every_surface_agree_with_differences() {
    let samples = samples();
    assert!(samples.len() > 12);
    for sample in &samples {
        places(sample, |a, b, spans| check_jet(sample.name, &sample.surface, a, b, spans));
    }
}

#[test]
fn jets_of_every_eased_surface_agree_with_differences() {
    for sample in samples() {
        let eased = Modified::new(sample.surface.clone(), offset(sample.heights, sample.lengths));
        let mut moved = 0.0f64;
        places(&sample, |a, b, spans| {
            check_jet(sample.name, &eased, a, b, spans);
            let (plain, at) = (sample.surface.jet(a, b), eased.jet(a, b));
            assert!(plain.normal.dot(&at.normal) > 0.99, "{}: side", sample.name);
            let f = eased.offset().jet(a, b).f;
            assert!((at.point - plain.point - plain.normal * f).norm() < 1e-13, "{}", sample.name);
            moved = moved.max((at.normal - plain.normal).norm());
        });
        assert!(moved > 1e-5, "{}: the normal is the eased surface's own, {moved:e}", sample.name);
    }
}

#[test]
fn second_derivatives_of_points_and_normals_agree_with_differences() {
    for sample in samples() {
        let (name, surface) = (sample.name, &sample.surface);
        places(&sample, |a, b, spans| {
            let at = surface.second_order(a, b);
            let jet = surface.jet(a, b);
            for (what, found, expected) in [
                ("point", at.jet.point, jet.point),
                ("normal", at.jet.normal, jet.normal),
                ("n_a", at.jet.normal_by_height, jet.normal_by_height),
                ("n_b", at.jet.normal_by_length, jet.normal_by_length),
            ] {
                assert!((found - expected).norm() < 1e-12, "{name}: {what}");
            }
            let steps = spans.map(|span| 1e-3 * span);
            let size = (1.0 / spans[0] + 1.0 / spans[1]).powi(2);
            let unit =
                jet.by_height.norm().max(jet.by_length.norm()) * (1.0 + 1.0 / spans[0] + 1.0 / spans[1]);
            let by_a =
                |pick: fn(SurfaceJet) -> Vector3<f64>| difference(|h| pick(surface.jet(a + h, b)), steps[0]);
            let by_b =
                |pick: fn(SurfaceJet) -> Vector3<f64>| difference(|h| pick(surface.jet(a, b + h)), steps[1]);
            close(name, "S_aa", &at.point[0], &by_a(|j| j.by_height), unit);
            close(name, "S_ab", &at.point[1], &by_b(|j| j.by_height), unit);
            close(name, "S_ba", &at.point[1], &by_a(|j| j.by_length), unit);
            close(name, "S_bb", &at.point[2], &by_b(|j| j.by_length), unit);
            close(name, "n_aa", &at.normal[0], &by_a(|j| j.normal_by_height), size);
            close(name, "n_ab", &at.normal[1], &by_b(|j| j.normal_by_height), size);
            close(name, "n_ba", &at.normal[1], &by_a(|j| j.normal_by_length), size);
            close(name, "n_bb", &at.normal[2], &by_b(|j| j.normal_by_length), size);
        });
    }
}

#[test]
fn a_mirrored_helicoid_is_the_one_of_the_opposite_helix() {
    let reference = reference();
    let mut input = reference["cases"]["helical"]["input"].clone();
    let right = cylindrical_gear(&input);
    input["beta_deg"] = serde_json::json!(-25.0);
    let left = cylindrical_gear(&input);
    let mut chance = chances();
    for flank in Flank::BOTH {
        let mirrored = Mirrored::new(Helicoid::new(&right, flank), 0.0);
        let expected = Helicoid::new(&left, flank);
        for _ in 0..20 {
            let (w, z) = (between([5.0, 40.0], chance()), between([-20.0, 20.0], chance()));
            let (found, expected) = (mirrored.jet(w, z), expected.jet(w, z));
            for (a, b) in [
                (found.point, expected.point),
                (found.by_height, expected.by_height),
                (found.by_length, expected.by_length),
                (found.normal, expected.normal),
                (found.normal_by_height, expected.normal_by_height),
                (found.normal_by_length, expected.normal_by_length),
            ] {
                assert!((a - b).norm() < 1e-12, "{found:?} {expected:?}");
            }
        }
    }
    let apart = Mirrored::new(Helicoid::new(&right, Flank::Left), 12.0);
    assert_eq!(apart.point(20.0, 12.0), apart.base().point(20.0, 12.0), "the halves meet at z_0");
    assert_eq!(apart.point(20.0, 30.0).z, 30.0, "the length is the axial position");
}

#[test]
fn borders_of_the_surfaces_have_numbers() {
    let reference = reference();
    let gear = cylindrical_gear(&reference["cases"]["helical"]["input"]);
    let flank = Helicoid::new(&gear, Flank::Left);
    let zero = EaseOff::new(EaseOffAmounts::default(), [0.0, 40.0], [-20.0, 20.0]).unwrap();
    let eased = Modified::new(flank, Arc::new(zero));
    // At the base circle S_w vanishes: what the offset leaves alone keeps its normal.
    assert_eq!(eased.jet(0.0, 3.0), flank.jet(0.0, 3.0));
    let bevel = SphericalInvolute::new(&bevel_gear("straight_bevel"), Flank::Left);
    assert!(bevel.normal_speed_bounds([0.0, 0.5], [0.0, 50.0]).iter().all(|bound| bound.is_finite()));
    let spiral = SphericalInvolute::new(&bevel_gear("spiral_bevel"), Flank::Left);
    let [heights, lengths] = spiral.domain();
    for height in heights {
        for length in lengths {
            let at = spiral.second_order(height, length);
            let all = [at.jet.point, at.jet.normal, at.jet.by_length, at.jet.normal_by_length];
            assert!(all.iter().flatten().chain(at.normal.iter().flatten()).all(|x| x.is_finite()), "{at:?}");
        }
    }
}
