//! The course of a finishing stroke: tool and workpiece turn coupled while the tool feeds along the face, with the corrected setting and
//! a periodic law of centre distance and coupling over the turn of the tool
//! (`docs/mathematics/skiving.md#periodic-correction-of-the-run-out`).

use super::course::Course;
use super::failure::of_machine;
use super::room::Room;
use super::task::{Carrier, SkivingWork, ToolMachining};
use crate::measuring::{Beam, MeasuringPose};
use machine::{Joint, Machine, MachineError, Mount, Positions, Station};
use nalgebra::Vector3;
use run::RunFailure;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The course of a stroke.
#[derive(Clone, Debug)]
pub(super) struct SkivingCourse<'m> {
    pub course: Course<'m>,
    /// How the workpiece sits on its spindle.
    pub work: Mount,
    /// Feeds z_V2 at which it begins and ends, mm.
    pub feeds: [f64; 2],
    /// Greatest distance of a contact from a rotary axis, mm.
    pub lever: f64,
}

/// The axis that turns the workpiece about itself, with its sense: the last one of its limb.
///
/// # Errors
/// A limb that ends with anything but a rotary axis along the workpiece's.
pub(super) fn work_turning(machine: &Machine) -> Result<(usize, f64), MachineError> {
    let limb = machine.station(Station::Work)?;
    let last = limb.axes.last().copied().filter(|&axis| machine.axes()[axis].joint == Joint::Rotary);
    let along = last.filter(|&axis| machine.axes()[axis].direction.cross(&limb.z).norm() < 1e-9);
    along
        .map(|axis| (axis, machine.axes()[axis].direction.dot(&limb.z).signum()))
        .ok_or_else(|| MachineError::MissingAxis { machine: machine.name().to_owned(), role: "work spindle" })
}

/// Lays a stroke out.
///
/// # Errors
/// Places that the machine does not reach, speeds that an axis does not have.
pub(super) fn skiving_course<'m>(
    work: &SkivingWork<'_>,
    machining: &ToolMachining<'m>,
) -> Result<SkivingCourse<'m>, RunFailure> {
    // A tool that is clocked stands where it was measured.
    let mount = Mount { angle: machining.mount.angle + work.clocking, ..machining.mount };
    // The workpiece is machined with the carrier parked.
    let carrier = machining.carrier.map(|carrier| Carrier { measuring: carrier.parked, ..carrier });
    let machining = ToolMachining { mount, carrier, ..machining.clone() };
    let machine = &machining.machine.machine;
    let (turning, sense) = work_turning(machine).map_err(|error| of_machine(&error, "the work spindle"))?;
    // No beam stands in the way of a stroke.
    let nowhere =
        Beam { point: Vector3::repeat(1e9), direction: Vector3::z(), level: Vector3::z(), radius: 1.0 };
    let mut course = Course::in_room(&machining, Room::around(&nowhere, 0.0))?;
    course.stander.axes.push(turning);
    let motion = &work.motion;
    let [lowest, highest] = work.engagement;
    let [lower, upper] = work.face;
    // The edges come from below the face and go out above it: the rake face leads, the body follows through what is cut.
    let feeds = [highest - (lower - work.overrun), lowest - (upper + work.overrun)];
    let cutting = work.bodies.edges.left.cutting_direction();
    let step = TAU / work.blocks_per_turn as f64;
    // Feed per radian of the tool.
    let rate = -work.feed * motion.ratio.abs() / TAU;
    let blocks = ((feeds[1] - feeds[0]) / (rate * step)).ceil().max(1.0) as usize;
    let position = |angle: f64, feed: f64, back: f64| {
        let [distance, _] = work.law.at(angle);
        let (sin, cos) = motion.crossed_axes_angle.sin_cos();
        MeasuringPose {
            swivel: motion.crossed_axes_angle,
            turn: angle + FRAC_PI_2,
            position: Vector3::new(
                motion.centre_distance + distance + back,
                -motion.tool_shift * sin,
                motion.tool_shift * cos - feed + work.work_height,
            ),
            off_flank: 0.0,
            beam_in_tool: Vector3::z(),
        }
    };
    let mut laid = SkivingCourse {
        course,
        work: Mount { reversed: false, axial: work.work_height, angle: 0.0 },
        feeds,
        lever: 0.0,
    };
    let stand = |course: &Course<'m>,
                 angle: f64,
                 feed: f64,
                 back: f64,
                 place: &str|
     -> Result<Positions, RunFailure> {
        let mut at = course.stander.stand(&position(angle, feed, back), course.at.as_ref(), place)?;
        let [_, turn] = work.law.at(angle);
        at[turning] = sense * (motion.state(angle, feed).work_angle + turn + FRAC_PI_2);
        Ok(at)
    };
    let first = motion.tool_angle;
    laid.course.comment("skiving stroke");
    let drawn = stand(&laid.course, first, feeds[0], machining.retreat.distance, "before the stroke")?;
    laid.course.rapid(drawn);
    let begin = stand(&laid.course, first, feeds[0], 0.0, "begin of the stroke")?;
    laid.course.straight(begin, machining.retreat.distance / machining.retreat.speed);
    let tip = Vector3::new(0.0, work.bodies.pair.tool().pitch_radius(), 0.0);
    laid.lever = laid.course.lever(&begin, &tip)?.max(work.bodies.pair.gear().pitch_radius());
    for k in 1..=blocks {
        let way = step * k as f64;
        let at = stand(
            &laid.course,
            first + cutting * way,
            feeds[0] + rate * way,
            0.0,
            &format!("block {k} of the stroke"),
        )?;
        laid.course.straight(at, step / work.speed);
    }
    let last = step * blocks as f64;
    let back = stand(
        &laid.course,
        first + cutting * last,
        feeds[0] + rate * last,
        machining.retreat.distance,
        "behind the stroke",
    )?;
    laid.course.straight(back, machining.retreat.distance / machining.retreat.speed);
    Ok(laid)
}
