//! Which error of the workpiece's angle each place of the flank keeps: the place is ground by the passes of its tooth whose feed is nearest
//! to the one of its contact, in the instant in which the tool comes deepest, and the deepest pass stays
//! (`docs/mathematics/generating-contact.md`).

use super::stroke::StrokeRecord;
use contact::FlankPair;
use foundation::kinematics::GeneratingMotion;
use foundation::numerics::extremes;
use nalgebra::{Matrix2, Vector2};
use num_dual::Dual64;
use std::f64::consts::TAU;

/// Slopes df/dw and df/dz of normal deviations at (w, z), mm/mm. Where worm and motion incline the flank, its contact lies millimetres of feed
/// beside the one of unmodified bodies, which is many turns of the gear; also where the two cancel each other on the flank.
#[derive(Clone, Copy)]
pub struct FlankSlopes<'a> {
    /// Of the flank that the stroke leaves without errors.
    pub ground: &'a dyn Fn(f64, f64) -> [f64; 2],
    /// Of the worm flank.
    pub worm: &'a dyn Fn(f64, f64) -> [f64; 2],
}

/// Where and when places of one flank are ground, in closed form: contacts of the unmodified bodies, moved by the slopes
/// of worm and flank; passes at the real feed.
#[derive(Clone, Copy)]
pub struct FlankPlaces<'a> {
    /// Contact relations of the flank.
    pub pair: &'a FlankPair,
    /// The motion that is driven.
    pub motion: &'a GeneratingMotion,
    /// The stroke with its errors.
    pub record: &'a StrokeRecord,
    /// How worm and flank are inclined.
    pub slopes: FlankSlopes<'a>,
}

/// What the control leaves on one flank of all teeth, um, normal, positive = material left.
#[derive(Clone, Debug, PartialEq)]
pub struct ControlledFlank {
    /// Lengths of roll, mm.
    pub w: Vec<f64>,
    /// Axial positions, mm.
    pub z: Vec<f64>,
    /// For each tooth the deviations, row-major [w][z].
    pub teeth: Vec<Vec<f64>>,
}

/// Passes looked at before and after the nearest one: further ones leave more than twice the marks.
const PASSES: i64 = 2;
/// Steps until the feed of a contact, and the time of a pass, do not move any more.
const STEPS: usize = 20;
/// Steps to the vertex of a pass: each reduces its error by the bend of the error over that of the gap, some hundredths.
const SLOPES: usize = 6;

/// A place with all that its passes need.
struct Place {
    /// z_V2 of its contact, mm.
    feed: f64,
    /// phi_2 of its contact for tooth 0, rad.
    angle: f64,
    /// Gap of a pose whose contact is (dw_2, dz_V2) beside this place: half its quadratic form, 1/mm.
    gap: Matrix2<f64>,
    /// d phi_2/d w_2 and d phi_2/d z_V2 of contacts, rad/mm.
    rates: [f64; 2],
}

