//! From files to a checked catalogue, by the way that job files go: text, tree, shape, types, contradictions.

use std::path::Path;
use std::sync::LazyLock;

use serde::Deserialize;
use serde_json::{Value, json};

use super::{Catalogue, checks, table};
use crate::job::LoadedJob;
use job::shape::{self, Subject};
use job::{Diagnostic, Document, JobError, Problem, Source, schema_of};

/// A checked catalogue and the documents it came from: one, or one each for worms and dressers.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadedCatalogue {
    /// The bodies.
    pub catalogue: Catalogue,
    /// Texts and places.
    pub documents: Vec<Document>,
}

static SCHEMA: LazyLock<Value> = LazyLock::new(|| schema_of::<Catalogue>("flankwright catalogue"));

/// The schema of a catalogue file, JSON Schema draft 2020-12.
pub fn catalogue_schema() -> Value {
    SCHEMA.clone()
}

const SUBJECT: Subject = Subject {
    document: "the catalogue",
    example: "a catalogue has entries `[[worm]]` and `[[dresser]]`; `flankwright schema --catalogue` lists their keys",
};

/// Reads, parses and checks a catalogue (TOML or JSON).
///
/// # Errors
/// All findings of the first stage that has any: text, keys and types and ranges, contradictions.
pub fn read_catalogue(path: &Path) -> Result<LoadedCatalogue, JobError> {
    parse_catalogue(Source::read(path)?)
}

/// As [`read_catalogue`], from a text.
///
/// # Errors
/// As [`read_catalogue`].
pub fn parse_catalogue(source: Source) -> Result<LoadedCatalogue, JobError> {
    let document = Document::parse(source)?;
    let findings = shape::check(document.root(), &SCHEMA, &SCHEMA, SUBJECT);
    refuse_if_any(&document, findings)?;
    checked(document.to_value(), vec![document])
}

/// Reads and checks a catalogue of two tables (CSV): worms and dressers.
///
/// # Errors
/// As [`read_catalogue`]; `invalid-table` for text that is no table.
pub fn read_catalogue_tables(worms: &Path, dressers: &Path) -> Result<LoadedCatalogue, JobError> {
    parse_catalogue_tables(Source::read(worms)?, Source::read(dressers)?)
}

/// As [`read_catalogue_tables`], from texts.
///
/// # Errors
/// As [`read_catalogue_tables`].
pub fn parse_catalogue_tables(worms: Source, dressers: Source) -> Result<LoadedCatalogue, JobError> {
    let worms = table_document(worms, "worm")?;
    let dressers = table_document(dressers, "dresser")?;
    let list = |document: &Document, key: &str| document.to_value()[key].clone();
    let value = json!({ "worm": list(&worms, "worm"), "dresser": list(&dressers, "dresser") });
    checked(value, vec![worms, dressers])
}

/// The catalogue that a job names; `None` for a job with fixed bodies.
///
/// # Errors
/// As [`read_catalogue`]; places are those of the catalogue's own files.
pub fn catalogue_of_job(loaded: &LoadedJob) -> Result<Option<LoadedCatalogue>, JobError> {
    let Some(source) = &loaded.job.catalogue else { return Ok(None) };
    match (&source.file, &source.worms_csv, &source.dressers_csv) {
        (Some(file), ..) => read_catalogue(&loaded.beside(file)).map(Some),
        (None, Some(worms), Some(dressers)) => {
            read_catalogue_tables(&loaded.beside(worms), &loaded.beside(dressers)).map(Some)
        }
        // A job that was read names one or the other.
        _ => {
            let finding = Diagnostic::new(Problem::MissingKey, "`catalogue` names no file")
                .field("catalogue.file")
                .way_out("add `file = \"...\"`");
            Err(loaded.error(finding))
        }
    }
}

/// One table, its cells checked.
fn table_document(source: Source, list: &str) -> Result<Document, JobError> {
    let document = Document::parse_with(source, |text| table::parse(text, list))?;
    // The table holds one of the two lists.
    let mut schema = SCHEMA.clone();
    schema["required"] = json!([list]);
    let findings = shape::check(document.root(), &schema, &schema, SUBJECT);
    refuse_if_any(&document, findings)?;
    Ok(document)
}

fn refuse_if_any(document: &Document, findings: Vec<Diagnostic>) -> Result<(), JobError> {
    if findings.is_empty() { Ok(()) } else { Err(JobError::new(document.source().clone(), findings)) }
}

/// The typed catalogue without contradictions.
fn checked(value: Value, documents: Vec<Document>) -> Result<LoadedCatalogue, JobError> {
    let catalogue = match Catalogue::deserialize(value) {
        Ok(catalogue) => catalogue,
        // The shape check admits what the types take; this is the net below it.
        Err(error) => {
            let finding =
                Diagnostic::new(Problem::InvalidCatalogue, format!("the catalogue cannot be read: {error}"))
                    .way_out("compare with the examples of catalogues");
            return Err(JobError::single(documents[0].source().clone(), finding));
        }
    };
    let findings = checks::check(&catalogue);
    for document in &documents {
        let own = |finding: &&Diagnostic| {
            let list = finding.field.as_deref().and_then(|f| f.split('[').next()).unwrap_or_default();
            document.span_of(list).is_some()
        };
        let placed: Vec<Diagnostic> = findings
            .iter()
            .filter(own)
            .map(|finding| {
                let span = finding.field.as_deref().and_then(|field| document.nearest_span(field));
                finding.clone().span(span)
            })
            .collect();
        refuse_if_any(document, placed)?;
    }
    Ok(LoadedCatalogue { catalogue, documents })
}
