//! The modification of an ideal tool: what a decomposition asks of the tool's flank at the point that grinds each workpiece
//! point (`docs/mathematics/generating-contact.md#decomposition-of-a-target`, `docs/mathematics/planning.md#from-the-ratio-to-the-flank`).

use super::target::relief_jet;
use super::{Carried, Decomposition, FlankLines, MovedProfile};
use contact::ThreadFunction;
use foundation::kinematics::{MotionLaw, PiecewisePolynomial};
use foundation::modification::Modification;
use foundation::numerics::Jet2;
use std::sync::Arc;

/// f_n1(w_1, z_1) = -cos b2 (F_C + F_L u + carried + F_P + reliefs) at the mapped point, normal, mm; or the modification that a
/// tool already has.
#[derive(Clone, Debug)]
pub struct IdealWorm {
    /// Numbers of the flank.
    pub lines: FlankLines,
    /// z_V1 as a function of z_V2; a constant for the class `radial`, whose tool has no lines of its own.
    pub shift: MotionLaw,
    /// The parts.
    pub parts: Decomposition,
    /// What the lines carry beside them.
    pub carried: Carried,
    /// Profile parts that are no polynomials.
    pub reliefs: Vec<Modification>,
    /// Where the reliefs of a dresser that exists are laid; `None`: where it was designed for.
    pub moved: Option<Arc<MovedProfile>>,
    /// A fitted profile over w_2, transverse, mm.
    pub spline: Option<PiecewisePolynomial>,
    /// The modification of a tool that exists, over (w_1, z_1), transverse, mm: it takes the place of all others.
    pub given: Option<Modification>,
}

impl IdealWorm {
    /// Whether no profile is asked of a dresser.
    pub fn has_plain_profile(&self) -> bool {
        let polynomial = self.parts.profile.iter().any(|&p| p != 0.0);
        self.reliefs.is_empty() && self.spline.is_none() && !polynomial
    }

    /// Whether the tool is not shifted, so that it has no lines of its own.
    pub fn is_radial(&self) -> bool {
        self.shift.is_constant()
    }

    /// F_C + F_L u + carried at the workpiece point ground by (w_1, z_1), as a function of (w_1, z_1); `None` where it does not
    /// exist.
    fn dressing_jet(&self, w_1: f64, z_1: f64) -> Option<Jet2> {
        let [w, z] = self.lines.work_point(w_1, z_1, &self.shift);
        let own = self.parts.dressing_jet(w.f - self.lines.w_m, z.f - self.lines.z_m);
        Some((own + self.carried.jet(&self.lines, w.f, z.f)?).of(w, z))
    }

    /// The part that the tool's lines carry, -cos b2 (F_C + F_L u + carried), at (w_1, z_1), mm. Zero for the class `radial`, NaN
    /// where it does not exist.
    pub fn dressing_share(&self, w_1: f64, z_1: f64) -> f64 {
        if self.is_radial() {
            return 0.0;
        }
        self.dressing_jet(w_1, z_1).map_or(f64::NAN, |jet| -self.lines.cos_b2 * jet.f)
    }

    /// 1 where (w_1, z_1) grinds the evaluated flank, falling to 0 over some `fall` mm beyond its ends in z, smoothly.
    pub fn share_of_flank(&self, w_1: f64, z_1: f64, fall: f64) -> f64 {
        let [_, z] = self.lines.work_point(w_1, z_1, &self.shift);
        let [from, to] = self.lines.face;
        let beyond = (from - z.f).max(z.f - to);
        1.0 / (1.0 + (beyond / fall).min(700.0).exp())
    }

    /// The profile part on the gear, F_P + reliefs + spline, transverse, with two derivatives by w_2, of a dresser in its designed place;
    /// `None` where it does not exist.
    pub fn profile_share(&self, w_2: f64) -> Option<[f64; 3]> {
        let relief = relief_jet(&self.reliefs, w_2, self.lines.z_m)?;
        let profile = self.parts.profile_jet(w_2 - self.lines.w_m);
        let spline = self.spline.as_ref().map_or([0.0; 3], |spline| spline.jet(w_2));
        Some(std::array::from_fn(|k| profile[k] + relief[k] + spline[k]))
    }
}

impl ThreadFunction for IdealWorm {
    fn jet(&self, w_1: f64, z_1: f64) -> Option<Jet2> {
        if let Some(given) = &self.given {
            return given.jet(w_1, z_1).ok().map(|jet| jet * self.lines.cos_b1);
        }
        let cos = -self.lines.cos_b2;
        let slope = self.lines.work_roll_slope();
        let w_2 = self.lines.work_roll(w_1);
        let mut p = self.profile_share(w_2)?;
        let mut moved = Jet2::default();
        if let Some(places) = &self.moved {
            let place = places.jet(w_1, z_1);
            let here = relief_jet(&self.reliefs, w_2, self.lines.z_m)?;
            let [f, f_w, f_ww] = relief_jet(&self.reliefs, self.lines.work_roll(place.f), self.lines.z_m)?;
            for (p, here) in p.iter_mut().zip(here) {
                *p -= here;
            }
            let there = Jet2 { f, fu: f_w * slope, fuu: f_ww * slope * slope, ..Jet2::default() };
            moved = there.of(place, Jet2::default()) * cos;
        }
        let mut jet = Jet2 {
            f: p[0] * cos,
            fu: p[1] * slope * cos,
            fuu: p[2] * slope * slope * cos,
            ..Jet2::default()
        } + moved;
        if !self.is_radial() {
            jet += self.dressing_jet(w_1, z_1)? * cos;
        }
        jet.is_finite().then_some(jet)
    }
}
