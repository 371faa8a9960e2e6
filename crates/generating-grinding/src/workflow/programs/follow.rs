//! A program on the bodies of a job: which of its strokes finish what, and the flank that they leave with everything else as the job
//! has it. Knows no process.

use super::clearance;
use super::indexing::{Found, shown_blocks};
use super::judge::{Judge, ReadBack, RunFlank};
use super::single_blocks::{jumps_of_dressing, jumps_of_grinding};
use super::sought::{Sought, nearest};
use foundation::geometry::Sides;
use machine::{Role, Station};
use metrology::Topography;
use motion::{MotionError, ReadStroke, Tracked};
use run::RunFailure;
use run::program_check::{CheckedFlank, CheckedStroke, ThreadProof, refused};
use std::collections::BTreeMap;
use verdict::Remark;

/// What a program does to the bodies.
pub struct Followed {
    /// "dressing" or "grinding".
    pub kind: &'static str,
    /// All its strokes.
    pub strokes: Vec<CheckedStroke>,
    /// The flank that it leaves.
    pub flanks: BTreeMap<&'static str, CheckedFlank>,
    /// The threads of the worm that it dresses.
    pub threads: Vec<ThreadProof>,
    /// Threads and tooth spaces that it leaves out, dresses twice or cuts too deep.
    pub faults: Vec<Remark>,
}

/// What strokes leave.
struct LeftBy {
    /// First and last block of each stroke.
    blocks: Vec<[usize; 2]>,
    /// Distance of the flanks from nominal, where they leave one.
    flanks: Sides<Option<Topography>>,
}

/// A thread counts as off beyond this share of the tolerance, if the flank leaves its tolerance by that.
pub const OFF: f64 = 0.1;

