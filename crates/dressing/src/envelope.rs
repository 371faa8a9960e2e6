//! Contact of one dresser circle with its envelope on the worm, exactly and in closed form (`docs/mathematics/dressing.md`),
//! and the worm as dressed by a motion DK(v) as a tool surface.

use super::dresser::FlankDresser;
use super::placement::{DresserAxes, RoomContact, WormScrew, touch};
use super::{DresserTool, GeometricRange};
use contact::{SurfaceJet, ToolSurface};
use foundation::geometry::{Flank, InvoluteFlank, MeridianPoint, ProfileOffset};
use foundation::kinematics::{DressingChain, DressingMotion};
use foundation::numerics::{Chebyshev, ChebyshevTable, Scalar, gradient_of, value_of, variables};
use nalgebra::Vector3;
use std::sync::Arc;

/// Pose of the dresser in the room and motion of the worm against it, per radian of worm rotation.
#[derive(Clone, Copy, Debug)]
pub(super) struct RelativeScrew<T: Scalar> {
    pub gamma: T,
    pub d: T,
    pub v_y: T,
    /// Rates by the worm position v: gamma', phi' (beyond 1/p), d', v_y'.
    pub rates: [T; 4],
    pub p: f64,
}

/// The contact of a dresser circle; `None` where the circle touches nothing.
pub(super) fn circle_contact<T: Scalar>(
    m: &MeridianPoint<T>,
    at: &RelativeScrew<T>,
) -> Option<RoomContact<T>> {
    let (sin, cos) = at.gamma.sin_cos();
    let (zero, one) = (T::from(0.0), T::from(1.0));
    let [gamma_v, phi_v, d_v, vy_v] = at.rates;
    let p = at.p;
    let worm = WormScrew {
        spin: Vector3::new(gamma_v * p, zero, phi_v * p + 1.0),
        drift: Vector3::new(-d_v * p, vy_v * cos * p, (one - vy_v * sin) * p),
    };
    touch(m, &DresserAxes::kinematic(at.gamma, at.d, at.v_y), &worm)
}

/// A point of the exact envelope of the moving dresser, in the worm's (w, b) coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnvelopePoint {
    /// Length of roll of the foot on the nominal flank, mm.
    pub w: f64,
    /// Worm z of the foot, mm.
    pub b: f64,
    /// Normal modification, mm.
    pub f: f64,
}

/// One flank of the worm as dressed: exact envelope over (t, v) (`docs/mathematics/dressing.md#conditions`).
#[derive(Clone, Debug)]
pub struct DressedWorm {
    dresser: FlankDresser,
    /// The four corrections, each with its first two derivatives.
    table: ChebyshevTable<12>,
    share: f64,
}

/// A profile offset times a factor.
#[derive(Debug)]
struct ScaledOffset(Arc<dyn ProfileOffset>, f64);

impl ProfileOffset for ScaledOffset {
    fn jet(&self, t: f64) -> [f64; 3] {
        self.0.jet(t).map(|x| x * self.1)
    }
}

impl DressedWorm {
    /// The worm flank dressed by `tool` with the correction series `corrections` (rad, rad, mm, mm over v; one interval).
    pub fn new(tool: &DresserTool, flank: Flank, corrections: &[Chebyshev; 4]) -> Self {
        let first = corrections.each_ref().map(Chebyshev::derivative);
        let second = first.each_ref().map(Chebyshev::derivative);
        let series = std::array::from_fn(|k| [&corrections[k / 3], &first[k / 3], &second[k / 3]][k % 3]);
        Self { dresser: tool.flanks[flank].clone(), table: ChebyshevTable::new(series), share: 1.0 }
    }

    /// The unmodified worm flank it stands on.
    pub fn flank(&self) -> &InvoluteFlank {
        &self.dresser.worm
    }

    /// Used range of the profile.
    pub fn range(&self) -> GeometricRange {
        self.dresser.range
    }

    /// Worm positions between which the motion goes, mm.
    pub(super) fn interval(&self) -> (f64, f64) {
        self.table.interval()
    }

    /// The four corrections at v with two derivatives each.
    fn corrections(&self, v: f64) -> [[f64; 3]; 4] {
        let values = self.table.values(v);
        std::array::from_fn(|k| std::array::from_fn(|order| values[3 * k + order] * self.share))
    }

    fn covers(&self, t: f64, v: f64) -> bool {
        self.dresser.profile.covers(t) && self.table.covers(v)
    }

    /// Envelope point and dresser normal in worm coordinates for dual parameters; `None` outside the dressed area or
    /// without contact.
    fn surface<T: Scalar>(&self, t: T, v: T) -> Option<(Vector3<T>, Vector3<T>)> {
        if !self.covers(value_of(t), value_of(v)) {
            return None;
        }
        let dv = v - value_of(v);
        let jets = self.corrections(value_of(v));
        let lifted = |k: usize, order: usize| {
            let slope = jets[k].get(order + 1).copied().unwrap_or(0.0);
            dv * slope + jets[k][order]
        };
        let screw = RelativeScrew {
            gamma: lifted(1, 0) + self.dresser.chain.crossing_angle,
            d: lifted(2, 0) + self.dresser.chain.centre_distance,
            v_y: lifted(3, 0) + self.dresser.chain.offset,
            rates: [lifted(1, 1), lifted(0, 1), lifted(2, 1), lifted(3, 1)],
            p: self.dresser.chain.screw_parameter,
        };
        let contact = circle_contact(&self.dresser.profile.at(t), &screw)?;
        let angle = lifted(0, 0) + self.dresser.chain.worm_angle + v / self.dresser.chain.screw_parameter;
        Some(contact.on_worm(angle, -v))
    }

