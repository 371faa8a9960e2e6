//! The flanks of `docs/mathematics/milling.md#flanks-as-patches` as surfaces: reference numbers, derivatives, bounds, errors.

mod bevel;
mod bounds;
pub mod cases;
mod derivatives;
mod errors;
mod grid;
mod numbers;
