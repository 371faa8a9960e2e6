//! The axes that carry the dressing motion: what their deviations do and how they are found again, and the motion on a machine
//! (`docs/mathematics/dressing.md#axes-and-their-deviations`).

pub(super) mod axis_influence;
pub mod deviation;
pub(super) mod deviation_recovery;
pub mod deviation_spread;
pub(super) mod machine_choice;
pub(super) mod machine_motion;

pub use axis_influence::WormContact;
pub use deviation::{AXIS_NAMES, Influence, influence};
pub use deviation_recovery::{
    MeasuredFlank, Measurement, RecoveredDeviation, Recovery, recover_deviation, recover_from_points,
};
pub use deviation_spread::{Quantiles, Spread, SpreadOfProfile, Spreads, spread_of_profile};
pub use machine_choice::{AxisCriterion, MachineChoice, SwivelChoice};
pub use machine_motion::{
    AxisReversal, AxisUncertainty, MachineMotion, MachineRow, MachineTask, MachineWay, SwivelLaw,
};
