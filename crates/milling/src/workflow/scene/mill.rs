//! A mill as a closed mesh: its cutting part with the corner, neck and shank above it. Knows no flank and no path.

use foundation::geometry::{Cutter, CutterShape};
use foundation::numerics::equidistant;
use scene::mesh::{MeshError, TriangleMesh, revolved};
use std::f64::consts::FRAC_PI_2;

/// Corners of a circle, and points of a corner or barrel.
const AROUND: usize = 96;
const ARC: usize = 16;
/// What is drawn above the highest part that is known, in radii of the cutting part.
const ABOVE: f64 = 2.0;

/// The cutter in tool coordinates, the tip at the origin. Above what is known of it it is drawn on for a little.
///
/// # Errors
/// [`MeshError`].
pub(super) fn mill(cutter: &Cutter) -> Result<TriangleMesh, MeshError> {
    let edge = cutter.cutting_length();
    let mut section = cutting_part(cutter.shape(), edge);
    let mut radius = section.last().map_or(0.0, |point| point[0]);
    // Neck, shank and holder in ascending order; the cutting part ends where they begin.
    let mut steps = cutter.steps().to_vec();
    steps.sort_by(|a, b| a.from.total_cmp(&b.from));
    for step in &steps {
        let from = step.from.max(section.last().map_or(0.0, |point| point[1]));
        section.extend([[radius, from], [step.radius, from]]);
        radius = step.radius;
    }
    let top = cutter.length() + ABOVE * cutter.shape().radius();
    section.extend([[radius, top], [0.0, top]]);
    let mut clean: Vec<[f64; 2]> = Vec::with_capacity(section.len());
    for point in section {
        let same = |other: &[f64; 2]| (other[0] - point[0]).abs().max((other[1] - point[1]).abs()) < 1e-9;
        if !clean.last().is_some_and(same) {
            clean.push(point);
        }
    }
    revolved(&clean, AROUND)
}

/// (radius, z) from the axis up to the end of the edges.
fn cutting_part(shape: &CutterShape, edge: f64) -> Vec<[f64; 2]> {
    let mut section = vec![[0.0, 0.0]];
    match *shape {
        CutterShape::Conical { radius, half_angle, corner_radius } => {
            let (sin, cos) = half_angle.sin_cos();
            let middle = (radius + (sin - 1.0) * corner_radius / cos).max(0.0);
            if corner_radius > 0.0 {
                section.extend(equidistant([0.0, FRAC_PI_2 - half_angle], ARC).into_iter().map(|angle| {
                    let (sin, cos) = angle.sin_cos();
                    [middle + corner_radius * sin, corner_radius * (1.0 - cos)]
                }));
                // The bottom of a ball is the tip itself.
                if middle < 1e-9 {
                    section.remove(1);
                }
            } else {
                section.push([radius, 0.0]);
            }
            let top = edge.max(section.last().map_or(0.0, |point| point[1]));
            section.push([radius + top * half_angle.tan(), top]);
        }
        CutterShape::Barrel { radius, height, profile_radius } => {
            let middle = radius - profile_radius;
            let at =
                |z: f64| middle + (profile_radius * profile_radius - (z - height).powi(2)).max(0.0).sqrt();
            // Below the tip there is nothing; above it the arc may begin on the axis only.
            let lowest =
                height - (profile_radius * profile_radius - (middle.min(0.0)).powi(2)).max(0.0).sqrt();
            let (from, to) = (lowest.max(0.0), edge.min(height + profile_radius));
            section[0][1] = from;
            let arc = equidistant([from, to], 2 * ARC).into_iter().map(|z| [at(z), z]);
            section.extend(arc.filter(|point| point[0] > 1e-9));
        }
    }
    section
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::geometry::ShankStep;

    #[test]
    fn every_vertex_of_the_cutting_part_lies_on_the_cutter() {
        let conical =
            |half_angle, corner_radius| CutterShape::Conical { radius: 3.0, half_angle, corner_radius };
        let barrel = |profile_radius, height| CutterShape::Barrel { radius: 3.0, height, profile_radius };
        let shapes = [
            conical(0.0, 0.0),
            conical(0.0, 1.0),
            conical(0.0, 3.0),
            conical(0.3, 0.0),
            conical(0.3, 1.0),
            barrel(40.0, 4.0),
            barrel(6.0, 5.0),
            barrel(3.0, 3.0),
        ];
        for shape in shapes {
            let cutter = Cutter::new(shape, 8.0, vec![ShankStep { radius: 2.5, from: 9.0 }]).unwrap();
            let mesh = mill(&cutter).unwrap();
            let mut seen = 0;
            for point in mesh.vertices.iter().filter(|p| p.z < 5.5 && p.z > 1e-6 && p.xy().norm() > 1e-6) {
                let off = shape.distance(point.xy().norm(), point.z);
                assert!(off.abs() < 1e-9, "{shape:?} {point} {off}");
                seen += 1;
            }
            assert!(seen >= AROUND || matches!(shape, CutterShape::Conical { corner_radius: 0.0, .. }));
        }
    }
}
