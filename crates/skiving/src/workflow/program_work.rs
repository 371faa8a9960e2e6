//! From a job to its measuring programs.

use super::prepare::SkivingBodies;
use super::programs::{
    MeasuringWork, Retreat, ScanWork, ToolMachining, ToolProgram, measuring_programs, scan_programs,
};
use super::scan::Scan;
use crate::job::{LoadedSkivingJob, SkivingJob, SkivingMachine, Stylus};
use foundation::numerics::Progress;
use job::machine::LoadedMachine;
use machine::Mount;
use run::RunFailure;
use run::program_check::machine_of_job;

/// Speed at which the tool goes to the beam and back, mm/s.
const RETREAT_SPEED: f64 = 50.0;

/// Programs at the light barrier, then those of the stylus; none without `[machine]`.
///
/// # Errors
/// [`RunFailure`]: a machine that does not reach a pose, a text that is not proven.
pub(super) fn programs(
    loaded: &LoadedSkivingJob,
    bodies: &SkivingBodies,
    scan: Option<&Scan>,
    progress: &dyn Progress,
) -> Result<Vec<ToolProgram>, RunFailure> {
    let job = &loaded.job;
    let Some(given) = &job.machine else { return Ok(Vec::new()) };
    let machine = machine_of_job(&loaded.document, &given.file)?;
    if job.output.programs.is_empty() {
        return Ok(Vec::new());
    }
    progress.start("programs", 1);
    let machining = machining(job, given, &machine);
    let mut programs = measuring_programs(&measuring_work(job, bodies), &machining)?;
    if let (Some(given), Some(scan)) = (&job.stylus, scan) {
        programs.extend(scan_programs(&scan_work(job, bodies, given, scan), &machining)?);
    }
    progress.advance(1);
    progress.finish();
    Ok(programs)
}

/// The machine of a job, and how its tool sits in it.
pub(super) fn machining<'a>(
    job: &'a SkivingJob,
    given: &SkivingMachine,
    machine: &'a LoadedMachine,
) -> ToolMachining<'a> {
    ToolMachining {
        machine,
        mount: Mount { reversed: false, axial: given.tool_length, angle: given.tooth_angle_deg.to_radians() },
        retreat: Retreat { distance: given.retreat, direction: None, speed: RETREAT_SPEED },
        output: given.output,
        dialects: &job.output.programs,
    }
}

/// What a job measures at the light barrier.
pub(super) fn measuring_work<'a>(job: &'a SkivingJob, bodies: &'a SkivingBodies) -> MeasuringWork<'a> {
    MeasuringWork {
        job: &job.job.name,
        flanks: &bodies.flanks,
        beam: &bodies.beam,
        senses: job.measuring.senses.list(),
        revolutions: job.measuring.revolutions,
        speed: bodies.barrier.speed,
    }
}

/// What a job scans.
pub(super) fn scan_work<'a>(
    job: &'a SkivingJob,
    bodies: &'a SkivingBodies,
    given: &'a Stylus,
    scan: &'a Scan,
) -> ScanWork<'a> {
    ScanWork {
        job: &job.job.name,
        edges: &bodies.edges,
        stylus: &scan.stylus,
        axes: scan.axes,
        range: scan.range,
        places: given.places,
        teeth: &given.teeth,
        speed: given.speed_mm_per_min / 60.0,
    }
}
