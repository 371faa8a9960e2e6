//! The course of a probe that scans the machined workpiece along its base circle: the ball runs on a straight line that touches the base
//! circle while the workpiece rolls under it (`docs/mathematics/skiving.md#measuring-the-workpiece`).

use super::course::Course;
use super::failure::{invalid, of_machine};
use super::room::Room;
use super::skive::work_turning;
use super::task::{Carrier, ProbeWork, ToolMachining};
use crate::measuring::{Beam, MeasuringPose};
use foundation::geometry::{Flank, Helicoid, Surface};
use foundation::numerics::wrapped_angle;
use machine::{Mount, Positions};
use nalgebra::{Rotation3, Vector3};
use run::RunFailure;
use std::f64::consts::TAU;

/// A profile that is scanned.
#[derive(Clone, Debug, PartialEq)]
pub struct ProbedProfile {
    /// Flank.
    pub flank: Flank,
    /// Tooth space.
    pub gap: usize,
    /// Lengths of roll of its places, mm.
    pub lengths: Vec<f64>,
}

/// A course with what is scanned on it.
#[derive(Clone, Debug)]
pub(super) struct ProbeCourse<'m> {
    pub course: Course<'m>,
    pub profiles: Vec<ProbedProfile>,
    /// The axis that turns the workpiece, and its sense.
    pub turning: (usize, f64),
    /// Greatest distance of a contact from a rotary axis, mm.
    pub lever: f64,
}

/// Where ball and workpiece stand: the ball on the bed, the workpiece turned.
#[derive(Clone, Copy, Debug)]
struct Stand {
    ball: Vector3<f64>,
    turn: f64,
}

/// Lays a measurement of the workpiece out.
///
/// # Errors
/// Places that the machine does not reach, a ball that does not fit into the tooth space.
pub(super) fn probe_course<'m>(
    work: &ProbeWork<'_>,
    machining: &ToolMachining<'m>,
) -> Result<ProbeCourse<'m>, RunFailure> {
    let mount = Mount { reversed: false, axial: work.length, angle: 0.0 };
    // The workpiece is measured where it was machined, with the carrier parked.
    let carrier = machining.carrier.map(|carrier| Carrier { measuring: carrier.parked, ..carrier });
    let machining = ToolMachining { mount, carrier, ..machining.clone() };
    let turning =
        work_turning(&machining.machine.machine).map_err(|error| of_machine(&error, "the work spindle"))?;
    let nowhere =
        Beam { point: Vector3::repeat(1e9), direction: Vector3::z(), level: Vector3::z(), radius: 1.0 };
    let mut course = Course::in_room(&machining, Room::around(&nowhere, 0.0))?;
    course.stander.axes.push(turning.0);
    let mut laid = ProbeCourse { course, profiles: Vec::new(), turning, lever: 0.0 };
    for &gap in work.gaps {
        for flank in Flank::BOTH {
            laid.profile(work, flank, gap)?;
        }
    }
    Ok(laid)
}

impl ProbeCourse<'_> {
    /// In to the flank, along it, out again.
    fn profile(&mut self, work: &ProbeWork<'_>, flank: Flank, gap: usize) -> Result<(), RunFailure> {
        let name = format!("{flank} flank of tooth space {gap}");
        let stands: Vec<Stand> =
            work.lengths[flank].iter().map(|w| rolled(work, (flank, gap), *w, 0.0)).collect();
        let [Some(first), Some(last)] = [stands.first(), stands.last()] else { return Ok(()) };
        let other = if flank == Flank::Left { Flank::Right } else { Flank::Left };
        // Off the flank at both ends, in the middle of what is free there.
        let room = |w: f64| {
            let at = centre(work, (flank, gap), w, 0.0);
            let opposite = work.bodies.edges[other].flank().helicoid().flank();
            // From the flank of this tooth space, not of the next one.
            let free = opposite.deviation(&back(work, gap, &at)).f_n.rem_euclid(base_pitch(work));
            free - work.ball_radius
        };
        let [begin, end] = [work.lengths[flank][0], *work.lengths[flank].last().unwrap_or(&f64::NAN)];
        let free = room(begin).min(room(end)).min(2.0 * work.clearance);
        // Written so that NaN does not fit.
        let fits = free >= LEAST_ROOM;
        if !fits {
            return Err(invalid(
                "workpiece_probe.ball_radius",
                work.ball_radius,
                "a ball that fits into the tooth space",
            ));
        }
        let off = 0.5 * free;
        let [before, behind] = [begin, end].map(|w| rolled(work, (flank, gap), w, off));
        let outside = |stand: &Stand| Stand { ball: radial(work, &stand.ball), ..*stand };
        self.course.comment(&format!("probe {flank} gap {gap}"));
        let at = self.stand(work, &outside(&before), &name)?;
        self.course.rapid(at);
        let in_and_out = |course: &mut Self, from: &Stand, to: &Stand| -> Result<(), RunFailure> {
            let at = course.stand(work, to, &name)?;
            let way =
                (to.ball - from.ball).norm().max(work.reach_of_turn(wrapped_angle(from.turn - to.turn)));
            course.course.straight(at, way / work.speed);
            Ok(())
        };
        in_and_out(self, &outside(&before), &before)?;
        in_and_out(self, &before, first)?;
        let at = self.stand(work, first, &name)?;
        self.lever = self.lever.max(self.course.lever(&at, &Vector3::new(work.reach, 0.0, 0.0))?);
        self.lever = self.lever.max(first.ball.xy().norm()).max(last.ball.xy().norm());
        self.course.output(true);
        for (a, b) in stands.iter().zip(&stands[1..]) {
            in_and_out(self, a, b)?;
        }
        self.course.output(false);
        in_and_out(self, last, &behind)?;
        in_and_out(self, &behind, &outside(&behind))?;
        self.profiles.push(ProbedProfile { flank, gap, lengths: work.lengths[flank].clone() });
        Ok(())
    }

    /// The axes with the ball at a place and the workpiece turned.
    fn stand(&self, work: &ProbeWork<'_>, stand: &Stand, place: &str) -> Result<Positions, RunFailure> {
        let [swivel, turn] = work.orientation;
        let beside = swivelled_and_turned(swivel, turn) * Vector3::new(work.reach, 0.0, 0.0);
        let pose = MeasuringPose {
            swivel,
            turn,
            position: stand.ball - beside,
            off_flank: 0.0,
            beam_in_tool: Vector3::z(),
        };
        let mut at = self.course.stander.stand(&pose, self.course.at.as_ref(), place)?;
        let (axis, sense) = self.turning;
        let before = self.course.at.map_or(0.0, |at| at[axis]);
        let wanted = sense * stand.turn;
        at[axis] = wanted + TAU * ((before - wanted) / TAU).round();
        Ok(at)
    }
}

