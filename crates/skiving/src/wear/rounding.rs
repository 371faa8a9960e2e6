//! The rounding of an edge in its section: how deep a worn one reaches, how much of the rake face has to go for a fresh one, where the
//! flank is then.
//!
//! In the section across the edge, rake face and clearance face are straight; directions count from the rake face's normal, h is half of
//! theta_c. A body of tangents is described by its support: how far it comes out in every direction. A rounding that has grown by drho comes
//! out less by drho (cos(th - h)/cos h - 1) (`docs/mathematics/skiving.md#the-virtual-edge`). A fresh edge below a rake face that has been
//! ground down by s is the old fresh one moved down along the clearance face; it comes out less by s sin(theta_c - th)/sin theta_c. It can
//! be made from the worn one where it comes out less in all directions up to theta_hi:
//!
//! ```text
//! s >= drho * 2 sin h sin(th/2)/cos(h - th/2),
//! ```
//!
//! which grows with th: the end of the rounding at theta_hi decides. Without a chamfer on the clearance face that is
//! drho (1 - cos theta_c): the depth at which the worn rounding ends less the depth at which a fresh one does.
//!
//! A chip is not of that shape. What is known of it is how much less the edge comes out at the contact, so that a fresh edge fits below it
//! at the earliest where it stands back by as much there.

use crate::EdgeSection;
use foundation::geometry::EdgeRounding;

/// Depth below the rake face at which a rounding that has grown ends towards the clearance face, mm. Without a chamfer there, an edge
/// that is ground down so far is sharp.
pub fn depth_of_rounding(section: &EdgeSection, rounding: &EdgeRounding, growth: f64) -> f64 {
    // The centre sinks by the growth, whatever the angles: v has one unit along the rake normal.
    rounding.depth() + growth - (rounding.radius + growth) * section.range[1].cos()
}

/// Depth along the rake normal that has to be ground off so that an edge like the fresh one can be made, mm; 0 without growth.
pub fn renewing_depth(section: &EdgeSection, growth: f64) -> f64 {
    let (half, end) = (0.5 * section.clearance_angle, 0.5 * section.range[1]);
    growth.max(0.0) * 2.0 * half.sin() * end.sin() / (half - end).cos()
}

/// Depth along the rake normal that has to be ground off at least so that a fresh edge stands below a chip which has taken `missing`,
/// normal to the flank at the contact, mm; 0 where nothing is missing.
pub fn chip_depth(section: &EdgeSection, missing: f64) -> f64 {
    let below = section.clearance_angle - section.contact_angle;
    if missing > 0.0 { missing * section.clearance_angle.sin() / below.sin().max(0.0) } else { 0.0 }
}