impl FlankPlaces<'_> {
    /// Deviation in mm that the place (w, z) of a tooth keeps, normal, positive = material left.
    pub fn deviation(&self, w: f64, z: f64, tooth: usize) -> f64 {
        self.deviation_of(&self.place(w, z), tooth)
    }

    /// Deviations of the teeth with these numbers, counted from 0, on a grid of all `w` with all `z` (mm).
    pub fn flank(&self, w: &[f64], z: &[f64], teeth: &[usize]) -> ControlledFlank {
        let places: Vec<Place> = w.iter().flat_map(|&w| z.iter().map(move |&z| self.place(w, z))).collect();
        let teeth = teeth
            .iter()
            .map(|&tooth| places.iter().map(|place| 1e3 * self.deviation_of(place, tooth)).collect());
        ControlledFlank { w: w.to_vec(), z: z.to_vec(), teeth: teeth.collect() }
    }

    fn place(&self, w: f64, z: f64) -> Place {
        let (pair, motion) = (self.pair, self.motion);
        // z_2 = work_z(w_2, F(v), v), by Newton's rule; linear for a constant diagonal ratio.
        let mut feed = z;
        let mut ratio = 0.0;
        for _ in 0..STEPS {
            let [shift, slope, _] = motion.shift.jet(feed);
            ratio = slope;
            let step = (z - pair.work_z(w, shift, feed)) / (pair.c_zv22 + slope * pair.c_zv12);
            feed += step;
            if step.abs() < 1e-12 {
                break;
            }
        }
        let shift = motion.shift.value(feed);
        let worm_roll = pair.worm_roll(w, shift, feed);
        let worm_z = pair.worm_z(worm_roll, shift, feed);
        let curvature = pair.relative_curvature(worm_roll, w, ratio);
        // Contact relations are linear: differences over 1 mm are derivatives.
        let angle = pair.work_angle(w, z);
        let z_beside = pair.work_z(w + 1.0, shift, feed);
        let by_roll = pair.work_angle(w + 1.0, z_beside) - angle;
        let z_by_feed = pair.c_zv22 + ratio * pair.c_zv12;
        let by_feed = (pair.work_angle(w, z + 1.0) - angle) * z_by_feed;
        let [f_w, f_z] = (self.slopes.ground)(w, z);
        let ground = [f_w + f_z * (z_beside - z), f_z * z_by_feed];
        let worm = |[dw, dz]: [f64; 2]| (self.slopes.worm)(worm_roll + dw, worm_z + dz);
        let [dw, dv] = curvature.displaced(ground, worm).unwrap_or_default();
        let angle = angle + by_roll * dw + by_feed * dv;
        Place { feed: feed + dv, angle, gap: curvature.h, rates: [by_roll, by_feed] }
    }

    fn deviation_of(&self, place: &Place, tooth: usize) -> f64 {
        let pitch_angle = TAU / self.motion.teeth.abs();
        let angle = place.angle + pitch_angle * tooth as f64;
        let nearest = self.turn_nearest(angle, place.feed);
        let (mut with, mut without) = (f64::INFINITY, f64::INFINITY);
        for turn in -PASSES..=PASSES {
            let [pass, ideal] = self.pass(place, angle + TAU * (nearest + turn) as f64);
            (with, without) = (with.min(pass), without.min(ideal));
        }
        with - without
    }

    /// Depth of one pass with the error and without it, mm. The gap of unmodified bodies is a parabola in time; its vertex moves by the slope
    /// of the error.
    fn pass(&self, place: &Place, angle: f64) -> [f64; 2] {
        let work = &self.pair.work;
        // The flank moves against the rotation of the body: n . (e_z x r) = s r_b cos(beta_b).
        let arm = -work.flank.sign() * work.base_radius * work.base_helix_angle.cos();
        let time = self.time_of(angle);
        let [_, turning] = self.work_angle(time);
        let feeding = self.record.speeds().velocity();
        let missed = self.record.feed(time) - place.feed;
        let [by_roll, by_feed] = place.rates;
        // (dw_2, dz_V2) = offset + rate (t - time).
        let offset = Vector2::new(-by_feed * missed / by_roll, missed);
        let rate = Vector2::new((turning - by_feed * feeding) / by_roll, feeding);
        let bend = rate.dot(&(place.gap * rate));
        let vertex = -rate.dot(&(place.gap * offset)) / bend;
        let gap = |after: f64| {
            let at = offset + rate * after;
            0.5 * at.dot(&(place.gap * at))
        };
        let mut after = vertex;
        for _ in 0..SLOPES {
            let [_, slope] = self.record.error_with_slope(time + after);
            after = vertex - arm * slope / bend;
        }
        let [error, _] = self.record.error_with_slope(time + after);
        [gap(after) + arm * error, gap(vertex)]
    }

    /// phi_2 and its rate at a time.
    fn work_angle(&self, time: f64) -> [f64; 2] {
        let speeds = self.record.speeds();
        let state = |time: Dual64| {
            let feed = time * speeds.velocity() + self.record.feed(0.0);
            self.motion.state(time * speeds.worm, feed, self.motion.phase[self.pair.flank()]).work_angle
        };
        let angle = state(Dual64::new(time, 1.0));
        [angle.re, angle.eps]
    }

    /// Full turns to be added to an angle so that it passes when the feed is nearest to `feed`.
    fn turn_nearest(&self, angle: f64, feed: f64) -> i64 {
        let [then, _] = self.work_angle(self.record.time(feed));
        ((then - angle) / TAU).round() as i64
    }

    /// When phi_2 has a value.
    fn time_of(&self, angle: f64) -> f64 {
        // Laws of the feed need not hold beyond the stroke.
        let mut time = self.record.start;
        for _ in 0..STEPS {
            let [at, rate] = self.work_angle(time);
            let step = (angle - at) / rate;
            time += step;
            if step.abs() < 1e-12 * time.abs().max(1.0) {
                break;
            }
        }
        time
    }
}

impl ControlledFlank {
    /// Least and greatest deviation over all teeth and places, um; [inf, -inf] of none.
    pub fn extremes(&self) -> [f64; 2] {
        extremes(self.teeth.iter().flatten().copied())
    }

    /// Root mean square over all teeth and places, um.
    pub fn rms(&self) -> f64 {
        let count = self.teeth.iter().map(Vec::len).sum::<usize>().max(1);
        (self.teeth.iter().flatten().map(|f| f * f).sum::<f64>() / count as f64).sqrt()
    }

    /// Mean of each tooth, um: what a pitch measurement sees.
    pub fn means(&self) -> Vec<f64> {
        self.teeth.iter().map(|f| f.iter().sum::<f64>() / f.len().max(1) as f64).collect()
    }
}
