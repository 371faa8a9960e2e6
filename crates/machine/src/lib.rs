//! Machines as data: a tree of axes with limits, from its description to poses and back with all solutions
//! (`docs/mathematics/generating-contact.md#machine-chains`). Knows poses and motions of bodies; knows no flank, no process, no file and no
//! control.
//!
//! A pose asked of a machine is that of a station's spindle in coordinates of the tool spindle, H = limb_tool(q)^-1
//! limb_station(q). Mounts turn poses of bodies into it ([`Mount`]).

mod axis;
mod carried;
mod choice;
mod description;
mod error;
pub mod five_axis;
mod forward;
mod frames;
mod gearbox;
mod influence;
mod inverse;
mod mount;
mod numeric;
mod orient;
mod placed;
mod rotations;
mod rule;
mod straight;

pub use axis::{Axis, AxisLimits, Joint, MOST_AXES, Positions, Role};
pub use choice::{Follower, Solution};
pub use description::{Limb, Machine, MachineParts};
pub use error::{InvalidMachine, MachineError};
pub use frames::{Bed, Station, StationSpindle, ToolSpindle};
pub use gearbox::{CouplingRates, GearCoupling};
pub use influence::MachineTwist;
pub use mount::{Mount, Mounts};
pub use orient::{AxisSolutions, FiveAxes, ToolAxis};
pub use rule::DressingRule;
pub use straight::StraightBound;
