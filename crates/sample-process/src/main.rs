//! The command `flankwright` with one process more: what a program of your own looks like that brings a process.

mod process;

use std::process::ExitCode;

fn main() -> ExitCode {
    if let Err(error) = flankwright::add_process(process::TipChamfering) {
        eprintln!("{error}");
        return ExitCode::FAILURE;
    }
    flankwright_cli::run()
}
