//! Dressing a grinding worm with a disc dresser in line contact (spec 30): settings DK -> worm flank, and back.

mod characteristics;
mod clearance;
mod conditions;
mod contact_line;
mod dresser;
mod dresser_pose;
mod dresser_section;
mod envelope;
mod error;
mod forward;
mod nominal;
mod section_outline;
mod swept_circle;
mod tilt_chart;
mod topological;
mod undermining;

pub use characteristics::{full_tip_land, quasi_static_modification, stretch};
pub use clearance::{Clearance, ThreadSpace};
pub use conditions::{Condition, ConditionSolver};
pub use contact_line::ContactLine;
pub use dresser::{DresserTool, FlankDresser, GeometricRange};
pub use dresser_section::{DresserSection, SectionPart};
pub use envelope::{DressedWorm, EnvelopePoint, dressing_motion};
pub use error::DressingError;
pub use forward::{DressedProfile, ProfilePoint, head_gradient};
pub use nominal::{NominalContact, nominal_contact};
pub use section_outline::{SectionOutline, ShownWorm};
pub use tilt_chart::TiltChart;
pub use topological::{NodePlan, NodeSolution, pitch_rolls, solve_dressing_motion, solve_node};
pub use undermining::WormFlank;
