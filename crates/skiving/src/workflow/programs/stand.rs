//! The machine's tool at a pose and back: positions of the axes for a measuring pose by inverse kinematics, and by forward kinematics
//! the pose that positions mean. The two share no formula.

use super::failure::of_machine;
use super::task::{Carried, Carrier, ToolMachining};
use crate::measuring::MeasuringPose;
use foundation::kinematics::{Direction, Point, Pose, Worm};
use machine::{Bed, Joint, Machine, MachineError, Mount, Positions, Station, ToolSpindle};
use nalgebra::Vector3;
use run::RunFailure;
use std::f64::consts::TAU;

/// A machine with a tool in its spindle.
#[derive(Clone, Debug)]
pub(super) struct Stander<'m> {
    pub machine: &'m Machine,
    /// Axes that a program moves: those of the tool, then what else it needs.
    pub axes: Vec<usize>,
    carrier: Option<Carrier>,
    pub mount: Mount,
    /// The axis that turns the tool.
    pub turning: usize,
    /// Sense in which it turns the tool about the tool's own +z.
    pub sense: f64,
}

/// What positions mean: the tool at T(position) Rx(swivel) Rz(turn), and how far it is off any such pose.
#[derive(Clone, Copy, Debug)]
pub(super) struct ToolStands {
    pub position: Vector3<f64>,
    pub swivel: f64,
    pub turn: f64,
    /// Lean of the tool's axis out of the Y-Z plane, rad: no measuring pose has one.
    pub lean: f64,
}

/// A radian counts as so many millimetres where positions are compared.
const LENGTH: f64 = 100.0;
/// Turns to either side that are looked at on an axis with ends.
const TURNS: i32 = 2;

impl<'m> Stander<'m> {
    /// # Errors
    /// A machine whose tool limb does not end with a spindle.
    pub fn new(machining: &ToolMachining<'m>) -> Result<Self, RunFailure> {
        let machine = &machining.machine.machine;
        let (turning, sense) =
            machine.tool_turning().map_err(|error| of_machine(&error, "the tool spindle"))?;
        let mut axes = machine.tool().axes.clone();
        axes.extend(machining.carrier.map(|carrier| carrier.axis).filter(|axis| !axes.contains(axis)));
        Ok(Self {
            machine,
            axes,
            carrier: machining.carrier,
            mount: machining.mount,
            turning,
            sense: sense * machining.mount.sense(),
        })
    }

    /// The carrier of the light barrier or of the tool, if one has to move.
    pub fn carrier(&self) -> Option<&Carrier> {
        self.carrier.as_ref()
    }

    /// Positions for a pose: of all solutions within the travels that nearest to where the axes stand, or to zero.
    ///
    /// # Errors
    /// The least excess over a travel if no solution is within all; a pose beyond the reach of the axes.
    pub fn stand(
        &self,
        pose: &MeasuringPose,
        near: Option<&Positions>,
        place: &str,
    ) -> Result<Positions, RunFailure> {
        let orientation = Pose::<Bed, Bed>::rx(pose.swivel).then(&Pose::<Bed, Worm>::rz(pose.turn));
        let tool: Pose<Bed, Worm> = Pose::rigid(*orientation.rotation(), pose.position);
        let spindle = tool.then(&self.mount.pose::<ToolSpindle, Worm>().inverse());
        let found = match self.carrier {
            Some(carrier) if carrier.carries == Carried::Tool => {
                self.machine.tool_placed_on(&spindle, (carrier.axis, carrier.measuring))
            }
            Some(carrier) => self.machine.tool_placed(&spindle).map(|mut found| {
                found.iter_mut().for_each(|at| at[carrier.axis] = carrier.measuring);
                found
            }),
            None => self.machine.tool_placed(&spindle),
        };
        let found = found.map_err(|error| of_machine(&error, place))?;
        let near = near.copied().unwrap_or_default();
        let turned: Vec<Positions> = found.iter().flat_map(|at| self.turns(at, &near)).collect();
        let admitted = turned.iter().filter(|at| self.beyond(at).is_none());
        let nearest = admitted.min_by(|a, b| self.apart(a, &near).total_cmp(&self.apart(b, &near)));
        nearest.copied().ok_or_else(|| {
            let excess = |at: &&Positions| self.beyond(at).map_or(0.0, |(excess, _)| excess);
            let least = turned.iter().min_by(|a, b| excess(a).total_cmp(&excess(b)));
            let error = least.and_then(|at| self.beyond(at)).map(|(_, error)| error);
            let error =
                error.unwrap_or(MachineError::NoSolution { starts: found.len(), residual: f64::INFINITY });
            of_machine(&error, place)
        })
    }

