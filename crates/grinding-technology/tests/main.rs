//! Tests of the technology of generating grinding on two gears: helical with a left-handed worm of three threads, and spur.

mod balance;
mod bodies;
mod errors;
mod optimum;
mod passes;
