//! A checked job: of a process that the caller knows, or of any.

use super::diagnostic::Diagnostic;
use super::document::Document;
use super::job_error::JobError;
use super::process_job::ProcessJob;
use super::tables::{JobInfo, Language};
use serde_json::Value;
use std::any::Any;
use std::fmt;
use std::path::PathBuf;
use std::sync::Arc;

/// A checked job and the document it came from.
#[derive(Clone, Debug, PartialEq)]
pub struct Loaded<J> {
    /// The job.
    pub job: J,
    /// Text and places, for messages about this job from other layers.
    pub document: Document,
}

impl<J> Loaded<J> {
    /// The path of a file that the job names ([`super::Source::beside`]).
    pub fn beside(&self, file: &str) -> PathBuf {
        self.document.source().beside(file)
    }

    /// An error about this job found by another layer; `diagnostic.field` decides its place.
    pub fn error(&self, diagnostic: Diagnostic) -> JobError {
        self.document.error(diagnostic)
    }
}

/// A checked job of any process; a clone shares it.
#[derive(Clone)]
pub struct AnyJob(Arc<dyn ErasedJob>);

/// What a job of any process has.
trait ErasedJob: Send + Sync {
    fn info(&self) -> &JobInfo;
    fn language(&self) -> Language;
    fn document(&self) -> &Document;
    fn value(&self) -> Result<Value, serde_json::Error>;
    fn pretty(&self) -> Result<String, serde_json::Error>;
    fn typed(&self) -> &dyn Any;
    fn debug(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result;
}

impl<J: ProcessJob> ErasedJob for Loaded<J> {
    fn info(&self) -> &JobInfo {
        self.job.info()
    }

    fn language(&self) -> Language {
        self.job.language()
    }

    fn document(&self) -> &Document {
        &self.document
    }

    fn value(&self) -> Result<Value, serde_json::Error> {
        serde_json::to_value(&self.job)
    }

    fn pretty(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string_pretty(&self.job)
    }

    fn typed(&self) -> &dyn Any {
        self
    }

    fn debug(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&self.job, f)
    }
}

impl<J: ProcessJob> From<Loaded<J>> for AnyJob {
    fn from(loaded: Loaded<J>) -> Self {
        Self(Arc::new(loaded))
    }
}

impl AnyJob {
    /// Name and process.
    pub fn info(&self) -> &JobInfo {
        self.0.info()
    }

    /// Language of its report.
    pub fn language(&self) -> Language {
        self.0.language()
    }

    /// Text and places.
    pub fn document(&self) -> &Document {
        self.0.document()
    }

    /// The job as a document of its file format.
    ///
    /// # Errors
    /// A value that JSON cannot hold.
    pub fn to_value(&self) -> Result<Value, serde_json::Error> {
        self.0.value()
    }

    /// The same as an indented text, keys in the order of the format.
    ///
    /// # Errors
    /// A value that JSON cannot hold.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        self.0.pretty()
    }

    /// The job as one of a process; `None` for one of another process.
    pub fn of<J: ProcessJob>(&self) -> Option<&Loaded<J>> {
        self.0.typed().downcast_ref()
    }

    /// An error about this job found by another layer; `diagnostic.field` decides its place.
    pub fn error(&self, diagnostic: Diagnostic) -> JobError {
        self.document().error(diagnostic)
    }
}

impl fmt::Debug for AnyJob {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.debug(f)
    }
}
