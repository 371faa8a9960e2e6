//! Stage one for a disc that writes the worm line by line: normal rays of the worm, shortened by the rounded tip of the disc, a
//! torus, in the poses of every line (`docs/mathematics/dressing.md#conditions`). Between the lines scallops stay; the rays see them.
//!
//! Every ray is tried against every line: where along it the torus comes nearest is found from distances alone, then the
//! length is followed to its least value in poses of its own.

use super::{RayGrid, RemovalError, Stage, Statistics, Uncut, error};
use foundation::geometry::InvoluteFlank;
use foundation::kinematics::DressingPath;
use foundation::numerics::{Progress, equidistant, golden_section};
use nalgebra::{Matrix3, Vector3};
use rayon::prelude::*;

/// What the stage is given. mm.
#[derive(Clone, Copy, Debug)]
pub struct LinePasses<'a> {
    /// The worm flank on whose normals the rays stand.
    pub worm: &'a InvoluteFlank,
    /// Radius of the circle on which the centres of the tip rounding lie.
    pub centre_radius: f64,
    /// Radius of the tip rounding.
    pub tip_radius: f64,
    /// The lines as they are driven.
    pub paths: &'a [DressingPath],
    /// Largest length, up or down, that counts as this flank's stock; at most half the tip radius.
    pub stock: f64,
}

/// What a line left of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineCut {
    /// Length left, mm: f_n1 > 0 material left standing.
    pub f: f64,
    /// Index of the line that cut deepest.
    pub path: usize,
    /// Where on it, t, mm.
    pub t: f64,
}

/// The rays of a worm flank after line dressing.
#[derive(Clone, Debug, PartialEq)]
pub struct LineDressed {
    /// Where the rays stand.
    pub grid: RayGrid,
    /// The rays, row-major `[w][z]`.
    pub rays: Vec<Result<LineCut, Uncut>>,
    /// What was looked at.
    pub statistics: Statistics,
}

impl LineDressed {
    /// The lengths f_n1, mm, row-major `[w][z]`.
    ///
    /// # Errors
    /// [`RemovalError::RayUncut`] when a ray has none.
    pub fn lengths(&self) -> Result<Vec<f64>, RemovalError> {
        super::dressed_flank::all_finished(Stage::Dressing, &self.grid, &self.rays, |ray| ray.f)
    }
}

/// Poses of the scan along a line.
const POSES: usize = 33;
/// The gap between two poses of the scan is at least that of the nearer one less this share of the way between them.
const WAY_SHARE: f64 = 0.6;
/// Steps of the search for the nearest approach, to a millionth of its interval, and of that for the least length.
const APPROACH_STEPS: usize = 32;
const STEPS: usize = 48;
/// Share of an interval of the scan round the nearest approach in which the length is searched.
const AROUND: f64 = 0.2;
/// Largest cosine between the ray and the outward normal of the torus that counts as meeting it from its front.
const FACING: f64 = -0.3;
/// Rounding of a length, mm.
const ROUNDING: f64 = 1e-12;

/// Worm coordinates into dresser coordinates.
struct ScanPose {
    rotation: Matrix3<f64>,
    translation: Vector3<f64>,
}

struct Scan {
    t: Vec<f64>,
    poses: Vec<ScanPose>,
}

/// A stretch of a line that may come near a ray's foot.
struct Approach {
    path: usize,
    /// Interval of the scan.
    interval: usize,
    /// Gap at the nearer of its ends.
    gap: f64,
    /// Bound of the gap inside it.
    least: f64,
}

/// Shortens the rays of `grid` by the disc on all lines.
///
/// # Errors
/// [`RemovalError::InvalidNumber`], [`RemovalError::InternalUnsupported`]. Rays that no line finishes are no error here; see
/// [`LineDressed::lengths`].
pub fn dress_lines(
    setup: &LinePasses<'_>,
    grid: &RayGrid,
    progress: &dyn Progress,
) -> Result<LineDressed, RemovalError> {
    error::positive("tip radius of the dresser", setup.tip_radius)?;
    error::positive("radius of the dresser's tip centres", setup.centre_radius)?;
    error::positive("dressing stock", setup.stock)?;
    if setup.stock > 0.5 * setup.tip_radius {
        return Err(RemovalError::InvalidNumber {
            field: "dressing stock",
            value: setup.stock,
            allowed: "up to half the tip radius of the dresser",
        });
    }
    if setup.worm.external_sign < 0.0 {
        return Err(RemovalError::InternalUnsupported { stage: Stage::Dressing });
    }
    for path in setup.paths {
        error::range("dressing line", path.domain)?;
    }
    let scans: Vec<Scan> = setup.paths.par_iter().map(scan).collect();
    progress.start("dressing lines", grid.count() as u64);
    let shots: Vec<(Result<LineCut, Uncut>, Statistics)> = (0..grid.count())
        .into_par_iter()
        .map(|index| {
            let (w, z) = grid.ray(index);
            let shot = shoot(setup, &scans, w, z);
            progress.advance(1);
            shot
        })
        .collect();
    progress.finish();
    let poses = (scans.len() * POSES) as u64;
    let statistics = shots
        .iter()
        .fold(Statistics { poses, ..Statistics::default() }, |sum, (_, statistics)| sum + *statistics);
    Ok(LineDressed { grid: grid.clone(), rays: shots.into_iter().map(|shot| shot.0).collect(), statistics })
}

