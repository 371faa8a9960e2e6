//! Limits of dressing: clearances against brute sampling of the swept section and against the rays of the referee, the section
//! as a picture shows it, and every refusal. The reference numbers are checked by `verify` (`tests/verify.rs`).

mod clearances;
mod errors;
mod outline;
mod referee;
mod setup;
