//! The programs and cutter locations of a milling job: its plan as work for tools, its machine, and the proof of every text by the
//! referee's rays.

use super::bodies::MillingBodies;
use super::clamping::{Clamping, TOO_CLOSE};
use super::machine_remarks::remarks;
use super::program_result::{MountTilt, ProgramOperation, ProgramResult};
use super::programs::{
    AtPole, CutterLocationText, MillingMachining, MillingProgram, MillingPrograms, MillingWork, RayProof,
    ToolWork,
};
use super::referee::{DEPTH, RefereedFlank, STOCK, rays as rays_of, swept};
use super::whole_program::{ProgramUnderTest, text_tolerance};
use crate::job::{CutterUse, MillingJob, MillingMachine, PoleWay};
use crate::{MillingPlan, OperationKind};
use foundation::numerics::Progress;
use job::machine::LoadedMachine;
use job::tables::Program as DialectName;
use nc::TipControl;
use run::RunFailure;
use run::program_check::{PartProof, dialects};
use verdict::{Remark, Verdict};

/// Texts of a run.
#[derive(Clone, Debug, Default)]
pub struct MillingTexts {
    /// Programs, where the job has a machine and names controls.
    pub programs: Option<MillingPrograms>,
    /// The machine that they are for.
    pub machine: Option<LoadedMachine>,
    /// What was proven of each.
    pub proofs: Vec<RayProof>,
    /// What each does to the whole part.
    pub parts: Vec<PartProof>,
    /// Cutter locations, where the job wants them.
    pub locations: Option<CutterLocationText>,
}

/// Of the referee's rays every so many are milled again as the texts say; a prime, so that all rows and columns come by.
const PROVEN: usize = 7;

/// The machine of a job and the options of its control.
pub(super) fn machining<'a>(
    given: &MillingMachine,
    machine: &'a LoadedMachine,
    dialects: &'a [DialectName],
) -> MillingMachining<'a> {
    let cap = given.pole_cap_deg.to_radians();
    MillingMachining {
        machine,
        mount: given.mount,
        tool_length: given.tool_length,
        rtcp: given.rtcp,
        tip_control: TipControl::Directions,
        position_tolerance: 1e-3 * given.position_tolerance_um,
        at_pole: match given.pole {
            PoleWay::Slow => AtPole::Slow { cap },
            PoleWay::Hold => AtPole::Hold { cap },
            PoleWay::Mount => AtPole::Mount { cap },
        },
        dialects,
    }
}

/// The texts of a plan, proven; programs for the dialects that the job names, else for all controls of its machine.
///
/// # Errors
/// [`RunFailure`]: a machine or control that cannot do it, a text that leaves another flank.
pub(super) fn texts(
    job: &MillingJob,
    machine: Option<LoadedMachine>,
    bodies: &MillingBodies,
    plan: &MillingPlan,
    flanks: &[RefereedFlank],
    progress: &dyn Progress,
) -> Result<MillingTexts, RunFailure> {
    let work = work(job, bodies, plan);
    let locations = job.output.cl.then(|| work.cutter_locations()).transpose()?;
    let (Some(given), Some(machine)) = (&job.machine, machine) else {
        return Ok(MillingTexts { locations, ..MillingTexts::default() });
    };
    let dialects = dialects(&job.output.programs, &machine);
    let programs = machining(given, &machine, &dialects).build(&work)?;
    let (mut rays, mut planned) = (Vec::new(), Vec::new());
    for (made, flank) in plan.flanks.iter().zip(flanks) {
        let all = rays_of(made, &flank.heights, &flank.lengths)
            .into_iter()
            .zip(&flank.simulated)
            .zip(&flank.judged);
        for ((ray, length), _) in all.filter(|(_, judged)| **judged).step_by(PROVEN) {
            rays.push(ray);
            planned.push(*length);
        }
    }
    let proofs = programs.prove(&work, &rays, &planned, [STOCK, DEPTH], progress)?;
    let cutters = work.cutters();
    let of_program = |program: &MillingProgram| {
        let (moves, tool_length) = (program.moves(), given.tool_length);
        let tolerance = text_tolerance(job, given);
        let paths = work.paths(moves);
        let swept = &swept(&cutters, &paths, STOCK)?;
        let clamping = Clamping::of_job(given);
        ProgramUnderTest { bodies, plan, work: &work, moves, swept, tool_length, tolerance, clamping }
            .prove(progress)
    };
    let parts = programs.programs.iter().map(of_program).collect::<Result<Vec<_>, _>>()?;
    Ok(MillingTexts { programs: Some(programs), machine: Some(machine), proofs, parts, locations })
}

