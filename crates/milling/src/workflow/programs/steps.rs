//! The blocks of a job on a machine: where each ends, what it does, how long it takes.

use super::operation_figures::{OperationFigures, StraightKept};
use crate::workflow::prepare::ToolData;
use machine::Positions;
use motion::milling::{BlockLimit, CutterPlace as Place};

/// What a block does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepKind {
    /// Rapid to the first place outside, from wherever the axes are.
    Position,
    /// Rapid outside of the workpiece.
    Link,
    /// Rapid outside of the workpiece that turns an axis back or brings it into its other solution.
    Unwind,
    /// Along the cutter's axis towards the workpiece, as fast as the axes may.
    Approach,
    /// Along the cutter's axis to the path, with the plunge feed.
    Plunge,
    /// Along the path, with the feed.
    Cut,
    /// Along the cutter's axis out of the workpiece, as fast as the axes may.
    Retract,
    /// Rapid to where the axes stand at the end of the program.
    End,
}

/// One block: where it ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// What it does.
    pub kind: StepKind,
    /// Which of the operations, from 0.
    pub operation: usize,
    /// Space, from 0.
    pub space: usize,
    /// Path of the operation, from 0.
    pub path: usize,
    /// The cutter at its end, workpiece coordinates.
    pub place: Place,
    /// The axes at its end.
    pub at: Positions,
    /// Its time, s.
    pub seconds: f64,
    /// What determines the time of a cut.
    pub limit: Option<BlockLimit>,
    /// Whether the control leads the tip.
    pub guided: bool,
}

/// All blocks with one tool.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolRun {
    /// The tool.
    pub tool: ToolData,
    /// Its blocks.
    pub steps: Vec<Step>,
}

/// The whole job on a machine.
#[derive(Clone, Debug, PartialEq)]
pub struct DrivenMotion {
    /// Tool by tool.
    pub tools: Vec<ToolRun>,
    /// Figures of each operation.
    pub operations: Vec<OperationFigures>,
    /// Time of all blocks, s; changes of tools are not in it.
    pub cycle_time: f64,
    /// What straight blocks of the axes leave.
    pub straight: StraightKept,
}

impl DrivenMotion {
    /// Time of the blocks of the first space, s: of one operation by its number, or of all.
    pub fn first_space_seconds(&self, operation: Option<usize>) -> f64 {
        let steps = self.tools.iter().flat_map(|run| &run.steps);
        let wanted = |step: &&Step| {
            let own = step.space == 0 && step.kind != StepKind::End;
            own && operation.is_none_or(|number| step.operation == number)
        };
        steps.filter(wanted).map(|step| step.seconds).sum()
    }
}
