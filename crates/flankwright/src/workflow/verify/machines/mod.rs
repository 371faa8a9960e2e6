//! 26-machine-chains: descriptions of machines, axis positions to poses and back, strokes, gearbox, influence of axes. Every block sees
//! the file's machines and tolerances.

mod cases;
mod input;
mod solutions;

pub(in super::super) use cases::{errors, forward, gearbox, influence, machines};
pub(in super::super) use solutions::{inverse, stroke};
