//! A text of a stroke held against what the job wants: forward kinematics bring the axes to the pose of workpiece and tool, the chain's
//! inverse tells angles, feed and distances of it, and these have to keep coupling, setting and law. The referee rolls the tool once more
//! with what the text drives.

use super::failure::{not_proven, of_machine};
use super::judge::{Followed, Judged, fault};
use super::skive::SkivingCourse;
use super::task::SkivingWork;
use crate::workflow::referee::{Law, skived};
use foundation::geometry::Flank;
use foundation::kinematics::{GeneratingState, Pose, Workpiece, Worm};
use foundation::numerics::Silent;
use machine::{Mounts, Positions, Station};
use run::RunFailure;
use std::f64::consts::TAU;

/// How far a speed or a feed may be off, as a share: what six digits of a feed leave.
const SHARE: f64 = 1e-5;
/// A centre distance that is farther from the one of the stroke is a retreat, mm.
const DRAWN_BACK: f64 = 0.5;

const AS_WRITTEN: &str = "correct this block, or take the text as it was written";

/// What axes do to the process at one moment: angle of the tool, feed, and what is beside coupling and setting.
#[derive(Clone, Copy, Debug)]
struct Moment {
    tool_angle: f64,
    feed: f64,
    /// Beside the centre distance, mm.
    distance: f64,
    /// Beside the coupled angle of the workpiece, rad.
    turn: f64,
    /// Beside shift and crossed axes, mm and rad.
    astray: [f64; 2],
}

impl SkivingCourse<'_> {
    fn moment(
        &self,
        work: &SkivingWork<'_>,
        at: &Positions,
        near: &GeneratingState,
    ) -> Result<(Moment, GeneratingState), RunFailure> {
        let machine = self.course.stander.machine;
        let mounts = Mounts { tool: self.course.stander.mount, counterpart: self.work };
        let spindles = machine.pose(Station::Work, at).map_err(|error| of_machine(&error, "read back"))?;
        let bodies: Pose<Worm, Workpiece> = mounts.bodies(&spindles);
        let motion = &work.motion;
        let chain = motion.chain();
        let state = chain.state_of(&bodies, near).ok_or_else(|| {
            not_proven("the axes bring tool and workpiece where no skiving setting brings them".into())
        })?;
        let moment = Moment {
            tool_angle: state.worm_angle,
            feed: state.feed,
            distance: state.delta_d,
            turn: state.work_angle - motion.state(state.worm_angle, state.feed).work_angle,
            astray: [state.shift - motion.tool_shift, state.delta_gamma],
        };
        Ok((moment, state))
    }
}

/// What a text drives, and how far it is off.
pub(super) struct Stroke {
    pub judged: Judged,
    /// Angle of the tool, then what is added to centre distance and angle of the workpiece, over a turn in the middle of the stroke.
    law: Vec<[f64; 3]>,
    /// Greatest way beside the law between two blocks, mm.
    pub between: f64,
}

