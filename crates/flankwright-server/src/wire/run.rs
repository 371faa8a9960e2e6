//! Runs.

use flankwright::exchange::inspection::{DatumFace, SlopeReference};
use flankwright::geometry::Sides;
use flankwright::workflow::Task;
use flankwright::workflow::inspection::{SheetOptions, Statements};
use flankwright_store as store;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use utoipa::ToSchema;

use super::{Failure, Job};
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

/// Signs of helix slopes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Signs {
    /// +1 or -1.
    pub left: i8,
    /// +1 or -1.
    pub right: i8,
}

/// What the files of a measurement do not tell, and how its sheets look.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(deny_unknown_fields, default)]
pub struct InspectOptions {
    /// Class of ISO 1328-1 whose tolerances are the limits, 1 to 11.
    pub class: Option<i32>,
    /// Helix traces with the top of the measuring machine upwards.
    pub top_up: bool,
    /// The gear was measured from the other end.
    pub from_other_end: bool,
    /// Signs of helix slopes as the file names the flanks.
    pub slope_signs: Option<Signs>,
    /// `+z` or `-z`.
    pub datum_face: Option<String>,
    /// `face-width` or `range`.
    pub helix_slope_over: Option<String>,
    /// `face-width` or `range`.
    pub profile_slope_over: Option<String>,
    /// Puts the parts into the store.
    pub keep: bool,
    /// Their series there.
    pub series: Option<String>,
}

impl InspectOptions {
    /// As the workflow takes them.
    ///
    /// # Errors
    /// What is wrong: the key and what it takes.
    pub fn taken(&self) -> Result<(SheetOptions, Statements), (&'static str, &'static str)> {
        if self.class.is_some_and(|class| !(1..=11).contains(&class)) {
            return Err(("class", "1 to 11"));
        }
        if self.series.as_ref().is_some_and(|series| series.chars().any(char::is_control)) {
            return Err(("series", "a name without control characters"));
        }
        let over = |key, of: &Option<String>| match of.as_deref() {
            None => Ok(None),
            Some("face-width") => Ok(Some(SlopeReference::FaceWidth)),
            Some("range") => Ok(Some(SlopeReference::Range)),
            Some(_) => Err((key, "\"face-width\" or \"range\"")),
        };
        let datum_face = match self.datum_face.as_deref() {
            None => None,
            Some("+z") => Some(DatumFace::PlusZ),
            Some("-z") => Some(DatumFace::MinusZ),
            Some(_) => return Err(("datum_face", "\"+z\" or \"-z\"")),
        };
        let slope_signs = match self.slope_signs {
            Some(Signs { left: -1 | 1, right: -1 | 1 }) | None => self
                .slope_signs
                .map(|signs| Sides { left: f64::from(signs.left), right: f64::from(signs.right) }),
            Some(_) => return Err(("slope_signs", "1 or -1 for each flank")),
        };
        let statements = Statements {
            other_end: self.from_other_end,
            slope_signs,
            datum_face,
            helix_slope_over: over("helix_slope_over", &self.helix_slope_over)?,
            profile_slope_over: over("profile_slope_over", &self.profile_slope_over)?,
        };
        let sheet =
            SheetOptions { tolerance_class: self.class, top_up: self.top_up, ..SheetOptions::default() };
        Ok((sheet, statements))
    }
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
