//! `flankwright schema`: the schema of the job file, of a catalogue, of a machine description, or of a document that a task writes.

use clap::{Args, ValueEnum};
use flankwright::exchange::catalogue::catalogue_schema;
use flankwright::exchange::machine::machine_schema;
use flankwright::exchange::{Diagnostic, Problem, job_schema};
use flankwright::workflow::{DocumentFormat, documents};
use serde_json::{Value, json};

use crate::common_arguments::CommonArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// What has a schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Subject {
    /// The job file
    Job,
    /// A catalogue of worms and dressers
    Catalogue,
    /// The description of a machine
    Machine,
    /// A document that a task writes, such as result.json
    Result,
}

/// Arguments of `schema`.
#[derive(Args, Debug)]
#[command(
    after_help = "Example:\n  flankwright schema > job.schema.json\n  flankwright schema result five-axis-milling > result.schema.json\n\n\
    Editors use it to complete and check job files. With -o it is written to DIR/job.schema.json (catalogue.schema.json, machine.schema.json)."
)]
pub struct SchemaArguments {
    /// What the schema is of
    #[arg(value_enum, value_name = "SUBJECT", default_value_t = Subject::Job)]
    pub subject: Subject,
    /// Of results: the kind of document; without it all kinds are listed
    #[arg(value_name = "KIND")]
    pub kind: Option<String>,
    /// The same as the subject `catalogue`
    #[arg(long, hide = true)]
    pub catalogue: bool,
    /// The same as the subject `machine`
    #[arg(long, hide = true, conflicts_with = "catalogue")]
    pub machine: bool,
    /// Arguments that every command has.
    #[command(flatten)]
    pub common: CommonArguments,
}

/// Prints the schema, or writes it to the given directory.
///
/// # Errors
/// The output cannot be written.
pub fn run(arguments: &SchemaArguments) -> Result<Exit, Failure> {
    let subject = match (arguments.subject, arguments.catalogue, arguments.machine) {
        (Subject::Job, true, _) => Subject::Catalogue,
        (Subject::Job, _, true) => Subject::Machine,
        (subject, ..) => subject,
    };
    if let Some(kind) = arguments.kind.as_ref().filter(|_| subject != Subject::Result) {
        return Err(unknown_kind(kind, "no kind beside this subject"));
    }
    let (schema, name) = match subject {
        Subject::Job => (job_schema(), "job.schema.json".to_owned()),
        Subject::Catalogue => (catalogue_schema(), "catalogue.schema.json".to_owned()),
        Subject::Machine => (machine_schema(), "machine.schema.json".to_owned()),
        Subject::Result => match &arguments.kind {
            Some(kind) => (of_result(kind)?, format!("{kind}.schema.json")),
            None => return list(&arguments.common),
        },
    };
    let text = output::json_text(&schema)?;
    match &arguments.common.output {
        Some(directory) => output::write_file(&directory.join(name), text.as_bytes())?,
        None => output::print(&text)?,
    }
    Ok(Exit::Done)
}

fn of_result(kind: &str) -> Result<Value, Failure> {
    let documents = documents();
    let found = documents.iter().find(|document| document.kind == kind);
    let names = || documents.iter().map(|document| document.kind).collect::<Vec<_>>().join(", ");
    found.map(DocumentFormat::schema).ok_or_else(|| unknown_kind(kind, &names()))
}

/// The kinds of documents with their files.
fn list(common: &CommonArguments) -> Result<Exit, Failure> {
    if common.json {
        let all: Vec<Value> = documents().iter().map(|d| json!({ "kind": d.kind, "file": d.file })).collect();
        output::print_json(&all)?;
    } else {
        output::print(
            &documents().iter().map(|d| format!("{:<24} {}\n", d.kind, d.file)).collect::<String>(),
        )?;
    }
    Ok(Exit::Done)
}

fn unknown_kind(kind: &str, allowed: &str) -> Failure {
    let finding =
        Diagnostic::new(Problem::UnknownValue, format!("there is no document of the kind `{kind}`"));
    let finding = finding.field("KIND").value(kind).allowed(allowed);
    Failure::new(Exit::BadInput, finding.way_out("`flankwright schema result` lists the kinds"))
}
