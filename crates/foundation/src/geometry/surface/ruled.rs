//! A ruled blade: straight lines between a curve at the hub and one at the tip, `docs/mathematics/milling.md#flanks-as-patches`.
//!
//! Height v = share of the way from hub to tip, length u = the curves' parameter.

use super::bounds::remainder;
use super::second_order::{cross_product_bounds, jet_of_derivatives, second_order_of};
use super::{BladeCurve, CylindricalCurve, NormalSide, OffsetBase, SecondOrder, Surface, SurfaceJet};
use crate::geometry::GeometryError;
use crate::numerics::Jet2;
use nalgebra::Vector3;
use std::sync::Arc;

/// S(v, u) = (1 - v) A(u) + v B(u).
#[derive(Clone, Debug)]
pub struct RuledBlade {
    hub: Arc<dyn BladeCurve>,
    tip: Arc<dyn BladeCurve>,
    side: NormalSide,
}

/// A blade on a conical hub inside a cylinder: the reference case of `docs/mathematics/milling.md#flanks-as-patches`. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BladeData {
    /// r_hub0, r_hub1: radii of the hub at u = 0 and 1.
    pub hub_radius: [f64; 2],
    /// r_tip: radius of the tip.
    pub tip_radius: f64,
    /// L: axial length.
    pub length: f64,
    /// th0, th1: azimuths of the hub curve at both ends, between them with u^2.
    pub hub_azimuth: [f64; 2],
    /// dth_tip0, dth_tip1: by how much the tip leads the hub at both ends.
    pub tip_lead: [f64; 2],
    /// Which side is out of the material.
    pub side: NormalSide,
}

impl RuledBlade {
    /// A blade between two curves over a common parameter.
    ///
    /// # Errors
    /// [`GeometryError::InvalidGeometry`] when they share no interval of it.
    pub fn new(
        hub: Arc<dyn BladeCurve>,
        tip: Arc<dyn BladeCurve>,
        side: NormalSide,
    ) -> Result<Self, GeometryError> {
        let blade = Self { hub, tip, side };
        let [from, to] = blade.lengths();
        if from < to {
            return Ok(blade);
        }
        Err(GeometryError::InvalidGeometry {
            what: "common interval of the blade's curves".into(),
            value: to - from,
            allowed: "> 0".into(),
        })
    }

