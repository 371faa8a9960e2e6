//! The lines in what a text does: wherever the tip of the disc moves along the written flank, and which line of the job that is. A line
//! is identified by where the disc touches the worm, never by its place in the text.

use super::touch::{Touch, counter_gap, touch_written};
use super::work::LineWork;
use crate::workflow::programs::cylinders::CLEARANCE;
use crate::workflow::programs::indexing::Indexing;
use crate::workflow::programs::technology::Technology;
use foundation::kinematics::{DressingPath, MotionLaw};
use foundation::numerics::extremes;
use machine::Machine;
use motion::{DressingPlace, MotionError, Tracked, Waypoint};
use rayon::prelude::*;
use verdict::Remark;

/// A line as a text drives it.
#[derive(Clone, Debug)]
pub struct TextLine {
    /// Thread of the worm, from 0.
    pub thread: u32,
    /// Line of the job, from 0.
    pub line: usize,
    /// First and last block, from 1.
    pub blocks: [usize; 2],
    /// Time, s.
    pub duration: f64,
    /// Worm positions v_zS from where to where, mm.
    pub shifts: [f64; 2],
    /// Least and largest height over the line of the job, mm.
    pub height: [f64; 2],
    /// Largest distance across the lines, mm.
    pub across: f64,
    /// How much of the line of the job it leaves out at its ends, mm.
    pub short: f64,
    /// The motion, brought back to thread 0.
    pub path: DressingPath,
}

/// What a text does with the disc.
#[derive(Clone, Debug)]
pub struct FoundLines {
    /// Lines in the order of the text.
    pub lines: Vec<TextLine>,
    /// What moves on the flank along no line, and where the disc is not clear of the worm beside its lines.
    pub faults: Vec<Remark>,
    /// Least distance of the disc outside the thread space from the worm's tip cylinder, and of its tip inside from the opposite flank,
    /// beside the lines, mm; infinite where there is none.
    pub least: [f64; 2],
}

/// A block moves along a line if it leaves the line by no more than this share of its way and of the pitch of the lines.
const ALONG: [f64; 2] = [0.02, 0.05];
/// A block comes to the flank or leaves it if its height changes by more than this share of its way on the flank.
const OFF_FLANK: f64 = 0.15;
/// Beside its lines the tip may stand below the wanted flank by this, mm: digits, and the closed distance to a modified flank.
const BELOW: f64 = 5e-4;
/// What digits take of the clearance of rapid moves, mm.
const SAMPLED: f64 = 0.05;

/// A run of places on the flank: the numbers of its first and last place in the chain.
type Run = [usize; 2];

/// Follows a text on the bodies of a flank.
pub struct Finder<'a> {
    pub work: LineWork<'a>,
    pub indexing: &'a Indexing,
    pub technology: &'a Technology,
    pub machine: &'a Machine,
}

