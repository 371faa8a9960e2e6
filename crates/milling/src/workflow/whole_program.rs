//! A program against the whole part: every block of its text, rapid moves included, on every surface of every space; rapid moves
//! against the stock that stands at their time; feeds and spindle against the job.

use super::clamping::Clamping;
use super::part_rays::{Closeness, PartRay, PartSurface, THIN_BACKS, has_thin_backs, part_rays, spacing};
use super::prepare::{MillingBodies, Mounting, PreparedMilling};
use super::programs::{FollowedMove, MillingWork, OBLIQUE};
use super::referee::{STOCK, mill_paths, swept};
use super::whole_part::{FaultKind, PartFault, WholePart, allowed};
use crate::MillingPlan;
use foundation::numerics::Progress;
use nalgebra::Vector3;
use referee::{MillPath, MilledRay, Milling, Rapids, Swept, mill, rapid_hits};
use run::RunFailure;
use run::program_check::{PartProof, ProgramFault};
use std::f64::consts::PI;

/// A text with all that it is held against.
pub(super) struct ProgramUnderTest<'a> {
    pub bodies: &'a MillingBodies,
    pub plan: &'a MillingPlan,
    pub work: &'a MillingWork<'a>,
    pub moves: &'a [FollowedMove],
    /// The same made ready for rays, each a path of its own; see [`swept`].
    pub swept: &'a Swept<'a>,
    /// From the nose of the spindle to the tip of the longest tool, mm.
    pub tool_length: f64,
    /// Tolerance of the job with what its text may add, mm; see [`text_tolerance`].
    pub tolerance: f64,
    /// What holds the workpiece.
    pub clamping: Clamping<'a>,
}

/// A flank from a text may be off by the tolerance of the job and by what straight blocks and digits may add, mm.
pub(super) fn text_tolerance(prepared: &PreparedMilling, mounting: &Mounting) -> f64 {
    1e-3 * (prepared.tolerance_um + OBLIQUE * mounting.position_tolerance_um + DIGITS_UM)
}

/// What four decimals of positions and angles move a cutter by, um.
const DIGITS_UM: f64 = 0.3;

/// Distance of places on rapid moves and of points of the tool, mm.
const RAPID_STEP: f64 = 2.0;
/// How exactly a ray is cut, mm: the search proves 1e-7 um, coordinates of the text have four decimals.
const DEPTH_RESOLUTION: f64 = 1e-4;
/// A rapid move that shortens a ray by less than this takes nothing, mm.
const TAKEN: f64 = 1e-3;
/// How far the tip may be faster than the feed of the job on a straight cut, and on one on which the cutter turns: it is the contact that
/// keeps the feed.
const FASTER: [f64; 2] = [1.5, 3.0];
/// A cut slower than this share of the feed, with no axis near its limit, has a feed of another unit.
const SLOWER: f64 = 0.2;
/// Moves shorter than this have no direction, mm.
const NO_WAY: f64 = 1e-3;
/// Turn of the axis below which a move is straight, rad.
const STRAIGHT: f64 = 1e-6;
/// Places on a move, and on the axis of a cutter, at which it is looked for the blank.
const QUARTERS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
/// Share by which a spindle may turn at another speed.
const SPINDLE: f64 = 0.01;

