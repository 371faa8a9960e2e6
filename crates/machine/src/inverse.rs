//! Inverse kinematics: the positions of all axes that give a pose, every solution (`docs/mathematics/programs.md#from-bodies-to-axes`).
//!
//! A linear axis turns nothing. So the rotary axes follow from the rotation alone, in closed form for any three directions
//! ([`super::rotations`]), and the linear ones from three linear equations; offsets and measured directions need no other way.
//! Chains of other kinds go to the iteration of [`super::numeric`].

use super::rotations::{NoWrist, about, across, three_axes, turn};
use super::{
    Bed, DressingRule, Joint, Machine, MachineError, Positions, Role, Station, StationSpindle, ToolSpindle,
};
use foundation::kinematics::Pose;
use foundation::numerics::{brent, equidistant, extremes};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Sine of the angle between tool and counterpart axis below which a wrist is at its pole.
const POLE: f64 = 1e-9;
/// The same under the rule of the swivel (`docs/mathematics/programs.md#from-bodies-to-axes`).
const POLE_OF_CHART: f64 = 1e-12;
/// Worm angles of one turn at which the axial slide is looked at.
const SCAN: usize = 181;
/// How far R^T R may be off the unit matrix.
const ORTHONORMAL: f64 = 1e-9;
/// How far a swivel of a solution found another way may be off the wanted one, rad.
const SAME_SWIVEL: f64 = 1e-9;

impl Machine {
    /// All positions that bring the work spindle to H, angles in (-180, 180] degrees. Travel is not looked at.
    ///
    /// # Errors
    /// [`MachineError::InvalidPose`], [`MachineError::InvalidNumber`]; [`MachineError::Singular`] for parallel spindles and
    /// where two linear axes do the same; [`MachineError::Unreachable`], [`MachineError::NotDetermined`],
    /// [`MachineError::NoSolution`] for a chain that cannot do it.
    pub fn grinding(&self, pose: &Pose<ToolSpindle, StationSpindle>) -> Result<Vec<Positions>, MachineError> {
        self.solve(Station::Work, pose, &[])
    }

    /// All positions that bring the dresser spindle to H under a rule, angles in (-180, 180] degrees; the swivel below 90
    /// degrees. `worm_wanted` (rad, of the worm's axis) settles the worm angle where the rule leaves it free, with parallel
    /// spindles. Travel is not looked at.
    ///
    /// # Errors
    /// As [`Machine::grinding`]; [`MachineError::MissingAxis`] for a machine without dresser, or without swivel under any rule
    /// but swivel 0; [`MachineError::Unreachable`] for a swivel or slide that the pose does not admit;
    /// [`MachineError::PoleOfChart`].
    pub fn dressing(
        &self,
        pose: &Pose<ToolSpindle, StationSpindle>,
        rule: DressingRule,
        worm_wanted: Option<f64>,
    ) -> Result<Vec<Positions>, MachineError> {
        let given = [rule.value(), worm_wanted.unwrap_or(0.0)];
        if let Some(&value) = given.iter().find(|x| !x.is_finite()) {
            return Err(MachineError::InvalidNumber { field: "value of the rule".into(), value });
        }
        let Some(swivel) = self.role(Role::Swivel) else {
            self.station(Station::Dresser)?;
            return match rule {
                DressingRule::Swivel(0.0) => self.by_swivel(pose, None, 0.0, worm_wanted),
                _ => Err(self.missing(Role::Swivel.key())),
            };
        };
        match rule {
            DressingRule::Swivel(angle) => self.by_swivel(pose, Some(swivel), angle, worm_wanted),
            DressingRule::WormAngle(angle) => self.by_worm(pose, swivel, angle),
            DressingRule::AxialSlide(slide) => self.by_slide(pose, swivel, slide),
        }
    }

