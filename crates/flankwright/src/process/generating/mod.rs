//! Generating grinding with a dressed worm (specs 25 and 28): settings -> flank by the exact contact, and back by
//! decomposition and precompensation.

mod decomposition;
mod dressed;
mod error;
pub mod least_squares;
mod lines;
mod local_envelope;
mod motion;
mod natural_twist;
mod plan;
mod precompensation;
mod quadratic;
mod ratio;
mod setup;
mod target;
mod worm_function;

pub use decomposition::{Decomposition, decompose_diagonal, decompose_radial, radial_residual};
pub use dressed::{
    DressedFlank, dress_flank, dresser_of_plan, dresser_profile, dressing_interval, finished_area,
};
pub use error::GeneratingError;
pub use lines::FlankLines;
pub use local_envelope::{LocalEnvelope, kinematic_compliance};
pub use motion::{common_motion, motion_of_flanks};
pub use natural_twist::{NaturalTwist, natural_twist};
pub use plan::{FlankPlan, GrindingPlan, PlanTask};
pub use precompensation::{IdealPlan, PlanningGrid, ProfilePolicy};
pub use quadratic::{
    Gauge, QuadraticDecomposition, QuadraticWorm, constant_only_profile_crowning, decompose_quadratic,
    product_functions,
};
pub use ratio::{Candidate, RatioChoice, RatioReason, lead_correction_ratio};
pub use setup::{DressingLimits, GrindingSetup, ProfilePlace, SetupInput};
pub use target::{ClassFit, FlankTarget};
pub use worm_function::IdealWorm;
