//! The root of the gear, refereed: rays of the gear shortened by the rounded edge of the worm's tip. The edge is all balls that
//! touch flank and tip of the worm from inside; where they lie is found by trial, not from a formula of the flank.

use super::{RemovalError, WormModification};
use foundation::geometry::InvoluteFlank;
use foundation::kinematics::{GeneratingMotion, MotionLaw};
use foundation::numerics::{Chebyshev, Scalar, brent, equidistant};
use nalgebra::{Matrix3, Rotation3, Vector3};
use num_dual::Dual2SVec64;
use rayon::prelude::*;
use std::f64::consts::PI;

/// The worm's edge and its motion. mm.
#[derive(Clone, Copy)]
pub struct RootGrinding<'a> {
    /// The worm flank beside the edge.
    pub worm: &'a InvoluteFlank,
    /// What the worm has more than that flank, f_n1, mm; beyond its domain as at its ends.
    pub modification: &'a dyn WormModification,
    /// Radius of the edge.
    pub corner_radius: f64,
    /// Tip radius over the worm's z.
    pub tip: &'a MotionLaw,
    /// The motion that is really driven.
    pub motion: &'a GeneratingMotion,
    /// Feeds between which that motion is driven, mm.
    pub feeds: [f64; 2],
    /// Half the width along the worm's axis in which the edge is looked for, beside the place that faces the gear: 6 mm for a
    /// fillet beside the root; what an edge cuts off a flank lies further out.
    pub along: f64,
}

/// A ray of the gear: foot and direction out of its material.
#[derive(Clone, Copy, Debug)]
pub struct RootRay {
    /// Foot, mm.
    pub foot: Vector3<f64>,
    /// Unit direction.
    pub direction: Vector3<f64>,
}

/// Half width of the raster about the instant at which tip and gear face each other, round the worm, mm.
const AROUND: f64 = 8.0;
/// Steps of the raster as a share of the radius of the edge.
const RASTER: f64 = 0.4;
/// Radius of the ball that finds where a smaller one is to be looked for, mm.
const WIDE: f64 = 0.8;
/// Steps over a pitch of the worm in search of the ball.
const STEPS: usize = 64;
/// Nodes of the path of the balls.
const PATH_NODES: usize = 17;
/// Feeds at which the slope of the shift is looked at.
const SLOPES: usize = 9;
/// The search for the shortest ray has settled at a step of this size, rad and mm.
const SETTLED: f64 = 1e-10;
const MOST_STEPS: usize = 60;

/// A ray in the space that the edge passes.
#[derive(Clone, Copy)]
struct Searched<'a> {
    /// Worm angle, feed and place along the worm at which tip and ray face each other.
    place: [f64; 3],
    /// Angle of the edge along the worm.
    path: &'a Chebyshev,
    foot: &'a Vector3<f64>,
    direction: &'a Vector3<f64>,
}

