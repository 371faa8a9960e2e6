//! Measured parts: in by whole sets, out by series.

mod characteristics;
mod import;
mod read;
mod values;
