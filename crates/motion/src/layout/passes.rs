//! Writes pass after pass into blocks and into the trace.

use super::gear::{GearBlocks, couple};
use super::{Coupling, Layout, LayoutOptions, Pass, PassReport, STANDS_STILL};
use crate::path::AxisPath;
use crate::speed::PathLimits;
use crate::trace::AxisTrace;
use crate::{AxisWords, Course, MotionError, Waypoint};
use machine::{Machine, Positions, Role, Station};
use nc::{Block, Header, Program, Word};

mod lines;

/// The program so far.
pub(super) struct Writer<'a> {
    machine: &'a Machine,
    words: &'a AxisWords,
    options: &'a LayoutOptions,
    blocks: Vec<Block>,
    trace: AxisTrace,
    /// Where all axes stand, once they have been positioned.
    standing: Option<Positions>,
    reports: Vec<PassReport>,
    tables: u32,
    at_rest: Vec<(usize, f64)>,
}

/// The three paths of a pass, from rest off the tool to rest off the tool.
struct Stroke {
    infeed: AxisPath,
    stroke: AxisPath,
    retraction: AxisPath,
    limits: PathLimits,
    /// Greatest speed of infeed and retraction, mm/s.
    infeed_speed: f64,
}

/// A way shorter than this is none, mm.
const LEAST_WAY: f64 = 1e-6;
/// Speed at which the tool comes in and goes out where no axis limits it, mm/s.
const INFEED_SPEED: f64 = 1e3;

impl<'a> Writer<'a> {
    pub fn new(
        machine: &'a Machine,
        words: &'a AxisWords,
        options: &'a LayoutOptions,
    ) -> Result<Self, MotionError> {
        if !(options.tolerance.is_finite() && options.tolerance > 0.0) {
            let (field, value, allowed) = ("chord tolerance", options.tolerance, "above 0 mm");
            return Err(MotionError::InvalidNumber { field, value, allowed });
        }
        let mut blocks: Vec<Block> = options.comments.iter().map(|text| comment(text)).collect();
        if options.dresser_speed != 0.0
            && let Some(spindle) = spindle_of(machine, words, Role::Dresser)
        {
            blocks.push(Block::Spindle { spindle, speed: options.dresser_speed });
        }
        Ok(Self {
            machine,
            words,
            options,
            blocks,
            trace: AxisTrace::default(),
            standing: None,
            reports: Vec::new(),
            tables: 0,
            at_rest: Vec::new(),
        })
    }

    /// One pass.
    pub fn pass(&mut self, pass: &Pass) -> Result<(), MotionError> {
        let stroke = self.stroke(pass)?;
        let paths = [&stroke.infeed, &stroke.stroke, &stroke.retraction];
        self.check_words(pass.course.station(), &paths)?;
        let gear = match &self.options.coupling {
            Coupling::Gearbox(gear) if pass.course.station() == Station::Work => {
                let paths = [&stroke.infeed, &stroke.stroke, &stroke.retraction];
                Some(couple(self.machine, self.words, gear, pass, paths, self.options, &mut self.tables)?)
            }
            _ => None,
        };
        if let Some(GearBlocks { table: Some(table), .. }) = &gear {
            self.blocks.push(Block::Table(Box::new(table.clone())));
        }
        let begun = self.trace.duration();
        self.blocks.push(comment(&pass.name));
        self.drive(pass, &stroke, gear.as_ref())?;
        if pass.dwell > 0.0 {
            self.blocks.push(Block::Dwell(pass.dwell));
            self.trace.stand(pass.dwell);
        }
        let time = self.trace.duration() - begun;
        let nodes = &stroke.stroke.nodes;
        let driven = [nodes.first(), nodes.last()].map(|node| node.map_or(0.0, |(at, _)| at.v));
        self.reports.push(PassReport {
            name: pass.name.clone(),
            driven,
            blocks: nodes.len().saturating_sub(1),
            speed: stroke.limits.speed,
            braked: stroke.limits.braked.clone(),
            chord_deviation: stroke.stroke.deviation + gear.as_ref().map_or(0.0, |gear| gear.deviation),
            short_blocks: self.short_blocks(&stroke.stroke, stroke.limits.speed),
            rounding: self.rounding(&pass.course, &stroke.stroke),
            time,
            path: stroke.stroke,
        });
        Ok(())
    }

