//! What the exact solver must know of a tool surface, and nothing more.

use foundation::numerics::{gradient_of, value_of};
use nalgebra::Vector3;
use num_dual::DualSVec64;

/// A point of a two-parameter surface with its outward normal (any length) and their first derivatives, in the tool's
/// rest frame. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceJet {
    /// Point P.
    pub p: Vector3<f64>,
    /// Normal N out of the material.
    pub n: Vector3<f64>,
    /// dP/dp.
    pub p_p: Vector3<f64>,
    /// dP/dq.
    pub p_q: Vector3<f64>,
    /// dN/dp.
    pub n_p: Vector3<f64>,
    /// dN/dq.
    pub n_q: Vector3<f64>,
}

impl SurfaceJet {
    /// From point and outward normal with their derivatives by (p, q).
    pub fn of_duals(point: &Vector3<DualSVec64<2>>, normal: &Vector3<DualSVec64<2>>) -> Self {
        let value = |x: &Vector3<DualSVec64<2>>| x.map(value_of);
        let by = |x: &Vector3<DualSVec64<2>>, k: usize| x.map(|c| gradient_of(&c)[k]);
        Self {
            p: value(point),
            n: value(normal),
            p_p: by(point, 0),
            p_q: by(point, 1),
            n_p: by(normal, 0),
            n_q: by(normal, 1),
        }
    }
}

/// A smooth tool flank with parameters (p, q) (`docs/mathematics/generating-contact.md#exact-contact`): involute thread with a
/// modification, worm as dressed, spline through measured points.
pub trait ToolSurface: Send + Sync {
    /// Point, normal and derivatives; `None` where the surface does not exist.
    fn jet(&self, p: f64, q: f64) -> Option<SurfaceJet>;

    /// Parameters of the surface point that belongs to (w_1, z_1) of the unmodified thread.
    fn start(&self, w_1: f64, z_1: f64) -> (f64, f64);

    /// The surface with a share (0..1) of its modification; share 0 is the unmodified thread in the same parameters, the second of
    /// which then runs along its screw evenly.
    fn with_share(&self, share: f64) -> Box<dyn ToolSurface + '_>;

    /// Largest sensible Newton steps in (p, q).
    fn step_limits(&self) -> (f64, f64) {
        (1.5, 6.0)
    }
}
