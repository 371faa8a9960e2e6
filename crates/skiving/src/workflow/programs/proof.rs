//! The proof of a measurement: with the axes where the text puts them the ideal tool switches the beam at the nominal place, and the
//! tool turns as it has to while the output is on.

use super::failure::{not_proven, of_skiving};
use super::measuring::{MeasuringCourse, Recording};
use super::replay::Move;
use super::stand::Stander;
use super::task::MeasuringWork;
use crate::SkivingError;
use crate::measuring::{Barrier, Beam, MeasuringPose, RealTool};
use machine::Positions;
use nalgebra::Vector3;
use run::RunFailure;

/// What an independent reader found of a text. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proof {
    /// Greatest way of the flank between where the ideal tool switches and the nominal place: lever times the angle between them. Of
    /// a scan: of the gap between edge and stylus.
    pub difference: f64,
    /// Greatest distance of the beam's axis from where the contact of the ideal tool wants it, at the beam's radius along the normal.
    pub axis_distance: f64,
    /// What rounding of the text explains of both.
    pub allowed: f64,
    /// Of a scan: what straight blocks leave between its places, greatest gap; of a stroke: beside its law.
    pub between_places: Option<f64>,
    /// Of a stroke: greatest difference between the flank of the text under the referee and the planned one.
    pub flank: Option<f64>,
}

/// Error of the proof's own numbers: mm at places of some 1000 mm, and rad.
pub(super) const OWN_ROUNDING: f64 = 1e-9;
/// How far a speed may be off, as a share: what six digits of the feed leave.
pub(super) const SPEED: f64 = 1e-6;

impl Proof {
    pub(super) fn new(allowed: f64) -> Self {
        Self { difference: 0.0, axis_distance: 0.0, allowed, between_places: None, flank: None }
    }

    /// Takes a place in and says whether it is explained.
    ///
    /// # Errors
    /// A place farther off than rounding explains.
    pub(super) fn add(&mut self, [difference, axis]: [f64; 2], place: &str) -> Result<(), RunFailure> {
        let difference = difference.abs();
        // Written so that NaN fails.
        let explained = difference <= self.allowed && axis <= self.allowed;
        if !explained {
            let [found, axis, allowed] = [difference, axis, self.allowed].map(|x| x * 1e3);
            return Err(not_proven(format!(
                "{place}: the ideal tool touches {found:.6} um off its nominal place, the beam lies {axis:.6} um off; digits explain \
                 {allowed:.6} um"
            )));
        }
        self.difference = self.difference.max(difference);
        self.axis_distance = self.axis_distance.max(axis);
        Ok(())
    }
}

/// Distance of a point from the beam's axis, mm.
pub(super) fn off_axis(beam: &Beam, point: &Vector3<f64>) -> f64 {
    beam.unit().cross(&(point - beam.point)).norm()
}

/// Proves the recordings of a text; `angle` is half a unit of the text's angles, rad.
///
/// # Errors
/// A text that records something else.
pub(super) fn prove(
    laid: &MeasuringCourse<'_>,
    work: &MeasuringWork<'_>,
    found: &[Vec<Move>],
    [allowed, angle]: [f64; 2],
) -> Result<Proof, RunFailure> {
    if found.len() != laid.recordings.len() {
        let text = format!("{} recordings in the text, {} planned", found.len(), laid.recordings.len());
        return Err(not_proven(text));
    }
    let mut proof = Proof::new(allowed);
    for (wanted, moves) in laid.recordings.iter().zip(found) {
        let Recording { flank, track, .. } = *wanted;
        let place = format!("{flank} flank, track {}", track + 1);
        turns(laid, wanted, moves, work.speed, angle).map_err(|reason| {
            not_proven(format!("{place}, {:?} sense: {reason}", wanted.sense).to_lowercase())
        })?;
        let Some(first) = moves.first() else { continue };
        let (pose, axis) = at_nominal(&laid.course.stander, work, wanted, &first.from)?;
        let difference = off_nominal(work, wanted, &pose).map_err(|error| of_skiving(&error))?;
        proof.add([difference, axis], &place)?;
    }
    Ok(proof)
}

/// The tool as the axes stand, with its spindle at the nominal place of a recording; and how far the beam's axis lies from where the
/// contact wants it, mm.
///
/// # Errors
/// Positions that are not finite.
pub(super) fn at_nominal(
    stander: &Stander<'_>,
    work: &MeasuringWork<'_>,
    wanted: &Recording,
    at: &Positions,
) -> Result<(MeasuringPose, f64), RunFailure> {
    let mut at = *at;
    at[stander.turning] = wanted.nominal;
    let stands = stander.tool(&at)?;
    let (of, planned) = &work.flanks[wanted.flank].tracks[wanted.track];
    let (contact, pose) = (&of.contact, stands.pose(planned));
    let axis = pose.to_machine(pose.turn, &(contact.point + contact.normal * work.beam.radius));
    let lean = stands.lean.abs() * contact.point.norm();
    Ok((pose, off_axis(work.beam, &axis) + lean))
}

/// How far the ideal tool switches from the nominal place of a recording in a pose, on the flank, mm.
///
/// # Errors
/// A tool that does not switch there.
pub(super) fn off_nominal(
    work: &MeasuringWork<'_>,
    wanted: &Recording,
    pose: &MeasuringPose,
) -> Result<f64, SkivingError> {
    let (of, _) = &work.flanks[wanted.flank].tracks[wanted.track];
    let barrier = Barrier { beam: work.beam, pose };
    let ideal = RealTool::ideal(work.teeth());
    let touch = barrier.touch(&work.flanks[wanted.flank].edge, &ideal, of, 0, work.beam.radius)?;
    Ok(of.contact.lever * (touch.turn - pose.turn))
}

/// Whether nothing but the spindle moves, from where to where and as fast as it has to.
fn turns(
    laid: &MeasuringCourse<'_>,
    wanted: &Recording,
    moves: &[Move],
    speed: f64,
    angle: f64,
) -> Result<(), String> {
    let stander = &laid.course.stander;
    let turning = stander.turning;
    let towards = stander.sense * wanted.sense.sign();
    let (Some(first), Some(last)) = (moves.first(), moves.last()) else {
        return Err("nothing moves while the output is on".into());
    };
    let half = angle + OWN_ROUNDING;
    let [on, off] = wanted.switched;
    let ends = [(first.from[turning], on), (last.to[turning], off)];
    for (found, wanted) in ends {
        // Written so that NaN fails.
        let same = (found - wanted).abs() <= half + f64::EPSILON * 4.0 * wanted.abs();
        if !same {
            let [found, wanted] = [found, wanted].map(f64::to_degrees);
            return Err(format!("the spindle is recorded to {found} deg, planned {wanted} deg"));
        }
    }
    for part in moves {
        let limb = &stander.axes;
        if limb.iter().any(|&axis| axis != turning && part.to[axis] != first.from[axis]) {
            return Err("another axis than the spindle moves while the output is on".into());
        }
        let way = towards * (part.to[turning] - part.from[turning]);
        let allowed = SPEED + 2.0 * half / way;
        // Written so that NaN and the other sense fail.
        let kept = way > 0.0 && (way / (part.seconds * speed) - 1.0).abs() <= allowed;
        if !kept {
            let found = (way / part.seconds).to_degrees();
            return Err(format!(
                "the spindle turns with {found} deg/s in its sense, planned {}",
                speed.to_degrees()
            ));
        }
    }
    Ok(())
}
