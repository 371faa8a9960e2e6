//! The modification of an ideal worm: what a decomposition asks of the worm flank at the point that grinds each workpiece
//! point (spec 25 section 4, spec 28 section 4).

use super::target::relief_jet;
use super::{Decomposition, FlankLines};
use crate::contact::ThreadFunction;
use crate::modification::Modification;
use crate::numerics::Jet2;

/// f_n1(w_1, z_1) = -cos b2 (F_C + F_L u + F_P + reliefs) at the mapped point, normal, mm.
#[derive(Clone, Debug)]
pub struct IdealWorm {
    /// Numbers of the flank.
    pub lines: FlankLines,
    /// Diagonal ratio K (0 for the class `radial`).
    pub ratio: f64,
    /// z_V01, mm.
    pub shift_origin: f64,
    /// The parts.
    pub parts: Decomposition,
    /// Profile parts that are no polynomials.
    pub reliefs: Vec<Modification>,
}

impl IdealWorm {
    /// F_C + F_L u at the workpiece point ground by (w_1, z_1), as a function of (w_1, z_1).
    fn dressing_jet(&self, w_1: f64, z_1: f64) -> Jet2 {
        let [w, z] = self.lines.work_point(w_1, z_1, self.ratio, self.shift_origin);
        self.parts.dressing_jet(w.f - self.lines.w_m, z.f - self.lines.z_m).of(w, z)
    }

    /// The part that the dressing motion carries, -cos b2 (F_C + F_L u), at (w_1, z_1), mm. Zero for the class `radial`.
    pub fn dressing_share(&self, w_1: f64, z_1: f64) -> f64 {
        if self.ratio == 0.0 {
            return 0.0;
        }
        -self.lines.cos_b2 * self.dressing_jet(w_1, z_1).f
    }

    /// The profile part on the gear, F_P + reliefs, transverse, with two derivatives by w_2; `None` where it does not exist.
    pub fn profile_share(&self, w_2: f64) -> Option<[f64; 3]> {
        let relief = relief_jet(&self.reliefs, w_2, self.lines.z_m)?;
        let profile = self.parts.profile_jet(w_2 - self.lines.w_m);
        Some(std::array::from_fn(|k| profile[k] + relief[k]))
    }
}

impl ThreadFunction for IdealWorm {
    fn jet(&self, w_1: f64, z_1: f64) -> Option<Jet2> {
        let cos = -self.lines.cos_b2;
        let w_2 = self.lines.work_roll(w_1);
        let shrink = -self.lines.cos_b2 / self.lines.cos_b1;
        let p = self.profile_share(w_2)?;
        let mut jet = Jet2 {
            f: p[0] * cos,
            fu: p[1] * shrink * cos,
            fuu: p[2] * shrink * shrink * cos,
            ..Jet2::default()
        };
        if self.ratio != 0.0 {
            jet += self.dressing_jet(w_1, z_1) * cos;
        }
        Some(jet)
    }
}
