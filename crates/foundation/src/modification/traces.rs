//! A modification given by helix traces at two or three lengths of roll: a cubic spline along each trace, straight or
//! parabolic between them.

use crate::numerics::{CubicSpline, Jet2};

/// f(w, z) = sum L_i(w) S_i(z): Lagrange's polynomials of the traces' lengths of roll times their splines, mm.
#[derive(Clone, Debug)]
pub(super) struct Traces {
    /// Lengths of roll, two or three, ascending, mm.
    pub(super) w: Vec<f64>,
    /// The splines over z, mm.
    pub(super) splines: Vec<CubicSpline>,
}

impl Traces {
    /// [L_i, L_i', L_i''] at w.
    fn weight(&self, i: usize, w: f64) -> [f64; 3] {
        let others = || self.w.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, x)| *x);
        let scale: f64 = others().map(|x| self.w[i] - x).product();
        let weight: f64 = others().map(|x| w - x).product();
        let [slope, curvature] = match self.w.len() {
            2 => [1.0, 0.0],
            _ => [others().map(|x| w - x).sum(), 2.0],
        };
        [weight / scale, slope / scale, curvature / scale]
    }

    #[inline]
    pub(super) fn value(&self, w: f64, z: f64) -> f64 {
        self.splines.iter().enumerate().map(|(i, spline)| self.weight(i, w)[0] * spline.value(z)).sum()
    }

    #[inline]
    pub(super) fn jet(&self, w: f64, z: f64) -> Jet2 {
        let mut sum = Jet2::default();
        for (i, spline) in self.splines.iter().enumerate() {
            let ([l, l1, l2], [s, s1, s2, _]) = (self.weight(i, w), spline.derivatives(z));
            sum += Jet2 { f: l * s, fu: l1 * s, fv: l * s1, fuu: l2 * s, fuv: l1 * s1, fvv: l * s2 };
        }
        sum
    }
}
