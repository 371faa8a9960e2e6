//! Flanks as smooth patches over two parameters: what milling needs of a flank, whatever the flank is made of.
//!
//! The height parameter a runs from root to tip, the length parameter b along the tooth (`docs/mathematics/milling.md#flanks-as-patches`).
//! Their units are those of the surface: length of roll and axial position in mm, roll angle in rad and distance from the apex in mm,
//! fractions of a grid.

mod blade_curve;
pub(super) mod bounds;
mod ease_off;
mod frustum;
mod grid;
mod helicoid;
mod mirrored;
mod modified;
mod offset_sum;
mod ruled;
mod second_order;

pub use blade_curve::{BladeCurve, CylindricalCurve, SplineCurve};
pub use ease_off::{EaseOff, EaseOffAmounts};
pub use frustum::Frustum;
pub use grid::GridSurface;
pub use helicoid::Helicoid;
pub(super) use helicoid::turned;
pub use mirrored::Mirrored;
pub use modified::{Modified, NormalOffset, OffsetBounds};
pub use offset_sum::OffsetSum;
pub use ruled::{BladeData, RuledBlade};
pub use second_order::{NormalSide, OffsetBase, SecondOrder};

use nalgebra::Vector3;
use std::fmt::Debug;

/// A place on a surface up to the second order. mm in workpiece coordinates, per unit of the parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceJet {
    /// The point P.
    pub point: Vector3<f64>,
    /// S_a = dP/da.
    pub by_height: Vector3<f64>,
    /// S_b = dP/db.
    pub by_length: Vector3<f64>,
    /// The unit normal n, out of the material.
    pub normal: Vector3<f64>,
    /// dn/da.
    pub normal_by_height: Vector3<f64>,
    /// dn/db.
    pub normal_by_length: Vector3<f64>,
}

/// A smooth surface S(a, b) with its normal.
pub trait Surface: Send + Sync + Debug {
    /// Where the parameters have a meaning, [from, to] of the height and of the length; infinite where nothing ends.
    fn domain(&self) -> [[f64; 2]; 2];

    /// The point at (a, b), mm. Inside the domain it is finite.
    fn point(&self, height: f64, length: f64) -> Vector3<f64>;

    /// Point, derivatives, normal and its derivatives at (a, b).
    fn jet(&self, height: f64, length: f64) -> SurfaceJet;

    /// Upper bounds of |S_a| and |S_b| over a box of parameters inside the domain: true everywhere in it, not sampled.
    fn speed_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 2];

    /// Upper bound of how far the surface is off its tangent plane at a box's middle m, mm: of |S(a, b) - S(m) - S_a(m) da -
    /// S_b(m) db| over the box; infinite where nothing is known.
    fn off_tangent(&self, _heights: [f64; 2], _lengths: [f64; 2]) -> f64 {
        f64::INFINITY
    }
}

impl SurfaceJet {
    /// How the normal turns along a tangent direction: dn(v), 1/mm times |v| (`docs/mathematics/milling.md#scallops-chords-local-gouging`).
    pub fn normal_change(&self, direction: &Vector3<f64>) -> Vector3<f64> {
        let (a, b) = (&self.by_height, &self.by_length);
        let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
        let (a_v, b_v) = (a.dot(direction), b.dot(direction));
        let determinant = aa * bb - ab * ab;
        let c_a = (bb * a_v - ab * b_v) / determinant;
        let c_b = (aa * b_v - ab * a_v) / determinant;
        self.normal_by_height * c_a + self.normal_by_length * c_b
    }

    /// The curvatures v_i . dn(v_j) in two orthogonal unit tangents, 1/mm, convex > 0: [K_11, K_12, K_22].
    pub fn curvatures(&self, first: &Vector3<f64>, second: &Vector3<f64>) -> [f64; 3] {
        let (along_first, along_second) = (self.normal_change(first), self.normal_change(second));
        [first.dot(&along_first), first.dot(&along_second), second.dot(&along_second)]
    }
}
