//! A circle of the dresser swept along the worm's thread: what it leaves on any worm flank, without the condition of contact
//! (`docs/mathematics/dressing.md#limits-of-a-correction`). An independent check of the forward calculation. Knows no section and no limit.

use crate::GeometricRange;
use crate::limits::dresser_pose::DresserPose;
use crate::limits::dresser_section::SectionCircle;
use foundation::geometry::InvoluteFlank;
use foundation::numerics::brent;
use std::f64::consts::{FRAC_PI_2, PI};

/// Worm flank on which a sweep is judged, in the plane z = b.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FlankSweep {
    pub pose: DresserPose,
    s: f64,
    base_radius: f64,
    cos_base: f64,
    range: GeometricRange,
    /// All of the lag that does not depend on the point.
    constant: f64,
    b: f64,
    reach: f64,
}

/// A point of a swept circle on the nominal ray of the flank.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SweptPoint {
    /// Ray length: what is left standing, mm.
    pub f: f64,
    /// Length of roll of the ray, mm.
    pub w: f64,
    /// Derivatives by psi, r, z.
    pub df: [f64; 3],
    pub dw: [f64; 3],
}

/// Least f on a circle within the used range.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CircleLeast {
    pub psi: f64,
    pub f: f64,
    pub w: f64,
    /// Derivative of the least value along the section.
    pub slope: f64,
}

/// Intervals of psi in which the sweep along an arc of less than a right angle to both sides is monotonic enough for its
/// derivatives to show every extreme.
const ARC_STEPS: usize = 24;
/// Accuracy of psi, rad.
const PSI: f64 = 1e-13;

impl FlankSweep {
    /// `space` is the number of the thread space, `beyond` the angle (rad) by which inactive threads widen it.
    pub fn new(
        pose: DresserPose,
        worm: &InvoluteFlank,
        range: GeometricRange,
        space: f64,
        beyond: f64,
        b: f64,
    ) -> Self {
        let s = worm.s();
        let screwed = b / pose.screw_parameter() - b * worm.twist_per_length();
        let constant = worm.base_space_half_angle + beyond
            - s * (FRAC_PI_2 + pose.worm_angle() + 2.0 * PI / worm.teeth * space - screwed);
        Self {
            pose,
            s,
            base_radius: worm.base_radius,
            cos_base: worm.base_helix_angle.cos(),
            range,
            constant,
            b,
            reach: worm.base_radius * worm.base_helix_angle.cos() * (2.0 * PI / worm.teeth + beyond),
        }
    }

    /// Plane z = b of the worm, mm.
    pub fn b(&self) -> f64 {
        self.b
    }

    /// Normal distance at which the same flank follows again, mm.
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// Number of thread space in which a room point lies nearest to the flank, if this sweep was made for space 0.
    pub fn nearest_space(&self, q: [f64; 3], pitch: f64) -> f64 {
        let w_1 = (q[0] * q[0] + q[1] * q[1] - self.base_radius.powi(2)).max(0.0).sqrt();
        self.s * (self.lag(q, w_1) / pitch).round()
    }

    /// By how much the flank lags behind a room point on the base circle, rad (section 4, delta without wrapping).
    fn lag(&self, q: [f64; 3], w_1: f64) -> f64 {
        let roll = w_1 / self.base_radius;
        roll - roll.atan()
            + self.s * (self.pose.direction(q) - q[2] / self.pose.screw_parameter())
            + self.constant
    }

    /// Axial position of the flank at a radius of the worm in a plane through its axis, seen from z = b, mm. There f is the axial
    /// distance times sin(beta_b).
    pub fn axial_position(&self, radius: f64) -> f64 {
        let roll = (radius * radius - self.base_radius.powi(2)).max(0.0).sqrt() / self.base_radius;
        self.s * self.pose.screw_parameter() * (roll - roll.atan() + self.constant)
    }

