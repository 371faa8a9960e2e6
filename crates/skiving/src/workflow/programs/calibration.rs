//! The course of a calibration: a mandrel in the upright spindle is driven through the beam along Y and into it along X, at two heights,
//! with the output on, so that the recorder takes down where the axes stand when the beam switches
//! (`docs/mathematics/skiving.md#light-barrier`).

use super::course::Course;
use super::failure::of_skiving;
use super::room::Room;
use super::task::{CalibrationWork, ToolMachining};
use crate::SkivingError;
use crate::measuring::{Approach, BeamLine, MeasuringPose};
use machine::{Mount, Positions};
use nalgebra::Vector3;
use run::RunFailure;
use std::f64::consts::TAU;

/// One way of the mandrel with the output on. mm, rad; places are those of its axis and its lower face.
#[derive(Clone, Debug, PartialEq)]
pub struct MandrelWay {
    /// Along which axis.
    pub along: Approach,
    /// Turn of the spindle.
    pub turn: f64,
    /// Where it begins and ends.
    pub ends: [Vector3<f64>; 2],
    /// Where the given beam switches: twice along Y, once along X.
    pub switches: Vec<Vector3<f64>>,
}

/// A course with the ways on which the beam switches.
#[derive(Clone, Debug)]
pub(super) struct CalibrationCourse<'m> {
    pub course: Course<'m>,
    pub ways: Vec<MandrelWay>,
    /// Greatest distance of the mandrel from a rotary axis, mm.
    pub lever: f64,
}

/// Lays a calibration out.
///
/// # Errors
/// Places that the machine does not reach, a mandrel that does not meet the beam.
pub(super) fn calibration_course<'m>(
    work: &CalibrationWork<'_>,
    machining: &ToolMachining<'m>,
) -> Result<CalibrationCourse<'m>, RunFailure> {
    let mount = Mount { axial: work.length, angle: 0.0, ..machining.mount };
    let machining = ToolMachining { mount, ..machining.clone() };
    let room = Room::around(work.beam, work.mandrel.radius + work.beam.radius);
    let course = Course::in_room(&machining, room)?;
    let mut laid = CalibrationCourse { course, ways: Vec::new(), lever: 0.0 };
    let line = line_of(work);
    for (number, z) in work.heights.into_iter().enumerate() {
        for position in 0..work.spindle_positions {
            let turn = TAU * position as f64 / work.spindle_positions as f64;
            let place = format!("mandrel at height {}, spindle at {:.3} deg", number + 1, turn.to_degrees());
            laid.height(work, &line, ([number, position], [z, turn]), &place)?;
        }
    }
    laid.course.park()?;
    Ok(laid)
}

/// The beam by its place at height 0 and its slopes.
pub(super) fn line_of(work: &CalibrationWork<'_>) -> BeamLine {
    let slope = work.beam.direction.xy() / work.beam.direction.z;
    BeamLine { point: work.beam.point.xy() - slope * work.beam.point.z, slope, radius: work.beam.radius }
}

impl CalibrationCourse<'_> {
    /// Through along Y, around the beam, into it along X, back out of it.
    fn height(
        &mut self,
        work: &CalibrationWork<'_>,
        line: &BeamLine,
        ([height, position], [z, turn]): ([usize; 2], [f64; 2]),
        place: &str,
    ) -> Result<(), RunFailure> {
        let mandrel = work.mandrel;
        let centre = line.at(z + 0.5 * mandrel.height);
        let at = |x: f64, y: f64| Vector3::new(centre.x + x, centre.y + y, z);
        // Where the beam is free along X and along Y, whatever side the mandrel comes from.
        let lean = line.slope.norm();
        let half = mandrel.radius + line.radius * lean.hypot(1.0) + 0.5 * mandrel.height * lean;
        let out = half + work.reach;
        let switch = |from: Vector3<f64>, axis: Vector3<f64>| {
            mandrel.switch(line, &from, &axis, [0.0, out]).ok_or_else(|| {
                of_skiving(&SkivingError::CalibrationSingular {
                    reason: "the mandrel does not meet the beam",
                })
            })
        };
        let begin = at(0.0, -out);
        let through = [switch(begin, Vector3::y())?, switch(at(0.0, out), -Vector3::y())?];
        let beside = at(-out, 0.0);
        let into = switch(beside, Vector3::x())?;
        let end = into + Vector3::x() * work.reach;
        // Comments have no decimal points.
        let numbered = format!("mandrel height {} spindle position {}", height + 1, position + 1);
        self.course.comment(&format!("{numbered} along y"));
        let place = |axis: &str| format!("{place}, along {axis}");
        // From outside of the beam in all axes at once, then to the height, and before the beam.
        if self.course.at.is_some() {
            let from = Vector3::new(beside.x, begin.y, z);
            let stand = self.stand(&from, turn, &place("Y"))?;
            self.course.rapid(stand);
        }
        let stand = self.stand(&begin, turn, &place("Y"))?;
        if self.course.at.is_none() && self.course.stander.carrier().is_some() {
            let away = out + self.course.retreat.distance;
            let aside = [at(-away, 0.0), at(away, 0.0), at(0.0, -away)];
            self.meet(&aside, turn, &place("Y"))?;
        }
        self.course.rapid(stand);
        self.way(work, (Approach::Y, turn), [begin, at(0.0, out)], through.to_vec(), &place("Y"))?;
        self.course.comment(&format!("{numbered} along x"));
        for corner in [at(-out, out), beside] {
            let stand = self.stand(&corner, turn, &place("X"))?;
            self.course.rapid(stand);
        }
        self.way(work, (Approach::X, turn), [beside, end], vec![into], &place("X"))?;
        let back = self.stand(&beside, turn, &place("X"))?;
        self.course.straight(back, (end - beside).norm() / work.speed);
        Ok(())
    }

    /// Waits for the carrier at the place that keeps farthest from the beam on its way.
    fn meet(&mut self, places: &[Vector3<f64>], turn: f64, name: &str) -> Result<(), RunFailure> {
        let mut best: Option<(f64, Positions)> = None;
        for place in places {
            // Places beyond a travel are none to wait at.
            let Ok(stand) = self.stand(place, turn, name) else { continue };
            let nearest = self.course.nearest_of_carrier(&stand)?;
            if best.is_none_or(|(known, _)| nearest > known) {
                best = Some((nearest, stand));
            }
        }
        let Some((_, stand)) = best else { return Ok(()) };
        self.course.bring(&stand, name)?;
        self.course.rapid(stand);
        Ok(())
    }

    /// One way with the output on.
    fn way(
        &mut self,
        work: &CalibrationWork<'_>,
        (along, turn): (Approach, f64),
        ends: [Vector3<f64>; 2],
        switches: Vec<Vector3<f64>>,
        place: &str,
    ) -> Result<(), RunFailure> {
        let to = self.stand(&ends[1], turn, place)?;
        self.course.output(true);
        self.course.straight(to, (ends[1] - ends[0]).norm() / work.speed);
        self.course.output(false);
        self.lever = self
            .lever
            .max(self.course.lever(&to, &Vector3::new(work.mandrel.radius, 0.0, work.mandrel.height))?);
        self.ways.push(MandrelWay { along, turn, ends, switches });
        Ok(())
    }

    /// The axes with the mandrel upright at a place.
    fn stand(&self, at: &Vector3<f64>, turn: f64, place: &str) -> Result<Positions, RunFailure> {
        let pose =
            MeasuringPose { swivel: 0.0, turn, position: *at, off_flank: 0.0, beam_in_tool: Vector3::z() };
        self.course.stander.stand(&pose, self.course.at.as_ref(), place)
    }
}
