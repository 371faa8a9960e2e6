//! The measuring programs of a run, and what they are made from.

use super::prepare::{CalibrationOutcome, PreparedSkiving, ToolMounting};
use super::probe;
use super::programs::{
    CalibrationWork, Carried, Carrier, MeasuringWork, ProbeWork, Retreat, ScanWork, SkivingWork,
    ToolMachining, ToolProgram, calibration_programs, measuring_programs, probe_programs, scan_programs,
    skiving_programs,
};
use super::scan::Scan;
use crate::job::{BarrierCarrier, Stylus, WorkpieceProbe};
use foundation::geometry::Sides;
use foundation::numerics::Progress;
use job::machine::LoadedMachine;
use job::{Diagnostic, Problem};
use machine::{Joint, Station};
use run::RunFailure;

/// Speed at which the tool goes to the beam and back, mm/s.
const RETREAT_SPEED: f64 = 50.0;

/// Programs at the light barrier, then those of the stylus; none without `[machine]`.
///
/// # Errors
/// [`RunFailure`]: a machine that does not reach a pose, a text that is not proven.
pub(super) fn programs(
    prepared: &PreparedSkiving,
    (scan, stroke): (Option<&Scan>, Option<&SkivingWork<'_>>),
    progress: &dyn Progress,
) -> Result<Vec<ToolProgram>, RunFailure> {
    let (Some(mounting), Some(machine)) = (&prepared.mounting, &prepared.machine) else {
        return Ok(Vec::new());
    };
    if prepared.output.programs.is_empty() {
        return Ok(Vec::new());
    }
    progress.start("programs", 1);
    let machining = machining(prepared, mounting, machine)?;
    let mut programs = measuring_programs(&measuring_work(prepared), &machining)?;
    if let Some(calibration) = &prepared.bodies.calibration {
        let work = calibration_work(prepared, calibration, mounting);
        programs.extend(calibration_programs(&work, &machining)?);
    }
    if let (Some(given), Some(scan)) = (&prepared.stylus, scan) {
        programs.extend(scan_programs(&scan_work(prepared, given, scan), &machining)?);
    }
    if let Some(given) = &prepared.probe {
        let lengths = probe::lengths(&prepared.bodies, given.places);
        programs.extend(probe_programs(&probe_work(prepared, given, &lengths), &machining)?);
    }
    if let Some(stroke) = stroke {
        programs.extend(skiving_programs(stroke, &machining)?);
    }
    progress.advance(1);
    progress.finish();
    Ok(programs)
}

/// A machine with the tool in it.
///
/// # Errors
/// [`RunFailure`] for a carrier that the machine does not have.
pub(super) fn machining<'a>(
    prepared: &'a PreparedSkiving,
    mounting: &ToolMounting,
    machine: &'a LoadedMachine,
) -> Result<ToolMachining<'a>, RunFailure> {
    let carrier = mounting.carrier.as_ref().map(|given| carrier(given, machine)).transpose()?;
    Ok(ToolMachining {
        machine,
        mount: mounting.mount,
        carrier,
        retreat: Retreat { distance: mounting.retreat, direction: None, speed: RETREAT_SPEED },
        output: mounting.output,
        dialects: &prepared.output.programs,
    })
}

