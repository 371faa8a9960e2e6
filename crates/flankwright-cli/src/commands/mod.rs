//! The commands, one a file: arguments and what they print.

mod catalogue;
pub mod check;
pub mod convert;
pub mod explore;
pub mod gearbox;
pub mod inspect;
mod measured_gear;
mod milling;
pub mod new;
mod outcome;
pub mod plan;
pub mod program;
pub mod schema;
pub mod serve;
pub mod simulate;
mod skiving;
mod statements;
pub mod store;
mod tangential;
pub mod verify;
