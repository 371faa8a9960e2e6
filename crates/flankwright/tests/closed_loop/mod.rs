//! Inspected flanks as surfaces, what of them is systematic, and the closed loop of settings.

mod correction;
mod dressing;
mod grinding;
mod second_order;
