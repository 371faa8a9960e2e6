//! The proof: what the texts say goes through reader, axes and forward kinematics to the bodies, and from there to the referee.

use super::build::{Built, BuiltProgram};
use super::result::{FlankProof, ProofResult};
use super::task::ProgramTask;
use crate::exchange::Diagnostic;
use crate::geometry::Sides;
use crate::kinematics::{DressingMotion, GeneratingMotion};
use crate::machine::Station;
use crate::metrology::Topography;
use crate::motion::{MotionError, ReadStroke, track};
use crate::nc::{Block, Dialect};
use crate::workflow::finding::RunFailure;
use std::collections::BTreeMap;

/// The finishing strokes that the texts of one control say, in the order of the run's strokes.
#[derive(Clone, Debug)]
pub struct ReadBack {
    /// Dressing.
    pub dressing: Vec<ReadStroke<DressingMotion>>,
    /// Grinding.
    pub grinding: Vec<ReadStroke<GeneratingMotion>>,
}

/// What the referee's own surface and solution may add to a comparison of two of its runs, um.
const MARGIN_UM: f64 = 0.005;
/// Chords count twice: as they stand, and with their corners rounded.
const CHORDS: f64 = 2.0;

fn not_followed(program: &BuiltProgram, error: &MotionError) -> RunFailure {
    let finding = Diagnostic::with_code(error.code(), format!("{}: {error}", program.file));
    RunFailure::not_producible(finding.field("machine").way_out(error.way_out()))
}

/// The blocks of a program that bear on its motion: neither comments nor the speed of a dresser, which is a body of revolution.
fn moves(program: &BuiltProgram) -> impl Iterator<Item = &Block> {
    let dressing = program.station == Station::Dresser;
    program.read.iter().filter(move |block| match block {
        Block::Comment(_) => false,
        Block::Spindle { .. } => !dressing,
        _ => true,
    })
}

/// The finishing strokes of a control's programs.
fn read_back(task: &ProgramTask<'_>, programs: &[&BuiltProgram]) -> Result<ReadBack, RunFailure> {
    let machine = &task.machine.machine;
    let mut found = ReadBack { dressing: Vec::new(), grinding: Vec::new() };
    for program in programs {
        let refused = |error: MotionError| not_followed(program, &error);
        let tracked = track(&program.read, machine, &program.words, &program.start).map_err(refused)?;
        let absent = |place: usize, strokes: usize| {
            refused(MotionError::NotFollowed {
                block: program.read.len(),
                reason: format!("stroke {} is missing; {strokes} are there", place + 1),
            })
        };
        for (k, &place) in program.finishing.iter().enumerate() {
            match program.station {
                Station::Dresser => {
                    let chain = &task.dressing[k].motion.chain;
                    let mut strokes =
                        tracked.dressing(machine, &task.technology.dressing, chain).map_err(refused)?;
                    let there = strokes.len();
                    if place >= there {
                        return Err(absent(place, there));
                    }
                    found.dressing.push(strokes.swap_remove(place));
                }
                Station::Work => {
                    let work = &task.grinding[k];
                    let mut strokes = tracked
                        .grinding(machine, &task.technology.grinding, &work.motion, work.phase)
                        .map_err(refused)?;
                    let there = strokes.len();
                    if place >= there {
                        return Err(absent(place, there));
                    }
                    found.grinding.push(strokes.swap_remove(place));
                }
            }
        }
    }
    Ok(found)
}

/// Proves the programs of every control; equal texts of different controls are proven once. `simulate` runs the referee on what was
/// read, `simulated` and `target` are its flanks of the run itself.
///
/// # Errors
/// A text that cannot be followed; a flank that differs from that of the run by more than blocks and digits explain: then nothing is
/// written.
pub(in crate::workflow) fn proofs(
    task: &ProgramTask<'_>,
    built: &Built,
    [target, simulated]: [&Sides<Option<Topography>>; 2],
    mut simulate: impl FnMut(&ReadBack) -> Result<Sides<Option<Topography>>, RunFailure>,
) -> Result<Vec<ProofResult>, RunFailure> {
    let mut proven: Vec<(Vec<&BuiltProgram>, ProofResult)> = Vec::new();
    for dialect in Dialect::ALL {
        let programs: Vec<&BuiltProgram> = built.programs.iter().filter(|p| p.dialect == dialect).collect();
        if programs.is_empty() {
            continue;
        }
        let same = |known: &[&BuiltProgram]| {
            known.len() == programs.len()
                && known
                    .iter()
                    .zip(&programs)
                    .all(|(a, b)| a.words.numbers == b.words.numbers && moves(a).eq(moves(b)))
        };
        if let Some((_, proof)) = proven.iter_mut().find(|(known, _)| same(known)) {
            proof.controls.push(dialect.name());
            continue;
        }
        let flanks = simulate(&read_back(task, &programs)?)?;
        let passes = || programs.iter().flat_map(|p| &p.layout.passes);
        let chords = programs
            .iter()
            .map(|p| p.layout.passes.iter().map(|pass| pass.chord_deviation).fold(0.0, f64::max))
            .sum::<f64>();
        let rounding = passes().map(|pass| pass.rounding).fold(0.0, f64::max) * programs.len() as f64;
        // A lead that a control takes in few digits turns the workpiece over the whole feed.
        let leads = programs.iter().map(|p| p.written.rounding.lead_ratio).fold(0.0, f64::max);
        let swept = task.grinding.iter().map(|work| (work.feeds[1] - work.feeds[0]) * work.per_turn);
        let rounding = rounding + leads * swept.fold(0.0, f64::max);
        let allowed = CHORDS * chords * 1e3 + rounding * 1e3 + MARGIN_UM;
        let mut of_flanks = BTreeMap::new();
        for (flank, proven) in flanks.iter() {
            let (Some(proven), Some(target), Some(simulated)) = (proven, &target[flank], &simulated[flank])
            else {
                continue;
            };
            let difference_um = proven.minus(simulated).largest() * 1e3;
            // A difference that is no number fails as well.
            if difference_um.is_nan() || difference_um > allowed {
                let files: Vec<&str> = programs.iter().map(|p| p.file.as_str()).collect();
                let finding = Diagnostic::with_code(
                    "program-not-proven",
                    format!(
                        "read back from {}, the {flank} flank differs by {difference_um:.4} um from the planned one; blocks and digits explain {allowed:.4} um",
                        files.join(" and ")
                    ),
                )
                .field("machine")
                .way_out("lower chord_tolerance_um of the control or give it more decimals; nothing was written");
                return Err(RunFailure::not_producible(finding));
            }
            let max_deviation_um = proven.minus(target).largest() * 1e3;
            of_flanks.insert(flank.name(), FlankProof { max_deviation_um, difference_um });
        }
        let largest = of_flanks.values().map(|f: &FlankProof| f.max_deviation_um).fold(0.0, f64::max);
        let result = ProofResult {
            controls: vec![dialect.name()],
            statement: format!("proven from the program text: max deviation {largest:.4} um"),
            flanks: of_flanks,
            chords_um: chords * 1e3,
            rounding_um: rounding * 1e3,
            allowed_difference_um: allowed,
        };
        proven.push((programs, result));
    }
    Ok(proven.into_iter().map(|(_, proof)| proof).collect())
}
