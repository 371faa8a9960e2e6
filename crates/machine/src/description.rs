//! The description of a machine, checked once: axes, their roles, and the limbs that they make. Knows how nothing moves.

use super::axis::MOST_AXES;
use super::{Axis, Bed, InvalidMachine, Joint, MachineError, Role, Station};
use foundation::kinematics::Pose;
use nalgebra::{Matrix3, Vector3};

/// A chain of axes from the bed to a spindle.
#[derive(Clone, Debug, PartialEq)]
pub struct Limb {
    /// Numbers of its axes, from the bed outwards.
    pub axes: Vec<usize>,
    /// The spindle frame with all axes at zero: origin (mm) and directions of its x and z, in M.
    pub origin: Vector3<f64>,
    /// Direction of the spindle's x.
    pub x: Vector3<f64>,
    /// Direction of the spindle's z.
    pub z: Vector3<f64>,
}

/// What a machine consists of, not yet checked.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineParts {
    /// Its name.
    pub name: String,
    /// All axes.
    pub axes: Vec<Axis>,
    /// Who does what: numbers of axes.
    pub roles: Vec<(Role, usize)>,
    /// From the bed to the tool spindle.
    pub tool: Limb,
    /// From the bed to the work spindle.
    pub work: Limb,
    /// From the bed to the dresser spindle.
    pub dresser: Option<Limb>,
}

/// A machine that has been checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Machine {
    parts: MachineParts,
}

/// Directions are unit vectors, frames orthogonal, up to this.
const UNIT: f64 = 1e-9;

/// What a machine with longer ways has beyond its travel, mm and rad: more than any part is large, and no further solution of the axes.
const LONGER: [f64; 2] = [5000.0, std::f64::consts::FRAC_PI_3];

impl Machine {
    /// The same machine with longer ways of these axes, to learn how far a motion would go that it cannot make.
    pub fn with_longer_ways(&self, longer: &[usize]) -> Self {
        let mut parts = self.parts.clone();
        for (_, axis) in parts.axes.iter_mut().enumerate().filter(|(number, _)| longer.contains(number)) {
            let more = match axis.joint {
                Joint::Linear => LONGER[0],
                Joint::Rotary => LONGER[1],
            };
            axis.travel = axis.travel.map(|[from, to]| [from - more, to + more]);
        }
        Self { parts }
    }

    /// Checks the parts.
    ///
    /// # Errors
    /// [`InvalidMachine`]: no axes or more than 12, a name twice, numbers that are not finite, a direction that is no unit
    /// vector, travel without length, an axis in no limb or in two places, a role that its axis cannot play, a spindle frame
    /// that is not orthogonal.
    pub fn new(parts: MachineParts) -> Result<Self, InvalidMachine> {
        let fail = |field: String, problem: String, allowed: &str| {
            Err(InvalidMachine { field, problem, allowed: allowed.into() })
        };
        let count = parts.axes.len();
        if !(1..=MOST_AXES).contains(&count) {
            return fail("axes".into(), format!("{count} axes"), "1 .. 12 axes");
        }
        for (number, axis) in parts.axes.iter().enumerate() {
            let field = |key: &str| format!("axes.{}.{key}", axis.name);
            if axis.name.is_empty() || parts.axes[..number].iter().any(|other| other.name == axis.name) {
                return fail(field("name"), "two axes of one name, or none".into(), "each name once");
            }
            let numbers = axis.direction.iter().chain(axis.point.iter());
            if numbers.chain(axis.travel.iter().flatten()).any(|x| !x.is_finite()) {
                return fail(field("direction"), "a number that is not finite".into(), "finite numbers");
            }
            let length = axis.direction.norm();
            if (length - 1.0).abs() > UNIT {
                return fail(
                    field("direction"),
                    format!("its length is {length}"),
                    "a unit vector up to 1e-9",
                );
            }
            if let Some([from, to]) = axis.travel
                && from >= to
            {
                let (from, to) = (axis.joint.shown(from), axis.joint.shown(to));
                return fail(field("max"), format!("travel {from} .. {to}"), "the end above the start");
            }
            if axis.nc_sign.abs() != 1.0 {
                return fail(field("nc_sign"), format!("{}", axis.nc_sign), "1 or -1");
            }
            let limits = [axis.limits.velocity, axis.limits.acceleration, axis.limits.jerk, axis.resolution];
            if let Some(bad) = limits.into_iter().flatten().find(|x| !(x.is_finite() && *x > 0.0)) {
                return fail(field("max_velocity"), format!("a limit of {bad}"), "above 0, or absent");
            }
        }
        for (role, axis) in &parts.roles {
            let field = || format!("roles.{}", role.key());
            let Some(axis) = parts.axes.get(*axis) else {
                return fail(field(), "names no axis".into(), "the name of an axis");
            };
            if axis.joint != role.joint() {
                return fail(
                    field(),
                    format!("{} moves the other way", axis.name),
                    "linear or rotary as the role is",
                );
            }
            if parts.roles.iter().filter(|(other, _)| other == role).count() > 1 {
                return fail(field(), "two axes".into(), "one axis");
            }
        }
        let machine = Self { parts };
        machine.check_limbs()?;
        Ok(machine)
    }