impl Finder<'_> {
    /// All lines of a text.
    ///
    /// # Errors
    /// [`MotionError::NotFollowed`].
    pub fn find(&self, tracked: &Tracked) -> Result<FoundLines, MotionError> {
        let (bodies, mounts) = (&self.work.written.bodies, &self.technology.dressing);
        let crossing = self.work.written.result.crossing_angle_deg;
        let chains = tracked.dressing_places(self.machine, mounts, crossing)?;
        let rapids = tracked.dressing_rapids(self.machine, mounts, crossing)?;
        let mut found = FoundLines { lines: Vec::new(), faults: Vec::new(), least: [f64::INFINITY; 2] };
        for chain in &chains {
            let touches: Vec<Option<Touch>> = chain
                .par_iter()
                .map(|place| self.inside(place).then(|| touch_written(bodies, &place.at)).flatten())
                .collect();
            let (runs, astray) = self.runs(chain, &touches);
            for [first, last] in astray {
                let (from, to) = (chain[first + 1].block, chain[last].block);
                found.faults.push(Remark::new(
                    "line-astray",
                    format!("blocks {from} to {to}: the disc moves on the flank across the lines"),
                    "lift it off the flank between its lines",
                ));
            }
            let lines: Vec<Result<TextLine, MotionError>> =
                runs.par_iter().map(|run| self.line(chain, &touches, *run)).collect();
            for line in lines {
                found.lines.push(line?);
            }
            self.beside(chain, &touches, &runs, &mut found);
        }
        let mut last = 0;
        for place in rapids {
            let out = self.out(&place);
            found.least[0] = found.least[0].min(out);
            if out < CLEARANCE - SAMPLED && place.block != last {
                last = place.block;
                found.faults.push(Remark::new(
                    "program-not-clear",
                    format!(
                        "block {}: a rapid move brings worm and disc to {out:.3} mm of each other; {CLEARANCE} mm are kept",
                        place.block
                    ),
                    "raise machine.clearance, or lift the disc out of the thread space before the block",
                ));
            }
        }
        Ok(found)
    }

    /// Distance of the disc from the worm's tip cylinder, mm; negative in the thread space.
    fn out(&self, place: &DressingPlace) -> f64 {
        let bodies = &self.work.written.bodies;
        place.at.centre_distance - bodies.disc.outside_radius() - bodies.worm_tip_radius
    }

    fn inside(&self, place: &DressingPlace) -> bool {
        self.out(place) < 0.0
    }

    /// (w, z) as t along the lines and X across them.
    fn along_across(&self, touch: &Touch) -> [f64; 2] {
        let Some(line) = self.work.written.plan.lines.first() else { return [f64::NAN; 2] };
        let (sin, cos) = line.direction.rho.sin_cos();
        [touch.w * cos - touch.z * sin, line.direction.coordinate(touch.w, touch.z)]
    }

    /// Runs along lines, and runs on the flank across them. A chain holds its start, then middle and end of each straight part.
    fn runs(&self, chain: &[DressingPlace], touches: &[Option<Touch>]) -> (Vec<Run>, Vec<Run>) {
        let counted = self.work.counted_below(self.technology);
        let pitch = self.work.written.plan.pitch;
        let threads = i64::from(self.indexing.threads);
        let (mut runs, mut astray): (Vec<Run>, Vec<Run>) = (Vec::new(), Vec::new());
        for first in (0..chain.len().saturating_sub(2)).step_by(2) {
            let last = first + 2;
            let (Some(a), Some(b)) = (&touches[first], &touches[last]) else { continue };
            if a.gap > counted || b.gap > counted {
                continue;
            }
            let ([t_a, x_a], [t_b, x_b]) = (self.along_across(a), self.along_across(b));
            let (along, across) = ((t_b - t_a).abs(), (x_b - x_a).abs());
            if (b.gap - a.gap).abs() > OFF_FLANK * along.hypot(across) {
                continue;
            }
            let on_line =
                across <= ALONG[0] * along + ALONG[1] * pitch && (a.space - b.space).rem_euclid(threads) == 0;
            let list = if on_line { &mut runs } else { &mut astray };
            match list.last_mut() {
                // A line that turns back is another one.
                Some(run) if run[1] == first && (!on_line || self.goes_on(touches, *run, t_b - t_a)) => {
                    run[1] = last;
                }
                _ => list.push([first, last]),
            }
        }
        (runs, astray)
    }

    /// Whether a run goes on in the same sense with a part that changes t by `step`.
    fn goes_on(&self, touches: &[Option<Touch>], [first, last]: Run, step: f64) -> bool {
        let (Some(a), Some(b)) = (&touches[first], &touches[last]) else { return false };
        (self.along_across(b)[0] - self.along_across(a)[0]) * step >= 0.0
    }

    /// The line of the job nearest to a run, and how the run drives it.
    fn line(
        &self,
        chain: &[DressingPlace],
        touches: &[Option<Touch>],
        [first, last]: Run,
    ) -> Result<TextLine, MotionError> {
        let written = self.work.written;
        let not_followed = || MotionError::NotFollowed {
            block: chain[last].block,
            reason: "the disc touches the worm where no line of the job is near".into(),
        };
        let threads = self.indexing.threads;
        // Of the nearest lines that whose disc touches the worm nearest to the middle of the run.
        let middle = first + 2 * ((last - first) / 4);
        let at_middle = touches[middle].ok_or_else(not_followed)?;
        let [t, x] = self.along_across(&at_middle);
        let lines = &written.plan.lines;
        let behind = lines.partition_point(|line| line.coordinate < x);
        let mut best: Option<(f64, usize, u32)> = None;
        for line in behind.saturating_sub(2)..(behind + 2).min(lines.len()) {
            let course = self.work.course(line, (0, threads), 0.0, self.technology)?;
            let own = course.position(&Waypoint { v: t, ..Waypoint::default() });
            let Some(own) = touch_written(&written.bodies, &own) else { continue };
            let apart = (self.along_across(&own)[1] - x).abs();
            let thread = (at_middle.space - own.space).rem_euclid(i64::from(threads)) as u32;
            if best.is_none_or(|(known, _, _)| apart < known) {
                best = Some((apart, line, thread));
            }
        }
        let (_, line, thread) = best.ok_or_else(not_followed)?;
        let course = self.work.course(line, (thread, threads), 0.0, self.technology)?;
        let mut heights = [f64::INFINITY, f64::NEG_INFINITY];
        let mut reached = [f64::INFINITY, f64::NEG_INFINITY];
        let mut across: f64 = 0.0;
        for k in first..=last {
            let touch = touches[k].ok_or_else(not_followed)?;
            let [t, x] = self.along_across(&touch);
            let beside = course.beside(&chain[k].at, &Waypoint { v: t, ..Waypoint::default() });
            heights = [heights[0].min(beside.height), heights[1].max(beside.height)];
            reached = [reached[0].min(beside.t), reached[1].max(beside.t)];
            // Ends of blocks lie on the line; between them straight blocks also lie aside.
            let own = course.position(&Waypoint { v: beside.t, ..Waypoint::default() });
            let own = touch_written(&written.bodies, &own).ok_or_else(not_followed)?;
            across = across.max((x - self.along_across(&own)[1]).abs());
        }
        let [from, to] = course.path.domain;
        Ok(TextLine {
            thread,
            line,
            blocks: [chain[first + 1].block, chain[last].block],
            duration: chain[first + 1..=last].iter().map(|place| place.duration).sum(),
            shifts: extremes(chain[first..=last].iter().map(|place| place.at.worm_shift)),
            height: heights,
            across,
            short: (reached[0] - from).max(to - reached[1]).max(0.0),
            path: self.path(&chain[first..=last], thread)?,
        })
    }

    /// The motion of a run over its own way, brought back to thread 0.
    fn path(&self, places: &[DressingPlace], thread: u32) -> Result<DressingPath, MotionError> {
        let reach = self.work.written.bodies.worm_pitch_radius;
        let back = std::f64::consts::TAU / f64::from(self.indexing.threads) * f64::from(thread);
        let ends: Vec<&DressingPlace> = places.iter().step_by(2).collect();
        let mut way = vec![0.0];
        for pair in ends.windows(2) {
            let (a, b) = (&pair[0].at, &pair[1].at);
            let step = (reach * (b.worm_angle - a.worm_angle))
                .hypot(b.worm_shift - a.worm_shift)
                .hypot(b.centre_distance - a.centre_distance);
            way.push(way[way.len() - 1] + step);
        }
        let law = |of: &dyn Fn(&DressingPlace) -> f64| -> Result<MotionLaw, MotionError> {
            let values: Vec<f64> = ends.iter().map(|place| of(place)).collect();
            match (way.as_slice(), values.as_slice()) {
                ([from, to], [a, b]) if to > from => {
                    Ok(MotionLaw::polynomial(*from, vec![*a, (b - a) / (to - from)]))
                }
                _ => MotionLaw::rounded_corners(&way, &values).map_err(|error| MotionError::NotFollowed {
                    block: places[0].block,
                    reason: error.to_string(),
                }),
            }
        };
        let mean = |of: &dyn Fn(&DressingPlace) -> f64| {
            ends.iter().map(|place| of(place)).sum::<f64>() / ends.len() as f64
        };
        Ok(DressingPath {
            domain: [0.0, way[way.len() - 1]],
            worm_angle: law(&|place| place.at.worm_angle + back)?,
            worm_shift: law(&|place| place.at.worm_shift)?,
            centre_distance: law(&|place| place.at.centre_distance)?,
            crossing_angle: mean(&|place| place.at.crossing_angle),
            offset: mean(&|place| place.at.offset),
        })
    }

    /// Looks at all places that lie on no line: the tip of the disc against both flanks of the thread space, or the disc outside of it.
    fn beside(
        &self,
        chain: &[DressingPlace],
        touches: &[Option<Touch>],
        runs: &[Run],
        found: &mut FoundLines,
    ) {
        let bodies = &self.work.written.bodies;
        let mut on_line = vec![false; chain.len()];
        for &[first, last] in runs {
            on_line[first..=last].fill(true);
        }
        let gaps: Vec<Option<[f64; 2]>> = chain
            .par_iter()
            .enumerate()
            .map(|(k, place)| {
                let looked_at = !on_line[k] && self.inside(place);
                // A tip that faces no point of a flank cannot be said to be clear of it.
                let own = || touches[k].map_or(f64::NEG_INFINITY, |touch| touch.gap);
                let counter = || counter_gap(bodies, &place.at).unwrap_or(f64::NEG_INFINITY);
                looked_at.then(|| [own(), counter()])
            })
            .collect();
        let mut last = 0;
        for (k, place) in chain.iter().enumerate() {
            let Some([own, counter]) = gaps[k] else {
                if !on_line[k] {
                    found.least[0] = found.least[0].min(self.out(place));
                }
                continue;
            };
            found.least[1] = found.least[1].min(counter);
            let into = if own < -BELOW {
                Some((own, "flank that it dresses"))
            } else if counter < 0.0 {
                Some((counter, "opposite flank"))
            } else {
                None
            };
            if let Some((gap, body)) = into.filter(|_| place.block != last) {
                last = place.block;
                let depth = if gap.is_finite() { format!("{:.4} mm deep ", -gap) } else { String::new() };
                found.faults.push(Remark::new(
                    "program-not-clear",
                    format!("block {}: beside its lines the disc goes {depth}into the {body}", place.block),
                    "lift the disc off the flank, or out of the thread space, before the block",
                ));
            }
        }
    }
}