    /// The blade of the reference case.
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`] for sizes that are no blade.
    pub fn of_data(data: &BladeData) -> Result<Self, GeometryError> {
        let number = |field, value: f64, good: bool, allowed| {
            if good && value.is_finite() {
                Ok(())
            } else {
                Err(GeometryError::InvalidNumber { field, value, allowed })
            }
        };
        let [r_0, r_1] = data.hub_radius;
        number("hub_radius at the beginning", r_0, r_0 > 0.0, "> 0 mm")?;
        number("hub_radius at the end", r_1, r_1 > 0.0, "> 0 mm")?;
        number("tip_radius", data.tip_radius, data.tip_radius > r_0.max(r_1), "above the hub's radii")?;
        number("blade length", data.length, data.length > 0.0, "> 0 mm")?;
        let ([th_0, th_1], [lead_0, lead_1]) = (data.hub_azimuth, data.tip_lead);
        let bend = th_1 - th_0;
        let height = [0.0, data.length, 0.0, 0.0];
        let hub = CylindricalCurve::new([r_0, r_1 - r_0, 0.0, 0.0], [th_0, 0.0, bend, 0.0], height)?;
        let tip = CylindricalCurve::new(
            [data.tip_radius, 0.0, 0.0, 0.0],
            [th_0 + lead_0, lead_1 - lead_0, bend, 0.0],
            height,
        )?;
        Self::new(Arc::new(hub), Arc::new(tip), data.side)
    }

    /// Curve A at the hub.
    pub fn hub(&self) -> &Arc<dyn BladeCurve> {
        &self.hub
    }

    /// Curve B at the tip.
    pub fn tip(&self) -> &Arc<dyn BladeCurve> {
        &self.tip
    }

    fn lengths(&self) -> [f64; 2] {
        let (hub, tip) = (self.hub.domain(), self.tip.domain());
        [hub[0].max(tip[0]), hub[1].min(tip[1])]
    }

    fn derivative_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> DerivativeBounds {
        let width = lengths[1] - lengths[0];
        let (hub, tip) = (self.hub.bounds(lengths), self.tip.bounds(lengths));
        let ends = lengths.map(|u| (self.hub.derivatives(u), self.tip.derivatives(u)));
        let across =
            |order: usize, bend: f64| longest(ends.each_ref().map(|(a, b)| b[order] - a[order]), width, bend);
        let share = |v: f64, i: usize| (1.0 - v).abs() * hub[i] + v.abs() * tip[i];
        // S_u is linear in v, so that it is longest at an end of the heights.
        let along = heights
            .map(|v| longest(ends.each_ref().map(|(a, b)| a[1] * (1.0 - v) + b[1] * v), width, share(v, 1)));
        DerivativeBounds {
            by_height: across(0, hub[0] + tip[0]),
            by_length: along[0].max(along[1]),
            mixed: across(1, hub[1] + tip[1]),
            by_length_twice: share(heights[0], 0).max(share(heights[1], 0)),
        }
    }
}

/// Greatest length of a vector over an interval of the given width, from its values at both ends and a bound of its second
/// derivative: it lies off the chord by at most width^2/8 times that, and no point of a chord is longer than its ends are.
fn longest(ends: [Vector3<f64>; 2], width: f64, bend: f64) -> f64 {
    ends[0].norm().max(ends[1].norm()) + width * width / 8.0 * bend
}

/// Upper bounds of |S_v|, |S_u|, |S_uv| and |S_uu| over a box.
struct DerivativeBounds {
    by_height: f64,
    by_length: f64,
    mixed: f64,
    by_length_twice: f64,
}

impl Surface for RuledBlade {
    fn domain(&self) -> [[f64; 2]; 2] {
        [[0.0, 1.0], self.lengths()]
    }

    fn point(&self, v: f64, u: f64) -> Vector3<f64> {
        self.hub.derivatives(u)[0] * (1.0 - v) + self.tip.derivatives(u)[0] * v
    }

    /// Where the blade has no tangent plane the normal and its derivatives are zero.
    fn jet(&self, v: f64, u: f64) -> SurfaceJet {
        let (a, b) = (self.hub.derivatives(u), self.tip.derivatives(u));
        let along = |order: usize| a[order] * (1.0 - v) + b[order] * v;
        let none = Vector3::zeros();
        let (by_height, by_length) = (b[0] - a[0], along(1));
        let second = [none, b[1] - a[1], along(2)];
        jet_of_derivatives(along(0), [by_height, by_length], &second, self.side.sign()).unwrap_or(
            SurfaceJet {
                point: along(0),
                by_height,
                by_length,
                normal: none,
                normal_by_height: none,
                normal_by_length: none,
            },
        )
    }

    fn speed_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 2] {
        let bounds = self.derivative_bounds(heights, lengths);
        [bounds.by_height, bounds.by_length]
    }

    fn off_tangent(&self, heights: [f64; 2], lengths: [f64; 2]) -> f64 {
        let bounds = self.derivative_bounds(heights, lengths);
        remainder([0.0, bounds.mixed, bounds.by_length_twice], heights, lengths)
    }
}

impl OffsetBase for RuledBlade {
    fn second_order(&self, v: f64, u: f64) -> SecondOrder {
        let (a, b) = (self.hub.derivatives(u), self.tip.derivatives(u));
        let along = [0, 1, 2, 3].map(|order| a[order] * (1.0 - v) + b[order] * v);
        let across = [0, 1, 2].map(|order| b[order] - a[order]);
        let by_height = [0, 1, 2].map(|i| Jet2 {
            f: across[0][i],
            fv: across[1][i],
            fvv: across[2][i],
            ..Jet2::default()
        });
        let by_length = [0, 1, 2].map(|i| Jet2 {
            f: along[1][i],
            fu: across[1][i],
            fv: along[2][i],
            fuu: 0.0,
            fuv: across[2][i],
            fvv: along[3][i],
        });
        second_order_of(along[0], &by_height, &by_length, self.side.sign())
    }

    fn normal_speed_bounds(&self, heights: [f64; 2], lengths: [f64; 2]) -> [f64; 2] {
        let bounds = self.derivative_bounds(heights, lengths);
        let middle = self.jet((heights[0] + heights[1]) / 2.0, (lengths[0] + lengths[1]) / 2.0);
        cross_product_bounds(
            [bounds.by_height, bounds.by_length],
            [0.0, bounds.mixed, bounds.by_length_twice],
            [(heights[1] - heights[0]) / 2.0, (lengths[1] - lengths[0]) / 2.0],
            middle.by_height.cross(&middle.by_length).norm(),
        )
    }
}
