//! What a store holds, as plain data.

use flankwright::geometry::Flank;
use flankwright::workflow::inspection::characteristic_key;
use flankwright::workflow::{Status, Task};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::content::PartContent;

/// A measured part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartRecord {
    /// The series whose trend it belongs to, e.g. a drawing or a family of parts.
    pub series: String,
    /// Number or name of the part.
    pub part: String,
    /// Number of the drawing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drawing: Option<String>,
    /// When it was measured, by the clock of the measuring room: `2026-03-14` or `2026-03-14T09:30:00`;
    /// [`flankwright::exchange::inspection::sortable_date`] makes one of what machines write.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub date: Option<String>,
    /// Measuring machine.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub machine: Option<String>,
    /// Name of the file that it came from.
    pub source: String,
    /// SHA-256 of the bytes of that file ([`crate::digest_of`]): the identity of the part.
    pub digest: String,
    /// The evaluated result.
    pub document: Value,
    /// What a series is evaluated from, each characteristic once.
    pub characteristics: Vec<CharacteristicValue>,
}

/// A measured part with what it was measured by, as it goes into the store.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredPart {
    /// What was evaluated.
    pub record: PartRecord,
    /// What it was evaluated from.
    pub content: PartContent,
}

impl MeasuredPart {
    /// What lists show of the part.
    pub fn into_summary(self) -> PartSummary {
        let PartRecord { series, part, drawing, date, machine, source, digest, .. } = self.record;
        PartSummary { series, part, drawing, date, machine, source, digest, has_files: true }
    }
}

/// One characteristic of a part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CharacteristicValue {
    /// Symbol, e.g. `fHa`, `Fp`; of a line beside the middle one with its mark behind a point, e.g. `fHa.o`.
    pub name: String,
    /// Flank, where it is one of a flank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flank: Option<Flank>,
    /// Tooth as the machine counts, where it is one of a tooth.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tooth: Option<u32>,
    /// What was made of single values, e.g. `single`, `mean`, `range`.
    pub statistic: String,
    /// The value, finite.
    pub value: f64,
    /// Its unit, e.g. `um`.
    pub unit: String,
    /// Lower limit, in the same unit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lower_limit: Option<f64>,
    /// Upper limit, in the same unit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upper_limit: Option<f64>,
}

impl CharacteristicValue {
    /// What was measured, without what was found.
    pub fn characteristic(&self) -> Characteristic {
        Characteristic {
            name: self.name.clone(),
            flank: self.flank,
            tooth: self.tooth,
            statistic: self.statistic.clone(),
            unit: self.unit.clone(),
        }
    }
}

/// What is measured: the same on all parts of a series.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
pub struct Characteristic {
    /// Symbol.
    pub name: String,
    /// Flank.
    pub flank: Option<Flank>,
    /// Tooth.
    pub tooth: Option<u32>,
    /// What was made of single values.
    pub statistic: String,
    /// Unit.
    pub unit: String,
}

impl Characteristic {
    /// One word for all of it, e.g. `fHa.left.mean`, `ffb.right.tooth-18.single`, `Fr.single`: the same in every version.
    pub fn key(&self) -> String {
        characteristic_key(&self.name, self.flank, self.tooth, &self.statistic)
    }
}

/// A series and how much there is of it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct SeriesSummary {
    /// The series.
    pub series: String,
    /// Number of parts.
    pub parts: u64,
    /// Date of its first part.
    pub first: Option<String>,
    /// Date of its last part.
    pub last: Option<String>,
}

/// A part without document and characteristics.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct PartSummary {
    /// The series.
    pub series: String,
    /// Number or name of the part.
    pub part: String,
    /// Number of the drawing.
    pub drawing: Option<String>,
    /// When it was measured.
    pub date: Option<String>,
    /// Measuring machine.
    pub machine: Option<String>,
    /// Name of the file.
    pub source: String,
    /// Digest of the file.
    pub digest: String,
    /// Whether its files are in the store, so that more can be made of it: the stock of a blank. Parts of earlier imports have evaluated
    /// values only.
    pub has_files: bool,
}