fn scan(path: &DressingPath) -> Scan {
    let t = equidistant(path.domain, POSES);
    let poses = t.iter().map(|&t| pose_at(path, t)).collect();
    Scan { t, poses }
}

fn pose_at(path: &DressingPath, t: f64) -> ScanPose {
    let pose = path.position(t).pose().inverse();
    ScanPose { rotation: *pose.rotation(), translation: *pose.translation() }
}

fn shoot(setup: &LinePasses<'_>, scans: &[Scan], w: f64, z: f64) -> (Result<LineCut, Uncut>, Statistics) {
    let frame = setup.worm.frame(w, z);
    let (point, normal) = (setup.worm.point_in(&frame, w, z), frame.n);
    let mut statistics = Statistics { rays: 1, ..Statistics::default() };
    // Places where a line may come near, the nearest first: what cuts deep soon rules out the rest.
    let mut approaches: Vec<Approach> = Vec::new();
    for (index, scan) in scans.iter().enumerate() {
        let places: Vec<Vector3<f64>> =
            scan.poses.iter().map(|pose| pose.rotation * point + pose.translation).collect();
        let gaps: Vec<f64> = places.iter().map(|p| gap(setup, p)).collect();
        statistics.tested += POSES as u64;
        let middle = |j: usize| gaps[j].min(gaps[j + 1]);
        for k in 0..POSES - 1 {
            let way = (places[k + 1] - places[k]).norm();
            let least = middle(k) - WAY_SHARE * way;
            // Only an interval that is no higher than its neighbours can hold a nearest approach.
            let valley =
                (k == 0 || middle(k - 1) >= middle(k)) && (k + 2 == POSES || middle(k + 1) >= middle(k));
            if least <= setup.stock && valley {
                approaches.push(Approach { path: index, interval: k, gap: middle(k), least });
            }
        }
    }
    approaches.sort_by(|a, b| a.gap.total_cmp(&b.gap));
    let mut best: Option<LineCut> = None;
    for approach in approaches {
        // A ray is no shorter than the distance of its foot, and below the surface no longer than 1/|FACING| times that.
        let reach = best.map_or(setup.stock, |cut: LineCut| cut.f.max(-FACING * cut.f).min(setup.stock));
        if approach.least > reach {
            continue;
        }
        let (scan, path) = (&scans[approach.path], &setup.paths[approach.path]);
        let k = approach.interval;
        let (low, high) = (scan.t[k.saturating_sub(1)], scan.t[(k + 2).min(POSES - 1)]);
        let mut nearest_gap = f64::INFINITY;
        let nearest = golden_section(low, high, APPROACH_STEPS, |t| {
            statistics.exact += 1;
            let pose = pose_at(path, t);
            let here = gap(setup, &(pose.rotation * point + pose.translation));
            nearest_gap = nearest_gap.min(here);
            here
        });
        if nearest_gap > reach {
            continue;
        }
        // Golden section looks inside an interval only; a line also cuts with its ends.
        let half = AROUND * (scan.t[1] - scan.t[0]);
        let (from, to) = ((nearest - half).max(path.domain[0]), (nearest + half).min(path.domain[1]));
        let length = |t: f64| length(setup, &pose_at(path, t), &point, &normal);
        let inside = golden_section(from, to, STEPS, |t| {
            statistics.exact += 1;
            length(t).unwrap_or(f64::INFINITY)
        });
        for t in [inside, from, to] {
            if let Some(f) = length(t)
                && f.abs() <= setup.stock
                && best.is_none_or(|cut| f < cut.f)
            {
                best = Some(LineCut { f, path: approach.path, t });
            }
        }
    }
    (best.ok_or(Uncut::NotReached), statistics)
}

/// Distance of a point in dresser coordinates from the torus; negative inside.
fn gap(setup: &LinePasses<'_>, p: &Vector3<f64>) -> f64 {
    (p.x.hypot(p.y) - setup.centre_radius).hypot(p.z) - setup.tip_radius
}

/// Length at which the ray meets the torus in a pose; `None` where it misses its front.
fn length(
    setup: &LinePasses<'_>,
    pose: &ScanPose,
    point: &Vector3<f64>,
    normal: &Vector3<f64>,
) -> Option<f64> {
    let p = pose.rotation * point + pose.translation;
    let n = pose.rotation * normal;
    let mut lam = 0.0;
    for _ in 0..30 {
        let x = p + n * lam;
        let r = x.x.hypot(x.y);
        let out = r - setup.centre_radius;
        let from_centre = out.hypot(x.z);
        let rate = (out * (x.x * n.x + x.y * n.y) / r + x.z * n.z) / from_centre;
        // NaN in the very centre of the tube misses like a ray that runs along it.
        if rate.is_nan() || rate > FACING {
            return None;
        }
        let step = (from_centre - setup.tip_radius) / rate;
        lam -= step;
        if step.abs() < ROUNDING {
            return Some(lam);
        }
    }
    None
}