    fn by_swivel(
        &self,
        pose: &Pose<ToolSpindle, StationSpindle>,
        swivel: Option<usize>,
        angle: f64,
        worm_wanted: Option<f64>,
    ) -> Result<Vec<Positions>, MachineError> {
        let fixed: Vec<(usize, f64)> = swivel.map(|axis| (axis, angle)).into_iter().collect();
        let reach = pose.rotation()[(0, 2)].hypot(pose.rotation()[(1, 2)]);
        let beyond = |name: &str| MachineError::Unreachable {
            what: name.to_owned(),
            wanted: angle.to_degrees(),
            least: -reach.min(1.0).asin().to_degrees(),
            greatest: reach.min(1.0).asin().to_degrees(),
            unit: "deg",
        };
        let named = |axis: usize| beyond(&self.axes()[axis].name);
        if angle.abs() >= FRAC_PI_2 {
            return Err(swivel.map_or_else(|| self.missing(Role::Swivel.key()), named));
        }
        if reach < POLE_OF_CHART {
            let worm = self.needed(Role::Worm)?;
            let wanted = worm_wanted
                .ok_or_else(|| MachineError::PoleOfChart { axis: self.axes()[worm].name.clone() })?;
            // Where the spindles are parallel the swivel can only be 0 and turns nothing else: it may as well be found.
            return match swivel {
                Some(swivel) => {
                    let mut found = self.by_worm(pose, swivel, wanted)?;
                    found.retain(|at| (at[swivel] - angle).abs() < SAME_SWIVEL);
                    found.iter_mut().for_each(|at| at[swivel] = angle);
                    if found.is_empty() { Err(named(swivel)) } else { Ok(found) }
                }
                None => self.parallel(pose, worm, wanted),
            };
        }
        match (self.solve_wrist(Station::Dresser, pose, &fixed, POLE_OF_CHART), swivel) {
            (Err(MachineError::Unreachable { .. }), Some(swivel)) => Err(named(swivel)),
            (found, _) => found,
        }
    }

    /// Parallel spindles on a machine without swivel, the worm given: the tilt stands at 0, the dresser takes up the rest.
    fn parallel(
        &self,
        pose: &Pose<ToolSpindle, StationSpindle>,
        worm: usize,
        angle: f64,
    ) -> Result<Vec<Positions>, MachineError> {
        check_pose(pose)?;
        let (tilt, dresser) = (self.needed(Role::Tilt)?, self.needed(Role::Dresser)?);
        let mut start = Positions::default();
        start[worm] = angle;
        let (at, deviation) = Wrist::new(self, Station::Dresser, pose, &start)?.only(dresser);
        if deviation > SAME_SWIVEL {
            return Err(MachineError::Unreachable {
                what: self.axes()[tilt].name.clone(),
                wanted: deviation.to_degrees(),
                least: 0.0,
                greatest: 0.0,
                unit: "deg",
            });
        }
        let axes = self.axes_at(Station::Dresser)?;
        let linear: Vec<usize> = axes.into_iter().filter(|&axis| self.joint(axis) == Joint::Linear).collect();
        match <[usize; 3]>::try_from(linear) {
            Ok(linear) => Ok(vec![self.place(Station::Dresser, pose, at, &linear)?]),
            Err(axes) => {
                Err(MachineError::NotDetermined { free: axes.len(), determined: 3, axes: self.names(&axes) })
            }
        }
    }

    fn by_worm(
        &self,
        pose: &Pose<ToolSpindle, StationSpindle>,
        swivel: usize,
        angle: f64,
    ) -> Result<Vec<Positions>, MachineError> {
        let worm = self.needed(Role::Worm)?;
        let mut found = self.solve(Station::Dresser, pose, &[(worm, angle)])?;
        found.retain(|at| at[swivel].abs() < FRAC_PI_2);
        Ok(found)
    }

