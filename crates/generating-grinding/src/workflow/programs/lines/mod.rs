//! Programs of a worm that a disc writes line by line, one for each flank: how they are laid out, how their lines are found again in a
//! text, and what the referee's rays make of those.

mod build;
mod find;
mod follow;
mod judge;
mod prove;
mod touch;
mod work;

pub use follow::follow_lines;
pub use prove::{NOT_COVERED, prove_lines};
pub use work::LineWork;
