//! The job format of one process.

use super::any::AnyJob;
use super::document::Document;
use super::job_error::JobError;
use super::process_job::ProcessJob;
use super::typed::typed;
use schemars::{Schema, SchemaGenerator};
use serde_json::Value;
use std::fmt;
use std::fmt::{Debug, Formatter};

/// The job format of one process.
#[derive(Clone, Copy)]
pub struct JobFormat {
    /// Name of the process.
    pub name: &'static str,
    /// What the process does, in one sentence.
    pub about: &'static str,
    /// A runnable job with a comment on every key.
    pub template: &'static str,
    pub(super) tables: fn(&mut SchemaGenerator) -> Schema,
    pub(super) read: fn(Document, &Value, &Value) -> Result<AnyJob, JobError>,
}

impl JobFormat {
    /// The format of a process.
    pub const fn of<J: ProcessJob>() -> Self {
        Self {
            name: J::NAME,
            about: J::ABOUT,
            template: J::TEMPLATE,
            tables: |generator| generator.subschema_for::<J>(),
            read: |document, schema, tables| typed::<J>(document, schema, tables).map(AnyJob::from),
        }
    }
}

impl Debug for JobFormat {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("JobFormat").field("name", &self.name).finish_non_exhaustive()
    }
}
