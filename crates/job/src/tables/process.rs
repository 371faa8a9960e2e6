//! `[job]`: name and process, and what the title block of the report says.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt;

/// Name, process and description of a job.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobInfo {
    /// Names the job and its output directory; letters, digits, `-`, `_`, `.` and spaces.
    #[schemars(extend("minLength" = 1, "maxLength" = 100))]
    pub name: String,
    /// What is to be planned.
    pub process: ProcessName,
    /// Free text for the report.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
    /// Number of the part, for the title block of the report.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minLength" = 1, "maxLength" = 100))]
    pub part_number: Option<String>,
    /// Number of the drawing, with its revision.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minLength" = 1, "maxLength" = 100))]
    pub drawing_number: Option<String>,
    /// Customer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minLength" = 1, "maxLength" = 100))]
    pub customer: Option<String>,
    /// The machine in words, where no `machine.file` names it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minLength" = 1, "maxLength" = 100))]
    pub machine_name: Option<String>,
    /// Date of the title block, `YYYY-MM-DD`; without it the report has none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("format" = "date", "x-way-out" = "give the date as year, month and day: \"2026-03-31\""))]
    pub date: Option<String>,
    /// Author of the job.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minLength" = 1, "maxLength" = 100))]
    pub author: Option<String>,
}

impl JobInfo {
    /// A job of which nothing is known but its name and process.
    pub fn named(name: &str, process: ProcessName) -> Self {
        Self {
            name: name.to_owned(),
            process,
            description: None,
            part_number: None,
            drawing_number: None,
            customer: None,
            machine_name: None,
            date: None,
            author: None,
        }
    }
}

/// The name of a process; that there is such a process is checked when a job is read.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct ProcessName(Cow<'static, str>);

impl ProcessName {
    /// The name of a known process.
    pub const fn new(name: &'static str) -> Self {
        Self(Cow::Borrowed(name))
    }

    /// The name.
    pub fn name(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for ProcessName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// The names stand in the schema of all job formats ([`crate::JobFormats`]), which puts them in the place of this one.
impl JsonSchema for ProcessName {
    fn schema_name() -> Cow<'static, str> {
        "Process".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "string" })
    }
}