/// The carrier of a job on its machine.
fn carrier(given: &BarrierCarrier, loaded: &LoadedMachine) -> Result<Carrier, RunFailure> {
    let machine = &loaded.machine;
    let refused = |key: &str, value: String, text: String, allowed: String, way_out: &str| {
        let finding = Diagnostic::new(Problem::InvalidJob, text).field(format!("machine.carrier{key}"));
        RunFailure::bad_input(finding.value(value).allowed(allowed).way_out(way_out))
    };
    let tool = &machine.tool().axes;
    // What stands behind an axis of the workpiece's chain is carried by it; the spindle itself carries the workpiece only.
    let work = machine.station(Station::Work).map(|limb| limb.axes.clone()).unwrap_or_default();
    let carriers: Vec<usize> = tool
        .first()
        .copied()
        .into_iter()
        .chain(work[..work.len().saturating_sub(1)].iter().copied())
        .collect();
    let named = machine.axis_named(&given.axis).filter(|axis| carriers.contains(axis));
    let Some(axis) = named else {
        let names: Vec<&str> = carriers.iter().map(|&axis| machine.axes()[axis].name.as_str()).collect();
        return Err(refused(
            ".axis",
            format!("{:?}", given.axis),
            format!("{} carries neither a light barrier nor the whole tool", given.axis),
            names.join(", "),
            "name the axis that carries the light barrier beside the work spindle, or the first axis of the tool's chain",
        ));
    };
    let described = &machine.axes()[axis];
    let places = match described.joint {
        Joint::Rotary => [given.measuring_deg, given.parked_deg],
        Joint::Linear => [given.measuring, given.parked],
    };
    let [Some(measuring), Some(parked)] = places else {
        let (found, allowed) = match described.joint {
            Joint::Rotary => ("mm", "measuring_deg and parked_deg"),
            Joint::Linear => ("deg", "measuring and parked"),
        };
        return Err(refused(
            "",
            format!("places in {found}"),
            format!("{} moves the other way", described.name),
            allowed.into(),
            "give the places in the unit of the axis",
        ));
    };
    for (key, value) in [("measuring", measuring), ("parked", parked)] {
        let suffix = if described.joint == Joint::Rotary { "_deg" } else { "" };
        if let Some(error) = described.beyond(described.joint.from_shown(value)) {
            let [least, most] = described.travel.unwrap_or_default().map(|end| described.joint.shown(end));
            return Err(refused(
                &format!(".{key}{suffix}"),
                value.to_string(),
                error.to_string(),
                format!("{least} to {most}"),
                "give a place within the travel of the carrier",
            ));
        }
    }
    let carries = if tool.contains(&axis) { Carried::Tool } else { Carried::Barrier };
    let [measuring, parked] = [measuring, parked].map(|value| described.joint.from_shown(value));
    Ok(Carrier { axis, measuring, parked, carries })
}

/// What is measured at the light barrier.
pub(super) fn measuring_work(prepared: &PreparedSkiving) -> MeasuringWork<'_> {
    let PreparedSkiving { bodies, recording, .. } = prepared;
    MeasuringWork {
        name: &prepared.info.name,
        flanks: &bodies.flanks,
        beam: &bodies.beam,
        senses: recording.senses,
        revolutions: recording.revolutions,
        speed: bodies.barrier.speed,
    }
}

/// What is driven into the light barrier: towards the beam as the job gives it, or as its switches tell.
pub(super) fn calibration_work<'a>(
    prepared: &'a PreparedSkiving,
    calibration: &'a CalibrationOutcome,
    mounting: &ToolMounting,
) -> CalibrationWork<'a> {
    let drive = &calibration.drive;
    CalibrationWork {
        name: &prepared.info.name,
        beam: &prepared.bodies.beam,
        mandrel: &drive.mandrel,
        heights: drive.heights,
        length: drive.length.unwrap_or(mounting.mount.axial),
        spindle_positions: drive.spindle_positions,
        speed: drive.speed,
        reach: drive.reach,
    }
}

/// What a probe scans of the workpiece.
pub(super) fn probe_work<'a>(
    prepared: &'a PreparedSkiving,
    given: &'a WorkpieceProbe,
    lengths: &'a Sides<Vec<f64>>,
) -> ProbeWork<'a> {
    let gear = &prepared.drawn.gear;
    ProbeWork {
        name: &prepared.info.name,
        bodies: &prepared.bodies,
        gaps: &given.gaps,
        lengths,
        ball_radius: given.ball_radius,
        length: given.length,
        reach: given.reach,
        orientation: [given.swivel_deg, given.spindle_deg].map(f64::to_radians),
        height: given.height,
        work_height: given.work_height,
        tip_radius: 0.5 * gear.tip_diameter,
        speed: given.speed_mm_per_min / 60.0,
        clearance: given.clearance,
    }
}

/// What is scanned.
pub(super) fn scan_work<'a>(
    prepared: &'a PreparedSkiving,
    given: &'a Stylus,
    scan: &'a Scan,
) -> ScanWork<'a> {
    ScanWork {
        name: &prepared.info.name,
        edges: &prepared.bodies.edges,
        stylus: &scan.stylus,
        axes: scan.axes,
        range: scan.range,
        places: given.places,
        teeth: &given.teeth,
        speed: given.speed_mm_per_min / 60.0,
    }
}
