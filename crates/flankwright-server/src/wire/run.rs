//! Runs.

use flankwright::workflow::Task;
use flankwright_store as store;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;

use super::{Failure, InspectOptions, Job};
use crate::openapi::library;

/// A run that is wanted.
#[derive(Clone, Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct NewRunRequest {
    /// What is done.
    #[schema(value_type = library::Task)]
    pub kind: Task,
    /// The job.
    pub job: Job,
}

/// What a run was asked, as the store keeps it. Measurements are files that were uploaded with it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Request {
    /// What is done.
    pub kind: Task,
    /// The job; measurements may go without.
    pub job: Option<Job>,
    /// Of measurements.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub options: Option<InspectOptions>,
}

/// The number of a run that was begun.
#[derive(Clone, Copy, Debug, Serialize, ToSchema)]
pub struct RunBegun {
    /// Its number.
    pub id: i64,
}

/// How far a run is.
#[derive(Clone, Debug, Default, PartialEq, Serialize, ToSchema)]
pub struct Advance {
    /// What is done now.
    pub stage: String,
    /// Steps of it that are done.
    pub done: u64,
    /// Steps of it.
    pub total: u64,
}

/// The state of a run.
#[derive(Clone, Copy, Debug, Serialize, ToSchema)]
pub struct RunStateAnswer {
    /// The state.
    #[schema(value_type = library::RunState)]
    pub state: store::RunState,
}

/// A run in a list.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub struct ListedRun {
    /// Number, kind, name, state, when.
    #[serde(flatten)]
    #[schema(value_type = library::RunSummary)]
    pub summary: store::RunSummary,
    /// How far it is, while it is under way.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub progress: Option<Advance>,
}

/// A file of a result.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub struct RunFile {
    /// Its name, with `/`.
    pub name: String,
    /// Its size.
    pub bytes: u64,
}

/// A chart of a result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
pub struct Chart {
    /// By which it is asked for.
    pub name: String,
    /// What it shows.
    pub title: String,
    /// The section of the report in which it stands.
    pub section: String,
}

/// A run.
#[derive(Clone, Debug, Serialize, ToSchema)]
pub struct Run {
    /// What lists show.
    #[serde(flatten)]
    pub summary: ListedRun,
    /// The job.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub job: Option<Job>,
    /// Names of the uploaded measurements.
    pub measurements: Vec<String>,
    /// The document of the result.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<library::ResultDocument>)]
    pub document: Option<Value>,
    /// Why there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<Failure>,
    /// Files of the result.
    pub files: Vec<RunFile>,
    /// Charts of the result.
    pub charts: Vec<Chart>,
    /// Whether its bodies can be seen in space.
    pub scene: bool,
}
