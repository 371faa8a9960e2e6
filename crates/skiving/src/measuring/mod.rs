//! Measuring a skiving tool in the machine: the beam of a light barrier, or a stylus, laid on the edge at its virtual contact points
//! (`docs/mathematics/skiving.md`).

mod barrier;
mod beam;
mod calibration;
mod conventional;
mod first_order;
mod mandrel;
mod pose;
mod reach;
mod readings;
mod real_tool;
mod shadow;
mod signal;
mod tactile;

pub use barrier::{Barrier, Touch};
pub use beam::Beam;
pub use calibration::{Approach, Calibration, Observation};
pub use conventional::{ConventionalReading, conventional_pose, conventional_reading};
pub use first_order::first_order_deviation;
pub use foundation::numerics::Noise;
pub use mandrel::{BeamLine, Gap, Mandrel};
pub(super) use pose::turned;
pub use pose::{MeasuringPose, PoseKind, measuring_poses, nearest_clamped, nominal_angle};
pub use reach::{PoseLimits, check_pose, reached_pose};
pub use readings::{BarrierData, FlankTracks, Reading, Sense, Switches, readings, switches};
pub use real_tool::{EdgeErrors, RealTool};
use shadow::own_edge_gap;
pub use shadow::{NearestFlank, OTHER_FLANK_GAP, nearest_other_flank};
pub use signal::{DarkBand, dark_band};
pub use tactile::{ScanAxes, ScanPlace, scan_curve};
