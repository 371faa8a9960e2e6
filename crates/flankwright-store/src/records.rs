//! What a store holds, as plain data.

use flankwright::geometry::Flank;
use flankwright::workflow::inspection::characteristic_key;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// A measured part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
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

impl PartRecord {
    /// The part without document and characteristics.
    pub fn into_summary(self) -> PartSummary {
        let Self { series, part, drawing, date, machine, source, digest, .. } = self;
        PartSummary { series, part, drawing, date, machine, source, digest }
    }
}

/// One characteristic of a part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
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
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
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
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
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
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
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
}

/// A value of one characteristic on a part.
#[derive(Clone, Debug, PartialEq, Serialize)]
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
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ToolSummary {
    /// The tool.
    pub tool: String,
    /// Number of measurements.
    pub measurements: u64,
}
