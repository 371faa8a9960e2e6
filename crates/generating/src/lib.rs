//! Generating grinding with a dressed worm (`docs/mathematics/modifications.md`, `docs/mathematics/planning.md`): settings -> flank by the exact contact, and back
//! by decomposition and precompensation.

pub mod areas;
mod best_fit;
pub mod carried;
mod class_fit;
pub mod correction;
pub mod curve_law;
pub mod decomposition;
pub mod dressed;
mod economy;
mod effort;
pub mod equal_ratio;
mod equal_swivel;
pub mod error;
pub mod feed_law;
mod fit_levers;
pub mod fit_shift;
pub mod free_lines;
pub mod gear_root;
mod gear_root_choice;
pub mod ideal_plan;
pub mod least_squares;
mod line_functions;
pub mod lines;
mod local_envelope;
pub mod made;
mod motion;
mod moved_profile;
pub mod natural_twist;
pub mod plan;
mod plan_by_fit;
pub mod planning_grid;
pub mod policy;
mod precompensation;
mod quadratic;
pub mod ratio;
mod ratio_nodes;
pub mod setup;
pub mod spared_worms;
pub mod stroke_layout;
mod stroke_place;
pub mod stroked;
pub mod strokes;
pub mod target;
pub mod tip_land;
mod variable_ratio;
mod wanted_worm;
pub mod workshop;
pub mod worm_function;

pub use carried::{Carried, FieldSpline, misfit_of_lines};
pub use class_fit::ClassFit;
pub use curve_law::{CurveLaw, WantedCurve};
pub use decomposition::{Decomposition, decompose_diagonal, decompose_radial, radial_residual};
pub use dressed::{
    DressedFlank, FinishedArea, dress_flanks, dresser_of_plan, dresser_profile, dressing_interval,
};
pub use economy::Prefer;
pub use effort::Effort;
pub use equal_ratio::{
    EqualRatio, EqualRatioSearch, Lever, RatioRoot, WormLine, generatrix, worm_at_crossing_angle,
};
pub use equal_swivel::{EqualSwivel, SwivelSide, equal_swivel};
pub use error::GeneratingError;
pub use feed_law::FeedLaw;
pub use fit_levers::{AllowedLever, FlankDemand, LeverBodies, LeverFit, LeverSearch};
pub use fit_shift::{DEFAULT_NODES, ShiftCoordinates, ShiftFit, fit_shift};
pub use free_lines::{FreeLines, equal_ratio_lines, lines_for_ratio};
pub use gear_root::{GroundRoot, WormTip};
pub use gear_root_choice::GearRootChoice;
pub use ideal_plan::{Command, IdealPlan};
pub use line_functions::{LineFunctions, LineWorm};
pub use lines::FlankLines;
pub use local_envelope::{LocalEnvelope, kinematic_compliance};
pub use made::MadeFlank;
pub use motion::{common_motion, motion_of_flanks};
pub use moved_profile::MovedProfile;
pub use natural_twist::{NaturalTwist, natural_twist};
pub use plan::{DEFAULT_LEAST_DETERMINANT, FlankPlan, GrindingPlan, LeastDeviation, PlanTask, PlannedTool};
pub use planning_grid::PlanningGrid;
pub use policy::{DressingRows, FreeCoefficients, PlanGauge, ProfilePolicy, SeriesRule};
pub use quadratic::{
    Gauge, QuadraticDecomposition, QuadraticWorm, constant_only_profile_crowning, decompose_quadratic,
    product_functions,
};
pub use ratio::{
    Candidate, FlankResidual, LEAST_DETERMINANT, NoPlan, RatioChoice, RatioReason, lead_correction_ratio,
};
pub use setup::{DresserChoice, DressingLimits, GrindingSetup, ProfilePlace, SetupInput, Tool};
pub use spared_worms::{SparedWorms, Undermined};
pub use stroke_layout::{AreaOfDresser, DressedSection, GivenDresser, StrokeChoice};
pub use stroke_place::{StrokeLayout, StrokePlace};
pub use stroked::StrokedFlank;
pub use strokes::Strokes;
pub use target::{Carrier, FlankTarget, PlaceOfDresser};
pub use tip_land::LeastRoom;
pub use variable_ratio::VariableRatio;
pub use wanted_worm::gear_of_worm;
pub use workshop::GearWorkshop;
pub use worm_function::IdealWorm;
