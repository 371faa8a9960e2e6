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

pub(crate) use bresenham::bresenham;
pub(crate) use budget::error_budget;
pub(crate) use chain::chain;
pub(crate) use coefficients::{coefficients, couplings};
pub(crate) use lead::ratio_of_lead;
pub(crate) use positions::gearbox;
pub(crate) use pulse_trains::pulse_trains;
pub(crate) use rate_multiplier::rate_multiplier;
pub(crate) use reversals::literal_reversal_loss;
pub(crate) use servo::servo;
pub(crate) use synchroniser::synchroniser;
pub(crate) use table::table;

#[cfg(test)]
mod tests;
