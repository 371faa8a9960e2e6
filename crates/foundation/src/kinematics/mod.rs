//! Where bodies stand and how they move: typed poses, chains of elementary motions, motion laws and couplings as plain
//! data. Knows shapes only by name; knows no contact and no process.

mod axis_twist;
mod dressing;
mod dressing_machine;
mod dressing_path;
mod error;
mod generating;
mod inverse_law;
mod law;
mod machine_error;
mod piecewise;
mod pose;
mod skiving;

pub use axis_twist::AxisTwist;
pub use dressing::{DressingChain, DressingCorrection, DressingMotion, DressingPosition};
pub use dressing_machine::{
    DressingAxes, DressingAxis, DressingBranch, DressingMachine, DressingRule, DressingSolution,
};
pub use dressing_path::DressingPath;
pub use error::LawError;
pub use generating::{GeneratingChain, GeneratingMotion, GeneratingState};
pub use inverse_law::InverseLaw;
pub use law::MotionLaw;
pub use machine_error::MachineError;
pub use piecewise::PiecewisePolynomial;
pub use pose::{Direction, Dresser, Point, Pose, Room, Workpiece, Worm};
pub use skiving::SkivingMotion;
