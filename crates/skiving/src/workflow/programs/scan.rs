//! The course of a scan: a stylus runs along the edges of some teeth while the axes follow, with the output on, and is drawn back
//! between them (`docs/mathematics/skiving.md#tracks-and-poses`).

use super::course::Course;
use super::failure::of_skiving;
use super::task::{ScanWork, ToolMachining};
use crate::measuring::{MeasuringPose, ScanPlace, nominal_angle, scan_curve};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::wrapped_angle;
use machine::Positions;
use run::RunFailure;

/// One edge that is scanned.
#[derive(Clone, Debug, PartialEq)]
pub struct Scanned {
    /// Flank of the workpiece that the edge makes.
    pub flank: Flank,
    /// Tooth, from 0.
    pub tooth: usize,
    /// Places of the scan with the poses that the tool takes for this tooth.
    pub places: Vec<ScanPlace>,
}

/// A course with what is scanned on it.
#[derive(Clone, Debug)]
pub(super) struct ScanCourse<'m> {
    pub course: Course<'m>,
    pub scanned: Vec<Scanned>,
    /// Time from place to place of each, s.
    pub times: Vec<Vec<f64>>,
    /// Greatest distance of a contact from a rotary axis, mm.
    pub lever: f64,
}

/// Lays a scan out.
///
/// # Errors
/// Poses that the stylus or the machine does not reach, a stylus that is not free between the teeth.
pub(super) fn scan_course<'m>(
    work: &ScanWork<'_>,
    machining: &ToolMachining<'m>,
) -> Result<ScanCourse<'m>, RunFailure> {
    let edges = Sides { left: &work.edges.left, right: &work.edges.right };
    let mut laid = ScanCourse {
        course: Course::new(machining, &edges, work.stylus)?,
        scanned: Vec::with_capacity(2 * work.teeth.len()),
        times: Vec::with_capacity(2 * work.teeth.len()),
        lever: 0.0,
    };
    for flank in [Flank::Left, Flank::Right] {
        let curve = scan_curve(&work.edges[flank], work.stylus, work.axes, work.range, work.places)
            .map_err(|error| of_skiving(&error))?;
        for &tooth in work.teeth {
            let turned = |place: &ScanPlace| {
                let turn = wrapped_angle(nominal_angle(&place.pose, tooth, work.count()));
                ScanPlace { pose: MeasuringPose { turn, ..place.pose }, ..*place }
            };
            let places: Vec<ScanPlace> = curve.iter().map(turned).collect();
            laid.scan(&places, &format!("{flank} flank, tooth {tooth}"), work.speed)?;
            laid.scanned.push(Scanned { flank, tooth, places });
        }
    }
    laid.course.park()?;
    Ok(laid)
}

impl ScanCourse<'_> {
    fn scan(&mut self, places: &[ScanPlace], name: &str, speed: f64) -> Result<(), RunFailure> {
        let [first, rest @ ..] = places else { return Ok(()) };
        self.course.comment(&format!("scan {}", name.replace(',', "")));
        let begin = self.course.approach(&first.pose, true, name)?;
        self.course.output(true);
        let mut before = (first, begin);
        let mut times = Vec::with_capacity(rest.len());
        for (k, place) in rest.iter().enumerate() {
            let here = format!("{name}, place {}", k + 2);
            let at = self.course.stander.stand(&place.pose, Some(&before.1), &here)?;
            self.lever = self.lever.max(self.course.lever(&at, &place.track.contact.point)?);
            let way = (place.track.contact.point - before.0.track.contact.point).norm();
            let seconds = (way / speed).max(self.least_time(&before.1, &at));
            self.course.straight(at, seconds);
            times.push(seconds);
            before = (place, at);
        }
        self.times.push(times);
        self.course.output(false);
        self.course.draw_back(&before.0.pose, name)
    }

    /// Time that the axes need from place to place, s.
    fn least_time(&self, from: &Positions, to: &Positions) -> f64 {
        let machine = self.course.stander.machine;
        let of_axis = |&axis: &usize| {
            let limit = machine.axes()[axis].limits.velocity.unwrap_or(f64::INFINITY);
            (to[axis] - from[axis]).abs() / limit
        };
        self.course.stander.axes.iter().map(of_axis).fold(0.0, f64::max)
    }
}
