//! Tools, offsets and lengths as the shop floor has them.

use crate::job::{CutterUse, LengthHolder, MillingJob, MillingMount, Rtcp, StockForm};
use job::checks::contradiction;
use job::{Diagnostic, Problem, shown_number};

pub(super) fn check(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    lengths(job, findings);
    roughing_feed(job, findings);
    clocking(job, findings);
    leads(job, findings);
    stock(job, findings);
    probe(job, findings);
    measured_halves(job, findings);
    let drawn = job.gear.is_some() || job.bevel.is_some();
    if job.compensation.is_some() && !drawn {
        findings.push(contradiction(
            "a compensation is made of modifications, which gears and bevel gears have",
            "compensation",
            "a table".into(),
            "no table, or a [gear] or [bevel]",
            "leave [compensation] out",
        ));
    }
    if job.measuring_grid.is_some() && job.bevel.is_none() {
        findings.push(contradiction(
            "a grid of points is how bevel gears are measured",
            "measuring_grid",
            "a table".into(),
            "no table, or a [bevel]",
            "leave [measuring_grid] out; profiles and helix traces of a [gear] are measured as its `evaluation` has them",
        ));
    }
}

/// A grid lies on flanks that reach from the toe to the heel.
fn measured_halves(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    if job.measuring_grid.is_some() && job.bevel.as_ref().is_some_and(|bevel| bevel.double_helical.is_some())
    {
        findings.push(contradiction(
            "the grid of a bevel gear reaches over flanks from toe to heel, and a double-helical gear has halves",
            "measuring_grid",
            "a table beside bevel.double_helical".into(),
            "no table with bevel.double_helical",
            "leave [measuring_grid] out",
        ));
    }
}

/// Every tool has a number of its own for its length.
fn lengths(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let given = [
        (CutterUse::Finishing, "cutter", true),
        (CutterUse::Bottom, "bottom_cutter", job.bottom_cutter.is_some()),
        (CutterUse::Roughing, "roughing_cutter", job.roughing_cutter.is_some()),
    ];
    let mut seen: Vec<(u32, &str, bool)> = Vec::new();
    for (purpose, table, given) in given {
        let (cutter, number) = job.cutter_for(purpose);
        if !given {
            continue;
        }
        // On Siemens every tool has its own numbers.
        let own = cutter.length_offset.unwrap_or(number.min(MOST_LENGTHS));
        let other =
            seen.iter().find(|(known, _, named)| *known == own && (*named || cutter.length_offset.is_some()));
        if let Some((_, other, _)) = other {
            let field = if cutter.length_offset.is_some() { table } else { other };
            findings.push(contradiction(
                "two tools have the same number for their lengths",
                format!("{field}.length_offset"),
                own.to_string(),
                "another number for each tool; without the key that of the tool",
                "give each tool a number of its own, or leave `length_offset` out",
            ));
        }
        seen.push((own, table, cutter.length_offset.is_some()));
    }
}

fn leads(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let milling = &job.milling;
    for (key, given) in [("lead_in", milling.lead_in), ("lead_out", milling.lead_out)] {
        if let (Some(_), Some(radius)) = (given, milling.approach_radius) {
            findings.push(contradiction(
                &format!("`approach_radius` stands beside `{key}`"),
                "milling.approach_radius",
                shown_number(radius),
                "no key, or neither of `lead_in` and `lead_out`",
                "keep the tables: they say how the cutter comes and leaves",
            ));
            return;
        }
    }
}

fn stock(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let Some(stock) = &job.stock else { return };
    match (stock.form, &job.milling.roughing) {
        (StockForm::Solid, None) => findings.push(contradiction(
            "a solid blank is finished without being cleared before",
            "stock.form",
            "\"solid\"".into(),
            "\"pre-cut\", or a table [milling.roughing]",
            "add [milling.roughing], or take \"pre-cut\" where another machine clears the spaces",
        )),
        (StockForm::PreCut, Some(_)) => findings.push(contradiction(
            "spaces that are cut already are cleared again",
            "stock.form",
            "\"pre-cut\"".into(),
            "\"solid\", or no table [milling.roughing]",
            "leave [milling.roughing] out, or take \"solid\"",
        )),
        _ => {}
    }
    if stock.form == StockForm::PreCut && stock.allowance.is_none() {
        let text = "a pre-cut part has an allowance on its flanks that is not given";
        findings.push(
            Diagnostic::new(Problem::MissingKey, text)
                .field("stock.allowance")
                .allowed("0 to 5 mm")
                .way_out("add `allowance = ...`, normal to the flanks"),
        );
    }
    let of_pre_cut = [("allowance", stock.allowance), ("clocking_error_deg", stock.clocking_error_deg)];
    for (key, given) in of_pre_cut {
        if let (StockForm::Solid, Some(value)) = (stock.form, given) {
            findings.push(contradiction(
                &format!("`{key}` is that of a pre-cut part"),
                format!("stock.{key}"),
                shown_number(value),
                "no key, or form = \"pre-cut\"",
                "leave it out: roughing leaves milling.roughing.allowance",
            ));
        }
    }
}