/// Finds the strokes of a program on these bodies and asks the referee for their flank. Of several strokes for the same thread or offset
/// the one nearest to the job's own finishes.
///
/// # Errors
/// A program whose axes do not bring these bodies together; the referee's.
pub fn follow(
    tracked: &Tracked,
    sought: &Sought<'_>,
    flanks: &Sides<Option<RunFlank>>,
    tolerance_um: f64,
    judge: &impl Judge,
) -> Result<Followed, RunFailure> {
    let refused = |error: MotionError| refused(&error);
    let nothing = |what: &str| {
        refused(MotionError::NotFollowed {
            block: 1,
            reason: format!("it has no {what} stroke on these bodies"),
        })
    };
    let turns = sought.machine.role(Role::Work).and_then(|axis| tracked.ranges[axis]);
    let grinds = turns.is_some_and(|[from, to]| to > from);
    let mut strokes = Vec::new();
    let mut threads = Vec::new();
    let mut faults;
    let mut left: Vec<LeftBy> = Vec::new();
    // What the strokes of these blocks cannot finish is a fault of theirs.
    let mut judged = |blocks: Vec<[usize; 2]>, read: &ReadBack, area: f64| match judge.flanks(read, area) {
        Ok(flanks) => {
            left.push(LeftBy { blocks, flanks });
            None
        }
        Err(RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) => {
            let text = format!(
                "blocks {} leave no whole flank: {}",
                shown_blocks(blocks.into_iter()),
                finding.message
            );
            Some(Remark::new("flank-not-finished", text, "correct the strokes of these blocks"))
        }
    };
    if grinds {
        let found = sought.ground(tracked).map_err(refused)?;
        let all = tracked.grinding(
            sought.machine,
            &sought.technology.grinding,
            &sought.grinding.first().ok_or_else(|| nothing("grinding"))?.motion,
            sought.grinding[0].phase,
        );
        let named = |work: usize, _: u32| sought.grinding[work].name.clone();
        list(&all.map_err(refused)?, &found, named, &mut strokes);
        if strokes.is_empty() {
            return Err(nothing("grinding"));
        }
        faults = found.faults;
        let blocks: Vec<[usize; 2]> = strokes.iter().map(|stroke| stroke.blocks).collect();
        let job = (sought.technology, sought.indexing, sought.grinding[0]);
        let beside = clearance::beside_blank(tracked, sought.machine, job, &blocks);
        faults.extend(beside.map_err(refused)?.into_iter().flat_map(|beside| beside.faults));
        faults.extend(jumps_of_grinding(&sought.grinding, &found.served, tolerance_um));
        for served in &found.served {
            let read = ReadBack { dressing: sought.own_dressing(), grinding: served.strokes.clone() };
            let blocks = served.strokes.iter().map(|stroke| stroke.blocks).collect();
            faults.extend(judged(blocks, &read, sought.area_of(&served.strokes)));
        }
        let (spaces, teeth) =
            (sought.indexing.spaces_of(&found.served), sought.indexing.teeth.unsigned_abs());
        if spaces != teeth {
            faults.push(Remark::new(
                "spaces-not-ground",
                format!(
                    "{spaces} of {teeth} tooth spaces are ground by every finishing stroke; strokes are at blocks {}",
                    shown_blocks(strokes.iter().map(|stroke| stroke.blocks))
                ),
                "give every index stroke of the pass",
            ));
        }
    } else {
        let found = sought.dressed(tracked).map_err(refused)?;
        let chain = &sought.dressing.first().ok_or_else(|| nothing("dressing"))?.motion.chain;
        let all = tracked.dressing(sought.machine, &sought.technology.dressing, chain);
        let indexing = sought.indexing;
        let named = |work: usize, thread: u32| indexing.on_thread(sought.dressing[work], thread).name;
        list(&all.map_err(refused)?, &found, named, &mut strokes);
        if strokes.is_empty() {
            return Err(nothing("dressing"));
        }
        let mut unfinished = Vec::new();
        if let Some(best) = nearest(&found.served) {
            for &area in sought.areas {
                let read = ReadBack { dressing: best.strokes.clone(), grinding: sought.own_grinding(area) };
                let blocks = best.strokes.iter().map(|stroke| stroke.blocks).collect();
                unfinished.extend(judged(blocks, &read, area));
            }
        }
        let of_threads;
        (threads, of_threads) = sought.threads(&found.served, judge)?;
        faults = found.faults;
        faults.extend(jumps_of_dressing(&sought.dressing, &found.served, tolerance_um));
        faults.extend(unfinished);
        faults.extend(of_threads);
        let blocks: Vec<[usize; 2]> = strokes.iter().map(|stroke| stroke.blocks).collect();
        let beside = clearance::beside_dresser(tracked, sought.machine, sought.technology, &blocks);
        faults.extend(beside.map_err(refused)?.into_iter().flat_map(|beside| beside.faults));
    }
    let mut checked: BTreeMap<&'static str, CheckedFlank> = BTreeMap::new();
    for LeftBy { blocks, flanks: of_blocks } in &left {
        for (flank, left) in of_blocks.iter() {
            let (Some(left), Some(run)) = (left, &flanks[flank]) else { continue };
            let [difference_um, max_deviation_um] = run.differences_um(left);
            if difference_um > OFF * tolerance_um && max_deviation_um > tolerance_um {
                let [w, z] = run.worst(left);
                let text = format!(
                    "blocks {}: the {flank} flank that they leave deviates by {max_deviation_um:.4} um at w = {w:.3}, z = {z:.3} mm, {difference_um:.4} um of it by the program; the tolerance is {tolerance_um} um",
                    shown_blocks(blocks.iter().copied())
                );
                faults.push(Remark::new("flank-off", text, "correct the axes of these blocks"));
            }
            let of = checked.entry(flank.name()).or_insert(CheckedFlank { max_deviation_um, difference_um });
            of.max_deviation_um = of.max_deviation_um.max(max_deviation_um);
            of.difference_um = of.difference_um.max(difference_um);
        }
    }
    for thread in &threads {
        for (flank, &um) in &thread.difference_um {
            let with_it = um + checked.get(flank).map_or(0.0, |f| f.max_deviation_um);
            if um > OFF * tolerance_um && with_it > tolerance_um {
                let named = sought.named(thread.thread - 1, &thread.blocks);
                faults.push(Remark::new(
                    "thread-off",
                    format!("the {flank} flank of {named} differs by {um:.4} um from that of the job"),
                    "correct the index angle and the axes of its stroke",
                ));
            }
        }
    }
    faults.extend(sought.too_fast(tracked, if grinds { Station::Work } else { Station::Dresser }));
    let kind = if grinds { "grinding" } else { "dressing" };
    Ok(Followed { kind, strokes, flanks: checked, threads, faults })
}

/// All strokes, with the name of what they finish.
fn list<M>(
    all: &[ReadStroke<M>],
    found: &Found<M>,
    named: impl Fn(usize, u32) -> String,
    strokes: &mut Vec<CheckedStroke>,
) {
    for stroke in all {
        let serves = found.finishing.iter().find(|(blocks, _, _)| *blocks == stroke.blocks);
        strokes.push(CheckedStroke {
            range_mm: stroke.range,
            blocks: stroke.blocks,
            duration_s: stroke.duration,
            serves: serves.map(|&(_, work, place)| named(work, place)),
        });
    }
}
