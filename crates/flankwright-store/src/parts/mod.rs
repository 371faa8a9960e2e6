//! Measured parts: in by whole sets, out by series.

mod characteristics;
mod content;
mod import;
mod named;
mod read;
mod rows;
mod values;

pub use named::{SHORTEST_DIGEST, StoredMeasurement};
