//! `inspect --blank`: the stock of a measured blank, from its file or from the store.

use std::path::Path;

use flankwright::exchange::LoadedJob;
use flankwright::workflow::inspection::{BlankStock, blank_of_content, blank_of_file};
use flankwright::workflow::{JobFailure, TaskOutcome};
use flankwright_store::blocking::Store;
use flankwright_store::{StoreAddress, StoredMeasurement};

use super::measured_gear::{Asked, beside};
use super::outcome::{ROWS, conclude, unwritten};
use super::store::place::failed;
use crate::exit::Exit;
use crate::failure::Failure;

/// Of a file; its table goes into a folder beside it.
///
/// # Errors
/// Everything that is wrong with job and measurement; files that cannot be written.
pub fn of_file(loaded: &LoadedJob, file: &Path, asked: &Asked<'_>) -> Result<Exit, Failure> {
    let found = blank_of_file(loaded, file, &asked.statements);
    deliver(loaded, found, &beside(file), asked)
}

/// Of a part of the store; its table goes into a folder here that is named after its file. What was stated when the part was imported holds,
/// unless something is stated now.
///
/// # Errors
/// As [`of_file`]; a store that cannot be read, no such part, one that was stored without its measurement.
pub fn of_part(
    loaded: &LoadedJob,
    part: &str,
    store: &StoreAddress,
    asked: &Asked<'_>,
) -> Result<Exit, Failure> {
    let store = Store::open_existing(store).map_err(failed)?;
    let StoredMeasurement { part, content } = store.measurement(part).map_err(failed)?;
    let files = store.files_of(&content).map_err(failed)?;
    let statements = if asked.statements.is_empty() { content.statements() } else { &asked.statements };
    let found = blank_of_content(loaded, &files, statements);
    let named = Path::new(&part.source).file_name().unwrap_or("part".as_ref());
    deliver(loaded, found, &beside(Path::new(named)), asked)
}

fn deliver(
    loaded: &LoadedJob,
    found: Result<BlankStock, JobFailure>,
    beside: &Path,
    asked: &Asked<'_>,
) -> Result<Exit, Failure> {
    let found = found.map_err(|failure| Failure::of_job_or_file(&loaded.document, failure))?;
    let written = found.write(asked.common.output.as_deref().unwrap_or(beside)).map_err(unwritten)?;
    conclude(asked.common, &found, ROWS, &written)
}
