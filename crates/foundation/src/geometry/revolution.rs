//! A surface of revolution with a smooth meridian, such as a dressing disc, plus a normal offset of its profile.
//!
//! Knows nothing of how the meridian was found. Coordinates: r from the axis, z along it, mm.

use crate::numerics::{Chebyshev, ChebyshevTable, Scalar, value_of};
use std::sync::Arc;

/// A function of the profile parameter with its first two derivatives: normal offset of a meridian, mm.
pub trait ProfileOffset: Send + Sync + std::fmt::Debug {
    /// `[g, g', g'']` at the parameter t.
    fn jet(&self, t: f64) -> [f64; 3];
}

/// Meridian of a surface of revolution as Chebyshev series of a parameter t; parametrised so that t is usually the length
/// of roll of the flank point that the profile point was designed for.
#[derive(Clone, Debug)]
pub struct Revolution {
    /// Radius and axial position, each with three derivatives.
    series: Arc<ChebyshevTable<8>>,
    orientation: f64,
    offset: Option<Arc<dyn ProfileOffset>>,
    /// What of the meridian is there; `None`: all of it.
    part: Option<(f64, f64)>,
}

/// Point and outward unit normal of a meridian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeridianPoint<T: Scalar> {
    /// Radius, mm.
    pub r: T,
    /// Axial position, mm.
    pub z: T,
    /// Radial part of the outward normal.
    pub n_r: T,
    /// Axial part of the outward normal.
    pub n_z: T,
}

impl Revolution {
    /// A meridian from its two series over the same interval; the outward normal is `orientation`·(z', -r')/|..|.
    pub fn new(radius: Chebyshev, axial: Chebyshev, orientation: f64) -> Self {
        let jets = |series: Chebyshev| {
            let d1 = series.derivative();
            let d2 = d1.derivative();
            let d3 = d2.derivative();
            [series, d1, d2, d3]
        };
        let ([r, r1, r2, r3], [z, z1, z2, z3]) = (jets(radius), jets(axial));
        Self {
            series: Arc::new(ChebyshevTable::new([&r, &r1, &r2, &r3, &z, &z1, &z2, &z3])),
            orientation: orientation.signum(),
            offset: None,
            part: None,
        }
    }

    /// The same surface with its profile moved outwards by g(t) along its normal (more material for g > 0).
    pub fn with_offset(&self, offset: Arc<dyn ProfileOffset>) -> Self {
        Self { offset: Some(offset), ..self.clone() }
    }

    /// The same surface without offset.
    pub fn plain(&self) -> Self {
        Self { offset: None, ..self.clone() }
    }

    /// The offset the profile carries, if any.
    pub fn offset(&self) -> Option<&Arc<dyn ProfileOffset>> {
        self.offset.as_ref()
    }

    /// The surface between two parameters, as far as it is there; beyond them it ends in edges.
    pub fn part(&self, from: f64, to: f64) -> Self {
        let (first, last) = self.interval();
        Self { part: Some((from.max(first), to.min(last))), ..self.clone() }
    }

    /// Whether it is the part of a surface.
    pub fn is_part(&self) -> bool {
        self.part.is_some()
    }

    /// Parameter interval the series were made for, or that of the part.
    pub fn interval(&self) -> (f64, f64) {
        self.part.unwrap_or_else(|| self.series.interval())
    }

    /// Whether t lies on the meridian.
    pub fn covers(&self, t: f64) -> bool {
        self.series.covers(t) && self.part.is_none_or(|(from, to)| t >= from && t <= to)
    }

    /// Point and outward normal at t, with the offset. Exact first derivatives for dual numbers.
    pub fn at<T: Scalar>(&self, t: T) -> MeridianPoint<T> {
        let x = value_of(t);
        let dt = t - x;
        // Black-box functions enter dual arithmetic by their own derivatives: f(t) = f(x) + f'(x) dt, exact to first order.
        let lift = |value: f64, slope: f64| dt * slope + value;
        let [r0, r1, r2, r3, z0, z1, z2, z3] = self.series.values(x);
        let (r, z) = (lift(r0, r1), lift(z0, z1));
        let (tr, tz) = (lift(r1, r2), lift(z1, z2));
        let length = (tr * tr + tz * tz).sqrt();
        let (n_r, n_z) = (tz / length * self.orientation, -tr / length * self.orientation);
        let Some(offset) = &self.offset else {
            return MeridianPoint { r, z, n_r, n_z };
        };
        let [g0, g1, g2] = offset.jet(x);
        let (g, dg) = (lift(g0, g1), lift(g1, g2));
        let (ar, az) = (lift(r2, r3), lift(z2, z3));
        // N' = -kappa (tangent), kappa = (r' z'' - z' r'')/length^3 in the sense of the orientation.
        let turn = (tr * az - tz * ar) / (length * length) * self.orientation;
        let (mr, mz) = (tr / length * turn, tz / length * turn);
        let (sr, sz) = (tr + dg * n_r + g * mr, tz + dg * n_z + g * mz);
        let new_length = (sr * sr + sz * sz).sqrt();
        MeridianPoint {
            r: r + g * n_r,
            z: z + g * n_z,
            n_r: sz / new_length * self.orientation,
            n_z: -sr / new_length * self.orientation,
        }
    }
}
