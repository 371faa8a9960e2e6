//! Planning as one best fit (`docs/mathematics/best-fit.md`): a smooth flank near the target that the process can make, and the command
//! that makes it, worm, dresser and motion together.
//!
//! The flank is planned first, the command follows from it through the envelope: edges of the target are rounded as far as tolerance and
//! envelope ask for, and no command folds that need not.

mod bases;
mod bound;
mod envelope;
mod expected;
mod flank;
mod planner;
mod programme;
mod ratios;
mod smoother;
mod within;

pub(super) use expected::Expected;
pub(super) use flank::{Contact, Folds, SomeContacts, Step};
pub(super) use planner::{BestFit, BestFitTask, Contacts};
pub(super) use within::{NEAR, Within};
