//! Words that several tables of a job share.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use foundation::geometry::Flank;

/// Hand of a helix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Hand {
    /// Left-hand helix, sign -1.
    Left,
    /// Right-hand helix, sign +1.
    Right,
}

impl Hand {
    /// +1 for right, -1 for left.
    pub fn sign(self) -> f64 {
        match self {
            Hand::Left => -1.0,
            Hand::Right => 1.0,
        }
    }
}

/// Which flanks a step works on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Flanks {
    /// The left flank only.
    Left,
    /// The right flank only.
    Right,
    /// Both flanks at once.
    #[default]
    Both,
}

impl Flanks {
    /// Whether a flank is among them.
    pub fn includes(self, flank: Flank) -> bool {
        match self {
            Self::Both => true,
            Self::Left => flank == Flank::Left,
            Self::Right => flank == Flank::Right,
        }
    }
}