    /// The paths of a pass: speed first, which decides how long run-in and run-out have to be.
    fn stroke(&self, pass: &Pass) -> Result<Stroke, MotionError> {
        let [from, to] = pass.range;
        let sense = (to - from).signum();
        let along = |places: &[Waypoint], tolerance: f64| {
            AxisPath::new(self.machine, &pass.course, (&pass.name, self.options.swivel), places, tolerance)
        };
        let place = |v: f64| Waypoint { v, ..Waypoint::default() };
        let tolerance = self.options.tolerance;
        let working = along(&[place(from), place(to)], tolerance)?;
        let limits = PathLimits::new(self.machine, &working, &lengths(&working), pass.speed);
        let [before, behind] = pass.room.map(|room| room.max(limits.run_in()));
        let (begin, end) = (from - sense * before, to + sense * behind);
        // Without run-in and run-out there is nothing to drive before and behind.
        let mut places = vec![place(begin), place(from), place(to), place(end)];
        places.dedup_by(|a, b| (a.v - b.v).abs() < LEAST_WAY);
        let stroke = along(&places, tolerance)?;
        let limits = PathLimits::new(self.machine, &stroke, &lengths(&stroke), pass.speed);
        // The worm goes on turning at its speed while the radial slide comes in and goes out.
        // Infeed and retraction take the time of the slide's ramps throughout, so that no block asks more of the worm than its speed.
        let (lead, infeed_speed) = match &pass.course {
            Course::Grinding(course) => {
                let time = self.infeed_time(pass.clearance);
                let slow = if time > 0.0 { pass.clearance / time } else { INFEED_SPEED };
                (course.turning * sense * limits.speed * time, slow)
            }
            Course::Dressing(_) | Course::Line(_) => (0.0, INFEED_SPEED),
        };
        let off = |v: f64, lead: f64| Waypoint { v, lift: pass.clearance, lead };
        let infeed = along(&[off(begin, -lead), place(begin)], tolerance)?;
        let retraction = along(&[place(end), off(end, lead)], tolerance)?;
        Ok(Stroke { infeed, stroke, retraction, limits, infeed_speed })
    }

    /// Time in which the radial slide moves by the clearance, s.
    fn infeed_time(&self, clearance: f64) -> f64 {
        let limits = self.machine.role(Role::Radial).map(|axis| self.machine.axes()[axis].limits);
        let limit = |x: Option<f64>| x.unwrap_or(f64::INFINITY);
        let speed = limits.and_then(|l| l.velocity).unwrap_or(INFEED_SPEED);
        let [a, j] = limits.map_or([f64::INFINITY; 2], |l| [limit(l.acceleration), limit(l.jerk)]);
        super::super::SCurve::new(clearance, speed, a, j).duration()
    }

