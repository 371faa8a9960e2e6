//! Measurements that were uploaded.

use flankwright::workflow::inspection::LeftOutFile;
use flankwright_store::MeasurementReport;
use schemars::JsonSchema;
use serde::Serialize;

/// What the document of a measurement says beside what was measured.
#[derive(Debug, Serialize, JsonSchema)]
pub struct HandedIn {
    /// What became of the parts in the store, where they are kept.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kept: Option<MeasurementReport>,
    /// What was uploaded beside measurements.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub left_out: Vec<LeftOutFile>,
}
