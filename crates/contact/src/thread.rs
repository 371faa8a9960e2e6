//! The involute thread with a normal modification f_n1(w_1, z_1) as a tool surface
//! (`docs/mathematics/generating-contact.md#exact-contact`).

use super::{SurfaceJet, ToolSurface};
use foundation::geometry::InvoluteFlank;
use foundation::numerics::{Jet2, Polynomial2, TensorSpline};

/// A twice differentiable normal modification of a thread over (w_1, z_1), mm.
pub trait ThreadFunction: Sync {
    /// Value and derivatives at (w_1, z_1); `None` outside its domain.
    fn jet(&self, w: f64, z: f64) -> Option<Jet2>;
}

/// f_n1 = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unmodified;

impl ThreadFunction for Unmodified {
    fn jet(&self, _: f64, _: f64) -> Option<Jet2> {
        Some(Jet2::default())
    }
}

impl ThreadFunction for TensorSpline {
    fn jet(&self, w: f64, z: f64) -> Option<Jet2> {
        let [[w0, w1], [z0, z1]] = self.domain();
        (w >= w0 && w <= w1 && z >= z0 && z <= z1).then(|| TensorSpline::jet(self, w, z))
    }
}

impl ThreadFunction for Polynomial2 {
    fn jet(&self, w: f64, z: f64) -> Option<Jet2> {
        Some(Polynomial2::jet(self, w, z))
    }
}

/// An involute thread flank moved by f_n1 along its normals.
#[derive(Clone, Copy, Debug)]
pub struct ModifiedThread<'a, F: ThreadFunction> {
    /// The unmodified flank.
    pub flank: InvoluteFlank,
    /// f_n1, > 0 material left.
    pub function: &'a F,
    /// Factor on f_n1.
    pub share: f64,
}

impl<'a, F: ThreadFunction> ModifiedThread<'a, F> {
    /// The flank with the whole of f_n1.
    pub fn new(flank: InvoluteFlank, function: &'a F) -> Self {
        Self { flank, function, share: 1.0 }
    }
}

impl<F: ThreadFunction> ToolSurface for ModifiedThread<'_, F> {
    fn jet(&self, w: f64, z: f64) -> Option<SurfaceJet> {
        if w.is_nan() || w <= 0.0 {
            return None;
        }
        let Jet2 { f, fu: f_w, fv: f_z, fuu: f_ww, fuv: f_wz, fvv: f_zz } =
            if self.share == 0.0 { Jet2::default() } else { self.function.jet(w, z)? * self.share };
        let (s, r_b) = (self.flank.s(), self.flank.base_radius);
        let (sb, cb) = self.flank.base_helix_angle.sin_cos();
        let tb = sb / cb;
        let frame = self.flank.frame(w, z);
        let (e_r, e_t, n, g) = (frame.e_r, frame.e_t, frame.n, frame.g);
        let wide = (w + f * cb) / r_b;
        let a = f_w / wide;
        let c = cb * f_z + s * sb * f_w;
        let a_w = f_ww / wide - f_w * (1.0 + f_w * cb) / (r_b * wide * wide);
        let a_z = f_wz / wide - f_w * f_z * cb / (r_b * wide * wide);
        let c_w = cb * f_wz + s * sb * f_ww;
        let c_z = cb * f_zz + s * sb * f_wz;
        // Derivatives of the frame by w; those by z are -s tan(beta_b) times them.
        let (er_w, n_w, g_w) = (-e_t / r_b, e_r * (cb / r_b), e_r * (s * sb / r_b));
        let turn = -s * tb;
        let tilt_w = n_w - er_w * a - g_w * c;
        Some(SurfaceJet {
            p: self.flank.point_in(&frame, w, z) + n * f,
            n: n - e_r * a - g * c,
            p_p: e_r * wide + n * f_w,
            p_q: g / cb + e_r * (turn * wide) + n * f_z,
            n_p: tilt_w - e_r * a_w - g * c_w,
            n_q: tilt_w * turn - e_r * a_z - g * c_z,
        })
    }

    fn start(&self, w_1: f64, z_1: f64) -> (f64, f64) {
        (w_1, z_1)
    }

    fn with_share(&self, share: f64) -> Box<dyn ToolSurface + '_> {
        Box::new(ModifiedThread { share: self.share * share, ..*self })
    }
}
