//! What the axes of a machine do along the paths that is worth a sentence: which of two positions they take, where they are turned
//! back, how they pass the pole (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::programs::{DrivenMotion, MillingPrograms, StepKind};
use foundation::numerics::extremes;
use machine::{Machine, Station};
use report::charts::{format_fixed, format_significant};

/// The sentences on a motion.
pub(super) fn remarks(machine: &Machine, programs: &MillingPrograms, motion: &DrivenMotion) -> Vec<String> {
    let mut remarks = Vec::new();
    if let Ok(axes) = machine.five_axes(Station::Work) {
        let ranges: Vec<String> = axes.rotary.iter().map(|&axis| range(machine, motion, axis)).collect();
        remarks.push(format!(
            "Every direction of the cutter has two positions of the rotary axes, each in several turns; of all that the travels allow \
             the ones with the least turning along each path are taken: {}.",
            ranges.join(", ")
        ));
    }
    let turned: usize = motion.operations.iter().map(|operation| operation.rewinds).sum();
    if turned > 0 {
        remarks.push(format!(
            "Between paths an axis is turned back or changes its position {turned} times, with the cutter outside of the workpiece."
        ));
    }
    for operation in &motion.operations {
        let slowest = operation.passages.iter().min_by(|a, b| a.1.feed.total_cmp(&b.1.feed));
        if let Some((path, section)) = slowest {
            remarks.push(format!(
                "{}: {} parts of paths come near the pole, path {} to {} deg; the feed there is {} mm/min, determined by {}.",
                operation.kind,
                operation.passages.len(),
                path + 1,
                format_significant(section.passage.least.to_degrees(), 3),
                format_significant(section.feed, 4),
                section.limit.name()
            ));
        }
        let (held, off) = operation.held;
        if held > 0 {
            remarks.push(format!(
                "{}: near the pole the first rotary axis is held at {held} places; the cutter's axis is off by up to {} deg there, its \
                 ball is not.",
                operation.kind,
                format_significant(off.to_degrees(), 3)
            ));
        }
    }
    remarks.extend(end_position(machine, motion));
    if let Some(tilt) = &programs.tilt {
        let [x, y, z] = tilt.axis.xyz.into();
        remarks.push(format!(
            "The workpiece has to be tilted by {} deg about the direction ({}, {}, {}) of the table through the workpiece's origin; \
             that keeps the cutter's axis {} deg away from the pole.",
            format_fixed(tilt.angle.to_degrees(), 4),
            format_fixed(x, 6),
            format_fixed(y, 6),
            format_fixed(z, 6),
            format_significant(tilt.least.to_degrees(), 3)
        ));
    }
    remarks
}

/// Where the axes stand at the end, if they go anywhere.
fn end_position(machine: &Machine, motion: &DrivenMotion) -> Option<String> {
    let last = motion.tools.last()?.steps.last().filter(|step| step.kind == StepKind::End)?;
    let axes = machine.five_axes(Station::Work).ok()?;
    let stands = axes.linear.into_iter().chain(axes.rotary).map(|axis| {
        let described = &machine.axes()[axis];
        let value = described.nc_sign * described.joint.shown(last.at[axis]);
        format!("{} {} {}", described.name, format_fixed(value, 3), described.joint.unit())
    });
    let stands = stands.collect::<Vec<String>>().join(", ");
    Some(format!("Where the axes stand at the end of the program, as the control counts them: {stands}."))
}

fn range(machine: &Machine, motion: &DrivenMotion, axis: usize) -> String {
    let steps = motion.tools.iter().flat_map(|run| &run.steps).filter(|step| step.kind != StepKind::End);
    let [low, high] = extremes(steps.map(|step| step.at[axis].to_degrees()));
    format!("{} {} to {} deg", machine.axes()[axis].name, format_fixed(low, 2), format_fixed(high, 2))
}
