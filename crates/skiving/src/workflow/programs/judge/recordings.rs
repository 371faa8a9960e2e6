//! Recordings at a light barrier in a text: which track, flank and sense each serves, whether the ideal tool switches there at its
//! nominal places, and whether the spindle turns through all that counts at the speed of the job.

use super::following::{Motion, Stretch};
use super::{Followed, Judged, fault};
use crate::measuring::Sense;
use crate::workflow::programs::measuring::{MeasuringCourse, Recording};
use crate::workflow::programs::proof::{OWN_ROUNDING, SPEED, at_nominal, off_nominal};
use crate::workflow::programs::task::MeasuringWork;
use machine::Positions;
use run::RunFailure;
use verdict::Remark;

/// A pose this near to one of the job is meant to be it, mm.
const NEAR: f64 = 0.01;
/// What another axis than the spindle may move while something is recorded, mm or rad.
const STANDS: f64 = 1e-9;

const AS_WRITTEN: &str = "correct these blocks, or take the text as it was written";

/// A text beside the measurement of a job.
struct Held<'a> {
    laid: &'a MeasuringCourse<'a>,
    work: &'a MeasuringWork<'a>,
    followed: &'a Followed,
    /// Half a unit of the text's angles, rad.
    half: f64,
    /// Whether the axes stand while the output is switched.
    stands_to_switch: bool,
}

