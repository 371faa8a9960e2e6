//! Where bodies stand and how they move: typed poses, chains of elementary motions, motion laws and couplings as plain
//! data. Knows shapes only by name; knows no contact and no process.

mod dressing;
mod error;
mod generating;
mod inverse_law;
mod law;
mod piecewise;
mod pose;

pub use dressing::{DressingChain, DressingCorrection, DressingMotion, DressingPosition};
pub use error::LawError;
pub use generating::{GeneratingChain, GeneratingMotion, GeneratingState};
pub use inverse_law::InverseLaw;
pub use law::MotionLaw;
pub use piecewise::PiecewisePolynomial;
pub use pose::{Direction, Dresser, Point, Pose, Room, Workpiece, Worm};
