//! Inverse kinematics of a tool that turns anyway: its axis and a point of it are wanted, two rotary and three linear axes are
//! there (`docs/mathematics/milling.md#positions-of-five-axes`). Both solutions; which one is taken along a path is decided where the path
//! is known.

use super::frames::{Bed, StationSpindle, ToolSpindle};
use super::inverse::within_turn;
use super::rotations::{NoWrist, about, turn, two_axes};
use super::{Joint, Machine, MachineError, Positions, Station};
use foundation::kinematics::{Direction, Point, Pose};
use nalgebra::{Matrix3, Vector3};

/// Where a turning tool is wanted, in coordinates of the station's spindle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolAxis {
    /// The point of the tool that is placed.
    pub tip: Point<StationSpindle>,
    /// The tool's +z, towards its holder, a unit vector.
    pub axis: Direction<StationSpindle>,
    /// That point in coordinates of the tool spindle, mm: (0, 0, -length) for a tool of that length.
    pub reach: Point<ToolSpindle>,
}

/// What there is for a direction of the tool.
#[derive(Clone, Debug, PartialEq)]
pub enum AxisSolutions {
    /// One or two sets of positions, angles in (-180, 180] degrees; first the one with the positive square root of
    /// `docs/mathematics/milling.md#positions-of-five-axes`.
    Positions(Vec<Positions>),
    /// The tool stands along the first rotary axis: its angle is free. The angle of the other axis; sine from the pole.
    Pole {
        /// Number of the axis that is free.
        free: usize,
        /// Sine of the angle between the tool and that axis.
        measure: f64,
    },
}

/// The axes that place a turning tool (`docs/mathematics/milling.md#positions-of-five-axes`): numbers in the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FiveAxes {
    /// th_1 and th_2: the axis next to the workpiece in the chain from it to the tool, and the axis next to the tool.
    pub rotary: [usize; 2],
    /// s_1 and s_2: +1 for an axis that carries the tool, -1 for one that carries the workpiece.
    pub senses: [f64; 2],
    /// The three slides, those of the tool first.
    pub linear: [usize; 3],
}

/// Determinant of the directions of the linear axes below which two do the same.
const LEAST_DETERMINANT: f64 = 1e-9;

impl Machine {
    /// All positions that bring the tool to this place; `held` gives the angle (rad) of the axis that is free at the pole.
    ///
    /// # Errors
    /// [`MachineError::NotDetermined`] for a machine with other than two rotary and three linear axes there;
    /// [`MachineError::Unreachable`] for a direction beyond the reach of the axes; [`MachineError::Singular`];
    /// [`MachineError::InvalidNumber`].
    pub fn tool_axis(
        &self,
        station: Station,
        wanted: &ToolAxis,
        held: Option<f64>,
    ) -> Result<AxisSolutions, MachineError> {
        check_numbers(wanted)?;
        let FiveAxes { rotary: [outer, inner], senses: [outer_sense, inner_sense], linear } =
            self.five_axes(station)?;
        let (tool, other) = (self.tool(), self.station(station)?);
        let p = tool.home::<ToolSpindle>().rotation() * Vector3::z();
        let q = other.home::<StationSpindle>().rotation() * wanted.axis.xyz;
        let [k_1, k_2] = [outer, inner].map(|axis| self.axes()[axis].direction);
        let sets = match two_axes([&k_1, &k_2], &p, &q) {
            Ok(sets) => sets,
            Err(NoWrist::Singular { measure }) => match held {
                Some(angle) => return self.tool_axis_held(station, wanted, angle).map(held_alone),
                None => return Ok(AxisSolutions::Pole { free: outer, measure }),
            },
            Err(NoWrist::Beyond { wanted, least, greatest }) => {
                return Err(MachineError::Unreachable {
                    what: format!("the direction of the tool against {}", self.axes()[outer].name),
                    wanted: wanted.clamp(-1.0, 1.0).acos().to_degrees(),
                    least: greatest.clamp(-1.0, 1.0).acos().to_degrees(),
                    greatest: least.clamp(-1.0, 1.0).acos().to_degrees(),
                    unit: "deg",
                });
            }
        };
        let placed = |[a, b]: [f64; 2]| {
            let mut at = Positions::default();
            at[outer] = within_turn(outer_sense * a);
            at[inner] = within_turn(inner_sense * b);
            self.slide(station, wanted, at, &linear)
        };
        sets.into_iter().map(placed).collect::<Result<_, _>>().map(AxisSolutions::Positions)
    }

    /// The positions with the first rotary axis at `angle` (rad): its point where it is wanted, its direction as near as the second
    /// rotary axis brings it.
    ///
    /// # Errors
    /// As [`Machine::tool_axis`], but no direction is beyond reach.
    pub fn tool_axis_held(
        &self,
        station: Station,
        wanted: &ToolAxis,
        angle: f64,
    ) -> Result<Positions, MachineError> {
        check_numbers(wanted)?;
        let FiveAxes { rotary, senses, linear } = self.five_axes(station)?;
        let p = self.tool().home::<ToolSpindle>().rotation() * Vector3::z();
        let q = self.station(station)?.home::<StationSpindle>().rotation() * wanted.axis.xyz;
        let [k_1, k_2] = rotary.map(|axis| self.axes()[axis].direction);
        let mut at = Positions::default();
        at[rotary[0]] = angle;
        at[rotary[1]] = within_turn(senses[1] * turn(&k_2, &p, &(about(&k_1, -senses[0] * angle) * q)));
        self.slide(station, wanted, at, &linear)
    }

