//! From a file to a checked job: text, tree, process, shape, types, contradictions. The only way to a job from outside, so
//! that a holder of one need not check it again.

use super::any::Loaded;
use super::document::Document;
use super::format::{JobFormats, not_available};
use super::job_error::JobError;
use super::job_format::JobFormat;
use super::node::Kind;
use super::process_job::ProcessJob;
use super::shape;
use super::source::Source;
use super::typed::typed;
use std::any::TypeId;
use std::collections::HashMap;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// Reads, parses and checks a job file of one process (TOML or JSON).
///
/// # Errors
/// All findings of the first stage that has any; `process-not-available` for a job of another process.
pub fn read_job_of<J: ProcessJob>(path: &Path) -> Result<Loaded<J>, JobError> {
    parse_job_of(Source::read(path)?)
}

/// As [`read_job_of`], from a text.
///
/// # Errors
/// As [`read_job_of`].
pub fn parse_job_of<J: ProcessJob>(source: Source) -> Result<Loaded<J>, JobError> {
    let document = Document::parse(source)?;
    let formats = alone::<J>();
    // A word that is nearly the name is left to the check of the shape, which says what it must be.
    if let Some((node, _)) = document.root().follow("job.process")
        && let Kind::Text(name) = &node.kind
        && shape::nearest(name, [J::NAME]).is_none()
    {
        return Err(not_available(&document, name, J::NAME));
    }
    typed(document, formats.schema(), formats.tables(0))
}

/// The format of a process alone, made once.
fn alone<J: ProcessJob>() -> &'static JobFormats {
    static KNOWN: Mutex<Option<HashMap<TypeId, &'static JobFormats>>> = Mutex::new(None);
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    known
        .get_or_insert_default()
        .entry(TypeId::of::<J>())
        .or_insert_with(|| Box::leak(Box::new(JobFormats::new(vec![JobFormat::of::<J>()]))))
}
