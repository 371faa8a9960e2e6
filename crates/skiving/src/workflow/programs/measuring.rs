//! The course of a measurement at the light barrier: for every track into its pose, for every sense of the spindle a run-up, whole
//! turns at constant speed while the output is on, and back out of the beam (`docs/mathematics/skiving.md`).

use super::course::Course;
use super::failure::invalid;
use super::task::{MeasuringWork, ToolMachining};
use crate::measuring::Sense;
use foundation::geometry::{Flank, Sides};
use machine::Positions;
use run::RunFailure;
use std::f64::consts::{PI, TAU};

/// What the recorder takes down with the tool in one pose, turning in one sense. Angles of the axis that turns the tool as the
/// machine counts it, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recording {
    /// Flank of the workpiece whose edge is measured.
    pub flank: Flank,
    /// Track, from 0.
    pub track: usize,
    /// Sense of the tool.
    pub sense: Sense,
    /// Where tooth 0 of the ideal tool switches: tooth k does 2 pi k/z1 before, in the sense of the tool's own angle.
    pub nominal: f64,
    /// Between where and where the switches count: the whole turns and one pitch more, beginning half a pitch beside a nominal place.
    pub counted: [f64; 2],
    /// Where the output is switched on and off: beside what counts by the ways to start and to brake on a control that stands still
    /// for it.
    pub switched: [f64; 2],
}

/// A course with what is recorded on it, and the pose of every recording.
#[derive(Clone, Debug)]
pub(super) struct MeasuringCourse<'m> {
    pub course: Course<'m>,
    pub recordings: Vec<Recording>,
    /// Ways over which the spindle has its speed before and behind what counts, rad: to run up and to brake, at least a pitch.
    pub steady: [f64; 2],
    /// Greatest distance of a contact from a rotary axis, mm.
    pub lever: f64,
}

/// Lays a measurement out for a control that stands still to switch an output, or does not.
///
/// # Errors
/// Poses that the machine does not reach, a beam that is not free between them, a speed that the spindle does not have after half a
/// turn.
pub(super) fn measuring_course<'m>(
    work: &MeasuringWork<'_>,
    machining: &ToolMachining<'m>,
    stands_to_switch: bool,
) -> Result<MeasuringCourse<'m>, RunFailure> {
    let edges = Sides { left: &work.flanks.left.edge, right: &work.flanks.right.edge };
    let course = Course::new(machining, &edges, work.beam)?;
    let pitch = TAU / work.teeth() as f64;
    let run_up = course.run_up(course.stander.turning, work.speed)?;
    // The run-up is half a turn, less what brings it to the middle between two nominal places.
    if run_up > PI - pitch {
        return Err(invalid(
            "measuring.speed_rpm",
            work.speed,
            "a speed that the spindle has after half a turn",
        ));
    }
    let turning = Turning { pitch, brake: run_up.max(pitch), stands_to_switch };
    let steady = [turning.brake.min(PI - pitch), turning.brake];
    let mut laid = MeasuringCourse { course, recordings: Vec::new(), steady, lever: 0.0 };
    for flank in [Flank::Left, Flank::Right] {
        for (track, (of, pose)) in work.flanks[flank].tracks.iter().enumerate() {
            let place = format!("{flank} flank, track {}", track + 1);
            laid.course.comment(&format!("{flank} track {}", track + 1));
            let nominal = laid.course.approach(pose, false, &place)?;
            laid.lever = laid.lever.max(laid.course.lever(&nominal, &of.contact.point)?);
            for &sense in work.senses {
                laid.record((flank, track, sense), &nominal, work, &turning);
            }
            laid.course.draw_back(pose, &place)?;
        }
    }
    laid.course.park()?;
    Ok(laid)
}

/// How the spindle is turned, rad.
struct Turning {
    /// From tooth to tooth.
    pitch: f64,
    /// Way to brake after a recording, at least a pitch.
    brake: f64,
    /// Whether it stands while the output is switched.
    stands_to_switch: bool,
}

impl MeasuringCourse<'_> {
    fn record(
        &mut self,
        (flank, track, sense): (Flank, usize, Sense),
        nominal: &Positions,
        work: &MeasuringWork<'_>,
        &Turning { pitch, brake, stands_to_switch }: &Turning,
    ) {
        let axis = self.course.stander.turning;
        let towards = self.course.stander.sense * sense.sign();
        let Some(mut at) = self.course.at else { return };
        let (here, nominal) = (at[axis], nominal[axis]);
        let mut turn = |course: &mut Course<'_>, to: f64| {
            let seconds = (to - at[axis]).abs() / work.speed;
            at[axis] = to;
            course.straight(at, seconds);
        };
        // The farthest place within half a turn that lies half a pitch before a nominal one.
        let ahead = towards * (here - nominal) + 0.5 * pitch;
        let run_in = ((ahead + PI) / pitch).floor() * pitch - ahead;
        let from = here + towards * run_in;
        let to = from + towards * (TAU * work.revolutions as f64 + pitch);
        let braked = to + towards * brake;
        let course = &mut self.course;
        let switched = if stands_to_switch {
            course.output(true);
            turn(course, from);
            turn(course, to);
            turn(course, braked);
            course.output(false);
            // The next recording begins elsewhere: an output is switched by a motion of its own.
            turn(course, braked + towards * pitch);
            [here, braked]
        } else {
            turn(course, from);
            course.output(true);
            turn(course, to);
            course.output(false);
            turn(course, braked);
            [from, to]
        };
        self.recordings.push(Recording { flank, track, sense, nominal, counted: [from, to], switched });
    }
}
