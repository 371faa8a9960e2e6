//! Writes the lines of a disc: into the thread space once, from line to line inside it, out of it where the next line lies elsewhere.

use super::{
    AxisPath, Course, INFEED_SPEED, LEAST_WAY, Machine, MotionError, PassReport, PathLimits, Positions,
    STANDS_STILL, Station, Waypoint, Writer, comment, lengths,
};
use crate::layout::{LayoutOptions, LinePass};
use crate::{Braked, LineCourse};
use foundation::kinematics::DressingPosition;
use foundation::numerics::extremes;
use nc::Block;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// From the end of a line to the start of the next the disc stays in the thread space if it leaves the helix by no more than this, along
/// the worm and in distance, mm. Straight blocks then stay nearer to the flank's own curve than the lift is high.
const ASIDE: f64 = 1.0;
/// Most of a turn by which it goes along the thread so.
const TURN: f64 = 0.45 * TAU;
/// Speed at which the disc comes to the flank and leaves it, mm/s of centre distance.
const TOUCH_SPEED: f64 = 10.0;
/// Lines at which the effect of rounding is looked at.
const ROUNDED_LINES: usize = 9;

/// One line with its ways to the flank and off it.
struct LinePaths {
    course: Course,
    /// Positions of the bodies where it begins and ends.
    ends: [DressingPosition; 2],
    reach: f64,
    infeed: AxisPath,
    stroke: AxisPath,
    retraction: AxisPath,
    /// Into the thread space and out of it.
    outer: [AxisPath; 2],
    /// Greatest speed of t, mm/s.
    speed: f64,
}

impl LinePaths {
    fn new(
        machine: &Machine,
        options: &LayoutOptions,
        pass: &LinePass<'_>,
        line: LineCourse,
    ) -> Result<Self, MotionError> {
        let [begin, end] = line.ends();
        let at = |v: f64, lift: f64| Waypoint { v, lift, lead: 0.0 };
        let ends = [line.position(&at(begin, 0.0)), line.position(&at(end, 0.0))];
        let (reach, speed) = (line.reach, pass.speed / line.way_over_t());
        let course = Course::Line(line);
        let along = |places: [Waypoint; 2]| {
            AxisPath::new(machine, &course, (&pass.name, options.swivel), &places, options.tolerance)
        };
        Ok(Self {
            infeed: along([at(begin, pass.hop), at(begin, 0.0)])?,
            stroke: along([at(begin, 0.0), at(end, 0.0)])?,
            retraction: along([at(end, 0.0), at(end, pass.hop)])?,
            outer: [
                along([at(begin, pass.clearance), at(begin, pass.hop)])?,
                along([at(end, pass.hop), at(end, pass.clearance)])?,
            ],
            course,
            ends,
            reach,
            speed,
        })
    }

    /// The way to the start of the next line inside the thread space, mm; `None` where it lies elsewhere.
    fn link(&self, next: &Self, screw: f64) -> Option<f64> {
        let (from, to) = (&self.ends[1], &next.ends[0]);
        // Axes go on in the turn in which they stand.
        let turned = to.worm_angle - from.worm_angle;
        let turned = turned - TAU * (turned / TAU).round();
        let along = to.worm_shift - from.worm_shift;
        let deeper = to.centre_distance - from.centre_distance;
        let near = (along - screw * turned).abs() <= ASIDE && deeper.abs() <= ASIDE && turned.abs() <= TURN;
        near.then(|| (self.reach * turned).hypot(along).hypot(deeper))
    }
}

