//! The tools of a run and the work offset in its result, and the table of tools as a file.

use super::prepare::PreparedMilling;
use super::programs::{ClockingCycle, MillingPrograms, ToolWork};
use super::result::CutterResult;
use super::work::work;
use crate::MillingPlan;
use job::{Cell, Column, CsvError, CsvTable};
use schemars::JsonSchema;
use serde::Serialize;

/// A tool of the machine's store.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ToolResult {
    /// Its number.
    pub number: u32,
    /// What it does, in the order of cutting.
    pub operations: Vec<String>,
    /// Its cutting part.
    pub cutter: CutterResult,
    /// From the nose of the spindle to its tip; absent without a machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length_mm: Option<f64>,
    /// Numbers of its length on controls that have it: H of LinuxCNC and Fanuc, D of Siemens.
    pub length_offset: LengthNumbers,
    /// Speed of the spindle.
    pub spindle_rpm: f64,
    /// Greatest feed of its operations.
    pub feed_mm_per_min: f64,
    /// Feed towards its paths.
    pub plunge_feed_mm_per_min: f64,
    /// Coolant: "off", "flood", "mist", "flood-and-mist".
    pub coolant: &'static str,
    /// Cutting edges; absent where the job does not tell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub teeth: Option<u32>,
}

/// Numbers behind H and D.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct LengthNumbers {
    /// Behind H.
    pub h: u32,
    /// Behind D.
    pub d: u32,
}

/// What the control has to hold as work offset.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WorkOffsetResult {
    /// Its number: 1 is G54.
    pub number: u16,
    /// Values of X, Y and Z.
    pub position_mm: [f64; 3],
    /// The clocking angle of the workpiece, where the control holds it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clocking: Option<HeldAngle>,
}

/// A value of a rotary axis.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct HeldAngle {
    /// Name of the axis.
    pub axis: String,
    /// Its value as the control counts.
    pub value_deg: f64,
}

/// A program that finds the clocking angle.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ClockingResult {
    /// Path below the directory of the run.
    pub file: String,
    /// Control.
    pub control: &'static str,
    /// Name of the axis that turns.
    pub axis: String,
    /// Where it touches both flanks of a workpiece whose clocking angle is right, as the control counts.
    pub touches_deg: [f64; 2],
    /// Their mean.
    pub middle_deg: f64,
    /// Errors of the clocking angle, either way, that were tried on the text by the referee's rays.
    pub tried_deg: f64,
    /// How far what the text makes of them is off at most.
    pub off_deg: f64,
}

/// The clocking programs of a run.
pub(super) fn clocking(cycles: &[ClockingCycle]) -> Vec<ClockingResult> {
    let of = |cycle: &ClockingCycle| ClockingResult {
        file: cycle.file.clone(),
        control: cycle.dialect.name(),
        axis: cycle.axis.clone(),
        touches_deg: cycle.touches.map(f64::to_degrees),
        middle_deg: cycle.middle.to_degrees(),
        tried_deg: cycle.tried.to_degrees(),
        off_deg: cycle.off.to_degrees(),
    };
    cycles.iter().map(of).collect()
}

/// The tools of a plan by their first use.
pub(super) fn tools(prepared: &PreparedMilling, plan: &MillingPlan) -> Vec<ToolResult> {
    let mut tools: Vec<ToolResult> = Vec::new();
    for ToolWork { kind, cutter, tool, .. } in work(prepared, plan).tools {
        let name = kind.to_string();
        if let Some(known) = tools.iter_mut().find(|known| known.number == tool.number) {
            known.operations.push(name);
            known.feed_mm_per_min = known.feed_mm_per_min.max(tool.feed);
            continue;
        }
        let [h, d] = super::programs::length_numbers(&tool);
        tools.push(ToolResult {
            number: tool.number,
            operations: vec![name],
            cutter: CutterResult::new(cutter.shape(), cutter.cutting_length()),
            length_mm: (tool.length > 0.0).then_some(tool.length),
            length_offset: LengthNumbers { h, d },
            spindle_rpm: tool.spindle_rpm,
            feed_mm_per_min: tool.feed,
            plunge_feed_mm_per_min: tool.plunge_feed,
            coolant: tool.coolant.name(),
            teeth: tool.edges,
        });
    }
    tools
}

/// What the control has to hold, where the job has a work offset and programs were made.
pub(super) fn work_offset(
    prepared: &PreparedMilling,
    programs: Option<&MillingPrograms>,
) -> Option<WorkOffsetResult> {
    let offset = prepared.mounting.as_ref()?.work_offset?;
    let clocking = programs?.clocking.as_ref();
    let held = |held: &super::programs::HeldClocking| HeldAngle {
        axis: held.name.clone(),
        value_deg: held.value.to_degrees(),
    };
    Some(WorkOffsetResult {
        number: offset.number,
        position_mm: offset.position,
        clocking: clocking.map(held),
    })
}

/// The tools as a table.
///
/// # Errors
/// A value that is not finite.
pub(super) fn tool_table(tools: &[ToolResult]) -> Result<CsvTable, CsvError> {
    let columns = [
        Column::new("tool", ""),
        Column::new("h", ""),
        Column::new("d", ""),
        Column::new("profile", ""),
        Column::new("length", "mm"),
        Column::new("diameter", "mm"),
        Column::new("corner_or_profile_radius", "mm"),
        Column::new("half_angle", "deg"),
        Column::new("cutting_length", "mm"),
        Column::new("teeth", ""),
        Column::new("spindle", "1/min"),
        Column::new("feed", "mm/min"),
        Column::new("plunge_feed", "mm/min"),
        Column::new("coolant", ""),
    ];
    let mut table = CsvTable::new(&columns);
    let cell = |value: Option<f64>| value.map_or(Cell::Empty, Cell::Number);
    for tool in tools {
        let cutter = &tool.cutter;
        table.push_cells(&[
            Cell::Number(tool.number.into()),
            Cell::Number(tool.length_offset.h.into()),
            Cell::Number(tool.length_offset.d.into()),
            Cell::Word(cutter.profile),
            cell(tool.length_mm),
            Cell::Number(cutter.diameter),
            Cell::Number(cutter.profile_radius),
            Cell::Number(cutter.half_angle_deg),
            Cell::Number(cutter.cutting_length),
            cell(tool.teeth.map(f64::from)),
            Cell::Number(tool.spindle_rpm),
            Cell::Number(tool.feed_mm_per_min),
            Cell::Number(tool.plunge_feed_mm_per_min),
            Cell::Word(tool.coolant),
        ])?;
    }
    Ok(table)
}
