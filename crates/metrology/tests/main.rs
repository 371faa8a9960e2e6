//! Traces, surfaces and what of them is systematic.

mod areal;
mod comparison;
mod inspection;
mod reconstruction;
mod systematic;
