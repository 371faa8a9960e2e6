//! Jobs and what follows from them.

use std::collections::BTreeMap;

use flankwright::exchange::catalogue::{DresserEntry, WormEntry};
use flankwright::workflow::{self, DerivedSection, Remark};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use serde_json::value::RawValue;
use utoipa::ToSchema;

use super::Finding;
use crate::openapi::library;

/// A job as a client sends it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Job {
    /// Its text, TOML or JSON.
    pub text: String,
    /// Texts of the files that it names, by their names.
    #[serde(default)]
    pub files: BTreeMap<String, String>,
}

/// The program and its queue.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub struct About {
    /// Version of flankwright.
    pub version: &'static str,
    /// What can be planned.
    pub processes: Vec<ProcessSummary>,
    /// Runs that wait or are under way.
    pub queue: Queue,
}

/// A process.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub struct ProcessSummary {
    /// Its word in a job.
    pub name: &'static str,
    /// Its name for people.
    pub title: &'static str,
}

/// How busy the server is.
#[derive(Clone, Copy, Debug, Serialize, ToSchema)]
pub struct Queue {
    /// Runs under way.
    pub running: usize,
    /// Runs that wait.
    pub waiting: usize,
    /// Runs that may wait.
    pub most: usize,
}

/// An example in the list.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub struct ExampleSummary {
    /// By which it is asked for, e.g. `milling/blisk-blade`.
    pub id: String,
    /// Name of the job.
    pub name: String,
    /// Its process.
    pub process: String,
    /// What it shows.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
}

/// An example.
pub type ExampleAnswer = Job;

/// A commented job to start from.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub struct TemplateAnswer {
    /// Its text.
    pub text: &'static str,
}

/// A machine that jobs may name.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub struct MachineSummary {
    /// As a job names it, e.g. `machines/eight-axis.toml`.
    pub file: String,
    /// Its name.
    pub name: String,
    /// What it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
}

/// What is known of a job before anything is planned.
#[derive(Clone, Debug, Default, Serialize, ToSchema)]
pub struct CheckAnswer {
    /// Whether it can be planned, as far as that is known without planning.
    pub valid: bool,
    /// Its process.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub process: Option<String>,
    /// Its name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// What is wrong with it.
    pub findings: Vec<Finding>,
    /// Findings that were not kept.
    pub omitted: usize,
    /// Remarks.
    #[schema(value_type = Vec<library::Remark>)]
    pub warnings: Vec<Remark>,
    /// The job as JSON, wherever the text can be parsed.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<Object>)]
    pub tree: Option<Value>,
    /// What follows from it.
    #[schema(value_type = Vec<library::DerivedSection>)]
    pub derived: Vec<DerivedSection>,
}

/// A step on the way to an entry.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, ToSchema)]
#[serde(untagged)]
pub enum Step {
    /// Key of a table.
    Key(String),
    /// Place in a list, from 0.
    Place(usize),
}

/// A change of one entry.
#[derive(Clone, Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Edit {
    /// Keys, and places in lists from 0; at most 64.
    #[schema(min_items = 1, max_items = 64)]
    pub path: Vec<Step>,
    /// The new value, at most 256 KiB; null takes the entry out.
    #[schema(value_type = Value)]
    pub value: Box<RawValue>,
}

/// Changes of a text.
#[derive(Clone, Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct EditRequest {
    /// The text of a job.
    pub text: String,
    /// Changes, one after the other; at most 256.
    #[schema(max_items = 256)]
    pub edits: Vec<Edit>,
}

/// The changed text.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub struct EditAnswer {
    /// The text, with the comments and the order that it had.
    pub text: String,
    /// The job as JSON.
    #[schema(value_type = Object)]
    pub tree: Value,
}

/// A plan without its referee is wanted.
#[derive(Clone, Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct PreviewRequest {
    /// The job.
    pub job: Job,
    /// Charts: `target`, `planned`, `deviation`, `sections`, `motions`.
    #[serde(default)]
    pub charts: Vec<String>,
}

/// A plan without its referee.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub struct PreviewAnswer {
    /// The plan.
    #[serde(flatten)]
    #[schema(value_type = library::Preview)]
    pub preview: workflow::Preview,
    /// Charts by name, SVG.
    pub charts: BTreeMap<String, String>,
    /// How long it took.
    pub milliseconds: f64,
}

/// A program to be followed on a machine.
#[derive(Clone, Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct ProgramRequest {
    /// Its text.
    pub text: String,
    /// Its name.
    pub name: String,
    /// A machine of the program, e.g. `machines/eight-axis.toml`, or the name of a file of the job.
    pub machine: String,
    /// The job whose bodies it moves.
    #[serde(default)]
    pub job: Option<Job>,
    /// The HAL netlist of a LinuxCNC program whose gears are in one.
    #[serde(default)]
    pub netlist: Option<String>,
}

/// Worms and dressers of the store.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub struct CatalogueAnswer {
    /// The grinding worms.
    #[schema(value_type = Vec<library::WormEntry>)]
    pub worm: Vec<WormEntry>,
    /// The disc dressers.
    #[schema(value_type = Vec<library::DresserEntry>)]
    pub dresser: Vec<DresserEntry>,
}