/// How far the fresh edge stands behind the nominal one at an angle of the rounding once the rake face has been ground down by `depth`,
/// as a deviation: <= 0, mm.
pub fn recession(section: &EdgeSection, angle: f64, depth: f64) -> f64 {
    -depth * (section.clearance_angle - angle).sin() / section.clearance_angle.sin()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Vector2, Vector3};

    const FRESH: EdgeRounding = EdgeRounding {
        radius: 0.03,
        clearance_angle: 0.15,
        rake_chamfer_width: 0.05,
        rake_chamfer_angle: 0.17,
        clearance_chamfer_angle: 0.1,
    };

    fn section(clearance_angle: f64, rounding: &EdgeRounding) -> EdgeSection {
        EdgeSection {
            centre: Vector3::zeros(),
            tangent: Vector3::x(),
            rake_normal: Vector3::z(),
            outward: Vector3::y(),
            clearance_normal: Vector3::new(0.0, clearance_angle.sin(), clearance_angle.cos()),
            ruling: Vector3::zeros(),
            contact_angle: 0.95 * clearance_angle,
            clearance_angle,
            range: [rounding.rake_chamfer_angle, clearance_angle - rounding.clearance_chamfer_angle],
        }
    }

    /// Half planes (angle, offset) of an edge: rake face, rounding with its chamfers, clearance face `width` of chamfer away. Coordinates
    /// are [outward, rake normal], the fresh edge's centre is the origin.
    fn edge(section: &EdgeSection, rounding: &EdgeRounding, growth: f64, width: f64) -> Vec<(f64, f64)> {
        let [lo, hi] = section.range;
        let v = section.growth();
        let centre = -growth * Vector2::new(v.y, v.z);
        let radius = rounding.radius + growth;
        let mut planes = vec![(0.0, rounding.depth())];
        for k in 0..=2000 {
            let angle = lo + (hi - lo) * f64::from(k) / 2000.0;
            planes.push((angle, centre.dot(&direction(angle)) + radius));
        }
        let kappa = rounding.clearance_chamfer_angle;
        planes.push((section.clearance_angle, rounding.radius * kappa.cos() + width * kappa.sin()));
        planes
    }

    fn direction(angle: f64) -> Vector2<f64> {
        Vector2::new(angle.sin(), angle.cos())
    }

    /// Corners of a convex edge: neighbouring planes meet.
    fn corners(planes: &[(f64, f64)]) -> Vec<Vector2<f64>> {
        let meet = |two: &[(f64, f64)]| {
            let ((a, p), (b, q)) = (two[0], two[1]);
            let sine = (b - a).sin();
            Vector2::new(q * a.cos() - p * b.cos(), p * b.sin() - q * a.sin()) / sine
        };
        planes.windows(2).filter(|two| two[1].0 - two[0].0 > 1e-9).map(meet).collect()
    }

    fn stands_out(planes: &[(f64, f64)], corners: &[Vector2<f64>], shift: &Vector2<f64>) -> f64 {
        let all = corners
            .iter()
            .flat_map(|c| planes.iter().map(move |(angle, p)| (c + shift).dot(&direction(*angle)) - p));
        all.fold(f64::NEG_INFINITY, f64::max)
    }

    #[test]
    fn a_fresh_edge_fits_into_the_worn_one_from_the_stated_depth_on() {
        for (angle, rounding, width) in [
            (
                1.74,
                EdgeRounding {
                    rake_chamfer_width: 0.0,
                    rake_chamfer_angle: 0.0,
                    clearance_chamfer_angle: 0.0,
                    ..FRESH
                },
                0.0,
            ),
            (1.42, FRESH, 0.02),
            (2.1, FRESH, 0.005),
        ] {
            let section = section(angle, &rounding);
            let growth = 0.012;
            let (fresh, worn) =
                (edge(&section, &rounding, 0.0, width), edge(&section, &rounding, growth, width));
            let depth = renewing_depth(&section, growth);
            // Down along the clearance face until the rake face is the stated depth lower.
            let along = Vector2::new(1.0 / angle.tan(), -1.0);
            let out = |depth: f64| stands_out(&worn, &corners(&fresh), &(along * depth));
            assert!(out(depth).abs() < 1e-6, "{angle}: {}", out(depth));
            assert!(out(0.9 * depth) > 1e-5, "{angle}: {}", out(0.9 * depth));
            assert!(renewing_depth(&section, -growth) == 0.0);
        }
    }

    #[test]
    fn depths_are_those_of_the_section() {
        let plain = EdgeRounding {
            rake_chamfer_width: 0.0,
            rake_chamfer_angle: 0.0,
            clearance_chamfer_angle: 0.0,
            ..FRESH
        };
        for rounding in [plain, FRESH] {
            let section = section(1.7, &rounding);
            let growth = 0.009;
            let end = direction(section.range[1]) * (rounding.radius + growth);
            let v = section.growth();
            let worn = end - growth * Vector2::new(v.y, v.z);
            let found = depth_of_rounding(&section, &rounding, growth);
            assert!((found - (rounding.depth() - worn.y)).abs() < 1e-15);
            if rounding == plain {
                let renewed = found - depth_of_rounding(&section, &rounding, 0.0);
                assert!((renewed - renewing_depth(&section, growth)).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn a_lower_edge_stands_back_along_the_clearance_face() {
        let section = section(1.7, &FRESH);
        let along = Vector2::new(1.0 / section.clearance_angle.tan(), -1.0);
        for angle in [section.range[0], 1.0, section.contact_angle, section.range[1]] {
            let moved = direction(angle).dot(&(along * 0.1));
            assert!((recession(&section, angle, 0.1) - moved).abs() < 1e-15);
            assert!(moved < 0.0);
        }
    }
}
