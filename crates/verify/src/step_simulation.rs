//! Remainders between two feed positions or two roll steps, simulated with the chain and the unmodified worm flank alone
//! (`docs/mathematics/planning.md#the-referee`). Knows no closed form of them.

use contact::{FlankPair, Pair};
use foundation::geometry::Flank;
use foundation::kinematics::{GeneratingMotion, Point};
use foundation::numerics::golden_section;
use std::f64::consts::PI;

/// A ray of the workpiece and the motion that grinds it.
pub(super) struct StepSimulation<'a> {
    pair: &'a Pair,
    flank: &'a FlankPair,
    motion: &'a GeneratingMotion,
    w_2: f64,
    z_2: f64,
}

/// Evaluations of a one-dimensional minimum: narrows the bracket by 0.618^60, far below rounding of the length.
const EVALUATIONS: usize = 60;

impl<'a> StepSimulation<'a> {
    /// The ray at roll `w_2` that is in contact at zero feeds.
    pub fn new(pair: &'a Pair, flank: Flank, motion: &'a GeneratingMotion, w_2: f64) -> Self {
        let flank = &pair.flanks[flank];
        Self { pair, flank, motion, w_2, z_2: flank.work_z(w_2, 0.0, 0.0) }
    }

    /// Length left of the ray by the worm at one instant, mm.
    fn length(&self, worm_angle: f64, feed: f64) -> f64 {
        let work = &self.flank.work;
        let mut state = self.motion.state(worm_angle, feed, self.flank.phase);
        // The tooth on which the ray stands: whole pitches next to the contact at zero feeds.
        let pitch = 2.0 * PI / self.pair.work.tooth_count();
        let rest = self.motion.state(self.contact_angle(self.w_2, 0.0), 0.0, self.flank.phase).work_angle;
        state.work_angle += ((self.flank.work_angle(self.w_2, self.z_2) - rest) / pitch).round() * pitch;
        let pose = self.pair.chain.pose(&state);
        let (start, normal) = (work.point(self.w_2, self.z_2), work.normal(self.w_2, self.z_2));
        let turned = pose.rotation() * normal;
        let mut length = 0.0;
        for _ in 0..30 {
            let point = pose.point(&Point::from_vector(start + normal * length));
            let at = self.flank.worm.deviation(&point.xyz);
            let slope = self.flank.worm.normal(at.w, at.z).dot(&turned);
            let step = at.f_n / slope;
            length -= step;
            if step.abs() < 1e-14 {
                break;
            }
        }
        length
    }

    /// phi_1 at which roll `w_2` is in contact at feed `feed`.
    fn contact_angle(&self, w_2: f64, feed: f64) -> f64 {
        let shift = self.motion.shift.value(feed);
        let w_1 = self.flank.worm_roll(w_2, shift, feed);
        self.flank.worm_angle(w_1, self.flank.worm_z(w_1, shift, feed))
    }

    /// Height left midway between two passes at feeds `step` apart, all rotations in between, mm.
    pub fn feed_mark(&self, step: f64) -> f64 {
        let pass = |feed: f64| {
            let middle = self.contact_angle(self.w_2, feed);
            let reach = 0.2 * PI / self.pair.worm.tooth_count();
            let length = |angle: f64| self.length(angle, feed);
            length(golden_section(middle - reach, middle + reach, EVALUATIONS, length))
        };
        pass(0.5 * step).min(pass(-0.5 * step))
    }

    /// Height left midway between two roll steps `step` apart, all feeds in between, mm.
    pub fn facet(&self, step: f64) -> f64 {
        let cut = |roll: f64| {
            let length = |feed: f64| self.length(self.contact_angle(self.w_2 + roll, feed), feed);
            let reach = 20.0 * step;
            length(golden_section(-reach, reach, EVALUATIONS, length))
        };
        cut(0.5 * step).min(cut(-0.5 * step))
    }
}
