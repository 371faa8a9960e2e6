//! What goes to standard output and to files.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use flankwright::exchange::job::{JobInfo, Process};
use flankwright::exchange::{
    AnyJob, Diagnostic, GearboxJob, Loaded, LoadedGearboxJob, LoadedJob, Problem, Source, parse_any_job,
    read_any_job, write_atomically,
};
use serde::Serialize;

use crate::arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;

/// Prints a text. A reader that has seen enough (`| head`) is no error.
///
/// # Errors
/// Standard output cannot be written.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::cannot_write("standard output", &error))
        }
        _ => Ok(()),
    }
}

/// Prints one JSON document.
///
/// # Errors
/// As [`print()`]; a value that JSON cannot hold is an internal error.
pub fn print_json(value: &impl Serialize) -> Result<(), Failure> {
    print(&json_text(value)?)
}

/// A JSON document as it is printed and written: indented, with a line end.
///
/// # Errors
/// A value that JSON cannot hold is an internal error.
pub fn json_text(value: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(value)
        .map(|text| text + "\n")
        .map_err(|error| Failure::internal(format!("the result cannot be written as JSON: {error}")))
}

/// Writes a file whole or not at all.
///
/// # Errors
/// The file cannot be written.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    write_atomically(path, bytes).map_err(|error| Failure::cannot_write(&path.display().to_string(), &error))
}

/// Reads a job file of any process; `-` is standard input.
///
/// # Errors
/// Everything that is wrong with the job.
pub fn load_any_job(path: &Path) -> Result<AnyJob, Failure> {
    if path != Path::new("-") {
        return Ok(read_any_job(path)?);
    }
    let source = Source::read_from("-", io::stdin().lock()).map_err(|error| {
        Failure::new(Exit::BadInput, crate::failure::unreadable("standard input", &error))
    })??;
    Ok(parse_any_job(source)?)
}

/// Reads a job file for a command that takes generating grinding only.
///
/// # Errors
/// As [`load_any_job`]; a job of another process.
pub fn load_grinding_job(path: &Path, command: &str) -> Result<LoadedJob, Failure> {
    match load_any_job(path)? {
        AnyJob::Grinding(loaded) => Ok(loaded),
        AnyJob::Tangential(loaded) => {
            let name = loaded.job.job.process.name();
            let message = format!("`{command}` does not take a job of the process \"{name}\"");
            let finding = Diagnostic::new(Problem::ProcessNotAvailable, message)
                .field("job.process")
                .value(format!("\"{name}\""))
                .allowed(format!("\"{}\"", Process::GeneratingGrinding.name()))
                .way_out(
                    "take `flankwright plan`, which compares methods and shows sensitivities in its report",
                );
            Err(loaded.error(finding).into())
        }
        AnyJob::Gearbox(loaded) => Err(gearbox_only(&loaded, command)),
        AnyJob::Milling(loaded) => Err(refused(&loaded, Process::FiveAxisMilling, command)),
        AnyJob::Skiving(loaded) => Err(refused(&loaded, Process::SkivingToolMeasuring, command)),
    }
}

/// What a command that plans or simulates a flank answers to a job of the electronic gearbox.
pub fn gearbox_only(loaded: &LoadedGearboxJob, command: &str) -> Failure {
    loaded.error(GearboxJob::refused_by(command)).into()
}

/// What a command answers to a job of a process that it does not take.
pub fn refused<J>(loaded: &Loaded<J>, process: Process, command: &str) -> Failure {
    loaded.error(process.refused_by(command)).into()
}

/// Where the files of a job go: as told, else `<job name>.out/` beside the job.
pub fn directory<J>(common: &CommonArguments, loaded: &Loaded<J>, job: &JobInfo) -> PathBuf {
    common.output.clone().unwrap_or_else(|| loaded.beside(&format!("{}.out", job.name)))
}
