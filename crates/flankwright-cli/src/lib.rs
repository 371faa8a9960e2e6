//! The command `flankwright`: arguments, messages, progress and exit status around the library. Computes nothing.

pub mod arguments;
pub mod commands;
pub mod common_arguments;
pub mod exit;
pub mod failure;
pub mod output;
pub mod panics;
pub mod progress;

use std::ffi::OsString;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

use clap::Parser;
use flankwright::exchange::Diagnostic;

use arguments::{Arguments, Command};
use exit::Exit;
use failure::Failure;

/// Runs the command line of this process.
pub fn run() -> ExitCode {
    let arguments: Vec<OsString> = std::env::args_os().collect();
    panics::report_briefly();
    let parsed = match Arguments::try_parse_from(&arguments) {
        Ok(parsed) => parsed,
        Err(error) => return usage(&error, &arguments),
    };
    let json = parsed.command.common().json;
    let outcome = survived(|| match &parsed.command {
        Command::New(arguments) => commands::new::run(arguments),
        Command::Schema(arguments) => commands::schema::run(arguments),
        Command::Check(arguments) => commands::check::run(arguments),
        Command::Plan(arguments) => commands::plan::run(arguments),
        Command::Simulate(arguments) => commands::simulate::run(arguments),
        Command::Explore(arguments) => commands::explore::run(arguments),
        Command::Inspect(arguments) => commands::inspect::run(arguments),
        Command::Convert(arguments) => commands::convert::run(arguments),
        Command::Gearbox(arguments) => commands::gearbox::run(arguments),
        Command::Program(arguments) => commands::program::run(arguments),
        Command::Store(arguments) => commands::store::run(arguments),
        Command::Serve(arguments) => commands::serve::run(arguments),
        Command::Verify(arguments) => commands::verify::run(arguments),
    });
    match outcome {
        Ok(exit) => exit.into(),
        Err(failure) => {
            failure.tell(json);
            failure.exit.into()
        }
    }
}

/// The outcome of a command, a panic made into a failure. The hook has printed where; what is left is the exit status
/// and, for programs, the JSON answer.
fn survived(command: impl FnOnce() -> Result<Exit, Failure>) -> Result<Exit, Failure> {
    catch_unwind(AssertUnwindSafe(command)).unwrap_or_else(|_| Err(Failure::panicked()))
}

/// Help and version go to standard output; a wrong command line is bad input.
fn usage(error: &clap::Error, arguments: &[OsString]) -> ExitCode {
    if error.use_stderr() && arguments.iter().any(|a| a == "--json") {
        let text = error.to_string();
        let (message, rest) = text.split_once("\n\n").unwrap_or((&text, ""));
        let finding =
            Diagnostic::with_code("usage", message.trim_start_matches("error: ")).way_out(rest.trim());
        Failure::new(Exit::BadInput, finding).tell(true);
        return Exit::BadInput.into();
    }
    // Nothing is left to do if even this cannot be printed.
    let _ = error.print();
    if error.use_stderr() { Exit::BadInput.into() } else { Exit::Done.into() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_an_internal_error() {
        let failure = survived(|| panic!("on purpose")).unwrap_err();
        assert_eq!(failure.exit.code(), 1);
        assert_eq!(failure.to_json()["error"]["code"], "internal-error");
        assert_eq!(survived(|| Ok(Exit::TargetMissed)).map(Exit::code), Ok(3));
    }
}
