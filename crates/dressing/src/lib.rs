//! Dressing a grinding worm with a disc dresser in line contact (`docs/mathematics/dressing.md`): settings DK -> worm flank, and back.

pub mod axes;
pub mod catalogue;
pub mod characteristics;
pub mod conditions;
pub mod contact_line;
pub mod dresser;
pub mod envelope;
pub mod error;
pub mod forward;
pub mod limits;
pub mod line_dressing;
pub mod nominal;
pub mod other_worms;
pub mod placement;
pub mod strokes;
pub mod tilt_chart;
pub mod worm_form;

pub use axes::{
    AXIS_NAMES, AxisCriterion, AxisReversal, AxisUncertainty, Influence, MachineChoice, MachineMotion,
    MachineRow, MachineTask, MachineWay, MeasuredFlank, Measurement, Quantiles, RecoveredDeviation, Recovery,
    Spread, SpreadOfProfile, Spreads, SwivelChoice, SwivelLaw, WormContact, influence, recover_deviation,
    recover_from_points, spread_of_profile,
};
pub use characteristics::{full_tip_land, quasi_static_modification, stretch};
pub use conditions::{
    Compensated, Compensation, Condition, ConditionSolver, ConditionsAlong, CrowningEnd, CrowningLimits,
    CrowningPoint, CrowningRange, CrowningRows, MOST_COEFFICIENTS, MOST_ROWS, NodePlan, NodeSolution,
    PathReason, PitchPlace, PitchPoint, ProfileFit, RowAlong, RowMiss, RowSet, RowsAlong, SoftCondition,
    WidthLaw, WishAlong, fit_profile, fit_profile_along, fit_profile_on_path, four_points, map_of_upper_end,
    missed_rows, pitch_rolls, profile_error, refit_profile, shift_through, solve_conditions_along,
    solve_conditions_at, solve_dressing_motion, solve_rows_along, solve_rows_at, three_points,
    three_points_with_map, two_flank_points, two_points, uncorrected_profile,
};
pub use contact_line::ContactLine;
pub use dresser::{DresserTool, FlankDresser, GeometricRange};
pub use envelope::{DressedWorm, EnvelopePoint, dressing_motion};
pub use error::DressingError;
pub use forward::{DressedProfile, ProfilePoint, head_gradient};
pub use limits::{Clearance, DresserSection, SectionOutline, SectionPart, ShownWorm, ThreadSpace, WormFlank};
pub use line_dressing::{DressingLine, LineDressing, LinePlan, RelativeForm, TipDisc, Touch};
pub use nominal::{NominalContact, nominal_contact};
pub use other_worms::{StretchAngle, StretchCone, WormSeat, angle_of_least_stretch, cone_without_stretch};
pub use placement::{DresserAxes, RoomContact, WormScrew, touch};
pub use strokes::{
    ActiveArea, DressedStroke, MovingSection, MovingStroke, MultiStroke, ProfileSection, Stroke, StrokeAlong,
    StrokePoint, StrokeSection, StrokeSurface, StrokeWish, StrokedPoint, StrokedWorm, divide, divide_moving,
    solve_stroke_node,
};
pub use tilt_chart::TiltChart;
pub use worm_form::WormForm;
