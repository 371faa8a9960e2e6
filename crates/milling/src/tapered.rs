//! A flank of a conical gear between root and tip cone: the length of roll at which it begins and ends changes along the axis, so that its
//! height is counted anew, 0 on the cone at the root and 1 on that at the tip (`docs/mathematics/milling.md#flanks-as-patches`).

use foundation::geometry::{Surface, SurfaceJet};
use nalgebra::Vector3;
use std::sync::Arc;

/// Where a cone about the axis meets an involute helicoid: its length of roll over the axial position. Beyond the ends of the face it goes
/// on straight. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollOnCone {
    /// Radius at z = 0.
    radius: f64,
    /// Change of the radius along the axis.
    slope: f64,
    base_radius: f64,
    ends: [f64; 2],
}

impl RollOnCone {
    /// A cone of this radius at z = 0 that widens by `slope` for each mm, on a flank of this base radius, between the ends of the face;
    /// `None` where it does not lie outside of the base cylinder all over the face.
    pub fn new(radius: f64, slope: f64, base_radius: f64, ends: [f64; 2]) -> Option<Self> {
        let cone = Self { radius, slope, base_radius, ends };
        let outside = ends.iter().all(|z| radius + slope * z > base_radius);
        (outside && base_radius > 0.0).then_some(cone)
    }

    /// Length of roll with its first and second derivative by the position.
    fn at(&self, z: f64) -> [f64; 3] {
        let on_face = z.clamp(self.ends[0], self.ends[1]);
        let radius = self.radius + self.slope * on_face;
        let roll = ((radius - self.base_radius) * (radius + self.base_radius)).sqrt();
        let rate = self.slope * radius / roll;
        if on_face == z {
            let bend = self.slope * self.base_radius / roll;
            return [roll, rate, -bend * bend / roll];
        }
        [roll + rate * (z - on_face), rate, 0.0]
    }

    /// Upper bounds of the rate and its change over an interval, where both are greatest at the least length of roll.
    fn bounds(&self, lengths: [f64; 2]) -> [f64; 2] {
        let ends = lengths.map(|z| self.at(z.clamp(self.ends[0], self.ends[1])));
        [1, 2].map(|k| ends[0][k].abs().max(ends[1][k].abs()))
    }

    fn span(&self, lengths: [f64; 2]) -> [f64; 2] {
        // The length of roll grows or falls all along.
        lengths.map(|z| self.at(z)[0])
    }
}

/// A helicoid, or one with an offset, between two cones.
#[derive(Clone, Debug)]
pub struct Tapered {
    base: Arc<dyn Surface>,
    /// At the root and at the tip.
    cones: [RollOnCone; 2],
}

impl Tapered {
    /// A surface over length of roll and axial position between the cones at root and tip.
    pub fn new(base: Arc<dyn Surface>, cones: [RollOnCone; 2]) -> Self {
        Self { base, cones }
    }

    /// Length of roll at a height with its derivatives: w, w_a, w_b.
    fn roll(&self, height: f64, length: f64) -> [f64; 3] {
        let [root, tip] = self.cones.map(|cone| cone.at(length));
        let mix = |k: usize| root[k] + height * (tip[k] - root[k]);
        [mix(0), tip[0] - root[0], mix(1)]
    }

    /// Lengths of roll over a box, about that of its middle.
    fn rolls(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 2] {
        let middle = self.roll(0.5 * (heights[0] + heights[1]), 0.5 * (lengths[0] + lengths[1]))[0];
        // Bilinear in the height and in the rolls of both cones, which are monotonic: greatest and least at corners.
        let [root, tip] = self.cones.map(|cone| cone.span(lengths));
        let mut half = 0.0f64;
        for h in heights {
            for (a, b) in root.into_iter().flat_map(|a| tip.map(|b| (a, b))) {
                half = half.max((a + h * (b - a) - middle).abs());
            }
        }
        [middle - half, middle + half]
    }

    /// Upper bounds of |w_a|, |w_b|, |w_ab| and |w_bb| over a box.
    fn roll_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 4] {
        let [root, tip] = self.cones.map(|cone| cone.span(lengths));
        let across = root.iter().flat_map(|a| tip.iter().map(move |b| (b - a).abs())).fold(0.0, f64::max);
        let [[root_rate, root_bend], [tip_rate, tip_bend]] = self.cones.map(|cone| cone.bounds(lengths));
        let most = heights.iter().map(|h| h.abs()).fold(0.0, f64::max);
        let rest = heights.iter().map(|h| (1.0 - h).abs()).fold(0.0, f64::max);
        [across, rest * root_rate + most * tip_rate, root_rate + tip_rate, rest * root_bend + most * tip_bend]
    }
}

impl Surface for Tapered {
    /// Heights beyond both cones belong to the same flank.
    fn domain(&self) -> [[f64; 2]; 2] {
        [[f64::NEG_INFINITY, f64::INFINITY], [f64::NEG_INFINITY, f64::INFINITY]]
    }

    fn point(&self, height: f64, length: f64) -> Vector3<f64> {
        self.base.point(self.roll(height, length)[0], length)
    }

    fn jet(&self, height: f64, length: f64) -> SurfaceJet {
        let [roll, by_height, by_length] = self.roll(height, length);
        let at = self.base.jet(roll, length);
        SurfaceJet {
            point: at.point,
            by_height: at.by_height * by_height,
            by_length: at.by_length + at.by_height * by_length,
            normal: at.normal,
            normal_by_height: at.normal_by_height * by_height,
            normal_by_length: at.normal_by_length + at.normal_by_height * by_length,
        }
    }

