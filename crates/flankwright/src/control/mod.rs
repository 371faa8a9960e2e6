//! What a control makes of a motion before it reaches the flank: the error budget of pulse interpolation and the sampled
//! position loop of the workpiece spindle (spec 70). Knows neither processes nor files.

pub mod servo;

mod budget;
mod error;

pub use budget::{BudgetInput, ErrorBound, ErrorBudget};
pub use error::ControlError;
