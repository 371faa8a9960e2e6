//! `[measuring_grid]`: where a measuring machine touches the flanks of a bevel gear.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Points of each flank in rows from root to tip and columns from toe to heel: `plan` writes them with their normals as
/// `measuring-grid.csv`, `inspect` reads what was measured there. Rows lie on equal steps of the roll, columns on equal steps along the
/// pitch cone.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MeasuringGrid {
    /// Number of rows.
    #[schemars(extend("minimum" = 3, "maximum" = 101, "x-way-out" = "give the number of rows from root to tip; 5 is the default"))]
    pub rows: usize,
    /// Number of columns.
    #[schemars(extend("minimum" = 3, "maximum" = 101, "x-way-out" = "give the number of columns from toe to heel; 9 is the default"))]
    pub columns: usize,
    /// Share of the active flank's height that is left out at the root and at the tip.
    #[schemars(extend("minimum" = 0, "maximum" = 0.4, "x-way-out" = "give a share of the height; 0.1 is the default"))]
    pub profile_margin: f64,
    /// Share of the face width that is left out at toe and heel.
    #[schemars(extend("minimum" = 0, "maximum" = 0.4, "x-way-out" = "give a share of the face width; 0.1 is the default"))]
    pub length_margin: f64,
}

impl Default for MeasuringGrid {
    fn default() -> Self {
        Self { rows: 5, columns: 9, profile_margin: 0.1, length_margin: 0.1 }
    }
}