/// What is wrong with a recording: code, block, reason.
type Fault = (&'static str, usize, String);

/// Judges the recordings of a text; `allowed` is what digits explain, mm, `half_angle` half a unit of its angles, rad.
///
/// # Errors
/// Positions that are not finite.
pub(in super::super) fn recordings(
    laid: &MeasuringCourse<'_>,
    work: &MeasuringWork<'_>,
    followed: &Followed,
    [allowed, half_angle]: [f64; 2],
    stands_to_switch: bool,
) -> Result<Judged, RunFailure> {
    let held = Held { laid, work, followed, half: half_angle + OWN_ROUNDING, stands_to_switch };
    let mut judged = Judged::default();
    let mut next = 0;
    for stretch in &followed.stretches {
        let [on, off] = stretch.blocks;
        // Where the axes stand is not known; that is told already.
        let Some(at) = followed.begin(stretch) else { continue };
        let found = held.served(stretch, &at, next)?;
        let Some(wanted) = laid.recordings.get(found) else {
            let text = "more is recorded than the job asks for";
            judged.faults.push(fault("recording-astray", on, text, AS_WRITTEN));
            continue;
        };
        if found < next {
            let text = format!(
                "{} is recorded again, or behind its turn; readings are distinguished by their order",
                named(wanted)
            );
            judged.faults.push(fault("recording-astray", on, &text, AS_WRITTEN));
            continue;
        }
        judged.faults.extend(missing(&laid.recordings[next..found], on));
        next = found + 1;
        let mut faults = held.turns(wanted, stretch);
        let (pose, axis) = at_nominal(&laid.course.stander, work, wanted, &at)?;
        let reason = match off_nominal(work, wanted, &pose) {
            Ok(difference) => judged.off([difference, axis], allowed),
            Err(error) => Some(format!("the ideal tool does not switch: {error}")),
        };
        faults.extend(reason.map(|reason| ("recording-off", on, reason)));
        judged.sound += usize::from(faults.is_empty());
        for (code, block, reason) in faults {
            let text = format!("{}, recorded in blocks {on} to {off}: {reason}", named(wanted));
            judged.faults.push(fault(code, block, &text, AS_WRITTEN));
        }
    }
    judged.faults.extend(missing(&laid.recordings[next..], followed.last_block()));
    Ok(judged)
}

/// A recording as people name it.
fn named(of: &Recording) -> String {
    let sense = match of.sense {
        Sense::Positive => "positive",
        Sense::Negative => "negative",
    };
    format!("{} flank, track {}, {sense} sense", of.flank, of.track + 1)
}

/// Recordings that should have come before a block.
fn missing(recordings: &[Recording], block: usize) -> Vec<Remark> {
    let told = |of: &Recording| {
        let text = format!("{} is not recorded up to here", named(of));
        fault("recording-missing", block, &text, "record every track in every sense of the job")
    };
    recordings.iter().map(told).collect()
}

impl Held<'_> {
    /// Sense in which the machine's axis turns for a sense of the tool.
    fn towards(&self, sense: Sense) -> f64 {
        self.laid.course.stander.sense * sense.sign()
    }

    /// The recording that a stretch is meant to be: one of the job in whose pose the tool stands, in the sense in which it turns most;
    /// else the one whose turn it is.
    fn served(&self, stretch: &Stretch, at: &Positions, next: usize) -> Result<usize, RunFailure> {
        let stander = &self.laid.course.stander;
        let turned = |m: &Motion| m.from.map_or(0.0, |from| m.to[stander.turning] - from[stander.turning]);
        let farthest = self.followed.motions[stretch.motions.clone()].iter().map(turned);
        let farthest = farthest.max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0);
        // The one whose turn it is, those behind it, those before it.
        let mut order: Vec<usize> = (next..self.laid.recordings.len()).collect();
        order.extend(0..next.min(self.laid.recordings.len()));
        let mut best = (NEAR, next);
        for number in order {
            let wanted = &self.laid.recordings[number];
            if farthest * self.towards(wanted.sense) <= 0.0 {
                continue;
            }
            let (_, axis) = at_nominal(stander, self.work, wanted, at)?;
            if axis < best.0 {
                best = (axis, number);
                // Poses that differ by digits only are the same.
                if number == next {
                    break;
                }
            }
        }
        Ok(best.1)
    }

    /// Whether a motion turns the spindle and nothing else, in a sense of the axis and at the speed of the job.
    fn is_steady(&self, motion: &Motion, towards: f64) -> bool {
        let stander = &self.laid.course.stander;
        let turning = stander.turning;
        let (Some(from), Some(seconds)) = (motion.from, motion.seconds) else { return false };
        let mut limb = stander.axes.iter();
        if limb.any(|&axis| axis != turning && (motion.to[axis] - from[axis]).abs() > STANDS) {
            return false;
        }
        let way = towards * (motion.to[turning] - from[turning]);
        // Written so that NaN and the other sense fail.
        way > 0.0 && (way / (seconds * self.work.speed) - 1.0).abs() <= SPEED + 2.0 * self.half / way
    }

    /// The longest way about a stretch on which the spindle turns steadily, from where to where; none without any.
    fn steady_way(&self, stretch: &Stretch, towards: f64) -> Option<[f64; 2]> {
        let motions = &self.followed.motions;
        let turning = self.laid.course.stander.turning;
        let (mut first, mut end) = (stretch.motions.start, stretch.motions.end);
        if !self.stands_to_switch {
            let outside = |number: &usize| {
                !self.followed.recorded(*number) && self.is_steady(&motions[*number], towards)
            };
            first -= (0..first).rev().take_while(outside).count();
            end += (end..motions.len()).take_while(outside).count();
        }
        let (mut runs, mut open) = (Vec::<[f64; 2]>::new(), false);
        for motion in &motions[first..end] {
            let Some(from) = motion.from.filter(|_| self.is_steady(motion, towards)) else {
                open = false;
                continue;
            };
            match runs.last_mut().filter(|_| open) {
                Some(run) => run[1] = motion.to[turning],
                None => runs.push([from[turning], motion.to[turning]]),
            }
            open = true;
        }
        runs.into_iter().max_by(|a, b| (a[1] - a[0]).abs().total_cmp(&(b[1] - b[0]).abs()))
    }

    /// Whether the spindle turns through what counts, with the output on, and at its speed from the run-up to where it brakes.
    fn turns(&self, wanted: &Recording, stretch: &Stretch) -> Vec<Fault> {
        let stander = &self.laid.course.stander;
        let turning = stander.turning;
        let sign = stander.machine.axes()[turning].nc_sign;
        let shown = |angle: f64| (sign * angle).to_degrees();
        let towards = self.towards(wanted.sense);
        let [on, _] = stretch.blocks;
        let motions = &self.followed.motions[stretch.motions.clone()];
        let (Some(first), Some(last)) = (motions.first(), motions.last()) else {
            return vec![("recording-off", on, "nothing moves while the output is on".into())];
        };
        let mut faults = Vec::new();
        let covers = |[from, to]: [f64; 2], wanted: [f64; 2]| {
            let digits = self.half + f64::EPSILON * 4.0 * wanted[0].abs().max(wanted[1].abs());
            towards * (wanted[0] - from) >= -digits && towards * (to - wanted[1]) >= -digits
        };
        let [from, to] = wanted.counted;
        let recorded = [first.from.map_or(f64::NAN, |from| from[turning]), last.to[turning]];
        if !covers(recorded, [from, to]) {
            let text = format!(
                "the spindle is recorded from {:.6} to {:.6} deg; what counts goes from {:.6} to {:.6} deg",
                shown(recorded[0]),
                shown(recorded[1]),
                shown(from),
                shown(to)
            );
            faults.push(("recording-short", on, text));
        }
        let [run_up, brake] = self.laid.steady;
        let needed = [from - towards * run_up, to + towards * brake];
        let steady = self.steady_way(stretch, towards);
        if steady.is_none_or(|way| !covers(way, needed)) {
            // In a recording the first block that is not steady, else what leads to it or away from it.
            let inside = motions.iter().find(|motion| !self.is_steady(motion, towards));
            let (block, found) = match (inside, steady) {
                (Some(motion), _) => {
                    let way = motion.from.map(|from| towards * (motion.to[turning] - from[turning]));
                    let speed = way.zip(motion.seconds).map_or(f64::NAN, |(way, seconds)| way / seconds);
                    (
                        motion.block,
                        format!("{:.6} deg/s in its sense, or other axes move", speed.to_degrees()),
                    )
                }
                (None, Some([a, b])) => {
                    (on, format!("its speed only from {:.6} to {:.6} deg", shown(a), shown(b)))
                }
                (None, None) => (on, "never its speed".into()),
            };
            let text = format!(
                "the spindle has {found}; it needs {:.6} deg/s from {:.6} to {:.6} deg",
                self.work.speed.to_degrees(),
                shown(needed[0]),
                shown(needed[1])
            );
            faults.push(("recording-unsteady", block, text));
        }
        faults
    }
}
