//! Stage one: normal rays of the worm, shortened by the dresser over the real dressing motion
//! (`docs/mathematics/dressing.md#how-it-is-verified`).
//!
//! Every ray is tried against a table of poses over the whole stroke; each dip of its length over the worm position is
//! then followed to its bottom in poses of its own, with the velocity of the pose from dual numbers. No ray starts from
//! another one, so that the order of work is immaterial.

use super::dressed_flank::{DressedFlank, DressedRay};
use super::meridian::{self, Meridian};
use super::{RayGrid, RemovalError, Stage, Statistics, Uncut, error};
use foundation::geometry::{InvoluteFlank, Revolution};
use foundation::kinematics::DressingMotion;
use foundation::numerics::Progress;
use nalgebra::{Matrix3, Vector3};
use num_dual::Dual64;
use rayon::prelude::*;

/// What the stage is given. mm.
#[derive(Clone, Copy, Debug)]
pub struct Dressing<'a> {
    /// The worm flank on whose normals the rays stand.
    pub worm: &'a InvoluteFlank,
    /// The dresser's flank, its offset included. A part of a flank cuts with its edges too.
    pub dresser: &'a Revolution,
    /// The motion that is really driven.
    pub motion: &'a DressingMotion,
    /// First and last worm position v_zS of the stroke.
    pub shift_range: [f64; 2],
    /// Largest length, up or down, that counts as this flank's stock; below a quarter of the normal base pitch.
    pub stock: f64,
}

/// Poses of the scan per axial pitch. Over a 32nd of a pitch the length of a ray bends by some 0.1 um.
const POSES_PER_PITCH: f64 = 32.0;
/// Longest way of a flank point between two poses of the scan, mm: over half of it a disc of 30 mm radius curves away by
/// 0.1 mm, which is below the stock that a dip may stand off.
const LONGEST_WAY: f64 = 5.0;
/// Share of the axial pitch beyond which a hit belongs to another groove or to the back of the disc
/// (`docs/mathematics/dressing.md#how-it-is-verified`).
const OWN_GROOVE: f64 = 0.45;
/// Largest cosine between the ray and the dresser's outward normal that counts as meeting the dresser from its front.
const FACING: f64 = -0.3;
/// The bottom of a dip is found when the length expected below is under this, mm: 1e-10 um.
const SETTLED: f64 = 1e-13;
/// Rounding of a length: coordinates of some 100 mm go through three rotations, mm.
const ROUNDING: f64 = 1e-12;
/// Where the first secant on the rate of a length ends, mm: a bottom found is nearer than that.
const BESIDE: f64 = 0.01;
/// Check rays stand in every third cell in w and every fifth in z, and in every cell in w on a few sections: a kink lies in one row of cells
/// and would be passed over by a coarser sample.
const CHECK_STRIDES: [(usize, usize); 2] = [(3, 5), (1, 25)];
/// Rays per parcel of work; a parcel takes about a millisecond.
const PARCEL: usize = 64;

/// A pose of the scan: worm coordinates into dresser coordinates.
struct ScanPose {
    rotation: Matrix3<f64>,
    translation: Vector3<f64>,
}

pub(super) struct Cutter<'a> {
    setup: &'a Dressing<'a>,
    meridian: Meridian,
    poses: Vec<ScanPose>,
    step: f64,
    pitch: f64,
}

/// Length at one instant and its rate over v.
#[derive(Clone, Copy)]
struct Length {
    lam: f64,
    rate: f64,
}

struct Ray {
    point: Vector3<f64>,
    normal: Vector3<f64>,
}

/// One ray's result with the residue of its minimum, mm.
struct Shot {
    ray: Result<DressedRay, Uncut>,
    residue: f64,
    statistics: Statistics,
}