impl ProgramUnderTest<'_> {
    /// The proof.
    ///
    /// # Errors
    /// [`RunFailure`] for motions that the referee cannot follow.
    pub fn prove(&self, progress: &dyn Progress) -> Result<PartProof, RunFailure> {
        let rays = self.rays(progress)?;
        let whole = WholePart::of(self.swept, &rays, self.tolerance, progress)?;
        let mut faults: Vec<ProgramFault> = whole.faults.iter().map(|fault| self.part_fault(fault)).collect();
        faults.extend(self.rapid_cuts(&rays, &whole, progress)?);
        faults.extend(self.rapid_collisions(progress)?);
        let beside = self.clamping.beside(self.work, self.moves);
        faults.extend(beside.faults);
        faults.extend(self.feeds());
        faults.extend(self.spindles());
        faults.extend(self.coolant());
        // One fault of a block says enough of it.
        let mut known: Vec<(&'static str, usize, Option<usize>)> = Vec::new();
        faults.retain(|fault| {
            let key = (fault.code, fault.block, fault.space);
            let new = !known.contains(&key);
            known.push(key);
            new || fault.surface.is_some()
        });
        let surfaces: Vec<String> =
            whole.surfaces.iter().map(|figures| figures.surface.name(self.bodies)).collect();
        let spaces = [self.bodies.spaces, self.bodies.milled];
        let not_covered = self.not_covered();
        let ray_spacing_mm = spacing(self.bodies, self.plan);
        let rapid_moves = self.moves.iter().filter(|made| made.rapid).count();
        let statement = format!(
            "all {} spaces ({} of them milled): {} under {} rays, {ray_spacing_mm:.2} mm apart at most, depth to \
             {DEPTH_RESOLUTION} mm; {rapid_moves} rapid moves of tool, shank and holder against the stock that stands, every \
             {RAPID_STEP} mm; {}not covered: {}",
            spaces[0],
            spaces[1],
            surfaces.join(", "),
            rays.len(),
            self.clamping.statement(&beside.least),
            not_covered.join(", ")
        );
        Ok(PartProof {
            statement,
            spaces,
            surfaces,
            rays: rays.len(),
            ray_spacing_mm,
            depth_resolution_mm: DEPTH_RESOLUTION,
            rapid_moves,
            rapid_resolution_mm: RAPID_STEP,
            clamping_kept_mm: (!beside.least.is_empty()).then_some(self.clamping.kept),
            clamping: beside.least,
            not_covered,
            faults,
        })
    }

    /// Rays on the whole part. On the drawn root, for which the job gives no limit, a text may leave what the job's own paths leave, and
    /// the tolerance.
    fn rays(&self, progress: &dyn Progress) -> Result<Vec<PartRay>, RunFailure> {
        let mut rays = part_rays(self.bodies, self.plan, Closeness::Rows, self.tolerance)?;
        let each = rays.len() / self.bodies.spaces.max(1);
        let drawn: Vec<usize> =
            (0..each).filter(|&k| matches!(rays[k].surface, PartSurface::Drawn(_))).collect();
        if drawn.is_empty() {
            return Ok(rays);
        }
        let (cutters, paths) = mill_paths(self.bodies, self.plan);
        let own = swept(&cutters, &paths, STOCK)?;
        let normals: Vec<_> = drawn.iter().map(|&k| rays[k].ray).collect();
        let left =
            own.mill(&normals, progress).map_err(|error| RunFailure::of_removal(&error, "milling"))?.rays;
        for space in 0..self.bodies.milled {
            for (&k, left) in drawn.iter().zip(&left) {
                let most = left.ok().map(|ray| ray.length.max(0.0) + self.tolerance);
                rays[space * each + k].stock = most;
            }
        }
        Ok(rays)
    }

    fn not_covered(&self) -> Vec<String> {
        let mut left = vec![
            "the first positioning of each tool, which comes from outside".to_owned(),
            self.clamping.not_covered().to_owned(),
        ];
        if self.bodies.unknown.iter().any(|remark| remark.code == "blade-back-not-judged") {
            left.push("backs of the blades".into());
        }
        if has_thin_backs(self.bodies) {
            left.push(THIN_BACKS.into());
        }
        left
    }

    fn part_fault(&self, fault: &PartFault) -> ProgramFault {
        let place = Vector3::from(fault.place);
        let number = fault.by.map_or_else(|| self.nearest(&place), |[path, _]| path);
        let (block, rapid) = (self.moves[number].block, self.moves[number].rapid);
        let by = format!("block {block}{}", if rapid { ", a rapid move," } else { "" });
        let gouge = fault.kind == FaultKind::Gouge;
        let words = fault.words(self.bodies, &by);
        let text = if gouge { words } else { format!("{words}; the nearest block is {block}") };
        ProgramFault {
            code: if gouge && rapid { "rapid-collision" } else { fault.code() },
            text,
            way_out: "compare the block with those of the other spaces, and write the program anew from the job",
            block,
            space: Some(fault.space + 1),
            surface: Some(fault.surface.name(self.bodies)),
            place_mm: fault.place,
            amount_mm: Some(fault.amount),
        }
    }

    /// The move that comes nearest to a place with its tip.
    fn nearest(&self, place: &Vector3<f64>) -> usize {
        let distance = |made: &FollowedMove| {
            made.places.iter().map(|at| (at.tip - place).norm_squared()).fold(f64::INFINITY, f64::min)
        };
        let of = self.moves.iter().enumerate().map(|(k, made)| (k, distance(made)));
        of.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(k, _)| k)
    }

    /// Rapid moves that shorten a ray which no move before or behind them shortens as far.
    fn rapid_cuts(
        &self,
        rays: &[PartRay],
        whole: &WholePart,
        progress: &dyn Progress,
    ) -> Result<Vec<ProgramFault>, RunFailure> {
        let set = rays.iter().zip(&whole.milled).filter_map(|(at, found)| {
            let MilledRay { length, path, .. } = found.ok()?;
            // What is too deep is told already.
            let told = length < -allowed(at.surface, self.tolerance);
            (self.moves[path].rapid && !told).then_some((at, length, path))
        });
        let set: Vec<(&PartRay, f64, usize)> = set.collect();
        if set.is_empty() {
            return Ok(Vec::new());
        }
        let setup = self.swept.setup();
        let slow: Vec<MillPath> = setup
            .paths
            .iter()
            .zip(self.moves)
            .filter(|(_, made)| !made.rapid)
            .map(|(path, _)| path.clone())
            .collect();
        let normals: Vec<_> = set.iter().map(|(at, ..)| at.ray).collect();
        let without = mill(&Milling { paths: &slow, ..*setup }, &normals, progress)
            .map_err(|error| RunFailure::of_removal(&error, "milling"))?;
        let mut faults: Vec<ProgramFault> = Vec::new();
        for ((at, length, path), without) in set.into_iter().zip(without.rays) {
            let taken = without.map_or(setup.stock, |ray| ray.length) - length;
            let block = self.moves[path].block;
            let point = at.ray.point + at.ray.normal * length;
            let in_stock = taken > TAKEN && in_blank(&self.bodies.blank, &point);
            if !in_stock || faults.iter().any(|known| known.block == block) {
                continue;
            }
            let name = at.surface.name(self.bodies);
            faults.push(self.collision(block, point, Some((at.space + 1, name))));
        }
        Ok(faults)
    }

    fn collision(&self, block: usize, place: Vector3<f64>, on: Option<(usize, String)>) -> ProgramFault {
        let [x, y, z] = place.into();
        let space = on.as_ref().map_or_else(|| self.space_at(&place), |(space, _)| *space);
        let beside = on.as_ref().map_or_else(String::new, |(_, name)| format!(", {name}"));
        ProgramFault {
            code: "rapid-collision",
            text: format!(
                "space {space}{beside}, at ({x:.3}, {y:.3}, {z:.3}) mm: the rapid move of block {block} meets stock that stands there"
            ),
            way_out: "draw the tool back out of the blank before the rapid move",
            block,
            space: Some(space),
            surface: None,
            place_mm: place.into(),
            amount_mm: None,
        }
    }

    /// The space next to a place, from 1.
    fn space_at(&self, place: &Vector3<f64>) -> usize {
        let angle = place.y.atan2(place.x) - 0.5 * PI;
        let number = (angle / self.bodies.pitch).round() as i64;
        number.rem_euclid(self.bodies.spaces.max(1) as i64) as usize + 1
    }

    fn rapid_collisions(&self, progress: &dyn Progress) -> Result<Vec<ProgramFault>, RunFailure> {
        let rapid: Vec<bool> = self.moves.iter().map(|made| made.rapid).collect();
        let body = |point: &Vector3<f64>| in_blank(&self.bodies.blank, point);
        let rapids = Rapids {
            swept: self.swept,
            rapid: &rapid,
            body: &body,
            reach: self.tool_length,
            step: RAPID_STEP,
        };
        let hits =
            rapid_hits(&rapids, progress).map_err(|error| RunFailure::of_removal(&error, "milling"))?;
        Ok(hits.into_iter().map(|hit| self.collision(self.moves[hit.path].block, hit.place, None)).collect())
    }

    /// Cuts faster than the job allows, or so slow that their feed has another unit: the first of each tool and kind.
    fn feeds(&self) -> Vec<ProgramFault> {
        let mut faults: Vec<ProgramFault> = Vec::new();
        for made in &self.moves[1.min(self.moves.len())..] {
            let Some(seconds) = made.seconds.filter(|seconds| *seconds > 0.0) else { continue };
            let way: f64 = made.places.windows(2).map(|pair| (pair[1].tip - pair[0].tip).norm()).sum();
            let (Some(first), Some(last)) = (made.places.first(), made.places.last()) else { continue };
            if way < NO_WAY || !self.cuts(made) {
                continue;
            }
            let along = (last.tip - first.tip).dot(&last.axis) / way;
            let turn = first.axis.cross(&last.axis).norm();
            // Out of the workpiece along its own axis a cutter may go as fast as the axes do.
            if along > 1.0 - STRAIGHT && turn < STRAIGHT {
                continue;
            }
            let tools = self.work.tools.iter().map(|tool| &tool.tool).filter(|tool| tool.number == made.tool);
            let feeds = tools.flat_map(|tool| [tool.feed, tool.plunge_feed]);
            let [least, most] =
                feeds.fold([f64::INFINITY, 0.0f64], |[low, high], feed| [low.min(feed), high.max(feed)]);
            let feed = 60.0 * way / seconds;
            let faster = FASTER[usize::from(turn >= STRAIGHT)];
            let code = if feed > most * faster {
                "feed-too-fast"
            } else if turn < STRAIGHT && feed < least * SLOWER {
                "feed-too-slow"
            } else {
                continue;
            };
            if faults.iter().filter(|known| known.code == code).count() >= MOST_OF_A_KIND {
                continue;
            }
            let [x, y, z] = last.tip.into();
            faults.push(ProgramFault {
                code,
                text: format!(
                    "space {}, at ({x:.3}, {y:.3}, {z:.3}) mm: block {} cuts at {feed:.4} mm/min; the job's feeds for tool {} are {least} \
                     to {most} mm/min",
                    self.space_at(&last.tip),
                    made.block,
                    made.tool
                ),
                way_out: "give the feed in mm/min, or as the time of the block where axes turn",
                block: made.block,
                space: Some(self.space_at(&last.tip)),
                surface: None,
                place_mm: last.tip.into(),
                amount_mm: None,
            });
        }
        faults
    }

    /// Whether the axis of the cutter, up to the end of its edges, comes into the blank on a move.
    fn cuts(&self, made: &FollowedMove) -> bool {
        let cutter = &self.work.tools[self.work.tool(made.tool)].cutter;
        let heights = QUARTERS.map(|share| share * cutter.cutting_length());
        let within = |tip: Vector3<f64>, axis: Vector3<f64>| {
            heights.iter().any(|height| in_blank(&self.bodies.blank, &(tip + axis * *height)))
        };
        made.places.windows(2).any(|ends| {
            QUARTERS.into_iter().any(|share| {
                let at = |from: &Vector3<f64>, to: &Vector3<f64>| from.lerp(to, share);
                within(at(&ends[0].tip, &ends[1].tip), at(&ends[0].axis, &ends[1].axis))
            })
        })
    }

    /// Cuts without the coolant that the job wants, or with more: the first of every tool.
    fn coolant(&self) -> Vec<ProgramFault> {
        let mut faults: Vec<ProgramFault> = Vec::new();
        let mut known: Vec<u32> = Vec::new();
        for made in self.moves.iter().filter(|made| !made.rapid) {
            let wanted = self.work.tools[self.work.tool(made.tool)].tool.coolant.supplies();
            if made.coolant == wanted || known.contains(&made.tool) || !self.cuts(made) {
                continue;
            }
            known.push(made.tool);
            let place = made.places.last().map_or_else(Vector3::zeros, |at| at.tip);
            let [x, y, z] = place.into();
            faults.push(ProgramFault {
                code: "coolant",
                text: format!(
                    "space {}, at ({x:.3}, {y:.3}, {z:.3}) mm: block {} cuts with tool {} and of the coolant supplies with {}; the job \
                     wants {}",
                    self.space_at(&place),
                    made.block,
                    made.tool,
                    supplies(made.coolant),
                    supplies(wanted)
                ),
                way_out: "switch the coolant of the job on with M8 or M7 before the tool cuts, or off with M9",
                block: made.block,
                space: Some(self.space_at(&place)),
                surface: None,
                place_mm: place.into(),
                amount_mm: None,
            });
        }
        faults
    }

    /// Cuts with a spindle that does not turn as the job says: the first of every tool.
    fn spindles(&self) -> Vec<ProgramFault> {
        let mut faults: Vec<ProgramFault> = Vec::new();
        let mut known: Vec<u32> = Vec::new();
        for made in self.moves.iter().filter(|made| !made.rapid) {
            let turns = made.spindle.unwrap_or(0.0) * 30.0 / PI;
            let wanted = self.work.tools[self.work.tool(made.tool)].tool.spindle_rpm;
            let right = (turns - wanted).abs() <= SPINDLE * wanted;
            if right || known.contains(&made.tool) || !self.cuts(made) {
                continue;
            }
            known.push(made.tool);
            let place = made.places.last().map_or_else(Vector3::zeros, |at| at.tip);
            let [x, y, z] = place.into();
            faults.push(ProgramFault {
                code: "spindle-speed",
                text: format!(
                    "space {}, at ({x:.3}, {y:.3}, {z:.3}) mm: block {} cuts with tool {} at {turns:.1} 1/min; the job says {wanted} 1/min",
                    self.space_at(&place),
                    made.block,
                    made.tool
                ),
                way_out: "switch the spindle on clockwise at the speed of the job before the tool cuts",
                block: made.block,
                space: Some(self.space_at(&place)),
                surface: None,
                place_mm: place.into(),
                amount_mm: None,
            });
        }
        faults
    }
}

/// Supplies of coolant in words.
fn supplies([flood, mist]: [bool; 2]) -> &'static str {
    match (flood, mist) {
        (false, false) => "none",
        (true, false) => "the first (M8)",
        (false, true) => "the second (M7)",
        (true, true) => "both (M7, M8)",
    }
}

/// Feeds of the same kind that are listed one by one.
const MOST_OF_A_KIND: usize = 20;

/// Whether a place lies in a body of revolution with this section: a closed polygon of radius and position.
fn in_blank(section: &[[f64; 2]; 4], point: &Vector3<f64>) -> bool {
    let (radius, position) = (point.xy().norm(), point.z);
    let mut inside = false;
    for k in 0..section.len() {
        let ([r1, z1], [r2, z2]) = (section[k], section[(k + 1) % section.len()]);
        if (z1 > position) != (z2 > position) && radius < r1 + (position - z1) / (z2 - z1) * (r2 - r1) {
            inside = !inside;
        }
    }
    inside
}
