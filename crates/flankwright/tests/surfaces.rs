//! The flanks of spec 50 section 1 as surfaces: reference numbers, derivatives, bounds, errors.

#[path = "surfaces/bevel.rs"]
mod bevel;
#[path = "surfaces/bounds.rs"]
mod bounds;
#[path = "surfaces/cases.rs"]
mod cases;
#[path = "surfaces/derivatives.rs"]
mod derivatives;
#[path = "surfaces/errors.rs"]
mod errors;
#[path = "surfaces/grid.rs"]
mod grid;
#[path = "surfaces/numbers.rs"]
mod numbers;
