//! Surfaces known to the second order, normals included: what a surface must give to carry an offset along its normal.

use super::{Surface, SurfaceJet};
use crate::numerics::Jet2;
use nalgebra::Vector3;
use std::sync::Arc;

/// A place on a surface with the second derivatives of point and normal, each by height twice, by both, by length twice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SecondOrder {
    /// Up to the first order of the normal.
    pub jet: SurfaceJet,
    /// S_aa, S_ab, S_bb.
    pub point: [Vector3<f64>; 3],
    /// n_aa, n_ab, n_bb.
    pub normal: [Vector3<f64>; 3],
}

/// A surface that can be moved along its normal by a function of its parameters (`docs/mathematics/milling.md#flanks-as-patches`).
pub trait OffsetBase: Surface {
    /// Everything up to second order at (a, b).
    fn second_order(&self, height: f64, length: f64) -> SecondOrder;

    /// Upper bounds of |n_a| and |n_b| over a box of parameters inside the domain, as [`Surface::speed_bounds`] has them for the
    /// point; infinite where a box is too large for a statement.
    fn normal_speed_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 2];

    /// Upper bound of how far the normal is off its linear part at a box's middle, as [`Surface::off_tangent`] has it for the point.
    fn normal_off_tangent(&self, heights: [f64; 2], lengths: [f64; 2]) -> f64 {
        // It cannot leave its linear part faster than both can move.
        let [a, b] = self.normal_speed_bounds(heights, lengths);
        a * (heights[1] - heights[0]).abs() + b * (lengths[1] - lengths[0]).abs()
    }
}

/// To which side of S_a x S_b the normal points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NormalSide {
    /// n along S_a x S_b.
    Along,
    /// n against S_a x S_b.
    Against,
}

impl NormalSide {
    /// +1 or -1.
    pub fn sign(self) -> f64 {
        match self {
            Self::Along => 1.0,
            Self::Against => -1.0,
        }
    }
}

/// The jet of a surface whose normal is that of its own derivatives: `first` = S_a, S_b; `second` = S_aa, S_ab, S_bb. `None`
/// where they span no plane.
#[inline]
pub(crate) fn jet_of_derivatives(
    point: Vector3<f64>,
    [by_height, by_length]: [Vector3<f64>; 2],
    second: &[Vector3<f64>; 3],
    side: f64,
) -> Option<SurfaceJet> {
    let across = by_height.cross(&by_length);
    let scale = side / across.norm();
    if !scale.is_finite() {
        return None;
    }
    let normal = across * scale;
    let turned = |change: Vector3<f64>| (change - normal * normal.dot(&change)) * scale;
    Some(SurfaceJet {
        point,
        by_height,
        by_length,
        normal,
        normal_by_height: turned(second[0].cross(&by_length) + by_height.cross(&second[1])),
        normal_by_length: turned(second[1].cross(&by_length) + by_height.cross(&second[2])),
    })
}

/// Everything up to second order from the point and the jets of S_a and S_b, component by component. Where they span no plane the
/// normal and its derivatives are zero.
pub(crate) fn second_order_of(
    point: Vector3<f64>,
    by_height: &[Jet2; 3],
    by_length: &[Jet2; 3],
    side: f64,
) -> SecondOrder {
    let part = |jets: &[Jet2; 3], pick: fn(&Jet2) -> f64| Vector3::from_fn(|i, _| pick(&jets[i]));
    let cross = |i: usize, j: usize| by_height[i] * by_length[j] + -(by_height[j] * by_length[i]);
    let across = [cross(1, 2), cross(2, 0), cross(0, 1)];
    let square = across[0] * across[0] + across[1] * across[1] + across[2] * across[2];
    let inverse = if square.f > 0.0 { side / square.f.sqrt() } else { 0.0 };
    let of_square = if square.f > 0.0 {
        let (once, twice) = (-0.5 * inverse / square.f, 0.75 * inverse / (square.f * square.f));
        Jet2 { f: inverse, fu: once, fuu: twice, ..Jet2::default() }
    } else {
        Jet2::default()
    };
    let scale = of_square.of(square, Jet2::default());
    let normal = across.map(|component| component * scale);
    SecondOrder {
        jet: SurfaceJet {
            point,
            by_height: part(by_height, |j| j.f),
            by_length: part(by_length, |j| j.f),
            normal: part(&normal, |j| j.f),
            normal_by_height: part(&normal, |j| j.fu),
            normal_by_length: part(&normal, |j| j.fv),
        },
        point: [part(by_height, |j| j.fu), part(by_height, |j| j.fv), part(by_length, |j| j.fv)],
        normal: [part(&normal, |j| j.fuu), part(&normal, |j| j.fuv), part(&normal, |j| j.fvv)],
    }
}

/// Upper bounds of |n_a| and |n_b| of a normal that is the cross product of the derivatives: `speeds` and `second` bound |S_a|,
/// |S_b| and |S_aa|, |S_ab|, |S_bb| over a box with the given half sides, `across` is |S_a x S_b| at its middle.
pub(crate) fn cross_product_bounds(
    [a, b]: [f64; 2],
    [aa, ab, bb]: [f64; 3],
    halves: [f64; 2],
    across: f64,
) -> [f64; 2] {
    let change = [aa * b + a * ab, ab * b + a * bb];
    let least = across - change[0] * halves[0] - change[1] * halves[1];
    if least > 0.0 { change.map(|c| c / least) } else { [f64::INFINITY; 2] }
}

impl<S: Surface + ?Sized> Surface for Arc<S> {
    fn domain(&self) -> [[f64; 2]; 2] {
        (**self).domain()
    }

    fn point(&self, height: f64, length: f64) -> Vector3<f64> {
        (**self).point(height, length)
    }

    fn jet(&self, height: f64, length: f64) -> SurfaceJet {
        (**self).jet(height, length)
    }

    fn speed_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 2] {
        (**self).speed_bounds(heights, lengths)
    }

    fn off_tangent(&self, heights: [f64; 2], lengths: [f64; 2]) -> f64 {
        (**self).off_tangent(heights, lengths)
    }
}

impl<S: OffsetBase + ?Sized> OffsetBase for Arc<S> {
    fn second_order(&self, height: f64, length: f64) -> SecondOrder {
        (**self).second_order(height, length)
    }

    fn normal_speed_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 2] {
        (**self).normal_speed_bounds(heights, lengths)
    }

    fn normal_off_tangent(&self, heights: [f64; 2], lengths: [f64; 2]) -> f64 {
        (**self).normal_off_tangent(heights, lengths)
    }
}