/// Shortens the rays of `grid` by the dresser over the whole stroke.
///
/// # Errors
/// [`RemovalError::InvalidNumber`] for stroke, stock or screw parameter, [`RemovalError::InternalUnsupported`],
/// [`RemovalError::ProfileFolds`], [`RemovalError::Surface`] for a profile that is not finite. Rays that the dresser
/// does not finish are no error here; see [`DressedFlank::surface`].
pub fn dress(
    setup: &Dressing<'_>,
    grid: &RayGrid,
    progress: &dyn Progress,
) -> Result<DressedFlank, RemovalError> {
    let cutter = Cutter::new(setup, meridian::TOLERANCE)?;
    let mut feet: Vec<(f64, f64)> = (0..grid.count()).map(|i| grid.ray(i)).collect();
    feet.extend(CHECK_STRIDES.iter().flat_map(|&(w_stride, z_stride)| grid.cell_middles(w_stride, z_stride)));
    progress.start("dressing", feet.len() as u64);
    let shots: Vec<Shot> = feet
        .par_chunks(PARCEL)
        .map_init(Vec::new, |lengths, parcel| {
            let shots: Vec<Shot> = parcel.iter().map(|&(w, z)| cutter.shoot(w, z, lengths)).collect();
            progress.advance(parcel.len() as u64);
            shots
        })
        .flatten_iter()
        .collect();
    progress.finish();

    let mut statistics = Statistics { poses: cutter.poses.len() as u64, ..Statistics::default() };
    let mut residue: f64 = 0.0;
    let mut rays = Vec::with_capacity(feet.len());
    for shot in shots {
        statistics = statistics + shot.statistics;
        residue = residue.max(shot.residue);
        rays.push(shot.ray);
    }
    let checks = rays.split_off(grid.count());
    let checks = feet[grid.count()..].iter().zip(checks).map(|(&(w, z), ray)| (w, z, ray)).collect();
    Ok(DressedFlank {
        grid: grid.clone(),
        rays,
        checks,
        error_um: (residue + cutter.meridian.error + ROUNDING) * 1e3,
        statistics,
    })
}

impl<'a> Cutter<'a> {
    pub fn new(setup: &'a Dressing<'a>, tolerance: f64) -> Result<Self, RemovalError> {
        error::range("dressing stroke v_zS", setup.shift_range)?;
        error::positive("dressing stock", setup.stock)?;
        let flank = setup.worm;
        if flank.external_sign < 0.0 {
            return Err(RemovalError::InternalUnsupported { stage: Stage::Dressing });
        }
        let circumference = 2.0 * std::f64::consts::PI * flank.base_radius;
        let base_pitch = circumference * flank.base_helix_angle.cos() / flank.teeth;
        if setup.stock > 0.25 * base_pitch {
            return Err(RemovalError::InvalidNumber {
                field: "dressing stock",
                value: setup.stock,
                allowed: "up to a quarter of the normal base pitch",
            });
        }
        let screw = setup.motion.chain.screw_parameter;
        error::positive("magnitude of the screw parameter", screw.abs())?;
        let pitch = 2.0 * std::f64::consts::PI * screw.abs() / flank.teeth;
        let [from, to] = setup.shift_range;
        let outermost = setup.dresser.interval().1.hypot(flank.base_radius);
        let turning = outermost / (screw.abs() * LONGEST_WAY);
        let intervals = ((to - from) * turning.max(POSES_PER_PITCH / pitch)).ceil().max(2.0);
        // A million poses are a stroke of thirty thousand pitches: a mistake in the units, not a worm.
        if intervals > 1e6 {
            return Err(RemovalError::InvalidNumber {
                field: "dressing stroke v_zS",
                value: to - from,
                allowed: "a length of the order of the worm's width",
            });
        }
        let step = (to - from) / intervals;
        let poses = (0..=intervals as usize)
            .map(|k| {
                let pose = setup.motion.position(from + step * k as f64).pose().inverse();
                ScanPose { rotation: *pose.rotation(), translation: *pose.translation() }
            })
            .collect();
        Ok(Self { setup, meridian: Meridian::new(setup.dresser, tolerance)?, poses, step, pitch })
    }

    /// Bound of the error of a length beside the residue of its bottom, um.
    pub fn error_um(&self) -> f64 {
        (self.meridian.error + ROUNDING) * 1e3
    }

    /// Length of the ray at (w, z) and its derivatives by w and z; `None` where the dresser does not finish it.
    pub fn jet(&self, w: f64, z: f64) -> Option<[f64; 3]> {
        let found = self.shoot(w, z, &mut Vec::new()).ray.ok()?;
        let frame = self.setup.worm.frame(w, z);
        let ray = Ray { point: self.setup.worm.point_in(&frame, w, z), normal: frame.n };
        let cut = self.settled(&ray, found)?;
        // At the bottom the length does not change with the worm position: what is left is the ray's own displacement.
        let pose = self.setup.motion.position(cut.shift).pose().inverse();
        let by = |dw: f64, dz: f64| {
            let (w, z) = (Dual64::new(w, dw), Dual64::new(z, dz));
            let frame = self.setup.worm.frame(w, z);
            let [point, normal] = [self.setup.worm.point_in(&frame, w, z), frame.n];
            let rotation = pose.rotation().map(Dual64::from_re);
            let p = rotation * point + pose.translation().map(Dual64::from_re);
            let n = rotation * normal;
            let end = p + n * Dual64::from_re(cut.f);
            let r = end.x.re.hypot(end.y.re);
            let [_, slope] = self.meridian.at(r)?;
            let outward = |v: [f64; 3]| v[2] - slope * (end.x.re * v[0] + end.y.re * v[1]) / r;
            Some(-outward([end.x.eps, end.y.eps, end.z.eps]) / outward([n.x.re, n.y.re, n.z.re]))
        };
        Some([cut.f, by(1.0, 0.0)?, by(0.0, 1.0)?])
    }

