//! Scans of edges in a text: which edge each serves, whether the stylus touches it at every place of the job, and how fast it goes from
//! place to place.

use super::following::Stretch;
use super::{Followed, Judged, fault};
use crate::workflow::programs::scan::{ScanCourse, Scanned};
use crate::workflow::programs::scan_proof::off_edge;
use crate::workflow::programs::task::ScanWork;
use machine::Positions;
use run::RunFailure;
use verdict::Remark;

/// A place this near to one of the job is meant to be it, mm.
const NEAR: f64 = 0.01;
/// What digits of the feed may do to the time from place to place, as a share.
const TIME: f64 = 1e-5;

const AS_WRITTEN: &str = "correct these blocks, or take the text as it was written";

/// Judges the scans of a text; `allowed` is what digits explain, mm.
///
/// # Errors
/// Positions that are not finite.
pub(in super::super) fn scans(
    laid: &ScanCourse<'_>,
    work: &ScanWork<'_>,
    followed: &Followed,
    allowed: f64,
) -> Result<Judged, RunFailure> {
    let mut judged = Judged::default();
    let mut next = 0;
    for stretch in &followed.stretches {
        let [on, off] = stretch.blocks;
        // Where the axes stand is not known; that is told already.
        let Some(at) = followed.begin(stretch) else { continue };
        let found = served(laid, work, &at, next)?;
        let Some(wanted) = laid.scanned.get(found) else {
            judged.faults.push(fault("scan-astray", on, "more is scanned than the job asks for", AS_WRITTEN));
            continue;
        };
        if found < next {
            let text = format!(
                "{} is scanned again, or behind its turn; scans are distinguished by their order",
                named(wanted)
            );
            judged.faults.push(fault("scan-astray", on, &text, AS_WRITTEN));
            continue;
        }
        judged.faults.extend(missing(&laid.scanned[next..found], on));
        next = found + 1;
        let before = judged.faults.len();
        let course = (laid, work, found);
        for (code, block, reason) in places(course, followed, (stretch, &at), allowed, &mut judged)? {
            let text = format!("{}, scanned in blocks {on} to {off}: {reason}", named(wanted));
            judged.faults.push(fault(code, block, &text, AS_WRITTEN));
        }
        judged.sound += usize::from(judged.faults.len() == before);
    }
    judged.faults.extend(missing(&laid.scanned[next..], followed.last_block()));
    Ok(judged)
}

/// An edge as people name it.
fn named(of: &Scanned) -> String {
    format!("{} flank, tooth {}", of.flank, of.tooth)
}

/// Edges that should have been scanned before a block.
fn missing(scanned: &[Scanned], block: usize) -> Vec<Remark> {
    let told = |of: &Scanned| {
        let text = format!("{} is not scanned up to here", named(of));
        fault("scan-missing", block, &text, "scan both edges of every tooth of the job")
    };
    scanned.iter().map(told).collect()
}

/// The edge that a scan is meant to be: one of the job with a place where the tool stands, else the one whose turn it is.
fn served(
    laid: &ScanCourse<'_>,
    work: &ScanWork<'_>,
    at: &Positions,
    next: usize,
) -> Result<usize, RunFailure> {
    let mut best = (NEAR, next);
    for (number, scanned) in laid.scanned.iter().enumerate() {
        for place in &scanned.places {
            let [_, axis] = off_edge(&laid.course.stander, work, scanned, place, at)?;
            if axis < best.0 {
                best = (axis, number);
            }
        }
    }
    Ok(best.1)
}

/// What is wrong between two places or at one: code, block, reason.
type Fault = (&'static str, usize, String);

/// Goes through a scan from place to place.
fn places(
    (laid, work, found): (&ScanCourse<'_>, &ScanWork<'_>, usize),
    followed: &Followed,
    (stretch, begin): (&Stretch, &Positions),
    allowed: f64,
    judged: &mut Judged,
) -> Result<Vec<Fault>, RunFailure> {
    let (stander, scanned, times) = (&laid.course.stander, &laid.scanned[found], &laid.times[found]);
    let [on, _] = stretch.blocks;
    let motions = &followed.motions[stretch.motions.clone()];
    let stops = std::iter::once((on, begin, None))
        .chain(motions.iter().map(|motion| (motion.block, &motion.to, motion.seconds)));
    let mut faults = Vec::new();
    let (mut next, mut passed, mut elapsed) = (0, 0, 0.0);
    for (k, (block, at, seconds)) in stops.enumerate() {
        elapsed += seconds.unwrap_or(0.0);
        // The place of the edge, from the one whose turn it is on, that is nearest.
        let mut nearest: Option<(usize, [f64; 2])> = None;
        for (number, place) in scanned.places.iter().enumerate().skip(next) {
            let off = off_edge(stander, work, scanned, place, at)?;
            if nearest.is_none_or(|(_, best)| off[1] < best[1]) {
                nearest = Some((number, off));
            }
            // Its own place: no other is looked at.
            if number == next && off[1] <= allowed {
                break;
            }
        }
        let Some((number, off)) = nearest else {
            faults.push(("scan-off", block, "it goes on behind the last place".into()));
            continue;
        };
        // A place that was moved is still the one whose turn it is.
        let (number, off) = if off[1] > NEAR && number != next {
            (next, off_edge(stander, work, scanned, &scanned.places[next], at)?)
        } else {
            (number, off)
        };
        if let Some(reason) = judged.off(off, allowed) {
            faults.push(("scan-off", block, format!("place {}: {reason}", number + 1)));
        }
        if number > next {
            let text = match number - next {
                1 => format!("place {} is left out", next + 1),
                _ => format!("places {} to {} are left out", next + 1, number),
            };
            faults.push(("scan-off", block, text));
        }
        let planned: f64 = times[passed.min(number)..number].iter().sum();
        // Written so that NaN is told.
        let kept = (elapsed - planned).abs() <= TIME * planned;
        if k > 0 && !kept {
            let text = format!(
                "{elapsed:.6} s to place {}; with the speed of the job it takes {planned:.6} s",
                number + 1
            );
            faults.push(("scan-at-other-speed", block, text));
        }
        (next, passed, elapsed) = (number + 1, number, 0.0);
    }
    if next < scanned.places.len() {
        let block = motions.last().map_or(on, |last| last.block);
        faults.push(("scan-off", block, format!("it ends at place {next} of {}", scanned.places.len())));
    }
    Ok(faults)
}
