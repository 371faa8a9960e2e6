//! From a file to a checked machine, by the way that job files go: text, tree, shape, types, contradictions, the machine itself.

use std::path::Path;
use std::sync::LazyLock;

use serde::Deserialize;
use serde_json::Value;

use super::{MachineFile, checks};
use crate::diagnostic::{Diagnostic, Problem};
use crate::document::Document;
use crate::job_error::JobError;
use crate::schema;
use crate::shape::{self, Subject};
use crate::source::Source;
use machine::Machine;

/// A checked machine and the document it came from.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadedMachine {
    /// The description.
    pub file: MachineFile,
    /// What it describes.
    pub machine: Machine,
    /// Text and places.
    pub document: Document,
}

static SCHEMA: LazyLock<Value> = LazyLock::new(|| schema::schema_of::<MachineFile>("flankwright machine"));

/// The schema of a machine file, JSON Schema draft 2020-12.
pub fn machine_schema() -> Value {
    SCHEMA.clone()
}

const SUBJECT: Subject = Subject {
    document: "the machine",
    example: "`machines/` holds complete descriptions; `flankwright schema --machine` lists their keys",
};

/// Reads, parses and checks a machine description (TOML or JSON).
///
/// # Errors
/// All findings of the first stage that has any: text, keys and types and ranges, contradictions, the machine.
pub fn read_machine(path: &Path) -> Result<LoadedMachine, JobError> {
    parse_machine(Source::read(path)?)
}

/// As [`read_machine`], from a text.
///
/// # Errors
/// As [`read_machine`].
pub fn parse_machine(source: Source) -> Result<LoadedMachine, JobError> {
    let document = Document::parse(source)?;
    let refuse = |findings: Vec<Diagnostic>| {
        let placed = |finding: Diagnostic| match (&finding.span, &finding.field) {
            (None, Some(field)) => {
                let span = document.nearest_span(field);
                finding.span(span)
            }
            _ => finding,
        };
        JobError::new(document.source().clone(), findings.into_iter().map(placed).collect())
    };
    let findings = shape::check(document.root(), &SCHEMA, &SCHEMA, SUBJECT);
    if !findings.is_empty() {
        return Err(refuse(findings));
    }
    // The shape check admits what the types take; the error here is the net below it.
    let file = MachineFile::deserialize(document.to_value()).map_err(|error| {
        let message = format!("the machine cannot be read: {error}");
        refuse(vec![Diagnostic::new(Problem::InvalidMachine, message).way_out("compare with `machines/`")])
    })?;
    let findings = checks::check(&file);
    if !findings.is_empty() {
        return Err(refuse(findings));
    }
    let machine = file.machine().map_err(|error| {
        let finding = Diagnostic::new(Problem::InvalidMachine, error.to_string())
            .field(error.field)
            .value(error.problem)
            .allowed(error.allowed)
            .way_out("correct the description");
        refuse(vec![finding])
    })?;
    Ok(LoadedMachine { file, machine, document })
}