    /// The axes that place a turning tool at a station.
    ///
    /// # Errors
    /// [`MachineError::NotDetermined`] for other than two rotary and three linear axes; as [`Machine::station`].
    pub fn five_axes(&self, station: Station) -> Result<FiveAxes, MachineError> {
        let axes = self.axes_at(station)?;
        // f_m^-1 .. f_1^-1 e_1 .. e_n turns the tool's axis at zero into the wanted one, both in M.
        let (tool, other) = (self.tool(), self.station(station)?);
        let is_rotary = |axis: &&usize| self.joint(**axis) == Joint::Rotary;
        let first = other.axes.iter().rev().filter(is_rotary).map(|&axis| (axis, -1.0));
        let order: Vec<(usize, f64)> =
            first.chain(tool.axes.iter().filter(is_rotary).map(|&axis| (axis, 1.0))).collect();
        let linear: Vec<usize> =
            axes.iter().copied().filter(|&axis| self.joint(axis) == Joint::Linear).collect();
        let (&[outer, inner], Ok(linear)) = (order.as_slice(), <[usize; 3]>::try_from(linear)) else {
            let names = self.names(&axes);
            return Err(MachineError::NotDetermined { free: axes.len(), determined: 5, axes: names });
        };
        Ok(FiveAxes { rotary: [outer.0, inner.0], senses: [outer.1, inner.1], linear })
    }

    /// The direction (and its opposite) at which the first rotary axis does not move the tool's axis, in the station.
    ///
    /// # Errors
    /// As [`Machine::five_axes`].
    pub fn pole(&self, station: Station) -> Result<Direction<StationSpindle>, MachineError> {
        let first = self.axes()[self.five_axes(station)?.rotary[0]].direction;
        let home: Pose<Bed, StationSpindle> = self.station(station)?.home();
        Ok(Direction::from_vector(home.rotation().transpose() * first))
    }

    /// Where a tool stands: its point `reach` and its axis, in coordinates of the station's spindle.
    ///
    /// # Errors
    /// As [`Machine::pose`].
    pub fn tool_stands(
        &self,
        station: Station,
        at: &Positions,
        reach: &Point<ToolSpindle>,
    ) -> Result<(Point<StationSpindle>, Direction<StationSpindle>), MachineError> {
        let tool = self.pose(station, at)?.inverse();
        Ok((tool.point(reach), tool.direction(&Direction::from_vector(Vector3::z()))))
    }

    /// The linear axes that bring the tool's point to the wanted one.
    fn slide(
        &self,
        station: Station,
        wanted: &ToolAxis,
        mut at: Positions,
        linear: &[usize; 3],
    ) -> Result<Positions, MachineError> {
        let other = self.station(station)?;
        let tool: Pose<Bed, ToolSpindle> = self.limb(self.tool(), &at);
        let here: Pose<Bed, StationSpindle> = self.limb(other, &at);
        let gap = here.point(&wanted.tip).xyz - tool.point(&wanted.reach).xyz;
        let q = self.linear_axes(station, &at, linear, &gap)?;
        for (k, &axis) in linear.iter().enumerate() {
            at[axis] += q[k];
        }
        Ok(at)
    }

    /// How far three linear axes have to move to shift the tool against the station by `gap` (M, mm).
    pub(super) fn linear_axes(
        &self,
        station: Station,
        at: &Positions,
        linear: &[usize; 3],
        gap: &Vector3<f64>,
    ) -> Result<Vector3<f64>, MachineError> {
        let mut directions = Matrix3::zeros();
        for (limb, sense) in [(self.tool(), 1.0), (self.station(station)?, -1.0)] {
            for axis in self.standing(limb, at) {
                if let Some(k) = linear.iter().position(|&number| number == axis.axis) {
                    directions.set_column(k, &(axis.direction * sense));
                }
            }
        }
        let measure = directions.determinant().abs();
        let singular = || MachineError::Singular { axes: self.names(linear), measure };
        if measure < LEAST_DETERMINANT {
            return Err(singular());
        }
        directions.lu().solve(gap).ok_or_else(singular)
    }
}

fn held_alone(at: Positions) -> AxisSolutions {
    AxisSolutions::Positions(vec![at])
}

fn check_numbers(wanted: &ToolAxis) -> Result<(), MachineError> {
    let mut numbers = wanted.tip.xyz.iter().chain(wanted.axis.xyz.iter()).chain(wanted.reach.xyz.iter());
    match numbers.find(|x| !x.is_finite()) {
        Some(&value) => Err(MachineError::InvalidNumber { field: "tool axis".into(), value }),
        None => Ok(()),
    }
}
