//! A piece of a cylinder or cone about the workpiece's axis: root body, tip land, hub.

use super::{Surface, SurfaceJet};
use nalgebra::Vector3;

/// The surface between two circles about +z. Height parameter: azimuth from +y towards +x, rad; length parameter: 0 at the first
/// circle, 1 at the second one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frustum {
    /// Radii of both circles, mm.
    pub radii: [f64; 2],
    /// Their positions on the axis, mm.
    pub positions: [f64; 2],
    /// +1 where the material lies towards the axis, -1 where it lies outside.
    pub outward: f64,
}

impl Surface for Frustum {
    fn domain(&self) -> [[f64; 2]; 2] {
        [[f64::NEG_INFINITY, f64::INFINITY], [0.0, 1.0]]
    }

    fn point(&self, azimuth: f64, share: f64) -> Vector3<f64> {
        let at = |[from, to]: [f64; 2]| from + (to - from) * share;
        let (sin, cos) = azimuth.sin_cos();
        let radius = at(self.radii);
        Vector3::new(radius * sin, radius * cos, at(self.positions))
    }

    fn jet(&self, azimuth: f64, share: f64) -> SurfaceJet {
        let (sin, cos) = azimuth.sin_cos();
        let (radial, around) = (Vector3::new(sin, cos, 0.0), Vector3::new(cos, -sin, 0.0));
        let [widens, rises] = [self.radii, self.positions].map(|[from, to]| to - from);
        let slant = widens.hypot(rises) * rises.signum() * self.outward;
        let point = self.point(azimuth, share);
        SurfaceJet {
            point,
            by_height: around * point.xy().norm(),
            by_length: radial * widens + Vector3::z() * rises,
            normal: (radial * rises - Vector3::z() * widens) / slant,
            normal_by_height: around * (rises / slant),
            normal_by_length: Vector3::zeros(),
        }
    }

    fn speed_bounds(&self, _: [f64; 2], shares: [f64; 2]) -> [f64; 2] {
        let radius = |share: f64| (self.radii[0] + (self.radii[1] - self.radii[0]) * share).abs();
        let along = (self.radii[1] - self.radii[0]).hypot(self.positions[1] - self.positions[0]);
        [radius(shares[0]).max(radius(shares[1])), along]
    }
}
