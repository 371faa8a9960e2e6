//! Worm and workpiece in motion, in the form that the search of stage two uses.

use super::active_threads::{ActiveThreads, ThreadRule};
use super::descent::Slope;
use super::{RemovalError, Stage, WormArea, WormModification, error};
use foundation::geometry::InvoluteFlank;
use foundation::kinematics::{GeneratingMotion, Pose, Workpiece, Worm};
use foundation::numerics::Scalar;
use nalgebra::{Vector2, Vector3};
use num_dual::Dual64;

/// Which instants of the motion there are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GrindingMode {
    /// Every rotation at every feed: the envelope, as an endlessly slow feed leaves it.
    Continuous,
    /// The feed advances with the turning workpiece: z_V2 = start + feed phi_2/(2 pi), one pass per turn and tooth.
    FeedMarks {
        /// Feed per workpiece revolution, mm; its sign is the sense of z_V2 against phi_2.
        feed_per_revolution: f64,
        /// z_V2 at phi_2 = 0, mm; it decides where the marks lie.
        start: f64,
    },
}

/// What the stage is given. mm.
#[derive(Clone, Copy)]
pub struct Grinding<'a> {
    /// The unmodified worm flank.
    pub worm: &'a InvoluteFlank,
    /// The part of it that exists; the modification's own domain limits it further.
    pub area: WormArea,
    /// f_n1 on it.
    pub modification: &'a dyn WormModification,
    /// The workpiece flank on whose normals the rays stand.
    pub work: &'a InvoluteFlank,
    /// The motion that is really driven.
    pub motion: &'a GeneratingMotion,
    /// First and last feed z_V2 of the stroke.
    pub feed_range: [f64; 2],
    /// Largest length, up or down, that counts as this flank's stock; below a quarter of the normal base pitch.
    pub stock: f64,
    /// Which threads cut.
    pub threads: ActiveThreads<'a>,
    /// Envelope or true feed marks.
    pub mode: GrindingMode,
}

/// Largest slope of the gap along a ray that counts as meeting the worm from its front (`docs/mathematics/planning.md#the-referee`).
const FACING: f64 = -0.3;

/// Rounding of a length, mm: coordinates of some 100 mm and roll angles of some 10 rad on base radii of some 10 mm.
pub(super) const ROUNDING: f64 = 1e-12;

/// Shapes and motion in the form that the search uses.
pub(super) struct Engagement<'a> {
    pub setup: &'a Grinding<'a>,
    pub area: WormArea,
    /// Normal base pitch, mm.
    pub base_pitch: f64,
    phase: f64,
    /// d phi_1/d phi_2 at a fixed feed, negative.
    ratio: f64,
    /// `None` where every thread cuts.
    pub threads: Option<ThreadRule>,
}

/// A ray in workpiece coordinates.
pub(super) struct Ray {
    pub point: Vector3<f64>,
    pub normal: Vector3<f64>,
    pub w: f64,
}

/// Length of a ray at one instant with its rates by angle and feed, and the worm point it ends on.
#[derive(Clone, Copy)]
pub(super) struct Length {
    pub lam: f64,
    pub rates: Vector2<f64>,
    pub foot: [f64; 2],
}

impl Slope for Length {
    fn value(&self) -> f64 {
        self.lam
    }

    fn gradient(&self) -> Vector2<f64> {
        self.rates
    }
}

/// A value with its derivative along one direction, and the foot.
struct Gap {
    value: Dual64,
    foot: [f64; 2],
}

