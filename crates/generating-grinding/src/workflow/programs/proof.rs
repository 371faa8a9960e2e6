//! The proof: what the texts say goes through reader, axes and forward kinematics to the bodies, and from there to the referee.

use super::build::{Built, BuiltProgram};
use super::indexing::Served;
use super::judge::{Judge, ReadBack, RunFlank};
use super::lines::{NOT_COVERED, prove_lines};
use super::result::{FlankProof, ProofResult};
use super::sought::{CHORDS, MARGIN_UM, Sought, nearest, not_followed, not_proven};
use super::surroundings::Surroundings;
use super::task::ProgramTask;
use foundation::geometry::Sides;
use foundation::kinematics::GeneratingMotion;
use machine::Station;
use motion::{MotionError, PassReport, track};
use nc::{Block, Dialect};
use run::RunFailure;
use std::collections::BTreeMap;

/// Rays of the coarse grid for every thread of the worm: over the profile and along the worm.
pub const THREAD_GRID: [usize; 2] = [5, 9];
/// The blocks of a program that bear on its motion: neither comments nor the speed of a dresser, which is a body of revolution.
fn moves(program: &BuiltProgram) -> impl Iterator<Item = &Block> {
    let dressing = program.station == Station::Dresser;
    program.read.iter().filter(move |block| match block {
        Block::Comment(_) => false,
        Block::Spindle { .. } => !dressing,
        _ => true,
    })
}

/// Proves the programs of every control; equal texts of different controls are proven once. `flanks` are those of the run itself.
///
/// # Errors
/// A text that cannot be followed; threads or tooth spaces left out; a flank that differs from that of the run by more than blocks and
/// digits explain: then nothing is written.
pub fn proofs(
    task: &ProgramTask<'_>,
    built: &Built,
    flanks: &Sides<Option<RunFlank>>,
    judge: &impl Judge,
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
        let proof = prove(task, dialect, &programs, flanks, judge)?;
        proven.push((programs, proof));
    }
    Ok(proven.into_iter().map(|(_, proof)| proof).collect())
}

