//! Waviness: a sine along one direction of the flank with an amplitude that varies over the field.

use crate::numerics::Jet2;

/// f_t = (A_0 + A_uu u^2 + A_vv v^2) sin(2 pi X/lambda + delta), X = w sin rho + z cos rho (`docs/mathematics/modifications.md`).
#[derive(Clone, Copy, Debug)]
pub(super) struct Waviness {
    /// (2 pi/lambda)(sin rho, cos rho), rad/mm.
    pub(super) wave: [f64; 2],
    /// delta, rad.
    pub(super) phase: f64,
    /// A_0, A_uu, A_vv in mm.
    pub(super) amplitudes: [f64; 3],
    /// (w_m, z_m), mm.
    pub(super) middle: [f64; 2],
    /// (2/L_a, 2/L_b), 1/mm.
    pub(super) inverse_half: [f64; 2],
}

impl Waviness {
    #[inline]
    pub(super) fn jet(&self, w: f64, z: f64) -> Jet2 {
        let [a_0, a_uu, a_vv] = self.amplitudes;
        let [p, q] = self.inverse_half;
        let (u, v) = ((w - self.middle[0]) * p, (z - self.middle[1]) * q);
        let amplitude = Jet2 {
            f: a_0 + a_uu * u * u + a_vv * v * v,
            fu: 2.0 * a_uu * u * p,
            fv: 2.0 * a_vv * v * q,
            fuu: 2.0 * a_uu * p * p,
            fuv: 0.0,
            fvv: 2.0 * a_vv * q * q,
        };
        let [k_w, k_z] = self.wave;
        let (sin, cos) = (k_w * w + k_z * z + self.phase).sin_cos();
        amplitude * Jet2::ridge([sin, cos, -sin], k_w, k_z)
    }
}
