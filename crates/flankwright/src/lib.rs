//! flankwright plans, simulates and proves the manufacture of gear teeth.
//!
//! The modules are layers, listed from the ground up; a module imports only from modules above it in this
//! list (`tests/layers.rs` enforces it). `removal`, the referee, never imports `contact` or `process`.

pub mod numerics;

pub mod geometry;

pub mod modification;

pub mod kinematics;

pub mod inverse;

pub mod contact;

pub mod removal;

pub mod metrology;

pub mod process;

pub mod exchange;

pub mod report;

pub mod workflow;
