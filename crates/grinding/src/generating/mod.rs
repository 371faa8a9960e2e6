//! Generating grinding with a dressed worm (`docs/mathematics/modifications.md`, `docs/mathematics/planning.md`): settings -> flank by the exact contact, and back
//! by decomposition and precompensation.

pub mod areas;
mod carried;
mod curve_law;
mod decomposition;
mod dressed;
mod equal_ratio;
mod equal_swivel;
mod error;
mod feed_law;
mod fit_levers;
mod fit_shift;
mod free_lines;
mod gear_root;
mod ideal_plan;
pub mod least_squares;
mod line_functions;
mod lines;
mod local_envelope;
mod made;
mod motion;
mod natural_twist;
mod plan;
mod planning_grid;
mod policy;
mod precompensation;
mod quadratic;
mod ratio;
mod ratio_nodes;
mod setup;
mod share;
mod stroke_layout;
mod stroked;
mod strokes;
mod target;
mod tip_land;
mod variable_ratio;
mod workshop;
mod worm_function;

pub use carried::{Carried, FieldSpline, misfit_of_lines};
pub use curve_law::{CurveLaw, WantedCurve};
pub use decomposition::{Decomposition, decompose_diagonal, decompose_radial, radial_residual};
pub use dressed::{
    DressedFlank, dress_flanks, dresser_of_plan, dresser_profile, dressing_interval, finished_area,
};
pub use equal_ratio::{
    EqualRatio, EqualRatioSearch, Lever, RatioRoot, WormLine, generatrix, worm_at_crossing_angle,
};
pub use equal_swivel::{EqualSwivel, SwivelSide, equal_swivel};
pub use error::GeneratingError;
pub use feed_law::FeedLaw;
pub use fit_levers::{AllowedLever, FlankDemand, LeverBodies, LeverFit, LeverSearch};
pub use fit_shift::{DEFAULT_NODES, ShiftCoordinates, ShiftFit, fit_shift};
pub use free_lines::{FreeLines, equal_ratio_lines, lines_for_ratio};
pub use gear_root::{GearRootChoice, GroundRoot, WormTip};
pub use ideal_plan::IdealPlan;
pub use line_functions::{LineFunctions, LineWorm};
pub use lines::FlankLines;
pub use local_envelope::{LocalEnvelope, kinematic_compliance};
pub use made::MadeFlank;
pub use motion::{common_motion, motion_of_flanks};
pub use natural_twist::{NaturalTwist, natural_twist};
pub use plan::{FlankPlan, GrindingPlan, PlanTask, PlannedTool};
pub use planning_grid::PlanningGrid;
pub use policy::{DressingRows, FlankRows, FreeCoefficients, PlanGauge, ProfilePolicy};
pub use quadratic::{
    Gauge, QuadraticDecomposition, QuadraticWorm, constant_only_profile_crowning, decompose_quadratic,
    product_functions,
};
pub use ratio::{
    Candidate, FlankResidual, LEAST_DETERMINANT, NoPlan, RatioChoice, RatioReason, lead_correction_ratio,
};
pub use setup::{DresserChoice, DressingLimits, GrindingSetup, ProfilePlace, SetupInput, Tool};
pub use share::Command;
pub use stroke_layout::{
    AreaOfDresser, DressedSection, GivenDresser, StrokeChoice, StrokeLayout, StrokePlace,
};
pub use stroked::StrokedFlank;
pub use strokes::Strokes;
pub use target::{Carrier, ClassFit, FlankTarget};
pub use tip_land::LeastRoom;
pub use variable_ratio::VariableRatio;
pub use workshop::GearWorkshop;
pub use worm_function::IdealWorm;
