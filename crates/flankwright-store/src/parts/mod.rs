//! Measured parts: in by whole sets, out by series.

mod import;
mod read;
mod values;
