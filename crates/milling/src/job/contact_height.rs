//! `milling.contact_height`: where the straight side of the cutter touches, which spreads its wear
//! (`docs/mathematics/milling.md#cutter-location`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Heights of the contact above the tip, mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum ContactHeight {
    /// The same in all rows.
    Fixed(
        #[schemars(extend("minimum" = 0, "maximum" = 2000,
            "x-way-out" = "give a height between the corner radius and the cutting length in mm"))]
        f64,
    ),
    /// One for each row, from the root on.
    // Before the ramp: two numbers in a list would be read as its two keys.
    Rows(#[schemars(length(min = 1, max = 20_000), inner(range(min = 0, max = 2000)))] Vec<f64>),
    /// From the row at the root to that at the tip, linear in the number of the row.
    Ramp(HeightRamp),
}

/// Heights at the first and the last row.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeightRamp {
    /// At the root.
    #[schemars(extend("minimum" = 0, "maximum" = 2000,
        "x-way-out" = "give a height between the corner radius and the cutting length in mm"))]
    pub from: f64,
    /// At the tip.
    #[schemars(extend("minimum" = 0, "maximum" = 2000,
        "x-way-out" = "give a height between the corner radius and the cutting length in mm"))]
    pub to: f64,
}

impl ContactHeight {
    /// The heights given, each with its key below `milling.contact_height`.
    pub(super) fn given(&self) -> Vec<(String, f64)> {
        match self {
            Self::Fixed(height) => vec![(String::new(), *height)],
            Self::Ramp(ramp) => vec![(".from".to_owned(), ramp.from), (".to".to_owned(), ramp.to)],
            Self::Rows(heights) => {
                heights.iter().enumerate().map(|(row, height)| (format!("[{row}]"), *height)).collect()
            }
        }
    }
}
