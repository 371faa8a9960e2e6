//! What is said to whoever runs the server. Nobody may be listening.

use std::fmt::Display;
use std::io::Write;

/// Says something on standard error, if that is open.
pub fn say(text: impl Display) {
    drop(writeln!(std::io::stderr(), "{text}"));
}
