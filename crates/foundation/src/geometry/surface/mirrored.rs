//! A flank mirrored in a plane across the axis: the other half of a double helical gear (`docs/mathematics/milling.md#flanks-as-patches`).

use super::{OffsetBase, SecondOrder, Surface, SurfaceJet};
use nalgebra::Vector3;

/// The mirror image z -> 2 z_0 - z of a surface whose length parameter is the axial position: the length stays the axial position,
/// heights and sides stay what they are.
#[derive(Clone, Debug, PartialEq)]
pub struct Mirrored<S> {
    base: S,
    plane: f64,
}

/// The mirror image of a direction.
fn image(v: Vector3<f64>) -> Vector3<f64> {
    Vector3::new(v.x, v.y, -v.z)
}

impl<S: Surface> Mirrored<S> {
    /// The image in the plane z = z_0, mm.
    pub fn new(base: S, plane: f64) -> Self {
        Self { base, plane }
    }

    /// The surface before the mirror.
    pub fn base(&self) -> &S {
        &self.base
    }

    /// z_0, mm.
    pub fn plane(&self) -> f64 {
        self.plane
    }

    fn across(&self, length: f64) -> f64 {
        2.0 * self.plane - length
    }

    fn image_of_point(&self, point: Vector3<f64>) -> Vector3<f64> {
        Vector3::new(point.x, point.y, self.across(point.z))
    }

    fn lengths(&self, [from, to]: [f64; 2]) -> [f64; 2] {
        [self.across(to), self.across(from)]
    }

    fn image_of_jet(&self, jet: SurfaceJet) -> SurfaceJet {
        SurfaceJet {
            point: self.image_of_point(jet.point),
            by_height: image(jet.by_height),
            by_length: -image(jet.by_length),
            normal: image(jet.normal),
            normal_by_height: image(jet.normal_by_height),
            normal_by_length: -image(jet.normal_by_length),
        }
    }
}

impl<S: Surface> Surface for Mirrored<S> {
    fn domain(&self) -> [[f64; 2]; 2] {
        let [heights, lengths] = self.base.domain();
        [heights, self.lengths(lengths)]
    }

    fn point(&self, height: f64, length: f64) -> Vector3<f64> {
        self.image_of_point(self.base.point(height, self.across(length)))
    }

    fn jet(&self, height: f64, length: f64) -> SurfaceJet {
        self.image_of_jet(self.base.jet(height, self.across(length)))
    }

    fn speed_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 2] {
        self.base.speed_bounds(heights, self.lengths(lengths))
    }

    fn off_tangent(&self, heights: [f64; 2], lengths: [f64; 2]) -> f64 {
        self.base.off_tangent(heights, self.lengths(lengths))
    }
}

impl<S: OffsetBase> OffsetBase for Mirrored<S> {
    fn second_order(&self, height: f64, length: f64) -> SecondOrder {
        let at = self.base.second_order(height, self.across(length));
        let mirror = |[aa, ab, bb]: [Vector3<f64>; 3]| [image(aa), -image(ab), image(bb)];
        SecondOrder { jet: self.image_of_jet(at.jet), point: mirror(at.point), normal: mirror(at.normal) }
    }

    fn normal_speed_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 2] {
        self.base.normal_speed_bounds(heights, self.lengths(lengths))
    }

    fn normal_off_tangent(&self, heights: [f64; 2], lengths: [f64; 2]) -> f64 {
        self.base.normal_off_tangent(heights, self.lengths(lengths))
    }
}
