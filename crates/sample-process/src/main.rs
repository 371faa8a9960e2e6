//! The command `flankwright` with one process more: what a program of your own looks like that brings a process.

use flankwright_sample_process::TipChamfering;
use std::process::ExitCode;

fn main() -> ExitCode {
    if let Err(error) = flankwright::add_process(TipChamfering) {
        eprintln!("{error}");
        return ExitCode::FAILURE;
    }
    flankwright_cli::run()
}
