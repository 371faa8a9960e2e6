//! Dressing a grinding worm with a disc dresser in line contact (spec 30): settings DK -> worm flank, and back.

mod axis_influence;
mod characteristics;
mod conditions;
mod contact_line;
mod dresser;
mod envelope;
mod error;
mod forward;
mod line_dressing;
mod machine_choice;
mod machine_motion;
mod nominal;
mod tilt_chart;
mod topological;

pub use axis_influence::WormContact;
pub use characteristics::{full_tip_land, quasi_static_modification, stretch};
pub use conditions::{Condition, ConditionSolver};
pub use contact_line::ContactLine;
pub use dresser::{DresserTool, FlankDresser, GeometricRange};
pub use envelope::{DressedWorm, EnvelopePoint, dressing_motion};
pub use error::DressingError;
pub use forward::{DressedProfile, ProfilePoint, head_gradient};
pub use line_dressing::{DressingLine, LineDressing, LinePlan, RelativeForm, TipDisc, Touch};
pub use machine_choice::{AxisCriterion, MachineChoice, SwivelChoice};
pub use machine_motion::{
    AxisReversal, AxisUncertainty, MachineMotion, MachineRow, MachineTask, MachineWay, SwivelLaw,
};
pub use nominal::{NominalContact, nominal_contact};
pub use tilt_chart::TiltChart;
pub use topological::{NodePlan, NodeSolution, pitch_rolls, solve_dressing_motion, solve_node};
