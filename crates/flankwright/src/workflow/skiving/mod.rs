//! Skiving tools from their measurements: what resharpening has to know of them.

mod resharpening;

pub use resharpening::{DecidingEdge, EdgeResharpening, Resharpening, ToothResharpening};