    /// The point at the angle psi of a circle.
    pub fn at(&self, circle: &SectionCircle, psi: f64) -> SweptPoint {
        let (q, moved) = self.pose.point(circle, psi);
        let square = q[0] * q[0] + q[1] * q[1];
        let rest = square - self.base_radius * self.base_radius;
        // Continued through the base circle, so that limits of w are bracketed there too.
        let w_1 = rest.abs().sqrt().copysign(rest);
        let scale = self.base_radius * self.cos_base;
        let f = scale * self.lag(q, w_1);
        let mut point = SweptPoint { f, w: w_1 - self.cos_base * f, df: [0.0; 3], dw: [0.0; 3] };
        for (k, m) in moved.iter().enumerate() {
            let (out, around) = (q[0] * m[0] + q[1] * m[1], q[0] * m[1] - q[1] * m[0]);
            let turn = (w_1 / self.base_radius * out + self.s * around) / square;
            point.df[k] = scale * (turn - self.s * m[2] / self.pose.screw_parameter());
            point.dw[k] = out / w_1 - self.cos_base * point.df[k];
        }
        point
    }

    /// Least f of a circle on rays within the used range, if it is at most `most` (mm); a larger one may be found or not.
    pub fn least(&self, circle: &SectionCircle, most: f64) -> Option<CircleLeast> {
        let outer = self.range.w_na + self.cos_base * most;
        let [from, to] = self.pose.arc(circle, self.base_radius.hypot(outer))?;
        let mut best = None;
        let node = |k: usize| {
            let psi = from + (to - from) * k as f64 / ARC_STEPS as f64;
            (psi, self.at(circle, psi))
        };
        let mut a = node(0);
        for k in 1..=ARC_STEPS {
            let b = node(k);
            if a.1.dw[0] * b.1.dw[0] < 0.0 {
                // Either side of the turning point w rises or falls throughout.
                let turn =
                    brent([a.0, b.0], [a.1.dw[0], b.1.dw[0]], PSI, |psi| Some(self.at(circle, psi).dw[0]));
                let psi = turn.unwrap_or(0.5 * (a.0 + b.0));
                let turn = (psi, self.at(circle, psi));
                self.within(circle, a, turn, &mut best);
                self.within(circle, turn, b, &mut best);
            } else {
                self.within(circle, a, b, &mut best);
            }
            a = b;
        }
        let (psi, at, bound): (f64, SweptPoint, bool) = best?;
        let along = |d: &[f64; 3]| d[1] * circle.slope[0] + d[2] * circle.slope[1];
        let mut slope = along(&at.df);
        if bound {
            slope -= at.df[0] / at.dw[0] * along(&at.dw);
        }
        Some(CircleLeast { psi, f: at.f, w: at.w, slope })
    }

    /// Looks for a lower f between two angles between which w is monotonic.
    fn within(
        &self,
        circle: &SectionCircle,
        mut a: (f64, SweptPoint),
        mut b: (f64, SweptPoint),
        best: &mut Option<(f64, SweptPoint, bool)>,
    ) {
        let GeometricRange { w_nf, w_na } = self.range;
        let (low, high) = if a.1.w < b.1.w { (a.1.w, b.1.w) } else { (b.1.w, a.1.w) };
        if low > w_na || high < w_nf {
            return;
        }
        // What a smooth f can reach in between.
        let steepest = a.1.df[0].abs().max(b.1.df[0].abs());
        let least = a.1.f.min(b.1.f) - (b.0 - a.0) * steepest;
        if best.is_some_and(|(_, at, _)| at.f <= least) {
            return;
        }
        let mut bound = [false; 2];
        let ends = (a, b);
        for limit in [w_nf, w_na] {
            let over = [ends.0.1.w - limit, ends.1.1.w - limit];
            if over[0] * over[1] >= 0.0 {
                continue;
            }
            let Some(psi) =
                brent([ends.0.0, ends.1.0], over, PSI, |psi| Some(self.at(circle, psi).w - limit))
            else {
                return;
            };
            let cut = (psi, self.at(circle, psi));
            // The end that lies outside moves to the limit.
            let outside = if limit == w_nf { over[0] < 0.0 } else { over[0] > 0.0 };
            if outside {
                (a, bound[0]) = (cut, true);
            } else {
                (b, bound[1]) = (cut, true);
            }
        }
        let mut offer = |(psi, at): (f64, SweptPoint), bound: bool| {
            if best.is_none_or(|(_, least, _)| at.f < least.f) {
                *best = Some((psi, at, bound));
            }
        };
        offer(a, bound[0]);
        offer(b, bound[1]);
        if a.1.df[0] < 0.0
            && b.1.df[0] > 0.0
            && let Some(psi) =
                brent([a.0, b.0], [a.1.df[0], b.1.df[0]], PSI, |psi| Some(self.at(circle, psi).df[0]))
        {
            offer((psi, self.at(circle, psi)), false);
        }
    }
}
