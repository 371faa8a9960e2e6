//! Inverse kinematics of the tool's limb alone: a tool spindle wanted at a pose on the bed, before something that stands there beside
//! the workpiece, such as a light barrier. Knows no work spindle.

use super::frames::{Bed, ToolSpindle};
use super::inverse::{check_pose, within_turn};
use super::rotations::{NoWrist, about, across, three_axes, turn};
use super::{Joint, Machine, MachineError, Positions, Station};
use foundation::kinematics::Pose;
use nalgebra::{Matrix3, Vector3};

/// How far (sine) the spindle's axis may stay off the wanted direction.
const OFF_AXIS: f64 = 1e-9;
/// Sine of the angle between two axes below which they do the same.
const PARALLEL: f64 = 1e-9;

impl Machine {
    /// Where the tool spindle stands on the bed.
    ///
    /// # Errors
    /// [`MachineError::InvalidNumber`].
    pub fn tool_spindle(&self, at: &Positions) -> Result<Pose<Bed, ToolSpindle>, MachineError> {
        for &axis in &self.tool().axes {
            if !at[axis].is_finite() {
                let field = self.axes()[axis].name.clone();
                return Err(MachineError::InvalidNumber { field, value: at[axis] });
            }
        }
        Ok(self.limb(self.tool(), at))
    }

    /// The axis that turns the tool about itself, with the sense in which it does: the last one of the tool's limb.
    ///
    /// # Errors
    /// [`MachineError::MissingAxis`] for a limb that ends with anything but a rotary axis along the spindle's z through its origin.
    pub fn tool_turning(&self) -> Result<(usize, f64), MachineError> {
        let limb = self.tool();
        let last = limb.axes.last().copied().filter(|&axis| self.joint(axis) == Joint::Rotary);
        let along = last.and_then(|number| {
            let axis = &self.axes()[number];
            let beside = axis.direction.cross(&(limb.origin - axis.point)).norm();
            let off = axis.direction.cross(&limb.z).norm();
            (off < OFF_AXIS && beside < OFF_AXIS).then(|| (number, axis.direction.dot(&limb.z).signum()))
        });
        along.ok_or_else(|| self.missing("tool spindle"))
    }

    /// All positions of the tool's limb that bring its spindle to a pose on the bed, angles in (-180, 180] degrees; all other axes at
    /// 0. Travel is not looked at.
    ///
    /// # Errors
    /// [`MachineError::NotDetermined`] for a limb of other than three linear and one to three rotary axes;
    /// [`MachineError::Unreachable`] for a direction that its rotary axes do not reach; [`MachineError::Singular`];
    /// [`MachineError::InvalidPose`], [`MachineError::InvalidNumber`].
    pub fn tool_placed(&self, pose: &Pose<Bed, ToolSpindle>) -> Result<Vec<Positions>, MachineError> {
        self.placed(pose, &[])
    }

    /// The same with the first axis of the limb held where it stands: a carrier that brings the whole of the others before something else.
    ///
    /// # Errors
    /// As [`Machine::tool_placed`]; [`MachineError::MissingAxis`] for a limb that begins with another axis.
    pub fn tool_placed_on(
        &self,
        pose: &Pose<Bed, ToolSpindle>,
        (carrier, stands): (usize, f64),
    ) -> Result<Vec<Positions>, MachineError> {
        let held: [usize; 1] = [carrier];
        if self.tool().axes.first() != Some(&carrier) {
            return Err(self.missing("tool carrier"));
        }
        let mut at = Positions::default();
        at[carrier] = stands;
        // As the others see it with the carrier at zero.
        let wanted = self.carried(&held, &at).inverse().then(pose);
        let mut found = self.placed(&wanted, &held)?;
        found.iter_mut().for_each(|at| at[carrier] = stands);
        Ok(found)
    }

