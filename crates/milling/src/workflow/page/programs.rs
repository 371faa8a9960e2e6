//! The programs of a run as the page takes them: programs with the same kind of tip control are described once.

use crate::OperationKind;
use crate::page::{AxisCourse, CourseChart, CourseLine, ProgramsView};
use crate::workflow::ProgramResult;
use crate::workflow::programs::{DrivenMotion, MillingProgram, Step, StepKind};
use crate::workflow::run::MillingOutcome;
use machine::{Machine, Station};
use report::charts::{format_fixed, format_significant};
use report::kebab;
use report::{Column, Table};
use std::sync::Arc;

/// A motion, the controls that make it, and what the result says of the first of them.
struct Shown<'a> {
    motion: &'a DrivenMotion,
    controls: String,
    result: &'a ProgramResult,
}

/// The section; none without programs.
pub(super) fn view(outcome: &MillingOutcome) -> Option<ProgramsView> {
    let texts = &outcome.texts;
    let (programs, machine) = (&texts.programs.as_ref()?.programs, &texts.machine.as_ref()?.machine);
    let results = &outcome.result.programs;
    let mut motions: Vec<(&MillingProgram, Shown<'_>)> = Vec::new();
    for (program, result) in programs.iter().zip(results) {
        match motions.iter_mut().find(|(known, _)| Arc::ptr_eq(&known.motion, &program.motion)) {
            Some((_, shown)) => shown.controls = format!("{}, {}", shown.controls, result.control),
            None => {
                let controls = result.control.to_owned();
                motions.push((program, Shown { motion: &program.motion, controls, result }));
            }
        }
    }
    let motions: Vec<Shown<'_>> = motions.into_iter().map(|(_, shown)| shown).collect();
    let first = motions.first()?;
    // What holds for all of them is told once, without names.
    let common = |remark: &&String| motions.iter().all(|shown| shown.result.remarks.contains(remark));
    let mut remarks: Vec<String> = first.result.remarks.iter().filter(common).cloned().collect();
    for shown in &motions {
        let own = shown.result.remarks.iter().filter(|remark| !common(remark));
        remarks.extend(own.map(|remark| format!("{}: {remark}", shown.controls)));
    }
    Some(ProgramsView {
        proof: proof(results),
        remarks,
        courses: charts(machine, first),
        cycle_times: motions.iter().map(cycle_times).collect(),
    })
}

fn proof(results: &[ProgramResult]) -> Vec<String> {
    let um = |x: f64| format_significant(x, 3);
    let of = |result: &ProgramResult| {
        format!(
            "{}: {} blocks. Read back by a reader that shares no code with the writer and milled again by rays, the text leaves the \
             planned flanks of the first space within {} µm; digits and straight blocks explain up to {} µm. The whole part: {}; {}.",
            result.file,
            result.blocks,
            um(result.proof_difference_um),
            um(result.proof_allowed_um),
            result.part.statement,
            match result.part.faults.len() {
                0 => "nothing is wrong".to_owned(),
                count => format!("{count} faults"),
            }
        )
    };
    results.iter().map(of).collect()
}

fn cycle_times(shown: &Shown<'_>) -> Table {
    let s = |x: f64| format_fixed(x, 1);
    let mut rows: Vec<Vec<String>> = shown
        .result
        .operations
        .iter()
        .map(|operation| {
            let mut limits: Vec<(&String, &usize)> = operation.limited_by.iter().collect();
            limits.sort_by(|a, b| b.1.cmp(a.1).then(a.0.cmp(b.0)));
            let limits: Vec<String> = limits.iter().map(|(name, count)| format!("{name} {count}")).collect();
            let [a, b] = operation.rotary_travel_deg.map(|deg| format_fixed(deg, 0));
            vec![
                operation.name.clone(),
                operation.tool.to_string(),
                operation.blocks.to_string(),
                s(operation.one_space_s),
                s(operation.cutting_s),
                s(operation.rapid_s),
                s(operation.cutting_s + operation.rapid_s),
                limits.join(", "),
                format!("{a} / {b}"),
            ]
        })
        .collect();
    let sum = |of: &dyn Fn(&crate::workflow::ProgramOperation) -> f64| {
        shown.result.operations.iter().map(of).sum::<f64>()
    };
    rows.push(vec![
        "all".into(),
        String::new(),
        shown.result.blocks.to_string(),
        s(shown.result.one_space_s),
        s(sum(&|operation| operation.cutting_s)),
        s(sum(&|operation| operation.rapid_s)),
        s(shown.result.duration_s),
    ]);
    Table {
        caption: format!("Cycle times: {}", shown.controls),
        columns: vec![
            Column::text("Operation"),
            Column::number("Tool", ""),
            Column::number("Blocks", ""),
            Column::number("One space", "s"),
            Column::number("Cutting", "s"),
            Column::number("Rapid", "s"),
            Column::number("Whole", "s"),
            Column::text("Time of cuts set by"),
            Column::number("Rotary travel", "deg"),
        ],
        rows,
        note: "Cutting, rapid and whole are of all spaces. What sets the time: the feed, or the axis that would be too fast, with the \
               number of blocks. Changes of tools and the control's braking are not in the times."
            .into(),
    }
}

/// The axes over the first space, and along the middle row of the first flank.
fn charts(machine: &Machine, shown: &Shown<'_>) -> Vec<CourseChart> {
    let steps: Vec<&Step> = shown.motion.tools.iter().flat_map(|run| &run.steps).collect();
    let first: Vec<&Step> = steps.iter().copied().filter(|step| step.space == 0).collect();
    let mut charts = vec![CourseChart {
        id: "axes-over-time-all-paths-of-the-first-space".into(),
        title: "Axes over time: all paths of the first space".into(),
        caption: format!(
            "As the blocks for {} have it; what lies between with other spaces is left out.",
            shown.controls
        ),
        axes: courses(machine, &first),
    }];
    let flank = shown.motion.operations.iter().position(|o| matches!(o.kind, OperationKind::Flank(_)));
    if let Some(operation) = flank {
        let count = shown.motion.operations[operation].rows.len();
        let of_row: Vec<&Step> =
            first.iter().copied().filter(|s| s.operation == operation && s.path == count / 2).collect();
        let is_cut = |step: &&Step| step.kind == StepKind::Cut;
        // The row begins where the block before its first cut ends.
        if let (Some(from), Some(to)) = (of_row.iter().position(is_cut), of_row.iter().rposition(is_cut)) {
            let name = &shown.result.operations[operation].name;
            charts.push(CourseChart {
                id: kebab(&format!("axes over time middle path of the {name}")),
                title: format!("Axes over time: middle path of the {name}"),
                caption: String::new(),
                axes: courses(machine, &of_row[from.saturating_sub(1)..=to]),
            });
        }
    }
    charts
}

/// The five axes at the ends of blocks, from the first of them on.
fn courses(machine: &Machine, steps: &[&Step]) -> Vec<AxisCourse> {
    let Ok(axes) = machine.five_axes(Station::Work) else { return Vec::new() };
    let mut time = 0.0;
    let times: Vec<f64> = steps
        .iter()
        .enumerate()
        .map(|(k, step)| {
            time += if k > 0 { step.seconds } else { 0.0 };
            time
        })
        .collect();
    let course = |axis: usize| {
        let described = &machine.axes()[axis];
        AxisCourse {
            name: described.name.clone(),
            unit: described.joint.unit().into(),
            lines: vec![CourseLine {
                name: "position".into(),
                time_s: times.clone(),
                value: steps.iter().map(|step| described.joint.shown(step.at[axis])).collect(),
            }],
        }
    };
    axes.rotary.into_iter().chain(axes.linear).map(course).collect()
}
