//! The programs and cutter locations of a milling run, the proof of every text by the referee's rays, and what verdict and result state
//! of them.

use super::clamping::{Clamping, TOO_CLOSE};
use super::machine_remarks::remarks;
use super::prepare::PreparedMilling;
use super::program_result::{MountTilt, ProgramOperation, ProgramResult};
use super::programs::{ClockingCycle, CutterLocationText, MillingProgram, MillingPrograms, RayProof};
use super::referee::{DEPTH, RefereedFlank, STOCK, rays as rays_of, swept};
use super::whole_program::{ProgramUnderTest, text_tolerance};
use super::work::{machining, work};
use crate::MillingPlan;
use foundation::numerics::Progress;
use job::machine::LoadedMachine;
use run::RunFailure;
use run::program_check::{PartProof, dialects};
use verdict::{Remark, Verdict};

/// Texts of a run.
#[derive(Clone, Debug, Default)]
pub struct MillingTexts {
    /// Programs, where the job has a machine and names controls.
    pub programs: Option<MillingPrograms>,
    /// What was proven of each.
    pub proofs: Vec<RayProof>,
    /// What each does to the whole part.
    pub parts: Vec<PartProof>,
    /// Programs that find the clocking angle, where the job has a probe.
    pub cycles: Vec<ClockingCycle>,
    /// Cutter locations, where the job wants them.
    pub locations: Option<CutterLocationText>,
}

/// Of the referee's rays every so many are milled again as the texts say; a prime, so that all rows and columns come by.
const PROVEN: usize = 7;

/// The texts of a plan, proven; programs for the dialects that the job names, else for all controls of its machine.
///
/// # Errors
/// [`RunFailure`]: a machine or control that cannot do it, a text that leaves another flank.
pub(super) fn texts(
    prepared: &PreparedMilling,
    plan: &MillingPlan,
    flanks: &[RefereedFlank],
    progress: &dyn Progress,
) -> Result<MillingTexts, RunFailure> {
    let work = work(prepared, plan);
    let locations = prepared.output.cl.then(|| work.cutter_locations()).transpose()?;
    let (Some(mounting), Some(machine)) = (&prepared.mounting, &prepared.machine) else {
        return Ok(MillingTexts { locations, ..MillingTexts::default() });
    };
    let dialects = dialects(&prepared.output.programs, machine);
    let machining = machining(mounting, machine, &dialects);
    let programs = machining.build(&work)?;
    let cycles = match &mounting.probe {
        Some(probe) => machining.clocking_cycles(&work, &prepared.bodies, probe)?,
        None => Vec::new(),
    };
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
        let moves = program.moves();
        let paths = work.paths(moves);
        let swept = &swept(&cutters, &paths, STOCK)?;
        ProgramUnderTest {
            bodies: &prepared.bodies,
            plan,
            work: &work,
            moves,
            swept,
            tool_length: work.longest_tool(),
            tolerance: text_tolerance(prepared, mounting),
            clamping: Clamping::of_mounting(mounting),
        }
        .prove(progress)
    };
    let parts = programs.programs.iter().map(of_program).collect::<Result<Vec<_>, _>>()?;
    Ok(MillingTexts { programs: Some(programs), proofs, parts, cycles, locations })
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
        for cycle in &self.cycles {
            let detail = format!(
                "an angle of {:.3} deg either way comes out within {:.6} deg",
                cycle.tried.to_degrees(),
                cycle.off.to_degrees()
            );
            verdict.met(format!("clocking program for {}", cycle.dialect.name()), detail);
        }
        for left in self.parts.first().iter().flat_map(|part| &part.not_covered) {
            verdict.leave(format!("programs: {left}"), "the proof does not cover it");
        }
    }

    /// What the result says of the programs and of their machine.
    pub(super) fn results(&self, machine: Option<&LoadedMachine>) -> Vec<ProgramResult> {
        let (Some(programs), Some(machine)) = (&self.programs, machine) else { return Vec::new() };
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
