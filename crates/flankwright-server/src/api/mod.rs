//! Handlers: they take requests apart, ask others, and put answers together.

pub mod about;
pub mod charts;
pub mod error;
pub mod events;
pub mod examples;
pub mod files;
pub mod jobs;
pub mod kept;
pub mod measurements;
pub mod programs;
pub mod runs;
mod short;
mod take;
mod toml_edits;