impl RootGrinding<'_> {
    /// Lengths of the rays, mm, in their order: > 0 where material is left over the foot; `None` for a ray that no ball shortens, or only one
    /// at a feed that is not driven.
    ///
    /// # Errors
    /// [`RemovalError::InvalidNumber`] for an edge that does not fit on the worm.
    pub fn lengths(&self, rays: &[RootRay]) -> Result<Vec<Option<f64>>, RemovalError> {
        rays.par_iter().map(|ray| self.length(ray)).collect()
    }

    fn is_driven(&self, feed: f64) -> bool {
        (self.feeds[0]..=self.feeds[1]).contains(&feed)
    }

    /// Angle, from +y towards +x, at which the ball at the worm's z touches flank and tip.
    fn angle(&self, z: f64) -> Option<f64> {
        let r = self.tip.value(z) - self.corner_radius;
        let [w_ends, z_ends] = self.modification.domain();
        let modified =
            |w: f64| self.modification.value(w.clamp(w_ends[0], w_ends[1]), z.clamp(z_ends[0], z_ends[1]));
        let depth = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            let foot = self.worm.deviation(&Vector3::new(r * sin, r * cos, z));
            foot.f_n - modified(foot.w) + self.corner_radius
        };
        let pitch = 2.0 * PI / self.worm.teeth;
        let at = |k: usize| (k as f64 / STEPS as f64 - 0.5) * pitch;
        (0..STEPS).find_map(|k| {
            let ends = [depth(at(k)), depth(at(k + 1))];
            // The deviation leaps by a pitch where the nearest space changes.
            let leap = (ends[1] - ends[0]).abs() > 0.25 * pitch * self.worm.base_radius;
            (ends[0] * ends[1] <= 0.0 && !leap)
                .then(|| brent([at(k), at(k + 1)], ends, 1e-15, |angle| Some(depth(angle))))
                .flatten()
        })
    }

    fn length(&self, ray: &RootRay) -> Result<Option<f64>, RemovalError> {
        let motion = self.motion;
        let feed_0 = -ray.foot.z;
        let place = -motion.shift.value(feed_0);
        let reach = self.along + 2.0 * self.corner_radius;
        // The places of the edge that come to the ray at other feeds lie further along a worm that shifts.
        let steepest =
            equidistant(self.feeds, SLOPES).into_iter().map(|feed| motion.shift.lifted(feed)[1].abs());
        let wider = 1.0 + steepest.fold(0.0, f64::max);
        let [from, to] = [place - 2.0 * reach * wider, place + 2.0 * reach * wider];
        let nodes = (PATH_NODES as f64 * wider).ceil() as usize;
        let mut angles = Vec::with_capacity(nodes);
        for z in Chebyshev::nodes(from, to, nodes) {
            let Some(angle) = self.angle(z) else {
                return Err(RemovalError::InvalidNumber {
                    field: "radius of the worm's edge",
                    value: self.corner_radius,
                    allowed: "small enough to fit between flank and tip",
                });
            };
            // Continuous along the thread.
            let pitch = 2.0 * PI / self.worm.teeth;
            let before = angles.last().copied().unwrap_or(angle);
            let drift = match angles.len() {
                0 | 1 => -((to - from) / nodes as f64) * self.worm.twist_per_length(),
                n => angles[n - 1] - angles[n - 2],
            };
            let expected = if angles.is_empty() { angle } else { before + drift };
            angles.push(angle + ((expected - angle) / pitch).round() * pitch);
        }
        let path = Chebyshev::interpolate(from, to, &angles);
        let facing = path.value(place);
        // The space in which the ray stands.
        let pitch = 2.0 * PI / motion.teeth.abs();
        let seen = self.ball([facing, feed_0, place], &path);
        let turn = ((seen.x.atan2(seen.y) - ray.foot.x.atan2(ray.foot.y)) / pitch).round() * pitch;
        let turned = Rotation3::from_axis_angle(&Vector3::z_axis(), -turn);
        let (foot, direction) = (turned * ray.foot, turned * ray.direction);
        let reach = [AROUND, reach];
        let searched =
            Searched { place: [facing, feed_0, place], path: &path, foot: &foot, direction: &direction };
        // A large ball about the same centres finds the neighbourhood on a wide raster, its own ball the place in it.
        let wide = self.corner_radius.max(WIDE);
        let near = self.searched(&searched, wide, [0.0, 0.0], reach);
        let near = near.and_then(|(_, _, at)| self.searched(&searched, self.corner_radius, at, [wide; 2]));
        let best = near.or_else(|| self.searched(&searched, self.corner_radius, [0.0, 0.0], reach));
        let Some((least, at, _)) = best else { return Ok(None) };
        let (least, at) = self.settled(&searched, (least, at));
        Ok(self.is_driven(at.y).then_some(least))
    }

    /// The shortest ray about a place, by worm angle, feed and place along the worm.
    fn settled(&self, ray: &Searched<'_>, (mut least, mut x): (f64, Vector3<f64>)) -> (f64, Vector3<f64>) {
        let Searched { path, foot, direction, .. } = *ray;
        let ball = (path, self.corner_radius);
        for _ in 0..MOST_STEPS {
            let variables = [0, 1, 2].map(|k| Dual2SVec64::<3>::from_re(x[k]).derivative(k));
            let Some(at) = self.shortened(variables, ball, foot, direction) else { break };
            let (Some(slope), Some(bend)) = (&at.v1.0, &at.v2.0) else { break };
            let gradient = Vector3::new(slope[0], slope[1], slope[2]);
            let mut hessian = Matrix3::from_fn(|i, j| bend[(i, j)]);
            // Convex, so that the step goes down.
            let eigen = hessian.symmetric_eigenvalues().min();
            if eigen < 1e-6 {
                hessian += Matrix3::identity() * (1e-6 - eigen);
            }
            let Some(mut step) = hessian.try_inverse().map(|inverse| -(inverse * gradient)) else { break };
            let settled = step.norm() < SETTLED;
            let lower = (0..30).find_map(|_| {
                let next = x + step;
                step *= 0.5;
                self.shortened(next.into(), ball, foot, direction)
                    .filter(|&length| length <= least)
                    .map(|length| (length, next))
            });
            match lower {
                Some(found) => (least, x) = found,
                None => break,
            }
            if settled {
                break;
            }
        }
        (least, x)
    }

    /// Centre of the ball on the gear, mm, at worm angle, feed and place along the worm.
    fn ball<T: Scalar>(&self, [angle, feed, zeta]: [T; 3], path: &Chebyshev) -> Vector3<T> {
        let r = self.tip.lifted(zeta)[0] - self.corner_radius;
        let (sin, cos) = path.value(zeta).sin_cos();
        let state = self.motion.state(angle, feed, self.motion.phase[self.worm.flank]);
        let pose = self.motion.chain.pose(&state);
        let centre = Vector3::new(r * sin, r * cos, zeta);
        pose.rotation().transpose() * (centre - pose.translation())
    }

    /// The shortest ray that balls of a radius about the centres of the edge leave, on a raster: its length, worm angle, feed and place along
    /// the worm, and where the raster has it. The raster reaches `half` from `middle`, round the worm and along it, mm.
    fn searched(
        &self,
        ray: &Searched<'_>,
        radius: f64,
        middle: [f64; 2],
        half: [f64; 2],
    ) -> Option<(f64, Vector3<f64>, [f64; 2])> {
        let Searched { place: [facing, feed_0, place], path, foot, direction } = *ray;
        let by_angle = self.tip.value(place).recip();
        let raster = |k: usize| {
            let count = (2.0 * half[k] / (RASTER * radius)).ceil().clamp(8.0, 400.0) as usize + 1;
            equidistant([middle[k] - half[k], middle[k] + half[k]], count)
        };
        let along_worm = raster(1);
        let mut best: Option<(f64, Vector3<f64>, [f64; 2])> = None;
        for around in raster(0) {
            for &along in &along_worm {
                let mut feed = feed_0;
                let mut x = [facing, feed_0, place];
                // The feed that brings the ball to the ray's place along the gear.
                for _ in 0..3 {
                    let zeta = along - self.motion.shift.value(feed);
                    x = [path.value(zeta) + around * by_angle, feed, zeta];
                    feed += self.ball(x, path).z - foot.z - radius * direction.z;
                }
                if let Some(length) = self.shortened(x, (path, radius), foot, direction)
                    && best.is_none_or(|(least, ..)| length < least)
                {
                    best = Some((length, Vector3::from(x), [around, along]));
                }
            }
        }
        best
    }

    /// Length to which a ball of this radius shortens the ray; `None` also beyond the known part of the edge.
    fn shortened<T: Scalar>(
        &self,
        x: [T; 3],
        (path, radius): (&Chebyshev, f64),
        foot: &Vector3<f64>,
        direction: &Vector3<f64>,
    ) -> Option<T> {
        let (from, to) = path.interval();
        if !(from..=to).contains(&x[2].re()) {
            return None;
        }
        let centre = self.ball(x, path);
        let off = Vector3::new(centre.x - foot.x, centre.y - foot.y, centre.z - foot.z);
        let along = off.x * direction.x + off.y * direction.y + off.z * direction.z;
        let square = off.x * off.x + off.y * off.y + off.z * off.z;
        let rest = along * along - square + radius * radius;
        (rest.re() > 0.0).then(|| along - rest.sqrt())
    }
}
