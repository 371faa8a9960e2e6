//! Surfaces through grids of points of known flanks: passing through them, and the errors of the reference.

use super::cases::{Sample, between, bevel_gear, cylindrical_gear, number, reference, samples, surface};
use foundation::geometry::{Flank, GridSurface, Helicoid, NormalSide, Surface};
use foundation::numerics::{brent, equidistant};
use nalgebra::Vector3;

/// Point and tangent of the guide curve of a case at u (`docs/mathematics/milling.md#columns-and-rows`).
fn lead(case: &str, u: f64) -> [Vector3<f64>; 2] {
    let e_r = |angle: f64| Vector3::new(angle.sin(), angle.cos(), 0.0);
    if case == "helical" {
        let flank = Helicoid::new(&cylindrical_gear(&reference()["cases"][case]["input"]), Flank::Left);
        let (k, r_0) = (flank.twist(), flank.root_radius(1.25));
        let on = e_r(-k * u) * r_0;
        return [on + Vector3::z() * u, Vector3::new(-k * on.y, k * on.x, 1.0).normalize()];
    }
    let gear = bevel_gear(case);
    let (sin, cos) = gear.root_angle().sin_cos();
    let [turn, turn_rate, ..] = gear.line().derivatives(u);
    let (e_r, across) = (e_r(-turn), Vector3::new(turn.cos(), turn.sin(), 0.0));
    let along = e_r * sin + Vector3::z() * cos;
    [along * u, (along - across * (u * sin * turn_rate)).normalize()]
}

/// A grid over columns at equal steps of u with rows of equal arc length in the column planes
/// (`docs/mathematics/milling.md#columns-and-rows`).
fn columns(case: &str, [rows, columns]: [usize; 2], range: [f64; 2]) -> Vec<Vec<Vector3<f64>>> {
    let surface = surface(case);
    let case_data = &reference()["cases"][case];
    let heights = [number(&case_data["a_root"]), number(&case_data["a_tip"])];
    let mut grid = vec![Vec::new(); rows];
    for u in equidistant(range, columns) {
        let [c, t] = lead(case, u);
        let place = |a: f64| {
            let mut b = u;
            for _ in 0..60 {
                let jet = surface.jet(a, b);
                let step = (jet.point - c).dot(&t) / jet.by_length.dot(&t);
                b -= step;
                if step.abs() < 1e-13 * b.abs().max(1.0) {
                    break;
                }
            }
            b
        };
        let speed = |a: f64| {
            let jet = surface.jet(a, place(a));
            (jet.by_height - jet.by_length * (jet.by_height.dot(&t) / jet.by_length.dot(&t))).norm()
        };
        // Simpson's rule over fine steps from the root.
        let length = |to: f64| {
            let n = 60;
            let h = (to - heights[0]) / f64::from(n);
            let at = |i: i32| speed(heights[0] + h * f64::from(i));
            let inner: f64 = (1..n).map(|i| if i % 2 == 1 { 4.0 * at(i) } else { 2.0 * at(i) }).sum();
            h / 3.0 * (at(0) + inner + at(n))
        };
        let whole = length(heights[1]);
        for (i, row) in grid.iter_mut().enumerate() {
            let share = i as f64 / (rows - 1) as f64;
            let ends = [-share * whole, (1.0 - share) * whole];
            let a = brent(heights, ends, 1e-11, |a| Some(length(a) - share * whole)).unwrap();
            row.push(surface.point(a, place(a)));
        }
    }
    grid
}

#[test]
fn errors_against_the_flanks_are_those_of_the_reference() {
    let reference = reference();
    let items = reference["grid_surface"]["items"].as_array().unwrap();
    assert_eq!(items.len(), 4);
    for item in items {
        let case = item["case"].as_str().unwrap();
        let size = [0, 1].map(|i| number(&item["grid"][i]) as usize);
        let range = [number(&item["u_from_mm"]), number(&item["u_to_mm"])];
        let flank = surface(case);
        let case_data = &reference["cases"][case];
        let heights = [number(&case_data["a_root"]), number(&case_data["a_tip"])];
        // u grows along the rows and the height from row to row: S_a x S_b points into the material of a left flank.
        let grid = GridSurface::new(&columns(case, size, range), NormalSide::Against).unwrap();
        let (mut worst, mut angle) = (0.0f64, 0.0f64);
        let shares = equidistant([0.02, 0.98], 25);
        for &p in &shares {
            for &q in &shares {
                let jet = grid.jet(p, q);
                let [mut a, mut b] = [between(heights, p), between(range, q)];
                for _ in 0..30 {
                    let at = flank.jet(a, b);
                    let miss = jet.point - at.point;
                    let (s_a, s_b) = (at.by_height, at.by_length);
                    let (aa, ab, bb) = (s_a.dot(&s_a), s_a.dot(&s_b), s_b.dot(&s_b));
                    let (m_a, m_b) = (s_a.dot(&miss), s_b.dot(&miss));
                    a += (bb * m_a - ab * m_b) / (aa * bb - ab * ab);
                    b += (aa * m_b - ab * m_a) / (aa * bb - ab * ab);
                }
                let at = flank.jet(a, b);
                worst = worst.max(1e3 * (jet.point - at.point).dot(&at.normal).abs());
                let between = at.normal.cross(&jet.normal).norm().atan2(at.normal.dot(&jet.normal));
                angle = angle.max(between.to_degrees());
            }
        }
        let (um, degrees) = (number(&item["max_normal_error_um"]), number(&item["max_normal_angle_deg"]));
        assert!((worst - um).abs() < 1e-5, "{case} {size:?}: {worst} against {um} um");
        assert!((angle - degrees).abs() < 1e-6, "{case} {size:?}: {angle} against {degrees} deg");
    }
}

#[test]
fn a_grid_passes_through_its_points_with_the_side_of_the_caller() {
    for Sample { name, surface, heights, lengths } in samples() {
        let rows: Vec<Vec<Vector3<f64>>> = equidistant(heights, 6)
            .into_iter()
            .map(|a| equidistant(lengths, 5).into_iter().map(|b| surface.point(a, b)).collect())
            .collect();
        let [along, against] =
            [NormalSide::Along, NormalSide::Against].map(|side| GridSurface::new(&rows, side).unwrap());
        for (i, row) in rows.iter().enumerate() {
            for (j, point) in row.iter().enumerate() {
                let (a, b) = (along.heights()[i], along.lengths()[j]);
                assert!((along.point(a, b) - point).norm() < 1e-12, "{name}");
                assert_eq!(along.jet(a, b).normal, -against.jet(a, b).normal, "{name}");
            }
        }
        assert_eq!([along.heights()[0], along.heights()[5], along.lengths()[4]], [0.0, 1.0, 1.0]);
    }
}
