//! Worm, workpiece and dresser as bodies of revolution: how far they are apart, and how long a stroke runs in and out.

use foundation::kinematics::{Pose, Worm};
use foundation::numerics::equidistant;
use motion::{Course, Waypoint};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// Clearance of worm and blank where a stroke begins and ends, mm: above any stock.
pub const CLEARANCE: f64 = 1.0;
/// Longest run-in, mm, and the step in which it is looked for.
const LONGEST: f64 = 300.0;
const STEP: f64 = 1.0;
/// Halvings of a step: below a micrometre.
const HALVINGS: usize = 12;
/// Places around the blank and along it.
const AROUND: usize = 360;
const ALONG: usize = 21;

/// A worm and what stands against it, as cylinders. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinders {
    /// Largest tip radius of the worm.
    pub worm_radius: f64,
    /// Half the width of the worm; `None` for one without a stated width, which is endless.
    pub worm_half_width: Option<f64>,
    /// Tip radius of the gear or of the dresser.
    pub radius: f64,
    /// Half its face width.
    pub half_width: f64,
}

impl Cylinders {
    /// Least distance of the gear or the dresser from the worm, mm; negative where they overlap.
    pub fn gap<Body: 'static>(&self, pose: &Pose<Worm, Body>) -> f64 {
        let faces = equidistant([-self.half_width, self.half_width], ALONG);
        let around = (0..AROUND).map(|k| (TAU * k as f64 / AROUND as f64).sin_cos());
        let of = |(sin, cos): (f64, f64)| {
            let rim = |z: &f64| {
                let at = Vector3::new(self.radius * cos, self.radius * sin, *z);
                let at = pose.rotation() * at + pose.translation();
                let radial = at.x.hypot(at.y) - self.worm_radius;
                let axial = self.worm_half_width.map_or(f64::NEG_INFINITY, |half| at.z.abs() - half);
                if axial > 0.0 { radial.max(0.0).hypot(axial) } else { radial }
            };
            faces.iter().map(rim).fold(f64::INFINITY, f64::min)
        };
        around.map(of).fold(f64::INFINITY, f64::min)
    }

    /// How far a stroke has to run on beyond `end` (mm) in the sense of `sense` until the bodies are clear of each other; 0 for one that
    /// never becomes so.
    pub fn run_out<Body: 'static>(&self, course: &Course, end: f64, sense: f64) -> f64 {
        let clear = |x: f64| {
            let place = course.place(&Waypoint { v: end + sense * x, ..Waypoint::default() });
            self.gap::<Body>(&course.mounts().bodies(&place.pose)) >= CLEARANCE
        };
        let steps = (LONGEST / STEP) as usize;
        let Some(first) = (0..=steps).map(|k| k as f64 * STEP).find(|&x| clear(x)) else { return 0.0 };
        let (mut low, mut high) = ((first - STEP).max(0.0), first);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if clear(middle) { high = middle } else { low = middle }
        }
        high
    }
}
