//! Worm, workpiece and dresser as bodies of revolution: the check from the texts that the worm comes in, goes out and travels clear of the blank and of the dresser. Knows no flank.

use super::build::Built;
use super::cylinders::{CLEARANCE, Cylinders};
use super::indexing::Indexing;
use super::mesh::Mesh;
use super::result::ClearanceResult;
use super::surroundings::{self, Surroundings};
use super::task::ProgramTask;
use super::technology::Technology;
use super::work::GrindingWork;
use foundation::kinematics::{Dresser, Pose, Workpiece, Worm};
use job::Diagnostic;
use machine::{Machine, Mounts, Station};
use motion::{MotionError, ReadStroke, Tracked, track};
use run::RunFailure;
use run::program_check::BodyClearance;
use std::collections::BTreeSet;
use verdict::Remark;

/// What places of the blank and of a text may be off, mm: chords of its circle and of its length, digits of the control.
const SAMPLED: f64 = 0.05;
/// What the check says of strokes that begin beside the stock.
const IN_SPACES: &str = "; where the worm comes in and goes out over the blank its threads stand in the tooth spaces, beside the stock that [stock] states";

/// Least distance of two bodies beside the strokes of a program, and where it is too small.
#[derive(Debug, Default)]
pub struct Beside {
    /// Least distance, mm, but for places in the tooth spaces; infinite where the program does nothing beside its strokes.
    pub least: f64,
    /// Whether the threads stand in the tooth spaces somewhere.
    pub in_spaces: bool,
    /// Places with less than is kept, one for each block.
    pub faults: Vec<Remark>,
}

/// Follows a program wherever no stroke grinds or dresses: approach, infeed, retraction, rapid moves, and the first and the last place of
/// every stroke. `strokes`: first and last block of each, from 1. `in_spaces`: whether bodies that overlap at a place of a block stand in each
/// other's spaces.
///
/// # Errors
/// [`MotionError`]: axes without a pose.
fn beside<Body: 'static>(
    tracked: &Tracked,
    (machine, station, mounts): (&Machine, Station, &Mounts),
    strokes: &[[usize; 2]],
    (cylinders, body, kept): (&Cylinders, &str, f64),
    in_spaces: impl Fn(usize, &Pose<Worm, Body>) -> bool,
) -> Result<Beside, MotionError> {
    let mut found = Beside { least: f64::INFINITY, in_spaces: false, faults: Vec::new() };
    let mut last = 0;
    for (block, positions) in tracked.beside(machine, strokes) {
        let pose = machine.pose(station, &positions)?;
        let bodies: Pose<Worm, Body> = mounts.bodies(&pose);
        let gap = cylinders.gap::<Body>(&bodies);
        if gap < kept - SAMPLED && in_spaces(block, &bodies) {
            found.in_spaces = true;
            continue;
        }
        found.least = found.least.min(gap);
        if gap < kept - SAMPLED && block != last {
            last = block;
            found.faults.push(Remark::new(
                "program-not-clear",
                format!("block {block}: worm and {body} come to {gap:.3} mm of each other where no stroke works; {kept} mm are kept"),
                "raise machine.clearance, or let the strokes begin and end further out",
            ));
        }
    }
    Ok(found)
}

/// First and last block of each stroke.
fn blocks_of<M>(strokes: &[ReadStroke<M>]) -> Vec<[usize; 2]> {
    strokes.iter().map(|stroke| stroke.blocks).collect()
}

/// What a grinding program does to the blank beside its strokes, which stand at these blocks; `None` where the blank is not known.
///
/// # Errors
/// [`MotionError`]: axes without a pose.
pub fn beside_blank(
    tracked: &Tracked,
    machine: &Machine,
    (technology, indexing, work): (&Technology, &Indexing, &GrindingWork),
    blocks: &[[usize; 2]],
) -> Result<Option<Beside>, MotionError> {
    let Some(cylinders) = &technology.cylinders else { return Ok(None) };
    let mesh = Mesh::new(tracked, blocks, (work, technology.strokes_of(work), indexing));
    let clear = |block: usize, bodies: &Pose<Worm, Workpiece>| {
        mesh.as_ref().is_some_and(|mesh| mesh.is_clear(block, bodies))
    };
    let of = (machine, Station::Work, &technology.grinding);
    beside::<Workpiece>(tracked, of, blocks, (cylinders, "blank", CLEARANCE), clear).map(Some)
}

