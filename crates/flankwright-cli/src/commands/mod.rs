//! The commands, one a file: arguments and what they print.

mod blank;
pub mod check;
pub mod convert;
pub mod explore;
pub mod gearbox;
pub mod inspect;
mod measured_gear;
pub mod new;
mod outcome;
mod page_language;
pub mod plan;
pub mod program;
pub mod schema;
pub mod serve;
pub mod simulate;
mod statements;
pub mod store;
pub mod verify;
