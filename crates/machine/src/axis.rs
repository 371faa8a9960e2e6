//! One axis of a machine: what it moves along or about, how far, how fast. Knows no other axis.

use super::MachineError;
use nalgebra::Vector3;
use std::ops::{Index, IndexMut};

/// How an axis moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Joint {
    /// Along its direction, mm.
    Linear,
    /// About its direction, rad.
    Rotary,
}

impl Joint {
    /// A value in the unit that messages and files use: mm or deg.
    pub fn shown(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Rotary => value.to_degrees(),
        }
    }

    /// A value of a message or file in the library's unit: mm or rad.
    pub fn from_shown(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Rotary => value.to_radians(),
        }
    }

    /// "mm" or "deg".
    pub fn unit(self) -> &'static str {
        match self {
            Self::Linear => "mm",
            Self::Rotary => "deg",
        }
    }
}

/// What an axis does in the machine's work (`docs/mathematics/programs.md#from-bodies-to-axes`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// X1: infeed between tool and workpiece.
    Radial,
    /// Z1: along the workpiece axis.
    Axial,
    /// A1: tilt of the tool head.
    Tilt,
    /// V1: shift of the tool along its axis, above the tilt.
    Shift,
    /// Y1: tangential slide, below the tilt.
    Tangential,
    /// B1: rotation of the tool.
    Worm,
    /// C2: rotation of the workpiece.
    Work,
    /// C5: swivel of the dresser.
    Swivel,
    /// B3: rotation of the dresser.
    Dresser,
}

impl Role {
    /// All roles.
    pub const ALL: [Self; 9] = [
        Self::Radial,
        Self::Axial,
        Self::Tilt,
        Self::Shift,
        Self::Tangential,
        Self::Worm,
        Self::Work,
        Self::Swivel,
        Self::Dresser,
    ];

    /// Its key in a machine file.
    pub fn key(self) -> &'static str {
        match self {
            Self::Radial => "radial",
            Self::Axial => "axial",
            Self::Tilt => "tilt",
            Self::Shift => "shift",
            Self::Tangential => "tangential",
            Self::Worm => "worm",
            Self::Work => "work",
            Self::Swivel => "swivel",
            Self::Dresser => "dresser",
        }
    }

    /// How an axis of this role moves.
    pub fn joint(self) -> Joint {
        match self {
            Self::Radial | Self::Axial | Self::Shift | Self::Tangential => Joint::Linear,
            Self::Tilt | Self::Worm | Self::Work | Self::Swivel | Self::Dresser => Joint::Rotary,
        }
    }
}

/// Greatest speed, acceleration and jerk of an axis: mm or rad per s, s^2, s^3. `None` is not limited.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AxisLimits {
    /// Speed.
    pub velocity: Option<f64>,
    /// Acceleration.
    pub acceleration: Option<f64>,
    /// Jerk.
    pub jerk: Option<f64>,
}

/// An axis in the machine frame M, all axes at zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Its name, e.g. "X1".
    pub name: String,
    /// How it moves.
    pub joint: Joint,
    /// Unit vector along or about which a positive value moves the body that the axis carries.
    pub direction: Vector3<f64>,
    /// A point of a rotary axis, mm.
    pub point: Vector3<f64>,
    /// Ends of travel, mm or rad; `None` turns without end.
    pub travel: Option<[f64; 2]>,
    /// +1 or -1: the control counts this times the value here (ISO 841 counts axes that carry the workpiece the other way).
    pub nc_sign: f64,
    /// Limits of its motion.
    pub limits: AxisLimits,
    /// Smallest step, mm or rad, if it is known.
    pub resolution: Option<f64>,
}

/// How far beyond its travel an axis may stand by rounding, rad or mm.
const TRAVEL_TOLERANCE: f64 = 1e-9;

impl Axis {
    /// How far a position stands inside the travel, mm or rad: negative beyond it, infinite without ends.
    pub fn margin(&self, value: f64) -> f64 {
        match self.travel {
            Some([from, to]) => (value - from).min(to - value),
            None => f64::INFINITY,
        }
    }

    /// Whether a position is within the travel; 1e-9 beyond counts as within.
    pub fn admits(&self, value: f64) -> bool {
        self.margin(value) >= -TRAVEL_TOLERANCE
    }

    /// The error of a position beyond the travel; `None` within it.
    pub fn beyond(&self, value: f64) -> Option<MachineError> {
        let [from, to] = self.travel?;
        (!self.admits(value)).then(|| MachineError::AxisLimit {
            axis: self.name.clone(),
            value: self.joint.shown(value),
            excess: self.joint.shown(-self.margin(value)),
            unit: self.joint.unit(),
            from: self.joint.shown(from),
            to: self.joint.shown(to),
        })
    }
}

/// Most axes of a machine.
pub const MOST_AXES: usize = 12;

/// Positions of all axes of a machine in the order of its description, mm or rad.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Positions([f64; MOST_AXES]);

impl Index<usize> for Positions {
    type Output = f64;

    fn index(&self, axis: usize) -> &f64 {
        &self.0[axis]
    }
}

impl IndexMut<usize> for Positions {
    fn index_mut(&mut self, axis: usize) -> &mut f64 {
        &mut self.0[axis]
    }
}
