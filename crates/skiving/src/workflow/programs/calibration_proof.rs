//! A text of a calibration held against what the job wants: the mandrel stands upright, every way with the output on is straight and as
//! fast as it has to be, the beam switches where it was expected, and stays free on all other ways. Where it switches is found by the
//! distance of the beam's axis from a cylinder with two ends; the planning parts the two bodies by planes and shares no formula with it.

use super::calibration::{CalibrationCourse, MandrelWay};
use super::judge::{Followed, Judged, fault};
use super::stand::Stander;
use super::task::CalibrationWork;
use crate::measuring::{Approach, Beam, Mandrel};
use foundation::numerics::{brent, golden_section};
use machine::Positions;
use nalgebra::Vector3;
use run::RunFailure;

/// Evaluations of the nearest point of a beam.
const SEARCH: usize = 70;
/// Places of a way at which the gap is looked at before its switches are refined.
const PLACES: usize = 200;
/// What must stay between mandrel and beam on rapid ways, in shares of the reach.
const FREE: f64 = 0.5;
/// How far a speed may be off, as a share.
const SPEED: f64 = 1e-5;
/// How far a way may begin or end elsewhere than wanted, mm; its switches are held more closely.
const NEAR: f64 = 0.01;

const AS_WRITTEN: &str = "correct these blocks, or take the text as it was written";

/// Gap between a beam and an upright mandrel with its axis at X, Y and its lower face at Z, mm; < 0 in the dark.
pub(super) fn gap(beam: &Beam, mandrel: &Mandrel, place: &Vector3<f64>) -> f64 {
    let middle = place + Vector3::z() * (0.5 * mandrel.height);
    let unit = beam.unit();
    // The body is convex, so that the distance along the beam has one minimum, near the foot of the body's middle.
    let foot = (middle - beam.point).dot(&unit);
    let reach = mandrel.radius + mandrel.height + (middle - beam.point - unit * foot).norm();
    let distance = |way: f64| {
        let off = beam.point + unit * way - middle;
        let (beside, above) = (off.xy().norm() - mandrel.radius, off.z.abs() - 0.5 * mandrel.height);
        if beside <= 0.0 && above <= 0.0 { beside.max(above) } else { beside.max(0.0).hypot(above.max(0.0)) }
    };
    let way = golden_section(foot - reach, foot + reach, SEARCH, distance);
    distance(way) - beam.radius
}

/// Judges the ways of a text; `allowed` is what digits explain, mm.
///
/// # Errors
/// Positions that are not finite.
pub(super) fn judged(
    laid: &CalibrationCourse<'_>,
    work: &CalibrationWork<'_>,
    followed: &Followed,
    allowed: f64,
) -> Result<Judged, RunFailure> {
    let mut judged = Judged { faults: followed.faults.clone(), ..Judged::default() };
    let stander = &laid.course.stander;
    let last = followed.last_block();
    for (number, wanted) in laid.ways.iter().enumerate() {
        let Some(stretch) = followed.stretches.get(number) else {
            let text = format!("{} is not driven up to here", named(wanted));
            judged.faults.push(fault("calibration-missing", last, &text, AS_WRITTEN));
            continue;
        };
        let [on, off] = stretch.blocks;
        let motions = &followed.motions[stretch.motions.clone()];
        let before = judged.faults.len();
        for reason in way(stander, work, wanted, motions, allowed, &mut judged)? {
            let text = format!("{}, recorded in blocks {on} to {off}: {reason}", named(wanted));
            judged.faults.push(fault("calibration-off", on, &text, AS_WRITTEN));
        }
        judged.sound += usize::from(judged.faults.len() == before);
    }
    for stretch in followed.stretches.iter().skip(laid.ways.len()) {
        let text = "more is recorded than the job asks for";
        judged.faults.push(fault("calibration-off", stretch.blocks[0], text, AS_WRITTEN));
    }
    let free = FREE * work.reach;
    for (number, motion) in followed.motions.iter().enumerate() {
        if followed.recorded(number) {
            continue;
        }
        // A straight way leads out of the beam again; rapid ones stay beside it.
        let straight = motion.seconds.is_some();
        let from = motion.from.as_ref().filter(|_| !straight).unwrap_or(&motion.to);
        let nearest = nearest(stander, work, [from, &motion.to])?;
        // Written so that NaN is a fault.
        let is_free = nearest >= free;
        if !is_free {
            let way = if straight { "at the end of a straight way" } else { "on a rapid way" };
            let text = format!(
                "{way} the mandrel comes as near as {nearest:.3} mm to the beam; {free:.3} mm leave it free"
            );
            judged.faults.push(fault("beam-not-free", motion.block, &text, "go around the beam"));
        }
        if let (Some(seconds), Some(from)) = (motion.seconds, &motion.from) {
            let speed = (stander.tool(&motion.to)?.position - stander.tool(from)?.position).norm() / seconds;
            if speed > work.speed * (1.0 + SPEED) {
                let text = format!(
                    "the mandrel moves at {:.1} mm/min beside what is recorded; the job says {:.1} mm/min",
                    60.0 * speed,
                    60.0 * work.speed
                );
                judged.faults.push(fault(
                    "too-fast-at-the-beam",
                    motion.block,
                    &text,
                    "give the block more time",
                ));
            }
        }
    }
    Ok(judged)
}

