//! The page of the electronic gearbox: counters, errors beside their bounds, budget, servo, set-ups to choose from. Finished numbers
//! in, a page out.

mod compose;
mod data;

pub use data::{Band, BandPanel, BudgetRow, GearboxReport, ServoReport, SetUpPoint, SetUpReport};
