//! The programs and cutter locations of a milling job: its plan as work for tools, its machine, and the proof of every text by the
//! referee's rays.

use super::bodies::MillingBodies;
use super::programs::{
    CutterLocationText, MillingMachining, MillingPrograms, MillingWork, RayProof, ToolWork,
};
use super::referee::{DEPTH, RefereedFlank, STOCK};
use super::result::ProgramResult;
use crate::exchange::LoadedMillingJob;
use crate::exchange::milling_job::{CutterUse, MillingJob};
use crate::nc::TipControl;
use crate::numerics::Progress;
use crate::process::milling::{MillingPlan, OperationKind};
use crate::removal::NormalRay;
use crate::workflow::finding::RunFailure;
use crate::workflow::programs::machine_of_job;

/// Texts of a run.
#[derive(Clone, Debug, Default)]
pub struct MillingTexts {
    /// Programs, where the job has a machine and names controls.
    pub programs: Option<MillingPrograms>,
    /// What was proven of each.
    pub proofs: Vec<RayProof>,
    /// Cutter locations, where the job wants them.
    pub locations: Option<CutterLocationText>,
}

/// Of the referee's rays every so many are milled again as the texts say; a prime, so that all rows and columns come by.
const PROVEN: usize = 7;

/// The texts of a plan, proven.
///
/// # Errors
/// [`RunFailure`]: a machine or control that cannot do it, a text that leaves another flank.
pub(super) fn texts(
    loaded: &LoadedMillingJob,
    bodies: &MillingBodies,
    plan: &MillingPlan,
    flanks: &[RefereedFlank],
    progress: &dyn Progress,
) -> Result<MillingTexts, RunFailure> {
    let job = &loaded.job;
    let work = work(job, bodies, plan);
    let locations = job.output.cl.then(|| work.cutter_locations()).transpose()?;
    let Some(machine) = job.machine.as_ref().filter(|_| !job.output.programs.is_empty()) else {
        return Ok(MillingTexts { locations, ..MillingTexts::default() });
    };
    let description = machine_of_job(loaded, &machine.file)?;
    let machining = MillingMachining {
        machine: &description,
        mount: machine.mount,
        tool_length: machine.tool_length,
        rtcp: machine.rtcp,
        tip_control: TipControl::Directions,
        position_tolerance: 1e-3 * machine.position_tolerance_um,
        dialects: &job.output.programs,
    };
    let programs = machining.build(&work)?;
    let (mut rays, mut planned) = (Vec::new(), Vec::new());
    for (made, flank) in plan.flanks.iter().zip(flanks) {
        let places = flank.heights.iter().flat_map(|a| flank.lengths.iter().map(move |b| (*a, *b)));
        let judged = places.zip(&flank.simulated).zip(&flank.judged).filter(|(_, judged)| **judged);
        for (((a, b), length), _) in judged.step_by(PROVEN) {
            let jet = made.active.surface.jet(a, b);
            rays.push(NormalRay { point: jet.point, normal: jet.normal });
            planned.push(*length);
        }
    }
    let proofs = programs.prove(&work, &rays, &planned, [STOCK, DEPTH], progress)?;
    Ok(MillingTexts { programs: Some(programs), proofs, locations })
}

/// The plan as work for tools.
fn work<'a>(job: &'a MillingJob, bodies: &MillingBodies, plan: &MillingPlan) -> MillingWork<'a> {
    let milling = &job.milling;
    let roughing_feed = milling.roughing.as_ref().and_then(|roughing| roughing.feed_mm_per_min);
    let tools = plan.operations.iter().map(|operation| {
        let (purpose, feed) = match operation.kind {
            OperationKind::Roughing => (CutterUse::Roughing, roughing_feed),
            OperationKind::Bottom => (CutterUse::Bottom, None),
            OperationKind::Flank(_) | OperationKind::Fillet(_) => (CutterUse::Finishing, None),
        };
        ToolWork {
            kind: operation.kind,
            cutter: bodies.options.cutter_of(operation.kind).clone(),
            number: job.cutter_for(purpose).1,
            spindle_rpm: milling.spindle_rpm,
            feed: feed.unwrap_or(milling.feed_mm_per_min),
            plunge_feed: milling.plunge_feed(),
            paths: operation.paths.clone(),
        }
    });
    MillingWork {
        job: &job.job.name,
        tools: tools.collect(),
        spaces: bodies.milled,
        pitch: bodies.pitch,
        retraction: bodies.retraction,
    }
}

impl MillingTexts {
    /// What the result says of the programs.
    pub(super) fn results(&self) -> Vec<ProgramResult> {
        let Some(programs) = &self.programs else { return Vec::new() };
        let of = |(program, proof): (&super::programs::MillingProgram, &RayProof)| ProgramResult {
            file: program.file.clone(),
            control: program.dialect.name(),
            blocks: program.blocks,
            duration_s: program.motion.cycle_time,
            rounding_um: 1e3 * program.rounding.distance,
            straight_blocks_um: 1e3 * program.motion.straight.tip,
            proof_difference_um: proof.difference_um,
            proof_allowed_um: proof.allowed_um,
        };
        programs.programs.iter().zip(&self.proofs).map(of).collect()
    }
}
