//! Where bodies stand and how they move: typed poses, chains of elementary motions, motion laws and couplings as plain
//! data. Knows shapes only by name; knows no contact and no process.

mod dressing;
mod generating;
mod law;
mod pose;

pub use dressing::{DressingChain, DressingCorrection, DressingMotion, DressingPosition};
pub use generating::{GeneratingChain, GeneratingMotion, GeneratingState};
pub use law::MotionLaw;
pub use pose::{Direction, Dresser, Point, Pose, Room, Workpiece, Worm};
