//! 26-machine-chains: descriptions of machines, axis positions to poses and back, strokes, gearbox, influence of axes. Every block sees
//! the file's machines and tolerances.

mod cases;
mod input;
mod solutions;

pub(crate) use cases::{errors, forward, gearbox, influence, machines};
pub(crate) use solutions::{inverse, stroke};
