//! Inspected flanks as surfaces, what of them is systematic, and the closed loop of settings.

mod areal;
mod comparison;
mod correction;
mod dressing;
mod grinding;
mod reconstruction;
mod second_order;
mod systematic;