    fn by_slide(
        &self,
        pose: &Pose<ToolSpindle, StationSpindle>,
        swivel: usize,
        slide: f64,
    ) -> Result<Vec<Positions>, MachineError> {
        let (worm, axial) = (self.needed(Role::Worm)?, self.needed(Role::Axial)?);
        let at =
            |angle: f64| -> Option<Positions> { self.by_worm(pose, swivel, angle).ok()?.into_iter().next() };
        let excess = |angle: f64| at(angle).map_or(f64::NAN, |at| at[axial] - slide);
        let angles = equidistant([-PI, PI], SCAN);
        let values: Vec<f64> = angles.iter().map(|&angle| excess(angle)).collect();
        let mut found = Vec::new();
        for k in 0..SCAN - 1 {
            // A zero at a node belongs to the interval that begins there; one at the end of the turn to its start.
            if values[k + 1] == 0.0 {
                continue;
            }
            let bracket = ([angles[k], angles[k + 1]], [values[k], values[k + 1]]);
            if let Some(mut solution) = brent(bracket.0, bracket.1, 0.0, |x| Some(excess(x))).and_then(at) {
                solution[worm] = within_turn(solution[worm]);
                found.push(solution);
            }
        }
        if found.is_empty() {
            let reached = values.iter().filter(|x| x.is_finite()).map(|x| x + slide);
            let [least, greatest] = extremes(reached);
            return Err(MachineError::Unreachable {
                what: self.axes()[axial].name.clone(),
                wanted: slide,
                least,
                greatest,
                unit: "mm",
            });
        }
        Ok(found)
    }

    /// All positions of a pose with some axes fixed.
    pub(super) fn solve(
        &self,
        station: Station,
        pose: &Pose<ToolSpindle, StationSpindle>,
        fixed: &[(usize, f64)],
    ) -> Result<Vec<Positions>, MachineError> {
        self.solve_wrist(station, pose, fixed, POLE)
    }

    fn solve_wrist(
        &self,
        station: Station,
        pose: &Pose<ToolSpindle, StationSpindle>,
        fixed: &[(usize, f64)],
        pole: f64,
    ) -> Result<Vec<Positions>, MachineError> {
        check_pose(pose)?;
        let axes = self.axes_at(station)?;
        let free: Vec<usize> = axes.into_iter().filter(|k| fixed.iter().all(|(axis, _)| axis != k)).collect();
        if free.len() != 6 {
            return Err(MachineError::NotDetermined {
                free: free.len(),
                determined: 6,
                axes: self.names(&free),
            });
        }
        let (rotary, linear): (Vec<usize>, Vec<usize>) =
            free.iter().partition(|&&axis| self.joint(axis) == Joint::Rotary);
        let mut start = Positions::default();
        fixed.iter().for_each(|&(axis, value)| start[axis] = value);
        let (Ok(rotary), Ok(linear)) = (<[usize; 3]>::try_from(rotary), <[usize; 3]>::try_from(linear))
        else {
            return self.iterate(station, pose, fixed);
        };
        let wrist = Wrist::new(self, station, pose, &start)?;
        wrist
            .angles(rotary, pole)
            .map_err(|reason| self.no_wrist(reason, &rotary))?
            .into_iter()
            .map(|at| self.place(station, pose, at, &linear))
            .collect()
    }

    fn no_wrist(&self, reason: NoWrist, axes: &[usize]) -> MachineError {
        match reason {
            NoWrist::Singular { measure } => MachineError::Singular { axes: self.names(axes), measure },
            NoWrist::Beyond { wanted, least, greatest } => MachineError::Unreachable {
                what: "the angle between the spindles".into(),
                wanted: wanted.clamp(-1.0, 1.0).acos().to_degrees(),
                least: greatest.clamp(-1.0, 1.0).acos().to_degrees(),
                greatest: least.clamp(-1.0, 1.0).acos().to_degrees(),
                unit: "deg",
            },
        }
    }

    /// The linear axes that bring the origins together, the rotary ones as they stand.
    fn place(
        &self,
        station: Station,
        pose: &Pose<ToolSpindle, StationSpindle>,
        mut at: Positions,
        linear: &[usize; 3],
    ) -> Result<Positions, MachineError> {
        let other = self.station(station)?;
        let tool: Pose<Bed, ToolSpindle> = self.limb(self.tool(), &at);
        let wanted = tool.then(pose);
        let here: Pose<Bed, StationSpindle> = self.limb(other, &at);
        let gap = here.translation() - wanted.translation();
        let q = self.linear_axes(station, &at, linear, &gap)?;
        for (k, &axis) in linear.iter().enumerate() {
            at[axis] += q[k];
        }
        Ok(at)
    }
}

/// A rotary axis in a pose's equation: its number, its direction, and the sense in which it enters.
type Turning = (usize, Vector3<f64>, f64);

