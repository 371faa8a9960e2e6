//! Rays of the workpiece shortened by the worm of a motion in time: one pose an instant, no coupling assumed. For motions that are no
//! function of the feed, such as those of a control with errors; slower than [`grind`](super::grind), which knows the coupling.

use super::{RayGrid, RemovalError, Stage, Uncut, WormArea, WormModification, error};
use foundation::geometry::InvoluteFlank;
use foundation::kinematics::{Pose, Workpiece, Worm};
use foundation::numerics::golden_section;
use nalgebra::Vector3;
use rayon::prelude::*;

/// What the rays are given. mm, s.
#[derive(Clone, Copy)]
pub struct TimedGrinding<'a> {
    /// The unmodified worm flank.
    pub worm: &'a InvoluteFlank,
    /// The part of it that exists.
    pub area: WormArea,
    /// f_n1 on it.
    pub modification: &'a dyn WormModification,
    /// The workpiece flank on whose normals the rays stand.
    pub work: &'a InvoluteFlank,
    /// X_SV at a time.
    pub pose: &'a (dyn Fn(f64) -> Pose<Worm, Workpiece> + Sync),
    /// First and last instant.
    pub span: [f64; 2],
    /// Duration of a revolution of the workpiece.
    pub revolution: f64,
    /// Largest length, up or down, that counts as this flank's stock.
    pub stock: f64,
}

/// Instants looked at per revolution: in the contact of one pass several of them leave less than the stock.
const INSTANTS: f64 = 500.0;
/// Passes whose best instant is this much above the least are refined as well, mm: more than what lies between two instants.
const NEAR: f64 = 0.02;
/// Largest slope of the gap along a ray that counts as meeting the worm from its front (`docs/mathematics/planning.md#the-referee`).
const FACING: f64 = -0.3;
/// Turns of a long stroke that are looked at first.
const COARSE: f64 = 16.0;
/// Lengths of the golden section: 0.618^60 of an interval is left.
const EVALUATIONS: usize = 62;

/// Lengths of the rays, mm, in the order of the grid.
///
/// # Errors
/// [`RemovalError::InvalidNumber`] for span, revolution or stock, [`RemovalError::FlanksDiffer`], [`RemovalError::RayUncut`].
pub fn grind_in_time(setup: &TimedGrinding<'_>, grid: &RayGrid) -> Result<Vec<f64>, RemovalError> {
    if setup.worm.flank != setup.work.flank {
        return Err(RemovalError::FlanksDiffer { worm: setup.worm.flank, work: setup.work.flank });
    }
    error::range("time of the stroke", setup.span)?;
    error::positive("duration of a revolution", setup.revolution)?;
    error::positive("grinding stock", setup.stock)?;
    let lengths: Vec<Option<f64>> =
        (0..grid.count()).into_par_iter().map(|k| setup.least(grid.ray(k))).collect();
    let count = lengths.iter().filter(|length| length.is_none()).count();
    let uncut = |k: usize| {
        let (w, z) = grid.ray(k);
        RemovalError::RayUncut { stage: Stage::Grinding, w, z, reason: Uncut::NotReached, count }
    };
    lengths.into_iter().enumerate().map(|(k, length)| length.ok_or_else(|| uncut(k))).collect()
}

impl TimedGrinding<'_> {
    fn least(&self, (w, z): (f64, f64)) -> Option<f64> {
        let frame = self.work.frame(w, z);
        let ray = (self.work.point_in(&frame, w, z), frame.n);
        let [first, last] = self.span;
        let turns = ((last - first) / self.revolution).ceil();
        // Of a long stroke some turns tell where the tool comes deepest; from turn to turn it does so gradually.
        let stride = (turns / COARSE).floor().max(1.0);
        let mut window = self.span;
        if stride > 1.0 {
            let seen = (0..)
                .map(|k| first + f64::from(k) * stride * self.revolution)
                .take_while(|&start| start < last)
                .flat_map(|start| self.bottoms(&ray, [start, (start + self.revolution).min(last)]));
            let (deepest, _) = seen.min_by(|a, b| a.1.total_cmp(&b.1))?;
            let way = (stride + 1.0) * self.revolution;
            window = [(deepest - way).max(first), (deepest + way).min(last)];
        }
        let bottoms = self.bottoms(&ray, window);
        let lowest = bottoms.iter().map(|bottom| bottom.1).reduce(f64::min)?;
        let step = self.revolution / INSTANTS;
        let near = bottoms.into_iter().filter(|bottom| bottom.1 <= lowest + NEAR);
        near.map(|(time, _)| self.refined(&ray, time - step, time + step))
            .filter(|length| length.abs() <= self.stock)
            .reduce(f64::min)
    }

    /// Instants in a window at which the ray is shorter than just before and after, with its length.
    fn bottoms(&self, ray: &(Vector3<f64>, Vector3<f64>), [first, last]: [f64; 2]) -> Vec<(f64, f64)> {
        let step = self.revolution / INSTANTS;
        let count = ((last - first) / step).ceil() as usize;
        // One instant beyond each end, so that a bottom at the end is seen from both sides.
        let length = |k: usize| {
            let time = first + (k as f64 - 1.0) * step;
            (time, self.length(ray, time).unwrap_or(f64::INFINITY))
        };
        let lengths: Vec<(f64, f64)> = (0..=count + 2).map(length).collect();
        // A bottom deeper than the stock belongs to another flank, and so does a single instant: another flank sweeps across the ray in
        // less than a step, the own one rolls along it.
        lengths
            .windows(3)
            .filter(|around| {
                let [before, here, after] = [around[0].1, around[1].1, around[2].1];
                here.abs() <= self.stock && here <= before && here <= after && before.max(after).is_finite()
            })
            .map(|around| around[1])
            .collect()
    }

    /// Least length in an interval that has one bottom.
    fn refined(&self, ray: &(Vector3<f64>, Vector3<f64>), from: f64, to: f64) -> f64 {
        let length = |time: f64| self.length(ray, time).unwrap_or(f64::INFINITY);
        length(golden_section(from, to, EVALUATIONS, length))
    }

    /// Where the ray meets the worm's front at an instant; `None` where it does not, or beyond the stock.
    fn length(&self, ray: &(Vector3<f64>, Vector3<f64>), time: f64) -> Option<f64> {
        let pose = (self.pose)(time);
        let point = pose.rotation() * ray.0 + pose.translation();
        let normal = pose.rotation() * ray.1;
        let gap = |length: f64| {
            let at = self.worm.deviation(&(point + normal * length));
            // NaN inside the base cylinder fails the test of the area.
            self.area.covers(at.w, at.z).then(|| at.f_n - self.modification.value(at.w, at.z))
        };
        let far = 2.0 * self.stock;
        let (mut a, mut b) = (0.0, 1e-3);
        let (mut gap_a, mut gap_b) = (gap(a)?, gap(b)?);
        // The gap is almost linear along the ray: the secant needs a few steps.
        for _ in 0..30 {
            let slope = (gap_b - gap_a) / (b - a);
            if slope.is_nan() || slope > FACING {
                return None;
            }
            let next = b - gap_b / slope;
            if next.abs() > far {
                return None;
            }
            if (next - b).abs() < 1e-13 {
                return Some(next);
            }
            (a, gap_a) = (b, gap_b);
            (b, gap_b) = (next, gap(next)?);
            if gap_b == gap_a {
                return Some(b);
            }
        }
        Some(b)
    }
}