/// What must be free of a ball in the tooth space, mm.
const LEAST_ROOM: f64 = 0.02;

/// Rx(A) Rz(B).
pub(super) fn swivelled_and_turned(swivel: f64, turn: f64) -> Rotation3<f64> {
    Rotation3::from_axis_angle(&Vector3::x_axis(), swivel)
        * Rotation3::from_axis_angle(&Vector3::z_axis(), turn)
}

/// Normal base pitch: distance of one flank from the next of its kind, mm.
pub(super) fn base_pitch(work: &ProbeWork<'_>) -> f64 {
    let flank = work.bodies.edges.left.flank().helicoid().flank();
    let teeth = f64::from(work.bodies.pair.gear().data().teeth.abs());
    TAU * flank.base_radius * flank.base_helix_angle.cos() / teeth
}

/// A point of the workpiece seen from its tooth space 0.
pub(super) fn back(work: &ProbeWork<'_>, gap: usize, point: &Vector3<f64>) -> Vector3<f64> {
    let pitch = TAU / f64::from(work.bodies.pair.gear().data().teeth.abs());
    Rotation3::from_axis_angle(&Vector3::z_axis(), -pitch * gap as f64) * point
}

/// Centre of the ball at a place of a flank, so far off it, in coordinates of the workpiece, mm.
fn centre(work: &ProbeWork<'_>, (flank, gap): (Flank, usize), w: f64, off: f64) -> Vector3<f64> {
    let helicoid: &Helicoid = work.bodies.edges[flank].flank().helicoid();
    let jet = helicoid.jet(w, work.height);
    let at = jet.point + jet.normal * (work.ball_radius + off);
    let pitch = TAU / f64::from(work.bodies.pair.gear().data().teeth.abs());
    Rotation3::from_axis_angle(&Vector3::z_axis(), pitch * gap as f64) * at
}

/// The ball on the line that touches the base circle, with the workpiece turned under it.
fn rolled(work: &ProbeWork<'_>, place: (Flank, usize), w: f64, off: f64) -> Stand {
    let at = centre(work, place, w, off);
    let base = work.bodies.edges[place.0].flank().helicoid().flank().base_radius;
    let lengths = &work.lengths[place.0];
    let middle = 0.5 * (lengths[0] + lengths[lengths.len() - 1]);
    // With the ball in the middle of the profile right before the tool's side.
    let sense = if place.0 == Flank::Left { 1.0 } else { -1.0 };
    let tangent = |point: &Vector3<f64>| (point.xy().norm_squared() - base * base).max(0.0).sqrt();
    let lean = (tangent(&centre(work, place, middle, 0.0)) / base).atan();
    let line = sense * (tangent(&at) / base).atan() - sense * lean;
    // Azimuth 0 of the machine is X; an internal gear is touched on the other side.
    let azimuth = if work.bodies.pair.gear().data().teeth > 0 { 0.0 } else { std::f64::consts::PI };
    let radius = at.xy().norm();
    let (sin, cos) = (azimuth + line).sin_cos();
    Stand {
        ball: Vector3::new(radius * cos, radius * sin, at.z + work.work_height),
        turn: azimuth + line - at.y.atan2(at.x),
    }
}

/// The same place outside of the tip circle.
fn radial(work: &ProbeWork<'_>, ball: &Vector3<f64>) -> Vector3<f64> {
    let external = work.bodies.pair.gear().data().teeth > 0;
    let beside = work.ball_radius + work.clearance;
    let radius = if external { work.tip_radius + beside } else { work.tip_radius - beside };
    let scale = radius / ball.xy().norm();
    Vector3::new(ball.x * scale, ball.y * scale, ball.z)
}