/// Which cutter of the job does an operation, and how fast, mm/min.
pub(super) fn purpose_and_feed(job: &MillingJob, kind: OperationKind) -> (CutterUse, f64) {
    let feed = job.milling.feed_mm_per_min;
    match kind {
        OperationKind::Roughing => {
            let own = job.milling.roughing.as_ref().and_then(|roughing| roughing.feed_mm_per_min);
            (CutterUse::Roughing, own.unwrap_or(feed))
        }
        OperationKind::Bottom => (CutterUse::Bottom, feed),
        OperationKind::Flank(_) | OperationKind::Fillet(_) => (CutterUse::Finishing, feed),
    }
}

/// The plan as work for tools.
pub(super) fn work<'a>(job: &'a MillingJob, bodies: &MillingBodies, plan: &MillingPlan) -> MillingWork<'a> {
    let milling = &job.milling;
    let tools = plan.operations.iter().map(|operation| {
        let (purpose, feed) = purpose_and_feed(job, operation.kind);
        ToolWork {
            kind: operation.kind,
            cutter: bodies.options.cutter_of(operation.kind).clone(),
            number: job.cutter_for(purpose).1,
            spindle_rpm: milling.spindle_rpm,
            feed,
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
    /// Notes what was proven of the texts.
    pub(super) fn judge(&self, verdict: &mut Verdict) {
        if self.programs.is_none() {
            verdict.leave("spindle, clamping and parts of the machine", "the job names no machine");
            return verdict.leave("programs", "the job names no machine");
        }
        for proof in &self.proofs {
            let control = proof.dialect.name();
            let detail = format!("{:.4} um from those of the plan", proof.difference_um);
            verdict.met(format!("program for {control}: flanks of the first space"), detail);
        }
        for (proof, part) in self.proofs.iter().zip(&self.parts) {
            let item = format!("program for {}: whole part and rapid moves", proof.dialect.name());
            let mut faults = part.faults.iter().filter(|fault| fault.code != TOO_CLOSE);
            match faults.next() {
                None => verdict.met(
                    item,
                    format!(
                        "{} spaces under {} rays, {} rapid moves",
                        part.spaces[0], part.rays, part.rapid_moves
                    ),
                ),
                Some(fault) => {
                    let detail = format!("{} faults in the text", 1 + faults.count());
                    verdict.missed(item, detail, Remark::new(fault.code, fault.text.clone(), fault.way_out));
                }
            }
        }
        for (proof, part) in self.proofs.iter().zip(&self.parts) {
            let Some(nearest) = part.clamping.first() else { continue };
            let item = format!(
                "program for {}: tool, holder and spindle against the clamping",
                proof.dialect.name()
            );
            match part.faults.iter().find(|fault| fault.code == TOO_CLOSE) {
                None => verdict.met(item, format!("{:.2} mm to {} or more", nearest.least_mm, nearest.body)),
                Some(fault) => {
                    let detail = format!("{:.2} mm to {}", nearest.least_mm, nearest.body);
                    verdict.missed(item, detail, Remark::new(fault.code, fault.text.clone(), fault.way_out));
                }
            }
        }
        for left in self.parts.first().iter().flat_map(|part| &part.not_covered) {
            verdict.leave(format!("programs: {left}"), "the proof does not cover it");
        }
    }

    /// What the result says of the programs.
    pub(super) fn results(&self) -> Vec<ProgramResult> {
        let (Some(programs), Some(machine)) = (&self.programs, &self.machine) else { return Vec::new() };
        let of = |((program, proof), part): ((&MillingProgram, &RayProof), &PartProof)| {
            let motion = &*program.motion;
            let operations = motion.operations.iter().enumerate();
            ProgramResult {
                file: program.file.clone(),
                control: program.dialect.name(),
                blocks: program.blocks,
                duration_s: motion.cycle_time,
                one_space_s: motion.first_space_seconds(None),
                operations: operations
                    .map(|(number, figures)| ProgramOperation {
                        name: figures.kind.to_string(),
                        tool: figures.tool,
                        blocks: figures.blocks,
                        cutting_s: figures.cutting,
                        rapid_s: figures.rapid,
                        one_space_s: motion.first_space_seconds(Some(number)),
                        limited_by: figures.limits.clone(),
                        rotary_travel_deg: figures.rotary_travel.map(f64::to_degrees),
                        turned_back: figures.rewinds,
                    })
                    .collect(),
                mount_tilt: programs.tilt.map(|tilt| MountTilt {
                    axis: tilt.axis.xyz.into(),
                    angle_deg: tilt.angle.to_degrees(),
                    pole_distance_deg: tilt.least.to_degrees(),
                }),
                remarks: remarks(&machine.machine, programs, motion),
                rounding_um: 1e3 * program.rounding.distance,
                straight_blocks_um: 1e3 * motion.straight.tip,
                proof_difference_um: proof.difference_um,
                proof_allowed_um: proof.allowed_um,
                part: part.clone(),
            }
        };
        programs.programs.iter().zip(&self.proofs).zip(&self.parts).map(of).collect()
    }
}
