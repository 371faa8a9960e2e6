//! Messages to the operator of the server, on a standard error that may be closed.

use std::fmt::Display;
use std::io::Write;

/// Says something on standard error, if that is open.
pub fn say(text: impl Display) {
    drop(writeln!(std::io::stderr(), "{text}"));
}
