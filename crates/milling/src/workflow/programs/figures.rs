//! Figures of the motion: times, what limits the feed, travel and smoothness of the rotary axes, passages near the pole, turning back
//! (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::passes::CutterPass;
use super::steps::{Step, StepKind, ToolRun};
use super::task::MillingWork;
use crate::OperationKind;
use machine::Positions;
use motion::milling::{
    AxisCourse, CutterPlace as Place, MillingSetup, RowSmoothness, SectionFeed, smoothness,
};
use std::collections::BTreeMap;

/// Largest deviations that straight blocks of the axes leave from the planned path.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StraightKept {
    /// Of the tip, mm.
    pub tip: f64,
    /// Of the axis, rad.
    pub axis: f64,
}

/// One path of the first space.
#[derive(Clone, Debug, PartialEq)]
pub struct RowFigures {
    /// Path of the operation, from 0; a path that is cut in pieces has one entry for each.
    pub path: usize,
    /// How smoothly the rotary axes run.
    pub smoothness: RowSmoothness,
}

/// One operation.
#[derive(Clone, Debug, PartialEq)]
pub struct OperationFigures {
    /// What it does.
    pub kind: OperationKind,
    /// Number of the tool.
    pub tool: u32,
    /// Time of cuts and plunges, s.
    pub cutting: f64,
    /// Time of all other blocks, s.
    pub rapid: f64,
    /// Blocks.
    pub blocks: usize,
    /// What determines the time of how many cuts: "feed" or the name of an axis.
    pub limits: BTreeMap<String, usize>,
    /// Travel of both rotary axes over all blocks, links included, rad; the axis next to the workpiece first.
    pub rotary_travel: [f64; 2],
    /// Rows of the first space.
    pub rows: Vec<RowFigures>,
    /// Parts of paths of the first space near the pole: path and feed there, mm/min.
    pub passages: Vec<(usize, SectionFeed)>,
    /// Places of the first space at which an axis is held near the pole, and by how much the cutter's axis is off there at most, rad.
    pub held: (usize, f64),
    /// Links on which an axis is turned back or changes its solution.
    pub rewinds: usize,
}

impl OperationFigures {
    /// Time of all its blocks, s.
    pub fn seconds(&self) -> f64 {
        self.cutting + self.rapid
    }
}

impl StraightKept {
    /// The larger of both.
    pub(super) fn larger(self, other: Self) -> Self {
        Self { tip: self.tip.max(other.tip), axis: self.axis.max(other.axis) }
    }
}

/// Figures that are being gathered.
pub(super) struct Figures<'a> {
    setup: &'a MillingSetup<'a>,
    operations: Vec<OperationFigures>,
    straight: StraightKept,
}

impl<'a> Figures<'a> {
    pub fn new(setup: &'a MillingSetup<'a>, work: &MillingWork<'_>) -> Self {
        let empty = work.tools.iter().map(|tool| OperationFigures {
            kind: tool.kind,
            tool: tool.number,
            cutting: 0.0,
            rapid: 0.0,
            blocks: 0,
            limits: BTreeMap::new(),
            rotary_travel: [0.0; 2],
            rows: Vec::new(),
            passages: Vec::new(),
            held: (0, 0.0),
            rewinds: 0,
        });
        Self { setup, operations: empty.collect(), straight: StraightKept::default() }
    }

    pub fn keep(&mut self, kept: StraightKept) {
        self.straight = self.straight.larger(kept);
    }

    pub fn row(&mut self, pass: &CutterPass, places: &[Place], nodes: &[Positions]) {
        if let (0, Some(operation)) = (pass.space, self.operations.get_mut(pass.operation)) {
            let smoothness = smoothness(self.setup, places, nodes);
            operation.rows.push(RowFigures { path: pass.path, smoothness });
        }
    }

    pub fn passage(&mut self, pass: &CutterPass, section: &SectionFeed) {
        if let (0, Some(operation)) = (pass.space, self.operations.get_mut(pass.operation)) {
            operation.passages.push((pass.path, section.clone()));
        }
    }

    pub fn held(&mut self, pass: &CutterPass, course: &AxisCourse) {
        if let (0, Some(operation)) = (pass.space, self.operations.get_mut(pass.operation)) {
            let off = course.axis_errors.iter().filter(|off| **off > 0.0);
            let (places, most) = operation.held;
            operation.held = (places + off.clone().count(), off.copied().fold(most, f64::max));
        }
    }

    /// What all blocks come to.
    pub fn finish(mut self, runs: &[ToolRun]) -> (Vec<OperationFigures>, StraightKept) {
        let rotary = self.setup.axes().rotary;
        let mut before: Option<&Step> = None;
        for step in runs.iter().flat_map(|run| &run.steps) {
            let Some(figures) = self.operations.get_mut(step.operation) else { continue };
            figures.blocks += 1;
            match step.kind {
                StepKind::Cut | StepKind::Plunge => figures.cutting += step.seconds,
                _ => figures.rapid += step.seconds,
            }
            if let Some(limit) = &step.limit {
                *figures.limits.entry(limit.name().to_owned()).or_default() += 1;
            }
            let unwinds = |step: &Step| step.kind == StepKind::Unwind;
            figures.rewinds += usize::from(unwinds(step) && !before.is_some_and(unwinds));
            if let Some(before) = before {
                for (travel, axis) in figures.rotary_travel.iter_mut().zip(rotary) {
                    *travel += (step.at[axis] - before.at[axis]).abs();
                }
            }
            before = Some(step);
        }
        (self.operations, self.straight)
    }
}
