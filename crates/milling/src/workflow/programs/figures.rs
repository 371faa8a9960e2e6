//! Figures of the motion: times, what limits the feed, travel and smoothness of the rotary axes, passages near the pole, turning back
//! (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::operation_figures::{OperationFigures, RowFigures, StraightKept};
use super::passes::CutterPass;
use super::steps::{Step, StepKind, ToolRun};
use super::task::MillingWork;
use machine::Positions;
use motion::milling::{AxisCourse, CutterPlace as Place, MillingSetup, SectionFeed, smoothness};
use std::collections::BTreeMap;

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
            tool: tool.tool.number,
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
