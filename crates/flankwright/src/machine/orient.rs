//! Inverse kinematics of a tool that turns anyway: its axis and a point of it are wanted, two rotary and three linear axes are
//! there (spec 50 section 11). Both solutions; which one is taken along a path is decided where the path is known.

use super::forward::{Bed, StationSpindle, ToolSpindle};
use super::rotations::{NoWrist, two_axes};
use super::{Joint, Machine, MachineError, Positions, Station};
use crate::kinematics::{Direction, Point, Pose};
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
    /// One or two sets of positions, angles in (-180, 180] degrees.
    Positions(Vec<Positions>),
    /// The tool stands along the first rotary axis: its angle is free. The angle of the other axis; sine from the pole.
    Pole {
        /// Number of the axis that is free.
        free: usize,
        /// Sine of the angle between the tool and that axis.
        measure: f64,
    },
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
        let numbers = wanted.tip.xyz.iter().chain(wanted.axis.xyz.iter()).chain(wanted.reach.xyz.iter());
        if let Some(&value) = numbers.into_iter().find(|x| !x.is_finite()) {
            return Err(MachineError::InvalidNumber { field: "tool axis".into(), value });
        }
        let axes = self.axes_at(station)?;
        let undetermined =
            || MachineError::NotDetermined { free: axes.len(), determined: 5, axes: self.names(&axes) };
        let (rotary, linear): (Vec<usize>, Vec<usize>) =
            axes.iter().partition(|&&axis| self.joint(axis) == Joint::Rotary);
        let (Ok(_), Ok(linear)) = (<[usize; 2]>::try_from(rotary), <[usize; 3]>::try_from(linear)) else {
            return Err(undetermined());
        };
        // f_m^-1 .. f_1^-1 e_1 .. e_n turns the tool's axis at zero into the wanted one, both in M.
        let (tool, other) = (self.tool(), self.station(station)?);
        let rotary = |axis: &&usize| self.joint(**axis) == Joint::Rotary;
        let first = other.axes.iter().rev().filter(rotary).map(|&axis| (axis, -1.0));
        let order: Vec<(usize, f64)> =
            first.chain(tool.axes.iter().filter(rotary).map(|&axis| (axis, 1.0))).collect();
        let &[(outer, outer_sense), (inner, inner_sense)] = order.as_slice() else {
            return Err(undetermined());
        };
        let p = tool.home::<ToolSpindle>().rotation() * Vector3::z();
        let q = other.home::<StationSpindle>().rotation() * wanted.axis.xyz;
        let [k_1, k_2] = [outer, inner].map(|axis| self.axes()[axis].direction);
        let sets = match two_axes([&k_1, &k_2], &p, &q) {
            Ok(sets) => sets,
            Err(NoWrist::Singular { measure }) => match held {
                Some(angle) => vec![[
                    outer_sense * angle,
                    super::rotations::turn(
                        &k_2,
                        &p,
                        &(super::rotations::about(&k_1, -outer_sense * angle) * q),
                    ),
                ]],
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
            at[outer] = super::inverse::within_turn(outer_sense * a);
            at[inner] = super::inverse::within_turn(inner_sense * b);
            self.slide(station, wanted, at, &linear)
        };
        sets.into_iter().map(placed).collect::<Result<_, _>>().map(AxisSolutions::Positions)
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
