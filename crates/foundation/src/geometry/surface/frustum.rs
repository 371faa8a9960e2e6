//! A piece of a cylinder or cone about the workpiece's axis: root body, tip land, hub.

use super::bounds::{largest, remainder};
use super::{Surface, SurfaceJet};
use nalgebra::Vector3;

/// The surface between two circles about +z. Height parameter: azimuth from +y towards +x, rad; length parameter: 0 at the first
/// circle, 1 at the second one. The lines of constant azimuth may turn about the axis as the teeth do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frustum {
    /// Radii of both circles, mm.
    pub radii: [f64; 2],
    /// Their positions on the axis, mm.
    pub positions: [f64; 2],
    /// Turn of the azimuth's zero at both circles, rad.
    pub turns: [f64; 2],
    /// +1 where the material lies towards the axis, -1 where it lies outside.
    pub outward: f64,
}

impl Surface for Frustum {
    fn domain(&self) -> [[f64; 2]; 2] {
        [[f64::NEG_INFINITY, f64::INFINITY], [0.0, 1.0]]
    }

    fn point(&self, azimuth: f64, share: f64) -> Vector3<f64> {
        let [radius, position, turn] = self.at(share);
        let (sin, cos) = (azimuth + turn).sin_cos();
        Vector3::new(radius * sin, radius * cos, position)
    }

    fn jet(&self, azimuth: f64, share: f64) -> SurfaceJet {
        let [radius, position, turn] = self.at(share);
        let (sin, cos) = (azimuth + turn).sin_cos();
        let (radial, around) = (Vector3::new(sin, cos, 0.0), Vector3::new(cos, -sin, 0.0));
        let [widens, rises, turns] = self.slopes();
        let slant = widens.hypot(rises) * rises.signum() * self.outward;
        let normal_by_height = around * (rises / slant);
        SurfaceJet {
            point: radial * radius + Vector3::z() * position,
            by_height: around * radius,
            by_length: radial * widens + around * (radius * turns) + Vector3::z() * rises,
            normal: (radial * rises - Vector3::z() * widens) / slant,
            normal_by_height,
            normal_by_length: normal_by_height * turns,
        }
    }

    fn speed_bounds(&self, _: [f64; 2], shares: [f64; 2]) -> [f64; 2] {
        let radius = self.largest_radius(shares);
        let [widens, rises, turns] = self.slopes();
        [radius, widens.hypot(rises).hypot(radius * turns)]
    }

    fn off_tangent(&self, azimuths: [f64; 2], shares: [f64; 2]) -> f64 {
        let radius = self.largest_radius(shares);
        let [widens, _, turns] = self.slopes();
        let turned = radius * turns;
        let second = [radius, widens.hypot(turned), (2.0 * widens * turns).hypot(turned * turns)];
        remainder(second, azimuths, shares)
    }
}

impl Frustum {
    /// Radius, position and turn.
    fn at(&self, share: f64) -> [f64; 3] {
        [self.radii, self.positions, self.turns].map(|[from, to]| from + (to - from) * share)
    }

    /// It is linear over the share.
    fn largest_radius(&self, shares: [f64; 2]) -> f64 {
        largest(shares.map(|share| self.at(share)[0]))
    }

    /// Their slopes over the share.
    fn slopes(&self) -> [f64; 3] {
        [self.radii, self.positions, self.turns].map(|[from, to]| to - from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_the_point() {
        let cone =
            Frustum { radii: [40.0, 55.0], positions: [-10.0, 20.0], turns: [0.1, 0.4], outward: -1.0 };
        let (a, b, h) = (0.3, 0.6, 1e-5);
        let jet = cone.jet(a, b);
        let by = |f: &dyn Fn(f64) -> Vector3<f64>| (f(h) - f(-h)) / (2.0 * h);
        for (closed, numeric) in [
            (jet.by_height, by(&|x| cone.point(a + x, b))),
            (jet.by_length, by(&|x| cone.point(a, b + x))),
            (jet.normal_by_height, by(&|x| cone.jet(a + x, b).normal)),
            (jet.normal_by_length, by(&|x| cone.jet(a, b + x).normal)),
        ] {
            assert!((closed - numeric).norm() < 1e-7, "{closed} {numeric}");
        }
        assert!(jet.normal.dot(&jet.by_height).abs() < 1e-12 && jet.normal.dot(&jet.by_length).abs() < 1e-12);
        assert!(jet.normal.dot(&jet.point) < 0.0);
        let bounds = cone.speed_bounds([0.0, 1.0], [0.0, 0.7]);
        assert!(bounds[0] >= jet.by_height.norm() && bounds[1] >= jet.by_length.norm());
    }
}
