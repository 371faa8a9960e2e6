//! Coolant of a cutter.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Supplies of coolant that are on while a cutter is in the spindle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CutterCoolant {
    /// None, M9.
    #[default]
    Off,
    /// The first supply, M8.
    Flood,
    /// The second supply, M7: mist, or what the builder of the machine has there, e.g. through the spindle.
    Mist,
    /// Both.
    FloodAndMist,
}

impl CutterCoolant {
    /// Whether the first and the second supply are on.
    pub fn supplies(self) -> [bool; 2] {
        [matches!(self, Self::Flood | Self::FloodAndMist), matches!(self, Self::Mist | Self::FloodAndMist)]
    }

    /// The word in job files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Flood => "flood",
            Self::Mist => "mist",
            Self::FloodAndMist => "flood-and-mist",
        }
    }
}
