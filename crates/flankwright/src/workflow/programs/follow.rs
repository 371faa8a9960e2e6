//! A program on the bodies of a job: which of its strokes finish what, and the flank that they leave with everything else as the job
//! has it. Knows no process.

use super::proof::ReadBack;
use super::result::{CheckedFlank, CheckedStroke};
use super::task::{DressingWork, GrindingWork};
use super::technology::Technology;
use crate::exchange::Diagnostic;
use crate::geometry::Sides;
use crate::kinematics::{DressingMotion, GeneratingMotion, MotionLaw};
use crate::machine::{Machine, Role};
use crate::metrology::Topography;
use crate::motion::{MotionError, ReadStroke, Tracked};
use crate::numerics::equidistant;
use crate::workflow::finding::RunFailure;
use std::collections::BTreeMap;

/// Places of a stroke at which it is compared with one of the job.
const PLACES: usize = 9;

/// The strokes of a job's own run, and its flanks.
pub(super) struct Bodies<'a> {
    pub technology: &'a Technology,
    pub dressing: Vec<&'a DressingWork>,
    pub grinding: Vec<&'a GrindingWork>,
    /// Target and flank of the run.
    pub flanks: [Sides<Option<Topography>>; 2],
}

/// What a program does to the bodies.
pub(super) struct Followed {
    /// "dressing" or "grinding".
    pub kind: &'static str,
    /// All its strokes.
    pub strokes: Vec<CheckedStroke>,
    /// The flank that it leaves.
    pub flanks: BTreeMap<&'static str, CheckedFlank>,
}

/// Finds the strokes of a program on these bodies and asks the referee (`simulate`) for their flank. Of several strokes for the same
/// flank the one nearest to the job's own finishes.
///
/// # Errors
/// A program whose axes do not bring these bodies together; the referee's.
pub(super) fn follow(
    machine: &Machine,
    tracked: &Tracked,
    bodies: &Bodies<'_>,
    simulate: impl FnOnce(&ReadBack) -> Result<Sides<Option<Topography>>, RunFailure>,
) -> Result<Followed, RunFailure> {
    let refused = |error: MotionError| {
        let finding = Diagnostic::with_code(error.code(), error.to_string());
        RunFailure::bad_input(finding.way_out(error.way_out()))
    };
    let nothing = |what: &str| {
        refused(MotionError::NotFollowed {
            block: 1,
            reason: format!("it has no {what} stroke on these bodies"),
        })
    };
    let turns = machine.role(Role::Work).and_then(|axis| tracked.ranges[axis]);
    let grinds = turns.is_some_and(|[from, to]| to > from);
    let mut read = ReadBack { dressing: Vec::new(), grinding: Vec::new() };
    let mut strokes: Vec<CheckedStroke> = Vec::new();
    let kind = if grinds {
        for work in &bodies.grinding {
            let there = tracked
                .grinding(machine, &bodies.technology.grinding, &work.motion, work.phase)
                .map_err(refused)?;
            let off = |stroke: &ReadStroke<GeneratingMotion>| {
                let apart = |a: &MotionLaw, b: &MotionLaw, at: f64| (a.value(at) - b.value(at)).abs();
                let at_place = |at: f64| {
                    apart(&stroke.motion.delta_d, &work.motion.delta_d, at)
                        + work.per_turn * apart(&stroke.motion.delta_phi_2, &work.motion.delta_phi_2, at)
                };
                equidistant(work.feeds, PLACES).into_iter().map(at_place).sum::<f64>()
            };
            let best = serve(&there, off, &work.name, &mut strokes).ok_or_else(|| nothing("grinding"))?;
            read.grinding.push(there[best].clone());
        }
        "grinding"
    } else {
        for work in &bodies.grinding {
            let motion = work.motion.clone();
            read.grinding.push(ReadStroke { motion, range: work.feeds, blocks: [0, 0], duration: 0.0 });
        }
        for work in &bodies.dressing {
            let there = tracked
                .dressing(machine, &bodies.technology.dressing, &work.motion.chain)
                .map_err(refused)?;
            let off = |stroke: &ReadStroke<DressingMotion>| {
                let at_place = |at: f64| {
                    let [a, b] = [stroke.motion.correction_at(at), work.motion.correction_at(at)];
                    // Angles at a radius of some 100 mm.
                    let weighed = [100.0, 100.0, 1.0, 1.0].iter().zip(a.iter().zip(b));
                    weighed.map(|(weight, (a, b))| weight * (a - b).abs()).sum::<f64>()
                };
                equidistant(work.interval, PLACES).into_iter().map(at_place).sum::<f64>()
            };
            let best = serve(&there, off, &work.name, &mut strokes).ok_or_else(|| nothing("dressing"))?;
            read.dressing.push(there[best].clone());
        }
        "dressing"
    };
    let left = simulate(&read)?;
    let [target, simulated] = &bodies.flanks;
    let mut flanks = BTreeMap::new();
    for (flank, left) in left.iter() {
        let (Some(left), Some(target), Some(simulated)) = (left, &target[flank], &simulated[flank]) else {
            continue;
        };
        let checked = CheckedFlank {
            max_deviation_um: left.minus(target).largest() * 1e3,
            difference_um: left.minus(simulated).largest() * 1e3,
        };
        flanks.insert(flank.name(), checked);
    }
    Ok(Followed { kind, strokes, flanks })
}

/// The stroke nearest to a stroke of the job, and all strokes listed once, with the name of the one that they finish.
fn serve<M>(
    there: &[ReadStroke<M>],
    off: impl Fn(&ReadStroke<M>) -> f64,
    name: &str,
    listed: &mut Vec<CheckedStroke>,
) -> Option<usize> {
    let best = (0..there.len()).min_by(|&a, &b| off(&there[a]).total_cmp(&off(&there[b])))?;
    for (k, stroke) in there.iter().enumerate() {
        let serves = (k == best).then(|| name.to_owned());
        match listed.iter_mut().find(|known| known.blocks == stroke.blocks) {
            Some(known) => known.serves = known.serves.take().or(serves),
            None => listed.push(CheckedStroke {
                range_mm: stroke.range,
                blocks: stroke.blocks,
                duration_s: stroke.duration,
                serves,
            }),
        }
    }
    Some(best)
}
