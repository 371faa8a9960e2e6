//! Stage two: normal rays of the workpiece, shortened by the worm over the real generating motion
//! (`docs/mathematics/planning.md#the-referee`).
//!
//! The worm's surface is the involute flank moved by f_n1(w_1, z_1) along its normals, where f_n1 is what stage one's
//! rays left. A ray's length in a pose is where it meets that surface; its least value over both parameters of the
//! motion, or over the turns that a real feed makes, is what is left. Every ray searches the whole motion for itself.

use super::active_threads::ThreadRule;
use super::descent::{Bottom, descend, descend_along};
use super::engagement::{Engagement, Grinding, GrindingMode, Length, ROUNDING, Ray};
use super::ground_flank::{GroundFlank, GroundRay};
use super::sweep::{Candidate, Scratch, Sweep};
use super::{RayGrid, RemovalError, Statistics, Uncut};
use foundation::numerics::Progress;
use nalgebra::{Vector2, Vector3};
use rayon::prelude::*;

/// Bottoms whose foot is nearer than this to a crease of the worm may have others beside them, mm of roll: contacts on both sides of
/// an angle of 0.01 rad lie no further apart.
const BESIDE_CREASE: f64 = 0.6;
/// Ways along the path of contact at which these are looked for, mm.
const CREASE_STRIDES: [f64; 8] = [-0.6, -0.3, -0.15, -0.07, 0.07, 0.15, 0.3, 0.6];
/// Edge of a tile in rays: small enough for a tight ball, large enough to share the bound.
const TILE: usize = 4;

/// One ray's result with the residue of its minimum, mm.
struct Shot {
    index: usize,
    ray: Result<GroundRay, Uncut>,
    residue: f64,
}

/// Shortens the rays of `grid` by the worm over the whole stroke.
///
/// # Errors
/// [`RemovalError::InvalidNumber`] for stroke, stock, area or feed, [`RemovalError::FlanksDiffer`],
/// [`RemovalError::InternalUnsupported`], [`RemovalError::NoActiveThread`]. Rays that the worm does not finish are no error
/// here; see [`GroundFlank::lengths`].
pub fn grind(
    setup: &Grinding<'_>,
    grid: &RayGrid,
    progress: &dyn Progress,
) -> Result<GroundFlank, RemovalError> {
    let engagement = Engagement::new(setup)?;
    let sweep = Sweep::new(&engagement, grid.w())?;
    progress.start("grinding", grid.count() as u64);
    let parts: Vec<(Vec<Shot>, Statistics)> = tiles(grid)
        .par_iter()
        .map_init(
            || (sweep.scratch(), Vec::new()),
            |(scratch, found), tile| {
                let part = engagement.shoot_tile(&sweep, grid, tile, scratch, found);
                progress.advance(tile.len() as u64);
                part
            },
        )
        .collect();
    progress.finish();

    let mut statistics = Statistics { poses: sweep.count() as u64, ..Statistics::default() };
    let mut residue: f64 = 0.0;
    let mut rays = vec![Err(Uncut::NotReached); grid.count()];
    for (shots, part) in parts {
        statistics = statistics + part;
        for shot in shots {
            residue = residue.max(shot.residue);
            rays[shot.index] = shot.ray;
        }
    }
    let error_um = (residue + ROUNDING) * 1e3 + setup.modification.error_um();
    Ok(GroundFlank { grid: grid.clone(), rays, error_um, statistics })
}

/// Ray indices of the tiles that cover the grid.
fn tiles(grid: &RayGrid) -> Vec<Vec<usize>> {
    let (rows, columns) = (grid.w().len(), grid.z().len());
    let mut tiles = Vec::new();
    for i in (0..rows).step_by(TILE) {
        for j in (0..columns).step_by(TILE) {
            let row = |r: usize| (j..(j + TILE).min(columns)).map(move |c| r * columns + c);
            tiles.push((i..(i + TILE).min(rows)).flat_map(row).collect());
        }
    }
    tiles
}

