//! The machine of a job and the dialects that are wanted.

use crate::finding::RunFailure;
use job::machine::{LoadedMachine, read_machine};
use job::tables::Program as DialectName;
use job::{Diagnostic, Document, Problem};

/// The machine that a job names.
///
/// # Errors
/// A finding on `machine.file` with what is wrong in that file.
pub fn machine_of_job(document: &Document, file: &str) -> Result<LoadedMachine, RunFailure> {
    let path = document.source().beside(file);
    read_machine(&path).map_err(|error| {
        let first = error.diagnostics.first();
        let place = first.and_then(|d| d.span.as_ref()).map(|span| error.source.line_column(span.start));
        let at = place.map_or(String::new(), |(line, column)| format!(", line {line}, column {column}"));
        let message = first.map_or_else(|| error.to_string(), |d| d.message.to_string());
        let code = first.map_or(Problem::InvalidMachine.code(), |d| d.code);
        let mut finding =
            Diagnostic::with_code(code, format!("the machine description {file}{at}: {message}"))
                .field("machine.file")
                .value(format!("{file:?}"));
        if let Some(allowed) = first.and_then(|d| d.allowed.clone()) {
            finding = finding.allowed(allowed);
        }
        let way_out = first.and_then(|d| d.way_out.clone());
        RunFailure::bad_input(
            finding.way_out(way_out.unwrap_or_else(|| "correct the machine description".into())),
        )
    })
}

/// The dialects that a job asks for; without a wish, those of the machine.
pub fn dialects(asked: &[DialectName], machine: &LoadedMachine) -> Vec<DialectName> {
    if !asked.is_empty() {
        return asked.to_vec();
    }
    let all = [DialectName::Linuxcnc, DialectName::Siemens, DialectName::Fanuc];
    all.into_iter().filter(|&dialect| machine.file.controls.of(dialect).is_some()).collect()
}