/// The proof of one control's programs.
fn prove(
    task: &ProgramTask<'_>,
    dialect: Dialect,
    programs: &[&BuiltProgram],
    flanks: &Sides<Option<RunFlank>>,
    judge: &impl Judge,
) -> Result<ProofResult, RunFailure> {
    let files = programs.iter().map(|p| p.file.as_str()).collect::<Vec<_>>().join(" and ");
    let sought = Sought::of_task(task);
    let mut dressed = Vec::new();
    let mut ground: Vec<(usize, Vec<Served<GeneratingMotion>>)> = Vec::new();
    for program in programs.iter().filter(|program| program.lines.is_none()) {
        let refused = |error: MotionError| not_followed(program, &error);
        let tracked =
            track(&program.read, sought.machine, &program.words, &program.start).map_err(refused)?;
        let faults = match program.station {
            Station::Dresser => {
                let found = sought.dressed(&tracked).map_err(refused)?;
                dressed = found.served;
                found.faults
            }
            Station::Work => {
                let found = sought.ground(&tracked).map_err(refused)?;
                let (spaces, teeth) =
                    (sought.indexing.spaces_of(&found.served), task.indexing.teeth.unsigned_abs());
                if spaces != teeth {
                    let text = format!("{}: {spaces} of {teeth} tooth spaces are ground", program.file);
                    return Err(not_proven(text, "give every index stroke of the pass"));
                }
                ground.push((program.area, found.served));
                found.faults
            }
        };
        let too_fast = sought.too_fast(&tracked, program.station);
        if let Some(fault) = faults.iter().chain(&too_fast).next() {
            return Err(not_proven(format!("{}: {}", program.file, fault.text), &fault.way_out));
        }
    }
    // Dressing and grinding add up; of the programs of several areas the worst counts.
    let of_stations = |value: &dyn Fn(&PassReport) -> f64| -> f64 {
        let worst = |station: Station| {
            let of_station = programs.iter().filter(|p| p.station == station && p.lines.is_none());
            of_station.flat_map(|p| &p.layout.passes).map(value).fold(0.0, f64::max)
        };
        worst(Station::Dresser) + worst(Station::Work)
    };
    let chords = of_stations(&|pass| pass.chord_deviation);
    let rounding = of_stations(&|pass| pass.rounding);
    // A lead that a control takes in few digits turns the workpiece over the whole feed.
    let leads = programs.iter().map(|p| p.written.rounding.lead_ratio).fold(0.0, f64::max);
    let swept = task.grinding.iter().map(|work| (work.feeds[1] - work.feeds[0]) * work.per_turn());
    let rounding = rounding + leads * swept.fold(0.0, f64::max);
    let allowed = CHORDS * chords * 1e3 + rounding * 1e3 + MARGIN_UM;
    let fine = "lower chord_tolerance_um of the control or give it more decimals; nothing was written";
    let dressing = nearest(&dressed).map_or(Vec::new(), |served| served.strokes.clone());
    let mut of_flanks: BTreeMap<&'static str, FlankProof> = BTreeMap::new();
    for (area, served) in ground.iter().flat_map(|(area, all)| all.iter().map(move |served| (area, served))) {
        let read = ReadBack { dressing: dressing.clone(), grinding: served.strokes.clone() };
        let apart = task.areas.get(*area).copied().unwrap_or(0.0);
        for (flank, left) in judge.flanks(&read, apart)?.iter() {
            let (Some(left), Some(run)) = (left, &flanks[flank]) else { continue };
            let [difference_um, max_deviation_um] = run.differences_um(left);
            if difference_um > allowed {
                let on = if task.areas.len() > 1 {
                    format!(" in finishing area {}", area + 1)
                } else {
                    String::new()
                };
                let text = format!(
                    "read back and simulated, {files} deviate from the plan by {difference_um:.4} um on the {flank} flank{on}; segmentation and rounding account for {allowed:.4} um"
                );
                return Err(not_proven(text, fine));
            }
            let of = of_flanks.entry(flank.name()).or_insert(FlankProof { max_deviation_um, difference_um });
            of.max_deviation_um = of.max_deviation_um.max(max_deviation_um);
            of.difference_um = of.difference_um.max(difference_um);
        }
    }
    let (lines, threads_of_lines) = prove_lines(task, programs, &sought)?;
    let (mut threads, faults) = sought.threads(&dressed, judge)?;
    if let Some(fault) = faults.first() {
        return Err(not_proven(format!("{files}: {}", fault.text), &fault.way_out));
    }
    for thread in &threads {
        if let Some((flank, &um)) = thread.difference_um.iter().find(|(_, um)| **um > allowed) {
            let named = sought.named(thread.thread - 1, &thread.blocks);
            let text = format!(
                "read back and simulated, {files} deviate from the plan by {um:.4} um on the {flank} flank of {named}; segmentation and rounding account for {allowed:.4} um"
            );
            return Err(not_proven(text, fine));
        }
    }
    let teeth = task.indexing.teeth.unsigned_abs();
    let index_strokes = ground.first().map_or(0, |(_, served)| served.len());
    let largest = of_flanks.values().map(|f| f.max_deviation_um).fold(0.0, f64::max);
    let mut statement = format!("proven from the program text: max deviation {largest:.4} um");
    if !threads.is_empty() {
        let left_out = task.indexing.threads as usize - task.indexing.active.len();
        let rest = if left_out > 0 { format!(", {left_out} left out by the job") } else { String::new() };
        statement.push_str(&format!(
            "; {} of {} threads of the worm dressed, both counted and under rays ({} x {} rays on each flank of each thread{rest})",
            threads.len(),
            task.indexing.threads,
            THREAD_GRID[0],
            THREAD_GRID[1]
        ));
    } else if lines.is_empty() {
        statement.push_str("; the worm is dressed by no program");
    }
    for of_flank in &lines {
        statement.push_str(&format!("; {}", of_flank.statement()));
    }
    threads.extend(threads_of_lines);
    statement.push_str(&format!(
        "; {teeth} of {teeth} tooth spaces ground in {index_strokes} index stroke{} of a pass",
        if index_strokes == 1 { "" } else { "s" }
    ));
    if task.areas.len() > 1 {
        statement.push_str(&format!(
            "; {0} of {0} finishing areas of the worm dressed, and ground with by a program each",
            task.areas.len()
        ));
    }
    let mut not_covered = not_covered(task);
    if !lines.is_empty() {
        not_covered.extend(NOT_COVERED.map(String::from));
    }
    statement.push_str(&format!("; not proven: {}", not_covered.join(", ")));
    Ok(ProofResult {
        controls: vec![dialect.name()],
        statement,
        flanks: of_flanks,
        threads_of_worm: task.indexing.threads,
        threads,
        lines,
        thread_rays: THREAD_GRID,
        areas: task.areas.len(),
        tooth_spaces: teeth,
        index_strokes,
        not_covered,
        chords_um: chords * 1e3,
        rounding_um: rounding * 1e3,
        allowed_difference_um: allowed,
    })
}

/// What a proof says nothing of.
fn not_covered(task: &ProgramTask<'_>) -> Vec<String> {
    let around = Surroundings::new(task.machine, &task.technology);
    let unknown = around.not_covered().join(" and ");
    let unknown = (!unknown.is_empty()).then(|| format!("approach, retraction and rapids against {unknown}"));
    let mut not: Vec<String> = unknown.into_iter().chain(around.exchanged().map(String::from)).collect();
    if task.technology.dresser.is_none() && !task.dressing.is_empty() {
        not.push(
            "approach, retraction and rapids of the worm against the dresser, for want of the worm's width"
                .into(),
        );
    }
    not
}
