//! `[output]` of the electronic gearbox.

use job::tables::Language;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What to write beside result and report.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct GearboxOutput {
    /// Language of the report; default English.
    #[serde(skip_serializing_if = "Language::is_default")]
    pub language: Language,
    /// Every pulse as a table.
    pub pulse_trace: bool,
    /// Every change of whole pulses and voltage as a table; with the table `split`.
    pub split_trace: bool,
}
