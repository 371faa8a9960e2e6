//! What goes to standard output and to files.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use flankwright::exchange::job::JobInfo;
use flankwright::exchange::{
    AnyJob, Diagnostic, Document, LoadedJob, Source, parse_any_job, read_any_job, write_atomically,
};
use flankwright::processes;
use serde::Serialize;

use crate::common_arguments::CommonArguments;
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
pub fn print_json(value: &(impl Serialize + ?Sized)) -> Result<(), Failure> {
    print(&json_text(value)?)
}

/// A JSON document as it is printed and written: indented, with a line end.
///
/// # Errors
/// A value that JSON cannot hold is an internal error.
pub fn json_text(value: &(impl Serialize + ?Sized)) -> Result<String, Failure> {
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
    let job = load_any_job(path)?;
    job.of().cloned().ok_or_else(|| refused(&job, command))
}

/// What a command answers to a job of a process that it does not take.
pub fn refused(job: &AnyJob, command: &str) -> Failure {
    job.error(processes().refused(command, job)).into()
}

/// Where the files of a job go: the given directory, else `<job name>.out/` beside the job. A job that lies in such a folder itself, as
/// `settings.json` does, has its own beside it: `<job name>.settings.out/`.
pub fn directory(common: &CommonArguments, document: &Document, job: &JobInfo) -> PathBuf {
    let beside = || {
        let own = document.source().beside(&format!("{}.out", job.name));
        let (Some(folder), Some(stem)) = (own.parent(), Path::new(document.source().name()).file_stem())
        else {
            return own;
        };
        if folder.file_name() != own.file_name() {
            return own;
        }
        folder.with_file_name(format!("{}.{}.out", job.name, stem.display()))
    };
    common.output.clone().unwrap_or_else(beside)
}

/// In a folder that no `-o` chose: the name of the job file whose results lie there.
const OWNER: &str = ".job";

/// As [`directory`], unless the results of another job file that is still there would be lost.
///
/// # Errors
/// Two job files of one name, without `-o`.
pub fn own_directory(
    common: &CommonArguments,
    document: &Document,
    job: &JobInfo,
) -> Result<PathBuf, Failure> {
    let directory = directory(common, document, job);
    if common.output.is_some() {
        return Ok(directory);
    }
    let (own, owner) =
        (owner_name(document), std::fs::read_to_string(directory.join(OWNER)).unwrap_or_default());
    let owner = owner.trim();
    if owner.is_empty() || own.as_deref() == Some(owner) || !directory.with_file_name(owner).is_file() {
        return Ok(directory);
    }
    let message = format!("{} holds the results of {owner}, a job of the same name", directory.display());
    let finding = Diagnostic::with_code("folder-of-another-job", message)
        .field("job.name")
        .value(format!("\"{}\"", job.name))
        .allowed("a name of its own for each job file of a folder")
        .way_out("change job.name, or say with `-o DIR` where the files shall go");
    Err(document.error(finding).into())
}

/// Notes in a folder that no `-o` chose whose results it holds.
///
/// # Errors
/// The folder cannot be written.
pub fn note_owner(common: &CommonArguments, document: &Document, directory: &Path) -> Result<(), Failure> {
    match owner_name(document) {
        Some(name) if common.output.is_none() => {
            write_file(&directory.join(OWNER), format!("{name}\n").as_bytes())
        }
        _ => Ok(()),
    }
}

/// The job file by its name; none for standard input.
fn owner_name(document: &Document) -> Option<String> {
    let name = document.source().name();
    let file = Path::new(name).file_name().filter(|_| name != "-")?;
    file.to_str().map(str::to_owned)
}