impl<'a> Engagement<'a> {
    pub fn new(setup: &'a Grinding<'a>) -> Result<Self, RemovalError> {
        if setup.worm.flank != setup.work.flank {
            return Err(RemovalError::FlanksDiffer { worm: setup.worm.flank, work: setup.work.flank });
        }
        if setup.worm.external_sign < 0.0 || setup.work.external_sign < 0.0 {
            return Err(RemovalError::InternalUnsupported { stage: Stage::Grinding });
        }
        error::range("feed range z_V2", setup.feed_range)?;
        error::positive("grinding stock", setup.stock)?;
        let work = setup.work;
        let circumference = 2.0 * std::f64::consts::PI * work.base_radius;
        let base_pitch = circumference * work.base_helix_angle.cos() / work.teeth;
        if setup.stock > 0.25 * base_pitch {
            return Err(RemovalError::InvalidNumber {
                field: "grinding stock",
                value: setup.stock,
                allowed: "up to a quarter of the normal base pitch",
            });
        }
        if let GrindingMode::FeedMarks { feed_per_revolution, start } = setup.mode {
            error::positive("magnitude of the feed per revolution", feed_per_revolution.abs())?;
            if !start.is_finite() {
                return Err(RemovalError::InvalidNumber {
                    field: "start of the feed",
                    value: start,
                    allowed: "finite",
                });
            }
        }
        let area = setup.area.within(setup.modification.domain())?;
        let phase = setup.motion.phase[work.flank];
        let (z_1, z_2) = (setup.motion.threads, setup.motion.teeth);
        let threads = ThreadRule::new(setup.threads, z_1, z_2)?;
        Ok(Self { setup, area, base_pitch, phase, ratio: -z_2 / z_1, threads })
    }

    /// X_SV at workpiece angle `angle` and feed `feed`: the worm angle that the coupling gives to them.
    pub fn pose<T: Scalar>(&self, angle: T, feed: T) -> Pose<Worm, Workpiece, T> {
        let motion = self.setup.motion;
        let at_rest = motion.state(T::from(0.0), feed, self.phase).work_angle;
        motion.chain.pose(&motion.state((angle - at_rest) * self.ratio, feed, self.phase))
    }

    /// Deviation of a worm-frame point from the modified worm; `None` where there is no worm beside it.
    #[inline]
    pub fn gap(&self, x: &Vector3<f64>) -> Option<f64> {
        let at = self.setup.worm.deviation(x);
        // NaN inside the base cylinder fails the test of the area.
        self.area.covers(at.w, at.z).then(|| at.f_n - self.setup.modification.value(at.w, at.z))
    }

    /// The same with a derivative along one direction, continued beyond the area.
    fn gap_along(&self, x: &Vector3<Dual64>) -> Gap {
        let at = self.setup.worm.deviation(x);
        let [f, f_w, f_z] = self.setup.modification.jet(at.w.re, at.z.re);
        let moved = Dual64::new(f, f_w * at.w.eps + f_z * at.z.eps);
        Gap { value: at.f_n - moved, foot: [at.w.re, at.z.re] }
    }

    /// Exact length of a ray at (angle, feed); `None` where it does not meet the worm's front.
    pub fn length(&self, ray: &Ray, at: Vector2<f64>, guess: f64) -> Option<Length> {
        let moving = [(1.0, 0.0), (0.0, 1.0)].map(|(by_angle, by_feed)| {
            let pose = self.pose(Dual64::new(at[0], by_angle), Dual64::new(at[1], by_feed));
            let point = pose.rotation() * ray.point.map(Dual64::from_re) + pose.translation();
            (point, pose.rotation() * ray.normal.map(Dual64::from_re))
        });
        let (point, normal) = (moving[0].0.map(|x| x.re), moving[0].1.map(|x| x.re));
        let mut lam = guess;
        // Quadratic convergence on an almost linear function: three steps.
        for _ in 0..20 {
            let end = Vector3::from_fn(|k, _| Dual64::new(point[k] + lam * normal[k], normal[k]));
            let gap = self.gap_along(&end);
            let slope = gap.value.eps;
            if slope.is_nan() || slope > FACING {
                return None;
            }
            let step = -gap.value.re / slope;
            lam += step;
            if step.abs() < ROUNDING {
                let rate = |(p, n): &(Vector3<Dual64>, Vector3<Dual64>)| {
                    let end = Vector3::from_fn(|k, _| p[k] + n[k] * lam);
                    -self.gap_along(&end).value.eps / slope
                };
                let rates = Vector2::new(rate(&moving[0]), rate(&moving[1]));
                return Some(Length { lam, rates, foot: gap.foot });
            }
        }
        None
    }
}
