//! Skiving tools: virtual edges under the referee, injected errors found again, every refusal.

mod any_beam;
mod broken;
mod chips;
mod errors;
mod monte_carlo;
mod pieces;
mod recovery;
mod referee;
pub mod samples;
mod wear;
