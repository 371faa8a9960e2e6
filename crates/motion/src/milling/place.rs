//! A place of a cutter on the workpiece, and the machine that it is wanted on.

use crate::MotionError;
use foundation::kinematics::{Direction, Point, Pose, Workpiece};
use machine::{
    AxisSolutions, FiveAxes, Joint, Machine, MachineError, Positions, Station, StationSpindle, ToolAxis,
    ToolSpindle,
};
use nalgebra::Vector3;

/// Where a cutter stands on the workpiece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutterPlace {
    /// C: where it touches the flank, mm.
    pub contact: Point<Workpiece>,
    /// T: its tip, on its axis, mm.
    pub tip: Point<Workpiece>,
    /// a: its axis towards the shank, a unit vector.
    pub axis: Direction<Workpiece>,
}

/// A machine with a workpiece and a cutter clamped.
#[derive(Clone, Debug)]
pub struct MillingSetup<'m> {
    machine: &'m Machine,
    axes: FiveAxes,
    pole: Direction<StationSpindle>,
    clamping: Pose<StationSpindle, Workpiece>,
    tool_length: f64,
}

/// How far the length of an axis may be off 1.
const UNIT: f64 = 1e-9;

impl CutterPlace {
    /// The place at a share of the way to another one: contact and tip on straight lines, the axis between the two directions.
    pub fn towards(&self, to: &Self, share: f64) -> Self {
        let between = |a: Vector3<f64>, b: Vector3<f64>| a + (b - a) * share;
        Self {
            contact: Point::from_vector(between(self.contact.xyz, to.contact.xyz)),
            tip: Point::from_vector(between(self.tip.xyz, to.tip.xyz)),
            axis: Direction::from_vector(between(self.axis.xyz, to.axis.xyz).normalize()),
        }
    }

    /// Checks the numbers of a path.
    ///
    /// # Errors
    /// [`MotionError::Place`] for numbers that are not finite and axes that are no unit vectors up to 1e-9.
    pub(super) fn check(places: &[Self]) -> Result<(), MotionError> {
        for (k, place) in places.iter().enumerate() {
            let wrong = |field: &str, value: f64| {
                let error = MachineError::InvalidNumber { field: field.into(), value };
                Err(MotionError::Place { place: k + 1, error })
            };
            for (field, xyz) in [("contact", &place.contact.xyz), ("tip", &place.tip.xyz)] {
                if let Some(&value) = xyz.iter().find(|x| !x.is_finite()) {
                    return wrong(field, value);
                }
            }
            let length = place.axis.xyz.norm();
            if !(1.0 - UNIT..=1.0 + UNIT).contains(&length) {
                return wrong("length of the axis (allowed: 1 up to 1e-9)", length);
            }
        }
        Ok(())
    }
}

impl<'m> MillingSetup<'m> {
    /// A workpiece clamped by `clamping` on the work spindle, a cutter whose tip stands `tool_length` (mm) before the origin of the
    /// tool spindle.
    ///
    /// # Errors
    /// [`MotionError::Lacking`] for a machine with other than two rotary and three linear axes there;
    /// [`MotionError::InvalidNumber`].
    pub fn new(
        machine: &'m Machine,
        clamping: Pose<StationSpindle, Workpiece>,
        tool_length: f64,
    ) -> Result<Self, MotionError> {
        let numbers = clamping.rotation().iter().chain(clamping.translation().iter()).chain([&tool_length]);
        if let Some(&value) = numbers.into_iter().find(|x| !x.is_finite()) {
            return Err(MotionError::InvalidNumber {
                field: "clamping or tool length",
                value,
                allowed: "finite",
            });
        }
        let axes = machine.five_axes(Station::Work)?;
        let pole = machine.pole(Station::Work)?;
        Ok(Self { machine, axes, pole, clamping, tool_length })
    }

