//! Measuring a skiving tool in the machine: the beam of a light barrier, or a stylus, laid on the edge at its virtual contact points
//! (spec 60 sections 6 to 12).

mod barrier;
mod beam;
mod noise;
mod pose;
mod readings;
mod real_tool;
mod shadow;

pub use barrier::{Barrier, Touch};
pub use beam::Beam;
pub use noise::Noise;
pub use pose::{MeasuringPose, PoseKind, measuring_poses, nearest_clamped, nominal_angle};
pub(super) use pose::turned;
pub use readings::{BarrierData, FlankTracks, Reading, Sense, Switches, readings, switches};
pub use real_tool::{EdgeErrors, RealTool};
pub use shadow::{NearestFlank, OTHER_FLANK_GAP, nearest_other_flank};
