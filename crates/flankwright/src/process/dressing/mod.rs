//! Dressing a grinding worm with a disc dresser in line contact (spec 30): settings DK -> worm flank, and back.

pub mod catalogue;
mod characteristics;
mod clearance;
mod conditions;
mod contact_line;
mod dresser;
mod dresser_section;
mod envelope;
mod error;
mod forward;
mod nominal;
mod other_worm;
mod profile_fit;
mod stretch_angle;
mod swept_circle;
mod tilt_chart;
mod topological;

pub use characteristics::{full_tip_land, quasi_static_modification, stretch};
pub use clearance::{Clearance, ThreadSpace, WormFlank};
pub use conditions::{Condition, ConditionSolver};
pub use contact_line::ContactLine;
pub use dresser::{DresserTool, FlankDresser, GeometricRange};
pub use dresser_section::{DresserSection, SectionPart};
pub use envelope::{DressedWorm, EnvelopePoint, dressing_motion};
pub use error::DressingError;
pub use forward::{DressedProfile, ProfilePoint, head_gradient};
pub use nominal::{NominalContact, nominal_contact};
pub use other_worm::WormSeat;
pub use profile_fit::{
    ProfileFit, fit_profile, fit_profile_along, fit_profile_on_path, profile_error, refit_profile,
    uncorrected_profile,
};
pub use stretch_angle::{StretchAngle, angle_of_least_stretch};
pub use tilt_chart::TiltChart;
pub use topological::{NodePlan, NodeSolution, pitch_rolls, solve_dressing_motion, solve_node};
