//! Which correction meets what is asked of the dressed worm: rows, their solution exactly and by compensation, along the worm, and how
//! far they can be met (`docs/mathematics/dressing.md`). Knows no neighbouring body of the dresser.

pub(super) mod along;
pub(super) mod compensation;
pub mod crowning_range;
pub mod path_end;
mod path_reason;
pub mod profile_fit;
mod row_set;
pub mod rows;
pub mod sets;
pub mod solver;
pub mod topological;

pub use along::{
    ConditionsAlong, MOST_COEFFICIENTS, MOST_ROWS, PitchPlace, RowAlong, RowSet, RowsAlong, WidthLaw,
    WishAlong,
};
pub use compensation::{Compensated, Compensation, SoftCondition};
pub use crowning_range::{CrowningEnd, CrowningLimits, CrowningPoint, CrowningRange, CrowningRows};
pub use path_reason::PathReason;
pub use profile_fit::{
    ProfileFit, fit_profile, fit_profile_along, fit_profile_on_path, profile_error, refit_profile,
    uncorrected_profile,
};
pub use row_set::{RowMiss, missed_rows, solve_rows_along, solve_rows_at};
pub use rows::Condition;
pub use sets::{
    PitchPoint, four_points, map_of_upper_end, shift_through, three_points, three_points_with_map,
    two_flank_points, two_points,
};
pub use solver::ConditionSolver;
pub use topological::{
    NodePlan, NodeSolution, pitch_rolls, solve_conditions_along, solve_conditions_at, solve_dressing_motion,
};
