//! Exit status of the command.

use std::process::ExitCode;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// Done and, where a tolerance is given, met.
    Done,
    /// A fault of the program.
    Internal,
    /// The input is wrong or inconsistent.
    BadInput,
    /// Done, but the target is not met within its tolerance.
    TargetMissed,
    /// Not producible with these bodies.
    NotProducible,
}

impl Exit {
    /// The number that the shell sees.
    pub fn code(self) -> u8 {
        match self {
            Exit::Done => 0,
            Exit::Internal => 1,
            Exit::BadInput => 2,
            Exit::TargetMissed => 3,
            Exit::NotProducible => 4,
        }
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        ExitCode::from(exit.code())
    }
}