    fn check_limbs(&self) -> Result<(), InvalidMachine> {
        let parts = &self.parts;
        let fail = |field: String, problem: String, allowed: &str| {
            Err(InvalidMachine { field, problem, allowed: allowed.into() })
        };
        let limbs =
            [("tool", Some(&parts.tool)), ("work", Some(&parts.work)), ("dresser", parts.dresser.as_ref())];
        let mut used = vec![0usize; parts.axes.len()];
        for (name, limb) in limbs {
            let Some(limb) = limb else { continue };
            for &axis in &limb.axes {
                match used.get_mut(axis) {
                    Some(count) => *count += 1,
                    None => {
                        return fail(format!("chains.{name}.axes"), "names no axis".into(), "names of axes");
                    }
                }
            }
            let frame = |key: &str| format!("chains.{name}.frame.{key}");
            for (key, v) in [("x", &limb.x), ("z", &limb.z)] {
                if (v.norm() - 1.0).abs() > UNIT || v.iter().any(|x| !x.is_finite()) {
                    return fail(
                        frame(key),
                        format!("its length is {}", v.norm()),
                        "a unit vector up to 1e-9",
                    );
                }
            }
            if limb.x.dot(&limb.z).abs() > UNIT {
                return fail(frame("x"), "not across z".into(), "perpendicular to z up to 1e-9");
            }
            if limb.origin.iter().any(|x| !x.is_finite()) {
                return fail(frame("origin_mm"), "a number that is not finite".into(), "finite numbers");
            }
        }
        for (axis, count) in parts.axes.iter().zip(used) {
            if count != 1 {
                let problem = format!("it stands in {count} places of the limbs");
                return fail(format!("axes.{}", axis.name), problem, "one place in one limb");
            }
        }
        Ok(())
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.parts.name
    }

    /// All axes; their places here are the numbers by which they are called.
    pub fn axes(&self) -> &[Axis] {
        &self.parts.axes
    }

    /// Number of the axis of a role.
    pub fn role(&self, role: Role) -> Option<usize> {
        self.parts.roles.iter().find(|(known, _)| *known == role).map(|(_, axis)| *axis)
    }

    /// Number of the axis of a role that is needed.
    ///
    /// # Errors
    /// [`MachineError::MissingAxis`].
    pub fn needed(&self, role: Role) -> Result<usize, MachineError> {
        self.role(role).ok_or_else(|| self.missing(role.key()))
    }

    /// Number of the axis of a name.
    pub fn axis_named(&self, name: &str) -> Option<usize> {
        self.parts.axes.iter().position(|axis| axis.name == name)
    }

    /// The limb of the tool.
    pub fn tool(&self) -> &Limb {
        &self.parts.tool
    }

    /// The limb of a station.
    ///
    /// # Errors
    /// [`MachineError::MissingAxis`] for the dresser of a machine without one.
    pub fn station(&self, station: Station) -> Result<&Limb, MachineError> {
        match station {
            Station::Work => Ok(&self.parts.work),
            Station::Dresser => self.parts.dresser.as_ref().ok_or_else(|| self.missing("dresser")),
        }
    }

    /// Numbers of the axes that move the tool or the station, those of the tool first, from the bed outwards.
    ///
    /// # Errors
    /// As [`Machine::station`].
    pub fn axes_at(&self, station: Station) -> Result<Vec<usize>, MachineError> {
        let other = self.station(station)?;
        Ok(self.parts.tool.axes.iter().chain(&other.axes).copied().collect())
    }

    pub(super) fn missing(&self, role: &'static str) -> MachineError {
        MachineError::MissingAxis { machine: self.parts.name.clone(), role }
    }

    /// Names of axes, for messages.
    pub(super) fn names(&self, axes: &[usize]) -> Vec<String> {
        axes.iter().filter_map(|&k| self.parts.axes.get(k)).map(|axis| axis.name.clone()).collect()
    }

    pub(super) fn joint(&self, axis: usize) -> Joint {
        self.parts.axes[axis].joint
    }
}

impl Limb {
    /// The spindle frame in M with all axes at zero.
    pub(super) fn home<Spindle>(&self) -> Pose<Bed, Spindle> {
        let rotation = Matrix3::from_columns(&[self.x, self.z.cross(&self.x), self.z]);
        Pose::rigid(rotation, self.origin)
    }
}