/// Judges the stroke of a text; `allowed` is what digits explain, mm.
///
/// # Errors
/// Positions that are not finite.
pub(super) fn judged(
    laid: &SkivingCourse<'_>,
    work: &SkivingWork<'_>,
    followed: &Followed,
    allowed: f64,
) -> Result<Stroke, RunFailure> {
    let motion = &work.motion;
    let mut judged = Judged { faults: followed.faults.clone(), ..Judged::default() };
    let pitch_radius = work.bodies.pair.gear().pitch_radius();
    let mut near = motion.state(motion.tool_angle, laid.feeds[0]);
    let mut moments: Vec<Moment> = Vec::new();
    let mut between = 0.0f64;
    let mut turns = 0.0;
    for block in &followed.motions {
        let (here, state) = laid.moment(work, &block.to, &near)?;
        let drawn = here.distance.abs() > DRAWN_BACK;
        let (Some(seconds), Some(from)) = (block.seconds, block.from) else {
            near = state;
            let inside =
                !drawn && (here.feed - laid.feeds[0]).abs() > 1.0 && (here.feed - laid.feeds[1]).abs() > 1.0;
            if inside {
                judged.faults.push(fault(
                    "stroke-off",
                    block.block,
                    "a rapid motion in the workpiece",
                    AS_WRITTEN,
                ));
            }
            continue;
        };
        let (before, _) = laid.moment(work, &from, &near)?;
        if drawn || before.distance.abs() > DRAWN_BACK {
            near = state;
            continue;
        }
        let off = |moment: &Moment| {
            let [distance, turn] = work.law.at(moment.tool_angle);
            let [shift, crossed] = moment.astray;
            let tangential = pitch_radius * (moment.turn - turn).abs();
            [
                (moment.distance - distance).abs().max(tangential),
                shift.abs().max(pitch_radius * crossed.abs()),
            ]
        };
        // Digits act through angle, distance and feed alike.
        let digits = 4.0 * allowed;
        if let Some(reason) = judged.off(off(&here), digits) {
            judged.faults.push(fault(
                "stroke-off",
                block.block,
                &format!("beside law or setting: {reason}"),
                AS_WRITTEN,
            ));
        }
        let turned = (here.tool_angle - before.tool_angle).abs();
        let kept = (turned / (seconds * work.speed) - 1.0).abs() <= SHARE;
        let fed = (here.feed - before.feed).abs();
        let rate = work.feed * motion.ratio.abs() / TAU * turned;
        // Written so that NaN is a fault.
        let fed_right = (fed - rate).abs() <= SHARE * rate + digits;
        if !(kept && fed_right) {
            let text = format!(
                "the tool turns {:.4} deg in {seconds:.6} s and feeds {fed:.6} mm; the job wants {:.4} deg and {rate:.6} mm",
                turned.to_degrees(),
                (seconds * work.speed).to_degrees()
            );
            judged.faults.push(fault("stroke-off", block.block, &text, AS_WRITTEN));
        }
        let mut middle = from;
        for &axis in &laid.course.stander.axes {
            middle[axis] = 0.5 * (from[axis] + block.to[axis]);
        }
        let (half_way, _) = laid.moment(work, &middle, &near)?;
        between = between.max(off(&half_way)[0]);
        turns += turned;
        for moment in [before, half_way] {
            moments.push(moment);
        }
        near = state;
    }
    let reached = moments
        .iter()
        .map(|moment| moment.feed)
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], feed| [a.min(feed), b.max(feed)]);
    let [begin, end] = laid.feeds;
    let covered = reached[1] >= begin.max(end) - DRAWN_BACK && reached[0] <= begin.min(end) + DRAWN_BACK;
    if !covered || turns < TAU {
        let text = format!(
            "the stroke feeds from {:.3} to {:.3} mm; the face needs {begin:.3} to {end:.3} mm",
            reached[1], reached[0]
        );
        judged.faults.push(fault("stroke-off", followed.last_block(), &text, AS_WRITTEN));
    }
    judged.sound = usize::from(judged.faults.is_empty());
    // A turn and a little more, from the middle on.
    let middle = moments.len() / 2;
    let law = moments[middle..]
        .iter()
        .map(|moment| [moment.tool_angle, moment.distance, moment.turn])
        .take_while(|[angle, ..]| (angle - moments[middle].tool_angle).abs() <= TAU + 0.5)
        .collect();
    Ok(Stroke { judged, law, between })
}

impl Stroke {
    /// Greatest difference between the flank that the text leaves under the referee and the planned one, mm.
    ///
    /// # Errors
    /// Edges that do not come by.
    pub fn flank_difference(&self, work: &SkivingWork<'_>) -> Result<Option<f64>, RunFailure> {
        let Some(planned) = work.after else { return Ok(None) };
        let mut table: Vec<[f64; 3]> = self.law.clone();
        table.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let law = |angle: f64| law_of(&table, angle);
        let (tool, clocking) = (&work.measurement.cutting, work.measurement.cutting_clocking);
        let law: &Law<'_> = &law;
        let left = skived(work.bodies, tool, clocking, (&work.motion, Some(law)), &Silent)?;
        let mut most = 0.0f64;
        for flank in Flank::BOTH {
            for (a, b) in left[flank].iter().flatten().zip(planned[flank].iter().flatten()) {
                most = most.max((a - b).abs());
            }
        }
        Ok(Some(most))
    }
}

/// What a table over a turn says at an angle, straight between its places.
fn law_of(table: &[[f64; 3]], angle: f64) -> [f64; 2] {
    let Some(first) = table.first() else { return [f64::NAN; 2] };
    let angle = first[0] + (angle - first[0]).rem_euclid(TAU);
    let after = table.partition_point(|row| row[0] < angle).clamp(1, table.len() - 1);
    let [a, b] = [table[after - 1], table[after]];
    let share = (angle - a[0]) / (b[0] - a[0]);
    [1, 2].map(|k| a[k] + share * (b[k] - a[k]))
}
