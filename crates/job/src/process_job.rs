//! What the job of a process is: its keys by its type, its name, its template, its contradictions.

use super::diagnostic::Diagnostic;
use super::document::Document;
use super::tables::{JobInfo, Language};
use schemars::JsonSchema;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Debug;

/// The job of a process. Its type gives keys, types and ranges; the table `[job]` stands in each.
pub trait ProcessJob:
    DeserializeOwned + Serialize + JsonSchema + Clone + Debug + PartialEq + Send + Sync + 'static
{
    /// Name of the process, as in `job.process`: lower-case words and hyphens.
    const NAME: &'static str;
    /// What the process does, in one sentence: for the schema.
    const ABOUT: &'static str;
    /// A runnable job with a comment on every key, for `flankwright new`.
    const TEMPLATE: &'static str;

    /// Name, process and description of the job.
    fn info(&self) -> &JobInfo;

    /// Language of the report.
    fn language(&self) -> Language {
        Language::default()
    }

    /// What the document lacks or names wrongly beyond what a schema can say.
    fn shape(_: &Document) -> Vec<Diagnostic> {
        Vec::new()
    }

    /// Contradictions between entries that are each in range, without places.
    fn contradictions(&self) -> Vec<Diagnostic>;
}
