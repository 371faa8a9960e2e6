//! A cutter as it is drawn: the section of its cutting part, its outline in a plane through the axis, its silhouette in a view.

use crate::CutterPlace;
use foundation::geometry::{Cutter, CutterShape};
use foundation::numerics::equidistant;
use nalgebra::Vector3;

/// Points of an arc, and of a circle about the axis.
const ARC: usize = 13;
const CIRCLE: usize = 36;
/// How much of neck, shank and holder is drawn above the edges, as a share of their height.
const ABOVE: f64 = 0.35;

/// Section of the cutting part from the axis at the tip up to a height: (radius, height), mm.
pub(super) fn section(shape: &CutterShape, height: f64) -> Vec<[f64; 2]> {
    match *shape {
        CutterShape::Conical { radius, half_angle, corner_radius } => {
            let (sin, cos) = half_angle.sin_cos();
            let centre = radius + (sin - 1.0) * corner_radius / cos;
            // From the lowest point of the corner to where it meets the side.
            let corner = equidistant([-std::f64::consts::FRAC_PI_2, -half_angle], ARC)
                .into_iter()
                .map(|angle| [centre + corner_radius * angle.cos(), corner_radius * (1.0 + angle.sin())]);
            let mut line = vec![[0.0, 0.0]];
            line.extend(corner.filter(|p| p[1] <= height));
            let [rho, z] = line[line.len() - 1];
            if z < height {
                line.push([rho + (height - z) * sin / cos, height]);
            }
            line
        }
        CutterShape::Barrel { radius, height: largest, profile_radius } => {
            let of = |z: f64| {
                let beside = (profile_radius * profile_radius - (z - largest).powi(2)).max(0.0);
                [(radius - profile_radius + beside.sqrt()).max(0.0), z]
            };
            let mut line = vec![[0.0, 0.0]];
            line.extend(equidistant([0.0, height], ARC).into_iter().map(of));
            line
        }
    }
}

/// Outline in a plane through the axis, open above: from the tip `at` along the unit vector `axis`.
pub(super) fn outline(shape: &CutterShape, height: f64, at: [f64; 2], axis: [f64; 2]) -> Vec<[f64; 2]> {
    let half = section(shape, height);
    let place = |side: f64, [rho, z]: [f64; 2]| {
        [at[0] + z * axis[0] + side * rho * axis[1], at[1] + z * axis[1] - side * rho * axis[0]]
    };
    let left = half.iter().rev().map(|&p| place(-1.0, p));
    left.chain(half.iter().map(|&p| place(1.0, p))).collect()
}

/// Silhouettes of the cutting part and of what follows above it, each convex, in a view.
pub(super) fn silhouettes(
    cutter: &Cutter,
    at: &CutterPlace,
    view: &dyn Fn(&Vector3<f64>) -> [f64; 2],
) -> Vec<Vec<[f64; 2]>> {
    let length = cutter.cutting_length();
    let top = (1.0 + ABOVE) * length;
    let mut bodies = vec![section(cutter.shape(), length)];
    for (k, step) in cutter.steps().iter().enumerate().filter(|(_, step)| step.from < top) {
        let end = cutter.steps().get(k + 1).map_or(top, |next| next.from.min(top));
        bodies.push(vec![[step.radius, step.from], [step.radius, end.max(step.from)]]);
    }
    // Two directions across the axis.
    let aside = if at.axis.x.abs() < 0.6 { Vector3::x() } else { Vector3::y() };
    let across = at.axis.cross(&aside).normalize();
    let other = at.axis.cross(&across);
    let ring = |[rho, z]: [f64; 2]| {
        (0..CIRCLE).map(move |k| {
            let (sin, cos) = (std::f64::consts::TAU * k as f64 / CIRCLE as f64).sin_cos();
            at.tip + at.axis * z + (across * cos + other * sin) * rho
        })
    };
    bodies
        .into_iter()
        .map(|body| convex_hull(body.into_iter().flat_map(ring).map(|point| view(&point)).collect()))
        .collect()
}

/// Convex hull, counter-clockwise (monotone chain).
fn convex_hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let turns_left = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0
    };
    let chain = |points: &mut dyn Iterator<Item = &[f64; 2]>| {
        let mut hull: Vec<[f64; 2]> = Vec::new();
        for &point in points {
            while let [.., a, b] = hull[..] {
                if turns_left(a, b, point) {
                    break;
                }
                hull.pop();
            }
            hull.push(point);
        }
        hull.pop();
        hull
    };
    let mut hull = chain(&mut points.iter());
    hull.extend(chain(&mut points.iter().rev()));
    hull
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_section_lies_on_the_cutter() {
        let shapes = [
            CutterShape::end_mill(3.0, 1.5),
            CutterShape::ball(2.0),
            CutterShape::Conical { radius: 2.0, half_angle: 0.1, corner_radius: 0.5 },
            CutterShape::Barrel { radius: 4.0, height: 6.0, profile_radius: 40.0 },
        ];
        for shape in shapes {
            let line = section(&shape, 12.0);
            assert_eq!(line[0], [0.0, 0.0]);
            for [rho, z] in &line[1..] {
                assert!(shape.distance(*rho, *z).abs() < 1e-12, "{shape:?} at {rho}, {z}");
            }
        }
    }

    #[test]
    fn a_hull_keeps_corners_only() {
        let hull = convex_hull(vec![[0.0, 0.0], [1.0, 0.0], [0.5, 0.5], [1.0, 1.0], [0.0, 1.0], [0.5, 0.0]]);
        assert_eq!(hull, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    }
}