    /// The bottom of a dip so exactly that the derivatives of its length have no noise: secants on the rate.
    fn settled(&self, ray: &Ray, found: DressedRay) -> Option<DressedRay> {
        let (mut v, mut length) = (found.shift, self.length(ray, found.shift, found.f)?);
        let (mut other, mut rate) = (v + BESIDE, self.length(ray, v + BESIDE, found.f)?.rate);
        for _ in 0..6 {
            let step = length.rate * (v - other) / (length.rate - rate);
            if !step.is_finite() || step.abs() > BESIDE {
                break;
            }
            (other, rate) = (v, length.rate);
            v -= step;
            length = self.length(ray, v, length.lam)?;
            if step.abs() < 1e-9 {
                break;
            }
        }
        Some(DressedRay { f: length.lam, shift: v })
    }

    /// The ray at (w, z); `lengths` is scratch.
    fn shoot(&self, w: f64, z: f64, lengths: &mut Vec<f64>) -> Shot {
        let frame = self.setup.worm.frame(w, z);
        let ray = Ray { point: self.setup.worm.point_in(&frame, w, z), normal: frame.n };
        lengths.clear();
        lengths.extend(self.poses.iter().map(|pose| self.first_order_length(&ray, pose)));
        let mut statistics = Statistics { rays: 1, tested: lengths.len() as u64, ..Statistics::default() };

        let dips = || dips(lengths, 2.0 * self.setup.stock);
        let Some(own) = dips().min_by(|&a, &b| lengths[a].abs().total_cmp(&lengths[b].abs())) else {
            return Shot { ray: Err(Uncut::NotReached), residue: 0.0, statistics };
        };
        let mut best: Option<(DressedRay, f64)> = None;
        let mut broken: Option<(f64, Uncut)> = None;
        for k in dips() {
            if (k as f64 - own as f64).abs() * self.step > OWN_GROOVE * self.pitch {
                statistics.foreign += 1;
                continue;
            }
            let followed = self.follow(&ray, k, lengths[k], &mut statistics.exact);
            match followed {
                Ok((found, residue)) => {
                    if best.is_none_or(|(other, _)| found.f < other.f) {
                        best = Some((found, residue));
                    }
                }
                Err(reason) => {
                    if broken.is_none_or(|(length, _)| lengths[k] < length) {
                        broken = Some((lengths[k], reason));
                    }
                }
            }
        }
        // A dip that breaks off below the best bottom would have cut deeper: the ray is not finished.
        let (ray, residue) = match (best, broken) {
            (Some((found, _)), Some((length, reason))) if length < found.f => (Err(reason), 0.0),
            (Some((found, _)), _) if found.f.abs() > self.setup.stock => (Err(Uncut::NotReached), 0.0),
            (Some((found, residue)), _) => (Ok(found), residue),
            (None, Some((_, reason))) => (Err(reason), 0.0),
            (None, None) => (Err(Uncut::NotReached), 0.0),
        };
        Shot { ray, residue, statistics }
    }

    /// Length by one Newton step from the foot; infinite where the dresser is not or shows its back.
    #[inline]
    fn first_order_length(&self, ray: &Ray, pose: &ScanPose) -> f64 {
        let p = pose.rotation * ray.point + pose.translation;
        let r = p.x.hypot(p.y);
        let Some([profile, slope]) = self.meridian.at(r) else { return f64::INFINITY };
        let n = pose.rotation * ray.normal;
        let side = self.meridian.side;
        let rate = side * (n.z - slope * (p.x * n.x + p.y * n.y) / r);
        if rate > FACING * slope.hypot(1.0) {
            return f64::INFINITY;
        }
        side * (profile - p.z) / rate
    }

