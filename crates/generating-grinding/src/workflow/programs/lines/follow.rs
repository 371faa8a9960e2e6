//! A program on the bodies of a job whose worm is written by lines: which lines it writes, and what it leaves on the flank.

use super::find::{Finder, FoundLines};
use super::judge::{WrittenThread, blocks, judge};
use super::work::LineWork;
use crate::workflow::programs::follow::{Followed, OFF};
use crate::workflow::programs::indexing::Indexing;
use crate::workflow::programs::technology::Technology;
use foundation::geometry::Sides;
use machine::Machine;
use motion::{MotionError, Tracked};
use run::RunFailure;
use run::program_check::{CheckedFlank, CheckedStroke, ThreadProof, refused};
use std::collections::BTreeMap;
use verdict::Remark;

/// Finds the lines of a program, of whichever flank it writes most, and says what they leave. `deviation_um` is the largest deviation of
/// each gear flank of the run; what the lines leave of the worm adds to it.
///
/// # Errors
/// A program without a line on these bodies, or whose axes do not bring them together.
pub fn follow_lines(
    tracked: &Tracked,
    (machine, technology, indexing): (&Machine, &Technology, &Indexing),
    works: &[LineWork<'_>],
    deviation_um: &Sides<f64>,
    tolerance_um: f64,
) -> Result<Followed, RunFailure> {
    let mut most: Option<(LineWork<'_>, FoundLines)> = None;
    for &work in works {
        let found = Finder { work, indexing, technology, machine }.find(tracked).map_err(|e| refused(&e))?;
        let lines = |found: &FoundLines| found.lines.len();
        if most.as_ref().is_none_or(|(_, known)| lines(&found) > lines(known)) {
            most = Some((work, found));
        }
    }
    let Some((work, found)) = most.filter(|(_, found)| !found.lines.is_empty()) else {
        let reason = "it has no line on these bodies".to_owned();
        return Err(refused(&MotionError::NotFollowed { block: 1, reason }));
    };
    let judged = judge(&work, indexing, &found);
    let mut followed = Followed {
        kind: "dressing",
        strokes: Vec::new(),
        flanks: BTreeMap::new(),
        threads: Vec::new(),
        faults: judged.faults,
    };
    let mut flank = CheckedFlank { max_deviation_um: deviation_um[work.flank], difference_um: 0.0 };
    for thread in &judged.threads {
        followed.strokes.push(CheckedStroke {
            range_mm: thread.shifts,
            blocks: thread.blocks,
            duration_s: thread.duration,
            serves: Some(format!(
                "{}, {} OF {} LINES",
                work.on_thread(thread.thread, indexing),
                thread.lines,
                work.count()
            )),
        });
        let difference_um = difference(thread) * 1e3;
        let off_um = off(thread) * 1e3;
        let with_it = deviation_um[work.flank] + off_um;
        flank.max_deviation_um = flank.max_deviation_um.max(with_it);
        flank.difference_um = flank.difference_um.max(difference_um);
        followed.threads.push(ThreadProof {
            thread: thread.thread + 1,
            blocks: vec![thread.blocks],
            difference_um: BTreeMap::from([(work.flank.name(), difference_um)]),
        });
        let named = format!("thread {} of {} of the worm", thread.thread + 1, indexing.threads);
        if thread.over.is_none() {
            followed.faults.push(Remark::new(
                "thread-not-finished",
                format!("{named}: its lines leave rays on the {} flank unfinished", work.flank),
                "write every line to its end",
            ));
        }
        if difference_um > OFF * tolerance_um && with_it > tolerance_um {
            let worst =
                if -thread.height[0].by > thread.height[1].by { thread.height[0] } else { thread.height[1] };
            // Where lines are missing all others may be right.
            let what = if worst.by.abs() * 1e3 > OFF * tolerance_um {
                format!(
                    "line {} (blocks {}) is {:.4} um off its height on the {} flank",
                    worst.line + 1,
                    blocks([worst.blocks]),
                    worst.by * 1e3,
                    work.flank
                )
            } else {
                format!(
                    "rays on the {} flank (blocks {}) differ by {difference_um:.4} um from those of the job's lines",
                    work.flank,
                    blocks([thread.blocks])
                )
            };
            followed.faults.push(Remark::new(
                "line-off",
                format!(
                    "{named}: {what}; with it the flank of the gear deviates by up to {with_it:.4} um; the tolerance is {tolerance_um} um"
                ),
                "correct the axes of these blocks",
            ));
        }
    }
    followed.flanks.insert(work.flank.name(), flank);
    Ok(followed)
}

/// How far a thread differs from that of the run: on rays, and line by line, mm. Rays that no line finishes are a fault of their own.
fn difference(thread: &WrittenThread) -> f64 {
    let rays = if thread.over.is_some() { thread.difference } else { 0.0 };
    rays.max(thread.height[0].by.abs()).max(thread.height[1].by.abs())
}

/// How far a thread stands off the wanted flank, mm.
fn off(thread: &WrittenThread) -> f64 {
    let [least, most] = thread.over.unwrap_or([0.0; 2]);
    (-least).max(most).max(-thread.height[0].by).max(thread.height[1].by)
}
