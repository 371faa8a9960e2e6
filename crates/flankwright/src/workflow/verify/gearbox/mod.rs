//! 70-gearbox: pulse interpolation, couplings, tables and the servo loop of the electronic gearbox.

mod bresenham;
mod budget;
mod case;
mod chain;
mod coefficients;
mod fingerprint;
mod formula;
mod lead;
mod numbers;
mod positions;
mod pulse_trains;
mod random;
mod rate_multiplier;
mod refusal;
mod reversals;
mod servo;
mod synchroniser;
mod table;
mod train;
mod unevenness;

pub(in super::super) use bresenham::bresenham;
pub(in super::super) use budget::error_budget;
pub(in super::super) use chain::chain;
pub(in super::super) use coefficients::{coefficients, couplings};
pub(in super::super) use lead::ratio_of_lead;
pub(in super::super) use positions::gearbox;
pub(in super::super) use pulse_trains::pulse_trains;
pub(in super::super) use rate_multiplier::rate_multiplier;
pub(in super::super) use reversals::literal_reversal_loss;
pub(in super::super) use servo::servo;
pub(in super::super) use synchroniser::synchroniser;
pub(in super::super) use table::table;

#[cfg(test)]
mod tests;
