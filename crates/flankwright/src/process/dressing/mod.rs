//! Dressing a grinding worm with a disc dresser in line contact (spec 30): settings DK -> worm flank, and back.

mod characteristics;
mod clearance;
mod conditions;
mod contact_line;
mod deviation;
mod deviation_recovery;
mod deviation_spread;
mod dresser;
mod dresser_section;
mod envelope;
mod error;
mod forward;
mod multi_stroke;
mod nominal;
mod other_worm;
mod profile_fit;
mod stretch_angle;
mod stroke;
mod stroke_division;
mod stroke_motion;
mod swept_circle;
mod tilt_chart;
mod topological;
mod two_flanks;

pub use characteristics::{full_tip_land, quasi_static_modification, stretch};
pub use clearance::{Clearance, ThreadSpace, WormFlank};
pub use conditions::{Condition, ConditionSolver};
pub use contact_line::ContactLine;
pub use deviation::{AXIS_NAMES, Influence, influence};
pub use deviation_recovery::{Measurement, RecoveredDeviation, Recovery, recover_deviation};
pub use deviation_spread::{Quantiles, Spread, SpreadOfProfile, Spreads, spread_of_profile};
pub use dresser::{DresserTool, FlankDresser, GeometricRange};
pub use dresser_section::{DresserSection, SectionPart};
pub use envelope::{DressedWorm, EnvelopePoint, dressing_motion};
pub use error::DressingError;
pub use forward::{DressedProfile, ProfilePoint, head_gradient};
pub use multi_stroke::{MultiStroke, StrokePoint};
pub use nominal::{NominalContact, nominal_contact};
pub use other_worm::WormSeat;
pub use profile_fit::{
    ProfileFit, fit_profile, fit_profile_along, profile_error, three_point_rows, uncorrected_profile,
};
pub use stretch_angle::{StretchAngle, angle_of_least_stretch};
pub use stroke::{ActiveArea, DressedStroke, Stroke};
pub use stroke_division::{ProfileSection, divide};
pub use stroke_motion::{
    MovingStroke, StrokeAlong, StrokeWish, StrokedPoint, StrokedWorm, solve_stroke_node,
};
pub use tilt_chart::TiltChart;
pub use topological::{NodePlan, NodeSolution, pitch_rolls, solve_dressing_motion, solve_node};
pub use two_flanks::{TwoFlankWish, solve_two_flank_motion, solve_two_flank_node, two_flank_rolls};
