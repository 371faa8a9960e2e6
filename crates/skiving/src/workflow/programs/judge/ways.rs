//! The ways beside what is recorded: rapid motions stay out of the beam, straight ones go in and out as slowly and as deep as the job
//! says, and the tool stands outside at the end. Before a stylus, which bends, they lead straight to the tool's axis with a tool that
//! does not turn.

use super::following::Motion;
use super::{Followed, fault};
use crate::measuring::MeasuringPose;
use crate::workflow::programs::course::Course;
use crate::workflow::programs::stand::Stander;
use machine::{Joint, Positions};
use run::RunFailure;
use verdict::Remark;

/// What a tool has to keep between two recordings.
pub(in super::super) struct Between<'a> {
    /// Room and retreat of the job's own course.
    pub course: &'a Course<'a>,
    /// Poses of the job.
    pub poses: Vec<MeasuringPose>,
    /// Whether what stands at the beam's place is a body.
    pub stylus: bool,
}

/// Below this a distance is digits, mm; and as a share, of speeds and directions.
const DIGITS: f64 = 1e-3;

/// What is wrong with the ways.
///
/// # Errors
/// Positions that are not finite.
pub(in super::super) fn ways(
    followed: &Followed,
    stander: &Stander<'_>,
    between: &Between<'_>,
) -> Result<Vec<Remark>, RunFailure> {
    let room = &between.course.room;
    let free = room.clear() - DIGITS;
    let deepest =
        between.poses.iter().map(|pose| room.distance(&pose.position)).fold(f64::INFINITY, f64::min);
    let mut faults = Vec::new();
    for (number, motion) in followed.motions.iter().enumerate() {
        if followed.recorded(number) {
            continue;
        }
        let from = motion.from.as_ref().unwrap_or(&motion.to);
        let nearest = room.nearest(stander, [from, &motion.to])?;
        if nearest >= free {
            continue;
        }
        let Some(seconds) = motion.seconds else {
            let text = format!(
                "on a rapid way the tool's axis comes as near as {nearest:.3} mm to the beam; {:.3} mm leave it free",
                room.clear()
            );
            faults.push(fault("beam-not-free", motion.block, &text, "draw the tool back before"));
            continue;
        };
        if nearest < deepest - DIGITS {
            let text = format!(
                "the tool's axis comes as near as {nearest:.3} mm to the beam; the deepest pose of the job is at {deepest:.3} mm"
            );
            faults.push(fault("too-deep-at-the-beam", motion.block, &text, "correct where this block goes"));
        }
        let speed = linear_way(stander, from, &motion.to) / seconds;
        let most = between.course.retreat.speed;
        if speed > most * (1.0 + DIGITS) {
            let text = format!(
                "the tool moves at {:.1} mm/min in the beam; the job says {:.1} mm/min",
                60.0 * speed,
                60.0 * most
            );
            faults.push(fault("too-fast-at-the-beam", motion.block, &text, "give the block more time"));
        }
        if between.stylus && !is_straight(motion, from, stander, between)? {
            let text = "beside the stylus the tool moves in another direction than to its axis, or turns";
            faults.push(fault("stylus-not-free", motion.block, text, "go in and out along the retreat"));
        }
    }
    if let Some(last) = followed.motions.last() {
        let left = room.nearest(stander, [&last.to, &last.to])?;
        if left < free {
            let text = format!("the tool is left at {left:.3} mm from the beam");
            faults.push(fault("beam-not-free", last.block, &text, "draw the tool back at the end"));
        }
    }
    Ok(faults)
}

/// Way of the linear axes, mm.
fn linear_way(stander: &Stander<'_>, from: &Positions, to: &Positions) -> f64 {
    let axes = stander.axes.iter();
    let linear = axes.filter(|&&axis| stander.machine.axes()[axis].joint == Joint::Linear);
    linear.map(|&axis| (to[axis] - from[axis]).powi(2)).sum::<f64>().sqrt()
}

/// Whether the tool goes to the stylus or away from it and does not turn.
fn is_straight(
    motion: &Motion,
    from: &Positions,
    stander: &Stander<'_>,
    between: &Between<'_>,
) -> Result<bool, RunFailure> {
    let machine = stander.machine;
    let turns = stander.axes.iter().any(|&axis| {
        machine.axes()[axis].joint == Joint::Rotary && (motion.to[axis] - from[axis]).abs() > DIGITS * DIGITS
    });
    let ends = [stander.tool(from)?, stander.tool(&motion.to)?];
    let way = ends[1].position - ends[0].position;
    let Some(like) = between.poses.first() else { return Ok(true) };
    let direction = between.course.room.direction(&ends[1].pose(like))?;
    Ok(!turns && way.cross(&direction).norm() <= DIGITS * way.norm().max(1.0))
}
