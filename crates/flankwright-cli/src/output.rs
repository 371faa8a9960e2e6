//! What goes to standard output and to files.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use flankwright::exchange::job::Process;
use flankwright::exchange::{
    AnyJob, Diagnostic, LoadedJob, Problem, Source, parse_any_job, read_any_job, write_atomically,
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

/// Reads a job file; `-` is standard input.
///
/// # Errors
/// Everything that is wrong with the job.
pub fn load_job(path: &Path) -> Result<LoadedJob, Failure> {
    let job = if path == Path::new("-") {
        let source = Source::read_from("-", io::stdin().lock()).map_err(|error| {
            Failure::new(Exit::BadInput, crate::failure::unreadable("standard input", &error))
        })??;
        parse_any_job(source)?
    } else {
        read_any_job(path)?
    };
    planned(job)
}

/// A job of tangential dressing is read and checked, but not planned.
fn planned(job: AnyJob) -> Result<LoadedJob, Failure> {
    match job {
        AnyJob::Grinding(loaded) => Ok(loaded),
        AnyJob::Tangential(loaded) => {
            let name = loaded.job.job.process.name();
            let message = format!("the job is valid, but the process \"{name}\" is not available yet");
            let finding = Diagnostic::new(Problem::ProcessNotAvailable, message)
                .field("job.process")
                .value(format!("\"{name}\""))
                .allowed(format!("\"{}\"", Process::GeneratingGrinding.name()))
                .way_out("keep the job; this version plans generating grinding only");
            Err(loaded.error(finding).into())
        }
    }
}

/// Where the files of a job go: as told, else `<job name>.out/` beside the job.
pub fn directory(common: &CommonArguments, loaded: &LoadedJob) -> PathBuf {
    common.output.clone().unwrap_or_else(|| loaded.beside(&format!("{}.out", loaded.job.job.name)))
}
