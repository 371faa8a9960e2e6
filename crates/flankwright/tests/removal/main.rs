//! The referee against exact solutions, reference numbers and itself.

mod dressing;
mod errors;
mod feed_marks;
mod grinding;
mod setups;
mod threads;
