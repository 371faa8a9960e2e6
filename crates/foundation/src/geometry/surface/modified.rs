//! A flank moved along its normal by a function of its parameters, and its own exact normal:
//! `docs/mathematics/milling.md#flanks-as-patches`.

use super::bounds::remainder;
use super::second_order::jet_of_derivatives;
use super::{OffsetBase, Surface, SurfaceJet};
use crate::numerics::Jet2;
use nalgebra::Vector3;
use std::fmt::Debug;
use std::sync::Arc;

/// Upper bounds of an offset over a box of parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OffsetBounds {
    /// Of |f|, mm.
    pub value: f64,
    /// Of |f_a|, mm per unit of the height.
    pub by_height: f64,
    /// Of |f_b|, mm per unit of the length.
    pub by_length: f64,
    /// Of |f_aa|, |f_ab| and |f_bb|; infinite where f has a kink.
    pub second: [f64; 3],
}

/// An offset f(a, b) of a surface along its normal, mm; > 0 leaves material.
pub trait NormalOffset: Send + Sync + Debug {
    /// Value, gradient and second derivatives at (a, b).
    fn jet(&self, height: f64, length: f64) -> Jet2;

    /// Upper bounds over a box of parameters: true everywhere in it, not sampled.
    fn bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> OffsetBounds;
}

/// P' = P + f n of a base surface, with the normal of P' itself on the side of the base's. Several offsets are one function: the
/// second derivatives of P' need those of the base's normal, so that what has been modified is no base again.
#[derive(Clone, Debug)]
pub struct Modified<S> {
    base: S,
    offset: Arc<dyn NormalOffset>,
}

impl<S: OffsetBase> Modified<S> {
    /// A surface with an offset.
    pub fn new(base: S, offset: Arc<dyn NormalOffset>) -> Self {
        Self { base, offset }
    }

    /// The surface without its offset.
    pub fn base(&self) -> &S {
        &self.base
    }

    /// The offset.
    pub fn offset(&self) -> &Arc<dyn NormalOffset> {
        &self.offset
    }
}

impl<S: OffsetBase> Surface for Modified<S> {
    fn domain(&self) -> [[f64; 2]; 2] {
        self.base.domain()
    }

    fn point(&self, height: f64, length: f64) -> Vector3<f64> {
        let at = self.base.jet(height, length);
        at.point + at.normal * self.offset.jet(height, length).f
    }

    /// Where P' has no tangent plane (an edge at the base circle) the normal and its derivatives are the base's.
    fn jet(&self, height: f64, length: f64) -> SurfaceJet {
        let at = self.base.second_order(height, length);
        let f = self.offset.jet(height, length);
        let base = &at.jet;
        let first = [
            base.by_height + base.normal * f.fu + base.normal_by_height * f.f,
            base.by_length + base.normal * f.fv + base.normal_by_length * f.f,
        ];
        let (n, n_a, n_b) = (&base.normal, &base.normal_by_height, &base.normal_by_length);
        let second = [
            at.point[0] + n * f.fuu + n_a * (2.0 * f.fu) + at.normal[0] * f.f,
            at.point[1] + n * f.fuv + n_b * f.fu + n_a * f.fv + at.normal[1] * f.f,
            at.point[2] + n * f.fvv + n_b * (2.0 * f.fv) + at.normal[2] * f.f,
        ];
        let point = base.point + n * f.f;
        let side = if first[0].cross(&first[1]).dot(n) < 0.0 { -1.0 } else { 1.0 };
        jet_of_derivatives(point, first, &second, side).unwrap_or(SurfaceJet {
            point,
            by_height: first[0],
            by_length: first[1],
            ..*base
        })
    }

    /// From the bounds of base and offset: n is perpendicular to S_a and n_a.
    fn speed_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 2] {
        let speeds = self.base.speed_bounds(heights, lengths);
        let turns = self.base.normal_speed_bounds(heights, lengths);
        let offset = self.offset.bounds(heights, lengths);
        [
            (speeds[0] + moved(offset.value, turns[0])).hypot(offset.by_height),
            (speeds[1] + moved(offset.value, turns[1])).hypot(offset.by_length),
        ]
    }

    /// With f = f_0 + f_1 + f_r and n = n_0 + n_1 + n_r (value, linear part and remainder at the middle), f n differs from its own
    /// linear part by f_r n_0 + f_0 n_r + (f - f_0)(n - n_0).
    fn off_tangent(&self, heights: [f64; 2], lengths: [f64; 2]) -> f64 {
        let offset = self.offset.bounds(heights, lengths);
        let turns = self.base.normal_speed_bounds(heights, lengths);
        let [a, b] = [heights, lengths].map(|[from, to]| 0.5 * (to - from).abs());
        let change = offset.by_height * a + offset.by_length * b;
        // Also where f has kinks it does not leave its linear part faster than both can change.
        self.base.off_tangent(heights, lengths)
            + remainder(offset.second, heights, lengths).min(2.0 * change)
            + moved(offset.value, self.base.normal_off_tangent(heights, lengths))
            + moved(change, turns[0] * a + turns[1] * b)
    }
}

/// How far an offset of at most `amount` moves by a turn of the normal. Without an offset a turn without bound does no harm: 0 times
/// infinity would be no number.
fn moved(amount: f64, turn: f64) -> f64 {
    if amount == 0.0 { 0.0 } else { amount * turn }
}