/// A way as people name it.
fn named(of: &MandrelWay) -> String {
    let axis = match of.along {
        Approach::X => "X",
        Approach::Y => "Y",
    };
    format!("the way along {axis} at Z = {:.3} mm, spindle at {:.3} deg", of.ends[0].z, of.turn.to_degrees())
}

/// What is wrong with a way.
fn way(
    stander: &Stander<'_>,
    work: &CalibrationWork<'_>,
    wanted: &MandrelWay,
    motions: &[super::judge::Motion],
    allowed: f64,
    judged: &mut Judged,
) -> Result<Vec<String>, RunFailure> {
    let (Some(first), Some(end)) = (motions.first(), motions.last()) else {
        return Ok(vec!["nothing moves while the output is on".into()]);
    };
    let Some(begin) = first.from else { return Ok(vec!["it begins where the axes are not known".into()]) };
    let mut faults = Vec::new();
    let ends = [stander.tool(&begin)?, stander.tool(&end.to)?];
    for (found, wanted) in ends.iter().zip(&wanted.ends) {
        if (found.position - wanted).norm() > NEAR {
            faults.push(format!(
                "it begins or ends {:.3} mm beside its place",
                (found.position - wanted).norm()
            ));
        }
    }
    let lean = ends.iter().map(|end| end.lean.abs().max(end.swivel.abs())).fold(0.0, f64::max);
    let turned = ends.iter().map(|end| (end.turn - wanted.turn).sin().abs()).fold(0.0, f64::max);
    if lean * work.mandrel.height > allowed || turned * work.mandrel.radius > allowed {
        faults.push("the mandrel does not stand upright at its turn of the spindle".into());
    }
    let mut found = Vec::new();
    for motion in motions {
        let from = motion.from.unwrap_or(begin);
        let seconds = motion.seconds.unwrap_or(f64::NAN);
        let [a, b] = [stander.tool(&from)?.position, stander.tool(&motion.to)?.position];
        // Written so that NaN and rapid motions fail.
        let kept =
            ((b - a).norm() / (seconds * work.speed) - 1.0).abs() <= SPEED + 2.0 * allowed / (b - a).norm();
        if !kept {
            faults.push(format!("block {} takes {seconds:.4} s for {:.4} mm", motion.block, (b - a).norm()));
        }
        found.extend(switches(work, [&a, &b]));
    }
    if found.len() != wanted.switches.len() {
        faults.push(format!("the beam switches {} times, wanted are {}", found.len(), wanted.switches.len()));
        return Ok(faults);
    }
    for (found, wanted) in found.iter().zip(&wanted.switches) {
        let off = found - wanted;
        let along = off.norm();
        if let Some(reason) = judged.off([along, 0.0], allowed) {
            faults.push(reason);
        }
    }
    Ok(faults)
}

/// Places of a straight way at which the beam switches, in their order.
fn switches(work: &CalibrationWork<'_>, [from, to]: [&Vector3<f64>; 2]) -> Vec<Vector3<f64>> {
    let at = |share: f64| from + (to - from) * share;
    let off = |share: f64| gap(work.beam, work.mandrel, &at(share));
    let shares: Vec<f64> = (0..=PLACES).map(|k| k as f64 / PLACES as f64).collect();
    let values: Vec<f64> = shares.iter().map(|share| off(*share)).collect();
    let crossing = |k: usize| {
        let ends = [values[k], values[k + 1]];
        let found =
            (ends[0] * ends[1] < 0.0).then(|| brent([shares[k], shares[k + 1]], ends, 0.0, |s| Some(off(s))));
        found.flatten().map(at)
    };
    (0..PLACES).filter_map(crossing).collect()
}

/// The least gap on a way.
fn nearest(
    stander: &Stander<'_>,
    work: &CalibrationWork<'_>,
    [from, to]: [&Positions; 2],
) -> Result<f64, RunFailure> {
    let [a, b] = [stander.tool(from)?.position, stander.tool(to)?.position];
    let at = |k: usize| gap(work.beam, work.mandrel, &(a + (b - a) * (k as f64 / PLACES as f64)));
    Ok((0..=PLACES).map(at).fold(f64::INFINITY, f64::min))
}