    /// Drives the paths once from wherever the axes stand.
    fn drive(&mut self, pass: &Pass, paths: &Stroke, gear: Option<&GearBlocks>) -> Result<(), MotionError> {
        let now = self.standing;
        // All three paths begin in the turns in which the endless axes stand.
        let turned = |path: &AxisPath, like: &Positions| path.clone().turned_to(self.machine, like);
        let mut infeed = match &now {
            Some(now) => turned(&paths.infeed, now),
            None => paths.infeed.clone(),
        };
        let joined = |path: &AxisPath, end: Option<&(Waypoint, Positions)>| match end {
            Some((_, end)) => turned(path, end),
            None => path.clone(),
        };
        let stroke = joined(&paths.stroke, infeed.nodes.last());
        let mut retraction = joined(&paths.retraction, stroke.nodes.last());
        if let (Some(gear), Some((_, begin)), Some((_, end))) =
            (gear, stroke.nodes.first(), stroke.nodes.last())
        {
            gear.settle(self.machine, &mut infeed, begin);
            gear.settle(self.machine, &mut retraction, end);
        }
        let Some(&(_, start)) = infeed.nodes.first() else { return Ok(()) };
        self.rapid_to(pass.course.station(), &start)?;
        let follower = gear.map(|gear| gear.follower);
        if let Some(gear) = gear {
            self.blocks.extend(gear.engage(self.machine, &start));
        }
        let parts = [(&infeed, None), (&stroke, Some(&paths.limits)), (&retraction, None)];
        for (path, limits) in parts {
            let lengths = lengths(path);
            let own;
            let limits = match limits {
                Some(limits) => limits,
                None => {
                    own = PathLimits::new(self.machine, path, &lengths, paths.infeed_speed);
                    &own
                }
            };
            let moving: Vec<usize> = (0..self.machine.axes().len())
                .filter(|&k| path.range(k) > STANDS_STILL && Some(k) != follower)
                .collect();
            for (pair, s) in path.nodes.windows(2).zip(lengths.windows(2)) {
                let target = self.words.targets(self.machine, &pair[1].1, |k| moving.contains(&k));
                self.blocks.push(Block::Linear { target, duration: (s[1] - s[0]) / limits.speed });
            }
            let length = lengths.last().copied().unwrap_or(0.0);
            self.trace.path(self.machine, path, &lengths, &limits.curve(length));
        }
        if let Some(gear) = gear {
            self.blocks.push(Block::GearOff { follower: gear.word });
        }
        self.standing = retraction.nodes.last().map(|node| node.1);
        Ok(())
    }

    /// Goes to the start of a pass: first off the tool, then everything else.
    fn rapid_to(&mut self, station: Station, start: &Positions) -> Result<(), MotionError> {
        let axes = driven(self.machine, station)?;
        let radial = self.machine.role(Role::Radial);
        let first = self.standing.is_none();
        let from = self.standing.unwrap_or(*start);
        let moves = |k: usize| axes.contains(&k) && (first || (from[k] - start[k]).abs() > STANDS_STILL);
        let mut now = from;
        for part in [true, false] {
            let target = self.words.targets(self.machine, start, |k| moves(k) && (Some(k) == radial) == part);
            if target.is_empty() {
                continue;
            }
            let next = self.words.positions(self.machine, &now, &target);
            self.trace.rapid(self.machine, &now, &next);
            self.blocks.push(Block::Rapid(target));
            now = next;
        }
        Ok(())
    }

    /// Every axis that moves has a word, or stands where its word says.
    fn check_words(&mut self, station: Station, paths: &[&AxisPath]) -> Result<(), MotionError> {
        for axis in driven(self.machine, station)? {
            if self.words.is_moved(axis) {
                continue;
            }
            let travel = paths.iter().map(|path| path.range(axis)).fold(0.0, f64::max);
            let described = &self.machine.axes()[axis];
            if travel > STANDS_STILL {
                return Err(MotionError::NoWord {
                    axis: described.name.clone(),
                    travel: described.joint.shown(travel),
                    unit: described.joint.unit(),
                });
            }
            let value = paths.iter().find_map(|path| path.nodes.first()).map_or(0.0, |node| node.1[axis]);
            match self.at_rest.iter().find(|(known, _)| *known == axis) {
                Some((_, known)) if (known - value).abs() > STANDS_STILL => {
                    return Err(MotionError::NoWord {
                        axis: described.name.clone(),
                        travel: described.joint.shown((known - value).abs()),
                        unit: described.joint.unit(),
                    });
                }
                Some(_) => {}
                None => {
                    self.at_rest.push((axis, value));
                    let shown = in_words(described.joint.shown(value), described.joint.unit());
                    self.blocks.push(comment(&format!("{} STANDS AT {shown}", described.name)));
                }
            }
        }
        Ok(())
    }

