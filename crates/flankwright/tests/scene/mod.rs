//! Scenes of runs: every example of a process has one, and what it shows is what was planned: closed bodies on the flanks of their
//! formulas, poses that are rotations, contacts on both bodies at once.

mod bodies;
mod checks;
mod grinding;
mod milling;
mod skiving;
mod tangential;