/// The same of a dressing program and the dresser.
///
/// # Errors
/// [`MotionError`]: axes without a pose.
pub fn beside_dresser(
    tracked: &Tracked,
    machine: &Machine,
    technology: &Technology,
    blocks: &[[usize; 2]],
) -> Result<Option<Beside>, MotionError> {
    let Some(cylinders) = &technology.dresser else { return Ok(None) };
    let of = (machine, Station::Dresser, &technology.dressing);
    beside::<Dresser>(tracked, of, blocks, (cylinders, "dresser", CLEARANCE), |_, _| false).map(Some)
}

/// Checks from the texts that worm, blank and dresser are clear of each other beside the strokes. `None` where no bodies are known.
///
/// # Errors
/// A text that cannot be followed; a place with less than the clearance.
pub fn check(task: &ProgramTask<'_>, built: &Built) -> Result<Option<ClearanceResult>, RunFailure> {
    let machine = &task.machine.machine;
    let technology = &task.technology;
    let mut least = f64::INFINITY;
    let mut in_spaces = false;
    let mut checked = BTreeSet::new();
    for program in &built.programs {
        let refused = |error: MotionError| {
            let finding = Diagnostic::with_code(error.code(), format!("{}: {error}", program.file));
            RunFailure::not_producible(finding.field("machine").way_out(error.way_out()))
        };
        let tracked = track(&program.read, machine, &program.words, &program.start).map_err(refused)?;
        let (body, found) = match program.station {
            Station::Work => {
                let Some(work) = task.grinding.first().filter(|_| technology.cylinders.is_some()) else {
                    continue;
                };
                let strokes = tracked.grinding(machine, &technology.grinding, &work.motion, work.phase);
                let blocks = blocks_of(&strokes.map_err(refused)?);
                let job = (technology, &task.indexing, work);
                ("workpiece", beside_blank(&tracked, machine, job, &blocks))
            }
            Station::Dresser => {
                let Some(work) = task.dressing.first().filter(|_| technology.dresser.is_some()) else {
                    continue;
                };
                let strokes = tracked.dressing(machine, &technology.dressing, &work.motion.chain);
                let blocks = blocks_of(&strokes.map_err(refused)?);
                ("dresser", beside_dresser(&tracked, machine, technology, &blocks))
            }
        };
        let Some(found) = found.map_err(refused)? else { continue };
        checked.insert(body);
        least = least.min(found.least);
        in_spaces |= found.in_spaces;
        if let Some(fault) = found.faults.first() {
            let finding = Diagnostic::with_code(fault.code, format!("{}, {}", program.file, fault.text));
            let way_out = format!("{}; nothing was written", fault.way_out);
            return Err(RunFailure::not_producible(finding.field("machine").way_out(way_out)));
        }
    }
    let around = Surroundings::new(task.machine, technology);
    let around_worm = surroundings::check(task, built, &around)?;
    let mut not_checked: Vec<&'static str> = around.not_covered();
    not_checked.extend(around.exchanged());
    if !checked.contains("dresser") && !task.dressing.is_empty() {
        not_checked.insert(0, "dresser");
    }
    let bodies: Vec<&'static str> = std::iter::once("worm").chain(checked).collect();
    Ok(least.is_finite().then(|| ClearanceResult {
        statement: format!(
            "from the program text: {} stay {least:.3} mm or more apart at the ends of the strokes, in approach, retraction and rapid moves ({CLEARANCE} mm are kept){}{}; not checked: {}",
            bodies.join(", "),
            if in_spaces { IN_SPACES } else { "" },
            clear_of(&around_worm, around.kept()),
            if not_checked.is_empty() { "the first move of a program".to_owned() } else { not_checked.join(", ") }
        ),
        checked: bodies,
        not_checked,
        bodies_kept_mm: (!around_worm.is_empty()).then(|| around.kept()),
        bodies: around_worm,
        least_mm: least,
        kept_mm: CLEARANCE,
    }))
}

/// What the worm's side keeps clear of over all blocks, in words; nothing without such bodies.
fn clear_of(bodies: &[BodyClearance], kept: f64) -> String {
    let Some(nearest) = bodies.first() else { return String::new() };
    let names: Vec<&str> = bodies.iter().map(|body| body.body.as_str()).collect();
    format!(
        "; over all blocks, strokes included, the worm and what its spindle carries stay clear of {}: least distance {:.3} mm, of {} and {} in block {} of {} ({kept} mm are kept)",
        names.join(", "),
        nearest.least_mm,
        nearest.of,
        nearest.body,
        nearest.block,
        nearest.file
    )
}