    /// Blocks between run-in and run-out that are over before an axis could reach its speed and stop again.
    fn short_blocks(&self, path: &AxisPath, speed: f64) -> usize {
        let lengths = lengths(path);
        let nodes = &path.nodes;
        let short = |k: &usize| {
            let time = (lengths[k + 1] - lengths[*k]) / speed;
            self.machine.axes().iter().enumerate().any(|(axis, described)| {
                let speed = (nodes[k + 1].1[axis] - nodes[*k].1[axis]).abs() / time;
                described.limits.acceleration.is_some_and(|a| time < 2.0 * speed / a)
            })
        };
        (1..nodes.len().saturating_sub(2)).filter(short).count()
    }

    /// What half a unit of the last digit of every number may leave on the flank, all added up, mm.
    fn rounding(&self, course: &Course, path: &AxisPath) -> f64 {
        let [mm, rad] = self.options.half_unit;
        let every = path.nodes.len().div_ceil(ROUNDING_PLACES).max(1);
        let of_place = |(at, positions): &(Waypoint, Positions)| -> f64 {
            let moved = |&axis: &usize| {
                let mut off = *positions;
                off[axis] += match self.machine.axes()[axis].joint {
                    machine::Joint::Linear => mm,
                    machine::Joint::Rotary => rad,
                };
                let pose = self.machine.pose(course.station(), &off).ok()?;
                course.off(&pose, at)
            };
            self.words.numbers.iter().filter(|&&axis| self.words.is_moved(axis)).filter_map(moved).sum()
        };
        path.nodes.iter().step_by(every).map(of_place).fold(0.0, f64::max)
    }

    pub fn finish(mut self, station: Option<Station>) -> Result<Layout, MotionError> {
        if station == Some(Station::Dresser)
            && self.options.dresser_speed != 0.0
            && let Some(spindle) = spindle_of(self.machine, self.words, Role::Dresser)
        {
            self.blocks.push(Block::Spindle { spindle, speed: 0.0 });
        }
        self.blocks.push(Block::End);
        let program = Program::new(header(self.words, self.options), self.blocks)?;
        Ok(Layout { program, trace: self.trace, passes: self.reports, at_rest: self.at_rest })
    }
}

/// A quantity in capital letters, digits and blanks only, which every control takes: "MINUS 12 POINT 5 DEG".
pub fn in_words(value: f64, unit: &str) -> String {
    let text = format!("{:.4}", value.abs());
    let text = text.trim_end_matches('0').trim_end_matches('.');
    let sign = if value < 0.0 && text != "0" { "MINUS " } else { "" };
    format!("{sign}{} {}", text.replace('.', " POINT "), unit.to_uppercase())
}

/// Places of a path at which the effect of rounding is looked at.
const ROUNDING_PLACES: usize = 33;

/// The spindle of a role's axis, if the control runs it as one.
fn spindle_of(machine: &Machine, words: &AxisWords, role: Role) -> Option<u8> {
    match words.words[words.place(machine.role(role)?)?].word {
        Word::Spindle(spindle) => Some(spindle),
        _ => None,
    }
}

/// The way between two waypoints as path length: mm of the parameter, or of the lift where the parameter stands.
fn lengths(path: &AxisPath) -> Vec<f64> {
    let mut sum = 0.0;
    let mut out = Vec::with_capacity(path.nodes.len());
    out.push(0.0);
    for pair in path.nodes.windows(2) {
        let (a, b): (&Waypoint, &Waypoint) = (&pair[0].0, &pair[1].0);
        sum += (b.v - a.v).abs().max((b.lift - a.lift).abs());
        out.push(sum);
    }
    out
}

/// Axes of a station that programs give targets of: all but the dresser's own rotation, which is a spindle.
fn driven(machine: &Machine, station: Station) -> Result<Vec<usize>, MotionError> {
    let dresser = machine.role(Role::Dresser);
    let all = machine.axes_at(station)?;
    Ok(all.into_iter().filter(|&axis| station == Station::Work || Some(axis) != dresser).collect())
}

/// The header of a program for these axes.
fn header(words: &AxisWords, options: &LayoutOptions) -> Header {
    Header { name: options.name.clone(), axes: words.words.clone(), chord_tolerance: options.tolerance }
}

fn comment(text: &str) -> Block {
    Block::Comment(text.into())
}