impl Engagement<'_> {
    fn shoot_tile(
        &self,
        sweep: &Sweep,
        grid: &RayGrid,
        tile: &[usize],
        scratch: &mut Scratch,
        found: &mut Vec<Candidate>,
    ) -> (Vec<Shot>, Statistics) {
        let mut statistics = Statistics { rays: tile.len() as u64, ..Statistics::default() };
        let rays: Vec<Ray> = tile
            .iter()
            .map(|&index| {
                let (w, z) = grid.ray(index);
                let frame = self.setup.work.frame(w, z);
                Ray { point: self.setup.work.point_in(&frame, w, z), normal: frame.n, w }
            })
            .collect();
        let centre = rays.iter().map(|ray| ray.point).sum::<Vector3<f64>>() / rays.len() as f64;
        let radius = rays.iter().map(|ray| (ray.point - centre).norm()).fold(0.0, f64::max);
        let dip = |ray: &Ray| sweep.hidden_dip(ray.w, self.base_pitch);
        let reach = self.setup.stock + rays.iter().map(dip).fold(0.0, f64::max);
        sweep.select(self, &centre, radius + reach, rays.len(), scratch, &mut statistics);
        let shots = tile
            .iter()
            .zip(&rays)
            .map(|(&index, ray)| {
                let dip = dip(ray);
                sweep.candidates(self, &ray.point, self.setup.stock + dip, scratch, found);
                let (ray, residue) = self.shorten(ray, sweep, found, dip, &mut statistics.exact);
                Shot { index, ray, residue }
            })
            .collect();
        (shots, statistics)
    }

    /// The least length over all candidates.
    fn shorten(
        &self,
        ray: &Ray,
        sweep: &Sweep,
        candidates: &[Candidate],
        dip: f64,
        exact: &mut u64,
    ) -> (Result<GroundRay, Uncut>, f64) {
        let mut best: Option<(GroundRay, f64)> = None;
        let mut broken: Option<(f64, Uncut)> = None;
        for candidate in candidates {
            if best.is_some_and(|(found, _)| candidate.gap - dip > found.f) {
                continue;
            }
            match self.finish(ray, sweep, candidate, exact) {
                Ok(Some((found, residue))) => {
                    if best.is_none_or(|(other, _)| found.f < other.f) {
                        best = Some((found, residue));
                    }
                }
                // The ray passes the worm sideways in this pose: no hit.
                Ok(None) => {}
                Err(reason) => {
                    if broken.is_none_or(|(gap, _)| candidate.gap < gap) {
                        broken = Some((candidate.gap, reason));
                    }
                }
            }
        }
        match (best, broken) {
            // Where a dip breaks off below the best bottom, an edge of tool or stroke decides what is left.
            (Some((found, _)), Some((gap, reason))) if gap < found.f => (Err(reason), 0.0),
            (Some((found, _)), _) if found.f.abs() > self.setup.stock => (Err(Uncut::NotReached), 0.0),
            (Some((found, residue)), _) => (Ok(found), residue),
            (None, Some((_, reason))) => (Err(reason), 0.0),
            (None, None) => (Err(Uncut::NotReached), 0.0),
        }
    }

    /// From a candidate of the scan to the length that the mode leaves.
    fn finish(
        &self,
        ray: &Ray,
        sweep: &Sweep,
        candidate: &Candidate,
        exact: &mut u64,
    ) -> Result<Option<(GroundRay, f64)>, Uncut> {
        let start = Vector2::new(candidate.angle, candidate.feed);
        let mut count = 0;
        let mut evaluate = |x: Vector2<f64>, guess: f64| {
            count += 1;
            self.length(ray, x, guess)
        };
        let finished = match evaluate(start, candidate.gap) {
            None => Ok(None),
            Some(first) => self
                .deepest(start, sweep, first.lam, &mut evaluate)
                .ok_or(Uncut::NotConverged)
                .and_then(|bottom| self.judged(&bottom).map(|()| bottom))
                .and_then(|bottom| {
                    let threads = self.threads.as_ref().map(|rule| (rule, self.thread(ray, &bottom)));
                    if threads.is_some_and(|(rule, first)| !rule.ever_cuts(first)) {
                        return Err(Uncut::NoActiveThread);
                    }
                    match self.setup.mode {
                        GrindingMode::Continuous => {
                            Ok(Some((ground(bottom.x, &bottom.sample), bottom.residue)))
                        }
                        GrindingMode::FeedMarks { feed_per_revolution, start } => {
                            let cuts = |turn: f64| threads.is_none_or(|(rule, first)| rule.cuts(first, turn));
                            self.least_pass(&bottom, feed_per_revolution, start, cuts, &mut evaluate)
                                .map(Some)
                        }
                    }
                }),
        };
        *exact += count;
        finished
    }

    /// The bottom below a start; beside a crease of the worm the deepest of those that lie side by side.
    fn deepest(
        &self,
        start: Vector2<f64>,
        sweep: &Sweep,
        guess: f64,
        evaluate: &mut impl FnMut(Vector2<f64>, f64) -> Option<Length>,
    ) -> Option<Bottom<Length>> {
        let scale = Vector2::from(sweep.step);
        let mut best = descend(start, scale, guess, &mut *evaluate);
        let creases = self.setup.modification.creases();
        let roll = best.as_ref().map(|bottom| bottom.sample.foot[0]);
        if !creases.iter().any(|crease| roll.is_none_or(|roll| (roll - crease).abs() < BESIDE_CREASE)) {
            return best;
        }
        let from = best.as_ref().map_or(start, |bottom| bottom.x);
        for stride in CREASE_STRIDES {
            // A turn of the workpiece moves the foot along the path of contact by about its base radius.
            let turned = from + Vector2::new(stride / self.setup.work.base_radius, 0.0);
            let other = descend(turned, scale, guess, &mut *evaluate);
            let deeper = |bottom: &Bottom<Length>| {
                self.judged(bottom).is_ok()
                    && best.as_ref().is_none_or(|best| bottom.sample.lam < best.sample.lam)
            };
            if other.as_ref().is_some_and(deeper) {
                best = other;
            }
        }
        best
    }

    /// The thread on which a bottom lies when phi_2 is the bottom's own angle, no whole turns added.
    fn thread(&self, ray: &Ray, bottom: &Bottom<Length>) -> i64 {
        let pose = self.pose(bottom.x[0], bottom.x[1]);
        let end = ray.point + ray.normal * bottom.sample.lam;
        self.setup.worm.nearest_space(&(pose.rotation() * end + pose.translation()))
    }

    /// Whether the bottom lies within stroke and worm.
    fn judged(&self, bottom: &Bottom<Length>) -> Result<(), Uncut> {
        let [from, to] = self.setup.feed_range;
        if !self.area.covers(bottom.sample.foot[0], bottom.sample.foot[1]) {
            return Err(Uncut::ToolMissing);
        }
        if bottom.x[1] < from || bottom.x[1] > to {
            return Err(Uncut::StrokeTooShort);
        }
        Ok(())
    }

    /// The least length over the turns of a real feed in which a thread cuts. Round the envelope's bottom the length of a
    /// pass grows with its distance from there, so that the search goes outwards on both sides until it grows.
    fn least_pass(
        &self,
        bottom: &Bottom<Length>,
        feed: f64,
        start: f64,
        cuts: impl Fn(f64) -> bool,
        evaluate: &mut impl FnMut(Vector2<f64>, f64) -> Option<Length>,
    ) -> Result<(GroundRay, f64), Uncut> {
        let per_angle = feed / (2.0 * std::f64::consts::PI);
        let direction = Vector2::new(1.0, per_angle);
        let h = &bottom.hessian;
        let curvature = direction.dot(&(h * direction));
        let mut pass = |turn: f64| -> Result<(GroundRay, f64), Uncut> {
            // Feed by which this pass misses the bottom at the bottom's angle, and the angle it should be met at instead.
            let missed = start + feed * turn + per_angle * bottom.x[0] - bottom.x[1];
            let turned = -(h[(0, 1)] + per_angle * h[(1, 1)]) * missed / curvature;
            let origin = bottom.x + Vector2::new(0.0, missed) + direction * turned;
            let (x, sample, residue) =
                descend_along(origin, direction, curvature, bottom.sample.lam, &mut *evaluate)
                    .ok_or(Uncut::NotConverged)?;
            let [from, to] = self.setup.feed_range;
            if x[1] < from || x[1] > to {
                return Err(Uncut::StrokeTooShort);
            }
            if !self.area.covers(sample.foot[0], sample.foot[1]) {
                return Err(Uncut::ToolMissing);
            }
            Ok((ground(x, &sample), residue))
        };
        // Some turn among as many as there are threads cuts, or the bottom would have been given up before.
        let period = self.threads.as_ref().map_or(1, ThreadRule::period);
        let next = |turn: f64, side: f64| (0..period).map(|k| turn + side * k as f64).find(|&k| cuts(k));
        let middle = (bottom.x[1] - start - per_angle * bottom.x[0]) / feed;
        let nearest = [-1.0, 1.0]
            .into_iter()
            .filter_map(|side| next(middle.round(), side))
            .min_by(|a, b| (a - middle).abs().total_cmp(&(b - middle).abs()))
            .ok_or(Uncut::NoActiveThread)?;
        let mut best = pass(nearest);
        for side in [-1.0, 1.0] {
            let mut last = best;
            let mut turn = nearest;
            // Passes that are not there (end of stroke, end of worm) leave the field to the others.
            while let Some(after) = next(turn + side, side) {
                turn = after;
                let Ok(found) = pass(turn) else { break };
                if last.is_ok_and(|(other, _)| found.0.f >= other.f) {
                    break;
                }
                if best.is_ok_and(|(other, _): (GroundRay, f64)| found.0.f < other.f) || best.is_err() {
                    best = Ok(found);
                }
                last = Ok(found);
            }
        }
        best
    }
}

fn ground(x: Vector2<f64>, sample: &Length) -> GroundRay {
    GroundRay {
        f: sample.lam,
        feed: x[1],
        work_angle: x[0],
        worm_roll: sample.foot[0],
        worm_z: sample.foot[1],
    }
}
