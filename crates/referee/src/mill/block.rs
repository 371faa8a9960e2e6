//! One block of a path as a motion: where the cutter stands at a fraction of it, and how a ray's point sees that.
//!
//! The tip moves linearly; the axis is interpolated linearly and then normalised (`docs/mathematics/milling.md#the-referee`). In the
//! coordinates of the cutter, turned without spin, a point p of the workpiece runs along y(t) with y' = -T' - z a' + ((p - T) a') a and
//! |y''| <= 2 W |T'| + 1.2 W^2 |p - T|, W the largest rate of turn of the block.

use super::body::Part;
use super::{CutterPlace, NormalRay};
use nalgebra::Vector3;

/// Bound of the second derivative of a rotation that a normalised chord makes, per square of its largest rate W: the angle is
/// atan x with x linear in t, so that |phi''| <= 0.65 W^2, at right angles to phi'^2 <= W^2.
const BEND: f64 = 1.2;

/// A block. Fractions t run from 0 to 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    tip: Vector3<f64>,
    axis: Vector3<f64>,
    axis_step: Vector3<f64>,
    /// T'.
    pub tip_step: Vector3<f64>,
    /// |T'|, mm.
    pub way: f64,
    /// W, rad.
    pub turn: f64,
    /// Index of the path.
    pub path: usize,
    /// Index of the block in the path.
    pub index: usize,
}

/// The cutter at one place of a block.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pose {
    pub tip: Vector3<f64>,
    pub axis: Vector3<f64>,
    /// a'.
    pub axis_rate: Vector3<f64>,
}

/// How a ray's point at a length lies to a part of the cutter in a pose.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch {
    /// Distance from the part, mm.
    pub distance: f64,
    /// Its derivative by the length.
    pub by_length: f64,
    /// Its derivative by the fraction, mm.
    pub by_fraction: f64,
    /// Speed of the point in the coordinates of the cutter at right angles to the gradient, squared, mm^2.
    pub slide_squared: f64,
    /// Distance of the point from the tip, mm.
    pub lever: f64,
}

/// Distance along a ray with its derivative; the gradient and the lever for bounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Along {
    pub distance: f64,
    pub by_length: f64,
    pub gradient: Vector3<f64>,
    /// From the tip to the point.
    pub arm: Vector3<f64>,
    /// Height of the point above the tip.
    height: f64,
}

impl Block {
    /// The block between two places with unit axes; `None` where the axis turns back onto itself, so that no chord can be
    /// normalised.
    pub fn new(path: usize, index: usize, from: &CutterPlace, to: &CutterPlace) -> Option<Self> {
        let tip_step = to.tip - from.tip;
        let axis_step = to.axis - from.axis;
        let middle = 0.5 * (from.axis + to.axis).norm();
        // A thousandth of a right angle short of a half turn.
        if middle < 1e-3 {
            return None;
        }
        let turn = axis_step.norm() / middle;
        Some(Self {
            tip: from.tip,
            axis: from.axis,
            axis_step,
            tip_step,
            way: tip_step.norm(),
            turn,
            path,
            index,
        })
    }

    /// Tip at both ends.
    pub fn tips(&self) -> [Vector3<f64>; 2] {
        [self.tip, self.tip + self.tip_step]
    }

    /// Axis at both ends.
    pub fn axes(&self) -> [Vector3<f64>; 2] {
        [self.axis, self.axis + self.axis_step]
    }

    /// The cutter at fraction t.
    #[inline]
    pub fn pose(&self, t: f64) -> Pose {
        let tip = self.tip + self.tip_step * t;
        if self.turn == 0.0 {
            return Pose { tip, axis: self.axis, axis_rate: Vector3::zeros() };
        }
        let chord = self.axis + self.axis_step * t;
        let length = chord.norm();
        let axis = chord / length;
        Pose { tip, axis, axis_rate: (self.axis_step - axis * axis.dot(&self.axis_step)) / length }
    }

    /// Bound of |y''| for points up to `lever` from the tip, mm.
    #[inline]
    pub fn bend(&self, lever: f64) -> f64 {
        self.turn * (2.0 * self.way + BEND * self.turn * lever)
    }

    /// Bound of |y'| for points up to `lever` from the tip, mm.
    #[inline]
    pub fn speed(&self, lever: f64) -> f64 {
        self.way + self.turn * lever
    }

    /// How the point at `length` lies to the part in a pose of this block.
    #[inline]
    pub fn touch(&self, part: &Part, ray: &NormalRay, length: f64, pose: &Pose) -> Touch {
        let along = pose.along(part, ray, length);
        let mut rate = -self.tip_step;
        if self.turn != 0.0 {
            rate += pose.axis * along.arm.dot(&pose.axis_rate) - pose.axis_rate * along.height;
        }
        let by_fraction = along.gradient.dot(&rate);
        Touch {
            distance: along.distance,
            by_length: along.by_length,
            by_fraction,
            slide_squared: (rate.norm_squared() - by_fraction * by_fraction).max(0.0),
            lever: along.arm.norm(),
        }
    }
}

impl Pose {
    /// Distance of the ray's point at `length` from a part that stands in this pose.
    #[inline]
    pub fn along(&self, part: &Part, ray: &NormalRay, length: f64) -> Along {
        let arm = ray.point + ray.normal * length - self.tip;
        let height = arm.dot(&self.axis);
        let across = arm - self.axis * height;
        let rho = across.norm();
        let [distance, by_rho, by_z] = part.distance(rho, height);
        let mut gradient = self.axis * by_z;
        if rho > 0.0 {
            gradient += across * (by_rho / rho);
        }
        Along { distance, by_length: gradient.dot(&ray.normal), gradient, arm, height }
    }

    /// The length, from `lowest` up to `highest`, at which the ray enters the part that stands in this pose.
    ///
    /// Newton's method on a convex function: from any start its steps end below the root and then climb to it without passing it,
    /// faster than steps by the distance alone. `start` is a length at which the distance falls, or `lowest`.
    pub fn entry(
        &self,
        part: &Part,
        ray: &NormalRay,
        [lowest, highest]: [f64; 2],
        start: f64,
    ) -> (Option<f64>, u64) {
        let mut length = start;
        for steps in 1..=LONGEST_CLIMB {
            let at = self.along(part, ray, length);
            if at.distance.abs() <= ON_SURFACE || (at.distance < 0.0 && length <= lowest) {
                return (Some(length), steps);
            }
            if at.by_length >= 0.0 {
                return (None, steps);
            }
            let next = (length - at.distance / at.by_length).max(lowest);
            if next > highest {
                return (None, steps);
            }
            if next == length {
                return (Some(length), steps);
            }
            length = next;
        }
        (None, LONGEST_CLIMB)
    }
}

/// A point is on the surface below this distance, mm; rounding of coordinates of 100 mm makes some 3e-14.
pub(super) const ON_SURFACE: f64 = 1e-13;
/// Steps of a climb along a ray; a head-on one takes five, a grazing one halves the rest in every step.
const LONGEST_CLIMB: u64 = 100;
