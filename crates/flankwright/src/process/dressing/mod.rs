//! Dressing a grinding worm with a disc dresser in line contact (spec 30): settings DK -> worm flank, and back.

mod axis_influence;
pub mod catalogue;
mod characteristics;
mod clearance;
mod compensation;
mod condition_sets;
mod condition_solver;
mod conditions;
mod conditions_along;
mod contact_line;
mod crowning_range;
mod deviation;
mod deviation_recovery;
mod deviation_spread;
mod dresser;
mod dresser_pose;
mod dresser_section;
mod envelope;
mod error;
mod forward;
mod line_dressing;
mod machine_choice;
mod machine_motion;
mod multi_stroke;
mod nominal;
mod other_worm;
mod path_reason;
mod placement;
mod profile_fit;
mod section_outline;
mod settled;
mod stretch_angle;
mod stroke;
mod stroke_division;
mod stroke_motion;
mod stroke_surface;
mod swept_circle;
mod tilt_chart;
mod topological;
mod two_flanks;
mod undermining;

pub use axis_influence::WormContact;
pub use characteristics::{full_tip_land, quasi_static_modification, stretch};
pub use clearance::{Clearance, ThreadSpace};
pub use compensation::{Compensated, Compensation, SoftCondition};
pub use condition_sets::{
    PitchPoint, four_points, map_of_upper_end, shift_through, three_points, three_points_with_map,
    two_flank_points, two_points,
};
pub use condition_solver::ConditionSolver;
pub use conditions::Condition;
pub use conditions_along::{ConditionsAlong, RowAlong};
pub use contact_line::ContactLine;
pub use crowning_range::{CrowningEnd, CrowningLimits, CrowningPoint, CrowningRange, CrowningRows};
pub use deviation::{AXIS_NAMES, Influence, influence};
pub use deviation_recovery::{Measurement, RecoveredDeviation, Recovery, recover_deviation};
pub use deviation_spread::{Quantiles, Spread, SpreadOfProfile, Spreads, spread_of_profile};
pub use dresser::{DresserTool, FlankDresser, GeometricRange};
pub use dresser_section::{DresserSection, SectionPart};
pub use envelope::{DressedWorm, EnvelopePoint, dressing_motion};
pub use error::DressingError;
pub use forward::{DressedProfile, ProfilePoint, head_gradient};
pub use line_dressing::{DressingLine, LineDressing, LinePlan, RelativeForm, TipDisc, Touch};
pub use machine_choice::{AxisCriterion, MachineChoice, SwivelChoice};
pub use machine_motion::{
    AxisReversal, AxisUncertainty, MachineMotion, MachineRow, MachineTask, MachineWay, SwivelLaw,
};
pub use multi_stroke::{MultiStroke, StrokePoint};
pub use nominal::{NominalContact, nominal_contact};
pub use other_worm::WormSeat;
pub use path_reason::PathReason;
pub use profile_fit::{
    ProfileFit, fit_profile, fit_profile_along, fit_profile_on_path, profile_error, refit_profile,
    uncorrected_profile,
};
pub use section_outline::{SectionOutline, ShownWorm};
pub use stretch_angle::{StretchAngle, angle_of_least_stretch};
pub use stroke::{ActiveArea, DressedStroke, Stroke};
pub use stroke_division::{ProfileSection, divide};
pub use stroke_motion::{
    MovingStroke, StrokeAlong, StrokeWish, StrokedPoint, StrokedWorm, solve_stroke_node,
};
pub use stroke_surface::StrokeSurface;
pub use tilt_chart::TiltChart;
pub use topological::{
    NodePlan, NodeSolution, pitch_rolls, residue_of_motion, solve_conditions_along, solve_conditions_at,
    solve_dressing_motion, solve_node,
};
pub use two_flanks::{TwoFlankWish, solve_two_flank_motion, solve_two_flank_node, two_flank_rolls};
pub use undermining::WormFlank;