/// A value of one characteristic on a part.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MeasuredCharacteristic {
    /// Digest of the part's file: its identity.
    pub digest: String,
    /// Number or name of the part.
    pub part: String,
    /// When it was measured.
    pub date: Option<String>,
    /// What was measured.
    #[serde(flatten)]
    pub characteristic: Characteristic,
    /// The value.
    pub value: f64,
    /// Lower limit, in the same unit.
    pub lower_limit: Option<f64>,
    /// Upper limit, in the same unit.
    pub upper_limit: Option<f64>,
}

/// A plan.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanRecord {
    /// Name of the job.
    pub job: String,
    /// SHA-256 of the job's text ([`crate::digest_of`]).
    pub digest: String,
    /// Verdict as the result says it, e.g. `met`.
    pub status: String,
    /// Version of flankwright that planned.
    pub version: String,
    /// The document of `result.json`.
    pub document: Value,
}

/// A plan without its document.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct PlanSummary {
    /// Its number in the store, by which [`crate::Store::plan`] finds it.
    pub id: i64,
    /// Name of the job.
    pub job: String,
    /// SHA-256 of the job's text.
    pub digest: String,
    /// Verdict.
    pub status: String,
    /// Version of flankwright.
    pub version: String,
}

/// A skiving tool and how often it was measured.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ToolSummary {
    /// The tool.
    pub tool: String,
    /// Number of measurements.
    pub measurements: u64,
}

/// The state of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RunState {
    /// Waits for its turn.
    Queued,
    /// Is carried out.
    Running,
    /// Has ended with a result.
    Done,
    /// Has ended with an error.
    Failed,
    /// Was cancelled by the user.
    Cancelled,
    /// Its server ended before it did.
    Interrupted,
}

impl RunState {
    const ALL: [Self; 6] =
        [Self::Queued, Self::Running, Self::Done, Self::Failed, Self::Cancelled, Self::Interrupted];

    /// Stable name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Queued => "queued",
            Self::Running => "running",
            Self::Done => "done",
            Self::Failed => "failed",
            Self::Cancelled => "cancelled",
            Self::Interrupted => "interrupted",
        }
    }

    /// The state of a name.
    pub fn of(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|state| state.name() == name)
    }

    /// Whether nothing more happens to it.
    pub fn has_ended(self) -> bool {
        !matches!(self, Self::Queued | Self::Running)
    }
}

/// A submitted run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NewRun {
    /// The server that carries it out.
    pub owner: String,
    /// What is done.
    pub kind: Task,
    /// Name of the job.
    pub name: String,
    /// What was asked, as the server understands it again.
    pub job: String,
    /// When, RFC 3339.
    pub created: String,
    /// Files that were uploaded with it.
    pub files: Vec<RunFile>,
}

/// How a run has ended.
#[derive(Clone, Debug, PartialEq)]
pub struct RunEnd {
    /// The state.
    pub state: RunState,
    /// When, RFC 3339.
    pub ended: String,
    /// Its result, or its error.
    pub document: Option<Value>,
    /// The files that it has written.
    pub files: Vec<RunFile>,
}

/// A file of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RunFile {
    /// Its name below the directory of the run, with `/`.
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

/// A run in a list.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct RunSummary {
    /// Its number.
    pub id: i64,
    /// What is done.
    pub kind: Task,
    /// Name of the job.
    pub name: String,
    /// The state.
    pub state: RunState,
    /// When it was submitted.
    pub created: String,
    /// When it has ended.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ended: Option<String>,
    /// The verdict of its document.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Status>")]
    pub status: Option<String>,
}

/// A file of a run in a list.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct RunFileSummary {
    /// Its name.
    pub name: String,
    /// Its size.
    pub bytes: u64,
}

/// A run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RunRecord {
    /// What lists show.
    #[serde(flatten)]
    pub summary: RunSummary,
    /// What was asked.
    pub job: String,
    /// Its result, or its error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub document: Option<Value>,
    /// Its files.
    pub files: Vec<RunFileSummary>,
}
