//! The flanks of spec 50 section 1 as surfaces: reference numbers, derivatives, bounds, errors.

mod bevel;
mod bounds;
pub mod cases;
mod derivatives;
mod errors;
mod grid;
mod numbers;