    fn placed(&self, pose: &Pose<Bed, ToolSpindle>, held: &[usize]) -> Result<Vec<Positions>, MachineError> {
        check_pose(pose)?;
        let limb = self.tool();
        let free = limb.axes.iter().filter(|axis| !held.contains(axis));
        let (rotary, linear): (Vec<usize>, Vec<usize>) =
            free.partition(|&&axis| self.joint(axis) == Joint::Rotary);
        let linear = <[usize; 3]>::try_from(linear).map_err(|_| self.not_placed())?;
        let wanted = pose.then(&limb.home::<ToolSpindle>().inverse());
        let sets = self.angles(&rotary, wanted.rotation())?;
        let placed = |angles: Vec<f64>| {
            let mut at = Positions::default();
            rotary.iter().zip(angles).for_each(|(&axis, angle)| at[axis] = within_turn(angle));
            let here: Pose<Bed, ToolSpindle> = self.limb(limb, &at);
            let gap = pose.translation() - here.translation();
            let ways = self.linear_axes(Station::Work, &at, &linear, &gap)?;
            linear.iter().zip(ways.iter()).for_each(|(&axis, way)| at[axis] = *way);
            Ok(at)
        };
        sets.into_iter().map(placed).collect()
    }

    fn not_placed(&self) -> MachineError {
        let axes = &self.tool().axes;
        MachineError::NotDetermined { free: axes.len(), determined: 5, axes: self.names(axes) }
    }

    /// All angles of the rotary axes that make up a rotation.
    fn angles(&self, rotary: &[usize], wanted: &Matrix3<f64>) -> Result<Vec<Vec<f64>>, MachineError> {
        let direction = |axis: usize| &self.axes()[axis].direction;
        match *rotary {
            [only] => {
                let k = direction(only);
                self.reached(&Vector3::clone(k), k, k, wanted)?;
                let x = across(k);
                Ok(vec![vec![turn(k, &x, &(wanted * x))]])
            }
            [first, last] => {
                let (k1, k2) = (direction(first), direction(last));
                let measure = k1.cross(k2).norm();
                if measure < PARALLEL {
                    return Err(MachineError::Singular { axes: self.names(rotary), measure });
                }
                let a = turn(k1, k2, &(wanted * k2));
                let before = about(k1, a);
                self.reached(&(before * k2), k1, k2, wanted)?;
                let x = across(k2);
                let b = turn(k2, &x, &(before.transpose() * wanted * x));
                Ok(vec![vec![a, b]])
            }
            [first, second, last] => {
                let directions = [direction(first), direction(second), direction(last)];
                let sets = three_axes(directions, wanted, OFF_AXIS).map_err(|reason| match reason {
                    NoWrist::Singular { measure } => {
                        MachineError::Singular { axes: self.names(rotary), measure }
                    }
                    NoWrist::Beyond { wanted, least, greatest } => {
                        out_of_reach(wanted.acos(), [greatest, least].map(|x| x.clamp(-1.0, 1.0).acos()))
                    }
                })?;
                Ok(sets.into_iter().map(Vec::from).collect())
            }
            _ => Err(self.not_placed()),
        }
    }

    /// Whether the spindle's axis, brought to `stands`, points where it is wanted; `first` and `last` are the axes at zero.
    fn reached(
        &self,
        stands: &Vector3<f64>,
        first: &Vector3<f64>,
        last: &Vector3<f64>,
        wanted: &Matrix3<f64>,
    ) -> Result<(), MachineError> {
        let goal = wanted * last;
        // Written so that NaN fails.
        let there = stands.cross(&goal).norm() <= OFF_AXIS && stands.dot(&goal) > 0.0;
        if there {
            return Ok(());
        }
        let angle = |a: &Vector3<f64>, b: &Vector3<f64>| a.cross(b).norm().atan2(a.dot(b));
        Err(out_of_reach(angle(first, &goal), [angle(first, last); 2]))
    }
}

fn out_of_reach(wanted: f64, [least, greatest]: [f64; 2]) -> MachineError {
    MachineError::Unreachable {
        what: "the angle of the tool spindle to the first rotary axis of its limb".into(),
        wanted: wanted.to_degrees(),
        least: least.to_degrees(),
        greatest: greatest.to_degrees(),
        unit: "deg",
    }
}