    /// The envelope point for profile parameter t at worm position v; `None` outside the dressed area.
    pub fn envelope_point(&self, t: f64, v: f64) -> Option<EnvelopePoint> {
        let (point, _) = self.surface(t, v)?;
        let at = self.dresser.worm.deviation(&point);
        Some(EnvelopePoint { w: at.w, b: at.z, f: at.f_n })
    }

    /// What the dresser circle with profile parameter t dresses at worm z = b, and at which worm position: Newton in v from the
    /// nominal contact. `None` where that lies outside the dressed area.
    pub fn at_height(&self, t: f64, b: f64) -> Option<(EnvelopePoint, f64)> {
        let (range, designed) = (&self.dresser.range, &self.dresser.designed);
        let w = range.w_nf + (t - designed.w_nf) * (range.length() / designed.length());
        let (_, mut v) = self.start(w, b);
        let mut previous = f64::INFINITY;
        for _ in 0..40 {
            let [vd] = variables([v]);
            let (point, _) = self.surface(num_dual::DualSVec64::<1>::from(t), vd)?;
            let z = self.dresser.worm.deviation(&point).z;
            let step = (value_of(z) - b) / gradient_of(&z)[0];
            if !step.is_finite() {
                return None;
            }
            v -= step;
            if step.abs() < 1e-12 || (step.abs() < 1e-9 && step.abs() >= previous) {
                return self.envelope_point(t, v).map(|e| (e, v));
            }
            previous = step.abs();
        }
        None
    }

    /// f at a worm point (w, b) and the (t, v) that dresses it: 2-D Newton from the nominal contact. `None` where the
    /// point is not dressed.
    pub fn modification(&self, w: f64, b: f64) -> Option<(f64, f64, f64)> {
        let (mut t, mut v) = self.start(w, b);
        let mut previous = f64::INFINITY;
        for _ in 0..40 {
            let [td, vd] = variables([t, v]);
            let (point, _) = self.surface(td, vd)?;
            let at = self.dresser.worm.deviation(&point);
            let (gw, gb) = (gradient_of(&at.w), gradient_of(&at.z));
            let (rw, rb) = (value_of(at.w) - w, value_of(at.z) - b);
            let det = gw[0] * gb[1] - gw[1] * gb[0];
            let (dt, dv) = ((rw * gb[1] - rb * gw[1]) / det, (gw[0] * rb - gb[0] * rw) / det);
            let size = dt.abs().max(dv.abs());
            if !size.is_finite() {
                return None;
            }
            t -= dt;
            v -= dv;
            if size < 1e-12 || (size < 1e-9 && size >= previous) {
                return self.envelope_point(t, v).map(|e| (e.f, t, v));
            }
            previous = size;
        }
        None
    }
}

impl ToolSurface for DressedWorm {
    fn jet(&self, t: f64, v: f64) -> Option<SurfaceJet> {
        let [td, vd] = variables([t, v]);
        let (p, n) = self.surface(td, vd)?;
        // The dresser's outward normal points into the worm.
        Some(SurfaceJet::of_duals(&p, &-n))
    }

    fn start(&self, w_1: f64, z_1: f64) -> (f64, f64) {
        let (from, to) = self.dresser.profile.interval();
        let (range, designed) = (&self.dresser.range, &self.dresser.designed);
        let scaled = designed.w_nf + (w_1 - range.w_nf) * (designed.length() / range.length());
        let t = scaled.clamp(from, to);
        let (first, last) = self.dresser.line.interval();
        let b = self.dresser.line.value(w_1.clamp(first, last));
        let (from, to) = self.table.interval();
        (t, (b - z_1).clamp(from, to))
    }

    fn with_share(&self, share: f64) -> Box<dyn ToolSurface + '_> {
        let mut scaled = self.clone();
        scaled.share *= share;
        scaled.dresser.profile = match (share, self.dresser.profile.offset()) {
            (_, None) => self.dresser.profile.clone(),
            (0.0, Some(_)) => self.dresser.profile.plain(),
            (_, Some(offset)) => {
                self.dresser.profile.with_offset(Arc::new(ScaledOffset(offset.clone(), share)))
            }
        };
        Box::new(scaled)
    }
}

/// The dressing motion that a set of correction series describes.
pub fn dressing_motion(chain: DressingChain, corrections: &[Chebyshev; 4]) -> DressingMotion {
    DressingMotion { chain, correction: corrections.clone().map(foundation::kinematics::MotionLaw::series) }
}
