//! A plan as work for tools, and the machine with the options of its control.

use super::prepare::{Mounting, PreparedMilling};
use super::programs::{MillingMachining, MillingWork, ToolWork};
use crate::MillingPlan;
use job::machine::LoadedMachine;
use job::tables::Program as DialectName;
use nc::TipControl;

/// The operations of a plan with their tools, feeds and speeds.
pub(super) fn work<'a>(prepared: &'a PreparedMilling, plan: &MillingPlan) -> MillingWork<'a> {
    let PreparedMilling { bodies, technology, .. } = prepared;
    let tools = plan.operations.iter().map(|operation| ToolWork {
        kind: operation.kind,
        cutter: bodies.options.cutter_of(operation.kind).clone(),
        tool: technology.tool_of(operation.kind),
        paths: operation.paths.clone(),
    });
    MillingWork {
        name: &prepared.info.name,
        tools: tools.collect(),
        spaces: bodies.milled,
        pitch: bodies.pitch,
        retraction: bodies.retraction,
    }
}

/// A machine with the workpiece on it.
pub(super) fn machining<'a>(
    mounting: &'a Mounting,
    machine: &'a LoadedMachine,
    dialects: &'a [DialectName],
) -> MillingMachining<'a> {
    MillingMachining {
        machine,
        mount: mounting.mount,
        held_clocking: mounting.held_clocking,
        work_offset: mounting.work_offset,
        holds_lengths: mounting.holds_lengths,
        spindle_dwell: mounting.spindle_dwell,
        end_position: &mounting.end_position,
        rtcp: mounting.rtcp,
        tip_control: TipControl::Directions,
        position_tolerance: 1e-3 * mounting.position_tolerance_um,
        at_pole: mounting.at_pole,
        dialects,
    }
}
