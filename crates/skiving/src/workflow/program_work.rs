//! The measuring programs of a run, and what they are made from.

use super::prepare::{PreparedSkiving, ToolMounting};
use super::programs::{
    MeasuringWork, Retreat, ScanWork, ToolMachining, ToolProgram, measuring_programs, scan_programs,
};
use super::scan::Scan;
use crate::job::Stylus;
use foundation::numerics::Progress;
use job::machine::LoadedMachine;
use run::RunFailure;

/// Speed at which the tool goes to the beam and back, mm/s.
const RETREAT_SPEED: f64 = 50.0;

/// Programs at the light barrier, then those of the stylus; none without `[machine]`.
///
/// # Errors
/// [`RunFailure`]: a machine that does not reach a pose, a text that is not proven.
pub(super) fn programs(
    prepared: &PreparedSkiving,
    scan: Option<&Scan>,
    progress: &dyn Progress,
) -> Result<Vec<ToolProgram>, RunFailure> {
    let (Some(mounting), Some(machine)) = (&prepared.mounting, &prepared.machine) else {
        return Ok(Vec::new());
    };
    if prepared.output.programs.is_empty() {
        return Ok(Vec::new());
    }
    progress.start("programs", 1);
    let machining = machining(prepared, mounting, machine);
    let mut programs = measuring_programs(&measuring_work(prepared), &machining)?;
    if let (Some(given), Some(scan)) = (&prepared.stylus, scan) {
        programs.extend(scan_programs(&scan_work(prepared, given, scan), &machining)?);
    }
    progress.advance(1);
    progress.finish();
    Ok(programs)
}

/// A machine with the tool in it.
pub(super) fn machining<'a>(
    prepared: &'a PreparedSkiving,
    mounting: &ToolMounting,
    machine: &'a LoadedMachine,
) -> ToolMachining<'a> {
    ToolMachining {
        machine,
        mount: mounting.mount,
        retreat: Retreat { distance: mounting.retreat, direction: None, speed: RETREAT_SPEED },
        output: mounting.output,
        dialects: &prepared.output.programs,
    }
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
