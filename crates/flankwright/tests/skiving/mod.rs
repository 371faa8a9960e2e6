//! Skiving tools: virtual edges under the referee, injected errors found again, every refusal.

mod errors;
mod monte_carlo;
mod recovery;
mod referee;
pub mod samples;
mod wear;