    fn speed_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 2] {
        let [by_roll, along] = self.base.speed_bounds(self.rolls(heights, lengths), lengths);
        let [by_height, by_length, ..] = self.roll_bounds(heights, lengths);
        [by_roll * by_height, along + by_roll * by_length]
    }

    /// What the base is off its tangent plane, and what the length of roll is off its own.
    fn off_tangent(&self, heights: [f64; 2], lengths: [f64; 2]) -> f64 {
        let rolls = self.rolls(heights, lengths);
        let [.., mixed, bend] = self.roll_bounds(heights, lengths);
        let [by_roll, _] = self.base.speed_bounds(rolls, lengths);
        let [a, b] = [heights, lengths].map(|[from, to]| 0.5 * (to - from).abs());
        self.base.off_tangent(rolls, lengths) + by_roll * (mixed * a * b + 0.5 * bend * b * b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::geometry::{Flank, Gear, GearData, Helicoid, Sides};

    const HALF: f64 = 15.0;
    /// Radii of form and tip cone at z = 0.
    const RADII: [f64; 2] = [50.6, 55.0];

    fn flank(side: Flank) -> (Tapered, f64) {
        let cone_angle = 6f64.to_radians();
        let gear = Gear::new(GearData {
            teeth: 25,
            normal_module: 4.0,
            pressure_angle: Sides::both(20f64.to_radians()),
            helix_angle: 12f64.to_radians(),
            profile_shift: 0.1,
            cone_angle,
        })
        .unwrap();
        let base = Helicoid::new(&gear, side);
        let slope = -cone_angle.tan();
        let of = |radius| RollOnCone::new(radius, slope, base.base_radius(), [-HALF, HALF]).unwrap();
        (Tapered::new(Arc::new(base), RADII.map(of)), slope)
    }

    #[test]
    fn heights_count_from_cone_to_cone() {
        for side in Flank::BOTH {
            let (surface, slope) = flank(side);
            for z in [-15.0, -3.0, 0.0, 8.0, 15.0] {
                for (height, radius) in [(0.0, RADII[0]), (1.0, RADII[1])] {
                    let point = surface.point(height, z);
                    assert!((point.xy().norm() - radius - slope * z).abs() < 1e-12 && point.z == z);
                }
            }
        }
        // A cone that dips below the base cylinder has no length of roll there.
        assert_eq!(RollOnCone::new(46.0, -0.1, 45.0, [-HALF, HALF]), None);
    }

    #[test]
    fn derivatives_are_those_of_points_and_normals() {
        let by = 1e-5;
        for side in Flank::BOTH {
            let (surface, _) = flank(side);
            for (height, z) in [(0.0, -20.0), (0.3, -15.5), (0.5, 2.0), (1.0, 14.0), (0.8, 22.0)] {
                let jet = surface.jet(height, z);
                let at = |dh: f64, dz: f64| surface.jet(height + dh, z + dz);
                let slopes = [
                    ((at(by, 0.0).point - at(-by, 0.0).point) / (2.0 * by), jet.by_height),
                    ((at(0.0, by).point - at(0.0, -by).point) / (2.0 * by), jet.by_length),
                    ((at(by, 0.0).normal - at(-by, 0.0).normal) / (2.0 * by), jet.normal_by_height),
                    ((at(0.0, by).normal - at(0.0, -by).normal) / (2.0 * by), jet.normal_by_length),
                ];
                for (k, (found, exact)) in slopes.into_iter().enumerate() {
                    assert!((found - exact).norm() < 1e-7 * (1.0 + exact.norm()), "{side} {height} {z} {k}");
                }
                let across = jet.by_height.cross(&jet.by_length).normalize();
                assert!((across.dot(&jet.normal).abs() - 1.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn bounds_hold_all_over_boxes() {
        for side in Flank::BOTH {
            let (surface, _) = flank(side);
            for (heights, lengths) in [
                ([0.0, 1.0], [-20.0, 20.0]),
                ([0.2, 0.5], [-4.0, 6.0]),
                ([-0.1, 0.1], [10.0, 19.0]),
                ([0.9, 1.0], [-15.0, -14.0]),
            ] {
                let speeds = surface.speed_bounds(heights, lengths);
                let off = surface.off_tangent(heights, lengths);
                let middle = [0.5 * (heights[0] + heights[1]), 0.5 * (lengths[0] + lengths[1])];
                let at_middle = surface.jet(middle[0], middle[1]);
                for k in 0..=20 {
                    for l in 0..=20 {
                        let at = |[from, to]: [f64; 2], n: i32| from + (to - from) * f64::from(n) / 20.0;
                        let (a, b) = (at(heights, k), at(lengths, l));
                        let jet = surface.jet(a, b);
                        assert!(jet.by_height.norm() <= speeds[0] * (1.0 + 1e-12));
                        assert!(jet.by_length.norm() <= speeds[1] * (1.0 + 1e-12));
                        let plane = at_middle.point
                            + at_middle.by_height * (a - middle[0])
                            + at_middle.by_length * (b - middle[1]);
                        assert!((jet.point - plane).norm() <= off * (1.0 + 1e-9) + 1e-12, "{side} {a} {b}");
                    }
                }
            }
        }
    }
}