    /// The same place in the turns of its rotary axes: the nearest one of endless axes, all within reach of axes with ends.
    fn turns(&self, at: &Positions, near: &Positions) -> Vec<Positions> {
        let mut sets = vec![*at];
        for &axis in &self.axes {
            let described = &self.machine.axes()[axis];
            let held = self.carrier.is_some_and(|carrier| carrier.axis == axis);
            if described.joint == Joint::Linear || held {
                continue;
            }
            let ends = described.travel.is_some();
            let offset = if ends { 0.0 } else { ((near[axis] - at[axis]) / TAU).round() };
            let turns = if ends { -TURNS..=TURNS } else { 0..=0 };
            let turned = |set: &Positions| {
                let set = *set;
                turns.clone().map(move |k| {
                    let mut set = set;
                    set[axis] += TAU * (offset + f64::from(k));
                    set
                })
            };
            sets = sets.iter().flat_map(turned).collect();
        }
        sets
    }

    /// The axis that is farthest beyond its travel: how far in comparable lengths, and the error.
    fn beyond(&self, at: &Positions) -> Option<(f64, MachineError)> {
        let of_axis = |&axis: &usize| {
            let described = &self.machine.axes()[axis];
            let scale = if described.joint == Joint::Linear { 1.0 } else { LENGTH };
            Some((-described.margin(at[axis]) * scale, described.beyond(at[axis])?))
        };
        self.axes.iter().filter_map(of_axis).max_by(|a, b| a.0.total_cmp(&b.0))
    }

    fn apart(&self, a: &Positions, b: &Positions) -> f64 {
        let of_axis = |&axis: &usize| {
            let scale = if self.machine.axes()[axis].joint == Joint::Linear { 1.0 } else { LENGTH };
            (a[axis] - b[axis]).abs() * scale
        };
        self.axes.iter().map(of_axis).fold(0.0, f64::max)
    }

    /// What positions mean.
    ///
    /// # Errors
    /// Positions that are not finite.
    pub fn tool(&self, at: &Positions) -> Result<ToolStands, RunFailure> {
        let spindle = self.machine.tool_spindle(at).map_err(|error| of_machine(&error, "read back"))?;
        // Beside a barrier that is carried, as it sees the tool: with the carrier in the place in which it measures.
        let seen: Pose<Bed, ToolSpindle> = match self.carrier {
            Some(carrier) if carrier.carries == Carried::Barrier => {
                let (_, carriers) = self.machine.carriers(carrier.axis).unwrap_or_default();
                let mut measuring = *at;
                measuring[carrier.axis] = carrier.measuring;
                let here = self.machine.carried(&carriers, at);
                self.machine.carried(&carriers, &measuring).then(&here.inverse()).then(&spindle)
            }
            _ => spindle,
        };
        let tool: Pose<Bed, Worm> = seen.then(&self.mount.pose());
        let r = tool.rotation();
        Ok(ToolStands {
            position: *tool.translation(),
            swivel: (-r[(1, 2)]).atan2(r[(2, 2)]),
            turn: (-r[(0, 1)]).atan2(r[(0, 0)]),
            lean: r[(0, 2)].asin(),
        })
    }

    /// Greatest distance of a point of the tool from the rotary axes that carry it, mm.
    ///
    /// # Errors
    /// [`MachineError`] as a finding.
    pub fn axis_lever(&self, at: &Positions, point: &Vector3<f64>) -> Result<f64, RunFailure> {
        let in_spindle: Point<ToolSpindle> =
            self.mount.pose::<ToolSpindle, Worm>().point(&Point::from_vector(*point));
        let mut squares = vec![0.0; self.machine.axes().len()];
        for unit in [Vector3::x(), Vector3::y(), Vector3::z()] {
            let direction = Direction::from_vector(unit);
            let parts = self.machine.influence(Station::Work, at, &in_spindle, &direction);
            for (axis, part) in parts.map_err(|error| of_machine(&error, "the tool"))? {
                squares[axis] += part * part;
            }
        }
        let rotary = |axis: &&usize| self.machine.axes()[**axis].joint == Joint::Rotary;
        Ok(self.axes.iter().filter(rotary).map(|&axis| squares[axis].sqrt()).fold(0.0, f64::max))
    }
}

impl ToolStands {
    /// As a measuring pose, as far as it is one; for distances from a beam only.
    pub fn pose(&self, like: &MeasuringPose) -> MeasuringPose {
        MeasuringPose { swivel: self.swivel, turn: self.turn, position: self.position, ..*like }
    }
}