    /// Exact length in the pose at v, with its rate; `None` where the ray does not meet the dresser's front.
    fn length(&self, ray: &Ray, v: f64, guess: f64) -> Option<Length> {
        let pose = self.setup.motion.position(Dual64::from_re(v).derivative()).pose().inverse();
        let p = pose.rotation() * ray.point.map(Dual64::from_re) + pose.translation();
        let n = pose.rotation() * ray.normal.map(Dual64::from_re);
        let side = self.meridian.side;
        let mut lam = guess;
        // Quadratic convergence from a guess 0.1 mm off takes four steps.
        for _ in 0..20 {
            let (x, y, z) = (p.x.re + lam * n.x.re, p.y.re + lam * n.y.re, p.z.re + lam * n.z.re);
            let r = x.hypot(y);
            let [profile, slope] = self.meridian.at(r)?;
            let rate = side * (n.z.re - slope * (x * n.x.re + y * n.y.re) / r);
            if rate > FACING * slope.hypot(1.0) {
                return None;
            }
            let step = side * (profile - z) / rate;
            lam += step;
            if step.abs() < ROUNDING {
                let drift = |k: usize| p[k].eps + lam * n[k].eps;
                let gap_rate = side * (drift(2) - slope * (x * drift(0) + y * drift(1)) / r);
                return Some(Length { lam, rate: -gap_rate / rate });
            }
        }
        None
    }

    /// The bottom of the dip round pose k: root of the rate, bracketed by poses of the scan.
    fn follow(&self, ray: &Ray, k: usize, guess: f64, exact: &mut u64) -> Result<(DressedRay, f64), Uncut> {
        let [from, to] = self.setup.shift_range;
        let mut at = |v: f64, guess: f64| {
            *exact += 1;
            self.length(ray, v, guess).ok_or(Uncut::ToolMissing)
        };
        let mut a = from + self.step * k as f64;
        let mut low = match at(a, guess) {
            // At an edge the scan's length may be one of a pose that just misses.
            Err(_) if self.setup.dresser.is_part() => {
                let beside = [a - self.step, a + self.step].into_iter().filter(|v| *v >= from && *v <= to);
                let (v, found) = beside
                    .filter_map(|v| at(v, guess).ok().map(|found| (v, found)))
                    .min_by(|x, y| x.1.lam.total_cmp(&y.1.lam))
                    .ok_or(Uncut::ToolMissing)?;
                a = v;
                found
            }
            found => found?,
        };
        // Downhill, pose by pose: the scan's first-order lengths may be off by one pose. Near the end of the profile
        // shorter strides keep to it.
        let mut stride = -self.step * low.rate.signum();
        let mut b = a;
        let mut high = low;
        for strides in 0.. {
            if strides > 16 {
                // The dresser ends here: a body that is only a part cuts with its edge, and less than nothing lies beyond the
                // last stride.
                let edge = self.setup.dresser.is_part();
                return if edge {
                    Ok((DressedRay { f: low.lam, shift: a }, 0.0))
                } else {
                    Err(Uncut::ToolMissing)
                };
            }
            b = a + stride;
            if b < from - 0.5 * self.step || b > to + 0.5 * self.step {
                return Err(Uncut::StrokeTooShort);
            }
            b = b.clamp(from, to);
            match at(b, low.lam) {
                Err(_) => stride *= 0.5,
                Ok(found) if found.rate * stride >= 0.0 => {
                    high = found;
                    break;
                }
                Ok(found) => (a, low) = (b, found),
            }
        }
        // Regula falsi with the Illinois weights: the bracket stays, the order is 1.44.
        let (mut weight_low, mut weight_high) = (1.0, 1.0);
        for _ in 0..60 {
            let (rate_a, rate_b) = (low.rate * weight_low, high.rate * weight_high);
            let v =
                if rate_a == rate_b { 0.5 * (a + b) } else { (a * rate_b - b * rate_a) / (rate_b - rate_a) };
            let middle = at(v, if low.lam < high.lam { low.lam } else { high.lam })?;
            // The rate falls to zero over at most the rest of the bracket, so no more than this lies below.
            let curvature = ((high.rate - low.rate) / (b - a)).abs();
            let below = 0.5 * middle.rate * middle.rate / curvature.max(f64::MIN_POSITIVE);
            if below < SETTLED || (b - a).abs() < SETTLED {
                return Ok((DressedRay { f: middle.lam, shift: v }, below));
            }
            if (middle.rate > 0.0) == (high.rate > 0.0) {
                (b, high) = (v, middle);
                weight_high = 1.0;
                weight_low *= 0.5;
            } else {
                (a, low) = (v, middle);
                weight_low = 1.0;
                weight_high *= 0.5;
            }
        }
        Err(Uncut::NotConverged)
    }
}

/// Indices of the local minima of a list that lie below a limit; ends of the list and of finite stretches count.
fn dips(lengths: &[f64], limit: f64) -> impl Iterator<Item = usize> + '_ {
    (0..lengths.len()).filter(move |&k| {
        let here = lengths[k];
        let below = |j: Option<&f64>| j.is_none_or(|&other| here <= other);
        let before = if k == 0 { None } else { lengths.get(k - 1) };
        here.abs() <= limit && below(before) && lengths.get(k + 1).is_none_or(|&next| here < next)
    })
}