/// The rotations of a pose's equation in their order: e_1 .. e_n A f_m^-1 .. f_1^-1 = 1 with the axes e of the tool's limb, f of
/// the station's, and A = home_tool H home_station^-1.
struct Wrist {
    /// The axes with their directions at zero.
    axes: Vec<Turning>,
    /// How many of them stand before A.
    before: usize,
    /// A.
    between: Matrix3<f64>,
    /// What the fixed axes are at.
    start: Positions,
}

impl Wrist {
    fn new(
        machine: &Machine,
        station: Station,
        pose: &Pose<ToolSpindle, StationSpindle>,
        start: &Positions,
    ) -> Result<Self, MachineError> {
        let (tool, other) = (machine.tool(), machine.station(station)?);
        let rotary = |axis: &&usize| machine.joint(**axis) == Joint::Rotary;
        let direction = |axis: usize| machine.axes()[axis].direction;
        let mut axes: Vec<_> =
            tool.axes.iter().filter(rotary).map(|&axis| (axis, direction(axis), 1.0)).collect();
        let before = axes.len();
        axes.extend(other.axes.iter().rev().filter(rotary).map(|&axis| (axis, direction(axis), -1.0)));
        let home = tool.home::<ToolSpindle>().then(pose).then(&other.home::<StationSpindle>().inverse());
        Ok(Self { axes, before, between: *home.rotation(), start: *start })
    }

    /// The free axes as they enter, turned by what stands fixed before them, and the rotation that they have to make.
    fn reduced(&self, free: &[usize]) -> (Vec<Turning>, Matrix3<f64>) {
        let mut turned = Matrix3::identity();
        let mut found = Vec::with_capacity(free.len());
        for (k, &(axis, direction, sense)) in self.axes.iter().enumerate() {
            if k == self.before {
                turned *= self.between;
            }
            if free.contains(&axis) {
                found.push((axis, turned * direction, sense));
            } else {
                turned *= about(&direction, sense * self.start[axis]);
            }
        }
        if self.before == self.axes.len() {
            turned *= self.between;
        }
        (found, turned.transpose())
    }

    /// All angles of three free axes, in (-pi, pi].
    fn angles(&self, free: [usize; 3], pole: f64) -> Result<Vec<Positions>, NoWrist> {
        let (found, wanted) = self.reduced(&free);
        let [first, second, third] = found.as_slice() else { return Ok(Vec::new()) };
        let sets = three_axes([&first.1, &second.1, &third.1], &wanted, pole)?;
        let placed = |set: [f64; 3]| {
            let mut at = self.start;
            for (&(axis, _, sense), angle) in found.iter().zip(set) {
                at[axis] = within_turn(sense * angle);
            }
            at
        };
        Ok(sets.into_iter().map(placed).collect())
    }

    /// The one free axis turned as far as the rotation allows, and what it leaves of it, rad.
    fn only(&self, free: usize) -> (Positions, f64) {
        let (found, wanted) = self.reduced(&[free]);
        let mut at = self.start;
        let mut left = wanted;
        for (axis, direction, sense) in found {
            let x = across(&direction);
            let angle = turn(&direction, &x, &(wanted * x));
            at[axis] = within_turn(sense * angle);
            left = about(&direction, -angle) * wanted;
        }
        (at, (left - Matrix3::identity()).amax())
    }
}

/// The same angle in (-pi, pi].
pub(super) fn within_turn(angle: f64) -> f64 {
    let turned = angle - TAU * (angle / TAU).round();
    if turned <= -PI { turned + TAU } else { turned }
}

/// A rotation that is one, numbers that are finite.
pub(super) fn check_pose<To, From>(pose: &Pose<To, From>) -> Result<(), MachineError> {
    let rotation = pose.rotation();
    if let Some(&value) = rotation.iter().chain(pose.translation().iter()).find(|x| !x.is_finite()) {
        return Err(MachineError::InvalidNumber { field: "pose".into(), value });
    }
    let off = (rotation.transpose() * rotation - Matrix3::identity()).amax();
    let deviation = off.max((rotation.determinant() - 1.0).abs());
    if deviation > ORTHONORMAL { Err(MachineError::InvalidPose { deviation }) } else { Ok(()) }
}