fn probe(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let Some((machine, probe)) = job.machine.as_ref().and_then(|machine| Some((machine, machine.probe?)))
    else {
        return;
    };
    if !machine.work_offset.is_some_and(|offset| offset.clocking) {
        findings.push(contradiction(
            "a clocking angle is probed that the control does not hold",
            "machine.probe",
            "a table".into(),
            "no table, or machine.work_offset with clocking = true",
            "add `clocking = true` to machine.work_offset, or leave `probe` out",
        ));
    }
    if job.blade.is_some() {
        findings.push(contradiction(
            "the space beside a blade has one flank only, between which nothing is probed",
            "machine.probe",
            "a table".into(),
            "no table, or a [gear] or [bevel]",
            "leave `probe` out",
        ));
    }
    let tables = [CutterUse::Finishing, CutterUse::Bottom, CutterUse::Roughing];
    if tables.into_iter().any(|purpose| job.cutter_for(purpose).1 == probe.number) {
        findings.push(contradiction(
            "the probe has the number of a cutter",
            "machine.probe.number",
            probe.number.to_string(),
            "a number that no cutter has",
            "give the number of the probe in the machine's store",
        ));
    }
    if let Some(stem) = probe.stem_diameter.filter(|stem| *stem >= probe.diameter) {
        findings.push(contradiction(
            "the stem of the probe is as thick as its ball",
            "machine.probe.stem_diameter",
            shown_number(stem),
            &format!("< {}, the diameter of the ball", shown_number(probe.diameter)),
            "give the diameter of the stem, or leave it out",
        ));
    }
}

/// Numbers that controls have for lengths.
const MOST_LENGTHS: u32 = 999;

fn roughing_feed(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let of_operation = job.milling.roughing.as_ref().and_then(|roughing| roughing.feed_mm_per_min);
    let of_cutter = job.roughing_cutter.as_ref().and_then(|cutter| cutter.feed_mm_per_min);
    if let (Some(_), Some(feed)) = (of_operation, of_cutter) {
        findings.push(contradiction(
            "`roughing_cutter.feed_mm_per_min` stands beside `milling.roughing.feed_mm_per_min`",
            "roughing_cutter.feed_mm_per_min",
            shown_number(feed),
            "at most one of both",
            "keep one of them",
        ));
    }
}

fn clocking(job: &MillingJob, findings: &mut Vec<Diagnostic>) {
    let Some(machine) = &job.machine else { return };
    let MillingMount { offset: [x, y], .. } = machine.mount;
    let held = machine.work_offset.is_some_and(|offset| offset.clocking);
    if held && (x != 0.0 || y != 0.0) {
        findings.push(contradiction(
            "the control cannot hold the clocking angle of a workpiece that stands beside the axis of the table",
            "machine.work_offset.clocking",
            "true".into(),
            "false, or machine.mount.offset = [0, 0]",
            "leave `clocking` out: the program then holds the angle",
        ));
    }
    if machine.tool_length_in == LengthHolder::Control
        && machine.rtcp == Rtcp::On
        && job.output.programs.iter().all(|program| *program != job::tables::Program::Linuxcnc)
        && !job.output.programs.is_empty()
    {
        findings.push(contradiction(
            "under tip control the control holds the lengths of tools anyway",
            "machine.tool_length_in",
            "\"control\"".into(),
            "no key, or rtcp = \"off\" or \"rows\", or a program for LinuxCNC",
            "leave `tool_length_in` out",
        ));
    }
}
