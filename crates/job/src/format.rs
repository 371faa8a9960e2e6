//! The job formats of several processes as one: which tables a job has is decided by `job.process`.

use super::any::AnyJob;
use super::diagnostic::{Diagnostic, Problem};
use super::document::Document;
use super::job_error::JobError;
use super::job_format::JobFormat;
use super::node::Kind;
use super::schema::schema_of_jobs;
use super::shape;
use super::source::Source;
use serde_json::Value;
use std::path::Path;

/// The job formats of several processes under one schema.
pub struct JobFormats {
    formats: Vec<JobFormat>,
    schema: Value,
}

impl JobFormats {
    /// Of these processes; the first is taken for a job that names none.
    pub fn new(formats: Vec<JobFormat>) -> Self {
        let schema = schema_of_jobs(&formats);
        Self { formats, schema }
    }

    /// The formats in their order.
    pub fn formats(&self) -> &[JobFormat] {
        &self.formats
    }

    /// The schema of the job file, JSON Schema draft 2020-12: every job has a table `job`, and its process decides which other tables
    /// there are. `x-way-out` beside a range is what messages advise.
    pub fn schema(&self) -> &Value {
        &self.schema
    }

    /// The part of the schema that jobs of the process at `place` have to meet.
    pub fn tables(&self, place: usize) -> &Value {
        &self.schema["allOf"][place]["then"]
    }

    /// The format of a process by its name.
    pub fn format(&self, name: &str) -> Option<&JobFormat> {
        self.formats.iter().find(|format| format.name == name)
    }

    /// Reads, parses and checks a job file (TOML or JSON) of any of the processes.
    ///
    /// # Errors
    /// All findings of the first stage that has any: text, process, keys and types and ranges, contradictions.
    pub fn read(&self, path: &Path) -> Result<AnyJob, JobError> {
        self.parse(Source::read(path)?)
    }

    /// As [`JobFormats::read`], from a text.
    ///
    /// # Errors
    /// As [`JobFormats::read`].
    pub fn parse(&self, source: Source) -> Result<AnyJob, JobError> {
        let document = Document::parse(source)?;
        let place = self.place(&document);
        (self.formats[place].read)(document, &self.schema, self.tables(place))
    }

    /// The process of a job decides which tables it has. A word that is none is left to the check of the shape, by the tables of the
    /// process that is most likely meant.
    pub(super) fn place(&self, document: &Document) -> usize {
        let Some(Kind::Text(name)) = document.root().follow("job.process").map(|(node, _)| &node.kind) else {
            return 0;
        };
        let meant = shape::nearest(name, self.formats.iter().map(|format| format.name));
        self.formats.iter().position(|format| Some(format.name) == meant).unwrap_or(0)
    }
}

/// A job of another process than the one that is wanted.
pub(super) fn not_available(document: &Document, name: &str, wanted: &str) -> JobError {
    let message = format!("a job of the process \"{name}\" is not planned here");
    let mut finding = Diagnostic::new(Problem::ProcessNotAvailable, message)
        .field("job.process")
        .allowed(format!("\"{wanted}\""))
        .way_out("choose one of the available processes");
    if let Some((node, _)) = document.root().follow("job.process") {
        finding = finding.value(node.shown());
    }
    document.error(finding)
}