impl Writer<'_> {
    /// All lines of a pass.
    pub fn lines(&mut self, pass: &LinePass<'_>) -> Result<(), MotionError> {
        let (machine, options) = (self.machine, self.options);
        let made: Vec<Result<LinePaths, MotionError>> = (0..pass.count)
            .into_par_iter()
            .map(|k| LinePaths::new(machine, options, pass, (pass.line)(k)?))
            .collect();
        let lines = made.into_iter().collect::<Result<Vec<_>, _>>()?;
        for line in &lines {
            let [approach, leave] = &line.outer;
            let paths = [approach, &line.infeed, &line.stroke, &line.retraction, leave];
            self.check_words(Station::Dresser, &paths)?;
        }
        self.blocks.push(comment(&pass.name));
        let begun = self.trace.duration();
        let mut braked: Option<Braked> = None;
        let mut slowest = f64::INFINITY;
        let mut short = 0;
        for (k, line) in lines.iter().enumerate() {
            let before = k.checked_sub(1).and_then(|before| lines[before].link(line, pass.screw));
            let behind = lines.get(k + 1).and_then(|next| line.link(next, pass.screw));
            let infeed = match before {
                Some(way) => {
                    let infeed = self.joined(&line.infeed);
                    self.link(&infeed, way, pass.speed);
                    infeed
                }
                None => {
                    let approach = self.joined(&line.outer[0]);
                    if let Some(&(_, start)) = approach.nodes.first() {
                        self.rapid_to(Station::Dresser, &start)?;
                    }
                    self.straight(&approach, INFEED_SPEED);
                    self.joined(&line.infeed)
                }
            };
            self.straight(&infeed, TOUCH_SPEED);
            let stroke = self.joined(&line.stroke);
            let limits = self.straight(&stroke, line.speed);
            short += self.short_blocks(&stroke, limits.speed);
            slowest = slowest.min(limits.speed);
            if let Some(by) = limits.braked
                && braked.as_ref().is_none_or(|known| by.share < known.share)
            {
                braked = Some(by);
            }
            let retraction = self.joined(&line.retraction);
            self.straight(&retraction, TOUCH_SPEED);
            if behind.is_none() {
                let leave = self.joined(&line.outer[1]);
                self.straight(&leave, INFEED_SPEED);
            }
        }
        let every = lines.len().div_ceil(ROUNDED_LINES).max(1);
        let rounding = lines.iter().step_by(every).map(|line| self.rounding(&line.course, &line.stroke));
        let Some(first) = lines.first() else { return Ok(()) };
        self.reports.push(PassReport {
            name: pass.name.clone(),
            driven: extremes(lines.iter().flat_map(|line| line.ends.map(|at| at.worm_shift))),
            blocks: lines.iter().map(|line| line.stroke.nodes.len().saturating_sub(1)).sum(),
            speed: slowest,
            braked,
            chord_deviation: lines.iter().map(|line| line.stroke.deviation).fold(0.0, f64::max),
            short_blocks: short,
            rounding: rounding.fold(0.0, f64::max),
            time: self.trace.duration() - begun,
            path: first.stroke.clone(),
        });
        Ok(())
    }

    /// A path begun in the turns in which the endless axes stand.
    fn joined(&self, path: &AxisPath) -> AxisPath {
        match &self.standing {
            Some(now) => path.clone().turned_to(self.machine, now),
            None => path.clone(),
        }
    }

    /// Goes over to the start of a path inside the thread space, `way` mm.
    fn link(&mut self, to: &AxisPath, way: f64, speed: f64) {
        let ends: (Option<Positions>, Option<Positions>) =
            (self.standing, to.nodes.first().map(|node| node.1));
        let (Some(from), Some(to)) = ends else { return };
        if way < LEAST_WAY {
            return;
        }
        let nodes = vec![(Waypoint::default(), from), (Waypoint { v: way, ..Waypoint::default() }, to)];
        self.straight(&AxisPath { nodes, deviation: 0.0 }, speed);
    }

    /// Drives a path from rest to rest, no faster than `wanted`.
    fn straight(&mut self, path: &AxisPath, wanted: f64) -> PathLimits {
        let lengths = lengths(path);
        let limits = PathLimits::new(self.machine, path, &lengths, wanted);
        let moving: Vec<usize> =
            (0..self.machine.axes().len()).filter(|&k| path.range(k) > STANDS_STILL).collect();
        if moving.is_empty() {
            return limits;
        }
        for (pair, s) in path.nodes.windows(2).zip(lengths.windows(2)) {
            let target = self.words.targets(self.machine, &pair[1].1, |k| moving.contains(&k));
            self.blocks.push(Block::Linear { target, duration: (s[1] - s[0]) / limits.speed });
        }
        let length = lengths.last().copied().unwrap_or(0.0);
        self.trace.sketch(self.machine, path, &lengths, &limits.curve(length));
        self.standing = path.nodes.last().map(|node| node.1);
        limits
    }
}