    /// The machine.
    pub fn machine(&self) -> &'m Machine {
        self.machine
    }

    /// Its axes.
    pub fn axes(&self) -> &FiveAxes {
        &self.axes
    }

    /// M: how the workpiece is clamped.
    pub fn clamping(&self) -> &Pose<StationSpindle, Workpiece> {
        &self.clamping
    }

    /// The same with the workpiece clamped otherwise.
    pub fn clamped(&self, clamping: Pose<StationSpindle, Workpiece>) -> Self {
        Self { clamping, ..self.clone() }
    }

    /// The same with a cutter of another length, mm.
    pub fn with_tool_length(&self, tool_length: f64) -> Self {
        Self { tool_length, ..self.clone() }
    }

    /// The direction of the pole on the workpiece; its opposite is one as well.
    pub fn pole(&self) -> Direction<Workpiece> {
        self.clamping.inverse().direction(&self.pole)
    }

    /// Angle (rad) between a cutter's axis and the line of the pole, 0 .. pi/2.
    pub fn pole_distance(&self, axis: &Direction<Workpiece>) -> f64 {
        let pole = self.pole().xyz;
        pole.cross(&axis.xyz).norm().atan2(pole.dot(&axis.xyz).abs())
    }

    /// The tip in coordinates of the tool spindle.
    pub(super) fn reach(&self) -> Point<ToolSpindle> {
        Point::new(0.0, 0.0, -self.tool_length)
    }

    fn wanted(&self, place: &CutterPlace) -> ToolAxis {
        ToolAxis {
            tip: self.clamping.point(&place.tip),
            axis: self.clamping.direction(&place.axis),
            reach: self.reach(),
        }
    }

    /// Both solutions for a place, or that it stands at the pole.
    ///
    /// # Errors
    /// As [`Machine::tool_axis`].
    pub fn solutions(&self, place: &CutterPlace) -> Result<AxisSolutions, MachineError> {
        self.machine.tool_axis(Station::Work, &self.wanted(place), None)
    }

    /// The positions with the first rotary axis at `angle` (rad) and the tip where it is wanted.
    pub(super) fn held(&self, place: &CutterPlace, angle: f64) -> Result<Positions, MachineError> {
        self.machine.tool_axis_held(Station::Work, &self.wanted(place), angle)
    }

    /// Where the cutter stands on the workpiece: tip and axis.
    ///
    /// # Errors
    /// As [`Machine::pose`].
    pub fn stands(&self, at: &Positions) -> Result<(Point<Workpiece>, Direction<Workpiece>), MachineError> {
        let (tip, axis) = self.machine.tool_stands(Station::Work, at, &self.reach())?;
        let back = self.clamping.inverse();
        Ok((back.point(&tip), back.direction(&axis)))
    }

    /// The same angle of a rotary axis in the turn nearest to `near`; the lower one of two that are as near.
    pub(super) fn nearest_turn(angle: f64, near: f64) -> f64 {
        use std::f64::consts::{PI, TAU};
        /// Closer than this (rad) to half a turn counts as half a turn.
        const HALF_TURN: f64 = 1e-9;
        let apart = angle - near;
        let apart = apart - TAU * (apart / TAU).round();
        near + if apart > PI - HALF_TURN { apart - TAU } else { apart }
    }

    /// |d th_1| + |d th_2|, rad.
    pub(super) fn turned(&self, a: &Positions, b: &Positions) -> f64 {
        self.axes.rotary.iter().map(|&axis| (b[axis] - a[axis]).abs()).sum()
    }

    /// Whether all five axes stand within their travel.
    pub(super) fn admits(&self, at: &Positions) -> bool {
        let axes = self.axes.rotary.iter().chain(&self.axes.linear);
        axes.into_iter().all(|&axis| self.machine.axes()[axis].admits(at[axis]))
    }

    /// Axes of these positions in the unit of paths: mm, and 100 mm for a radian.
    pub(super) fn scaled(&self, at: &Positions) -> [f64; 5] {
        let [a, b] = self.axes.rotary;
        let [x, y, z] = self.axes.linear;
        [a, b, x, y, z].map(|axis| match self.machine.axes()[axis].joint {
            Joint::Rotary => 100.0 * at[axis],
            Joint::Linear => at[axis],
        })
    }
}
