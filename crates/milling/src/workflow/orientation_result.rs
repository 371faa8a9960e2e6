//! The comparison of orientations in a milling job's `result.json`.

use motion::milling::RowSmoothness;
use schemars::JsonSchema;
use serde::Serialize;

/// The rotary motion of the middle row beside that of other systems (`docs/mathematics/milling.md#positions-of-five-axes`).
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OrientationResult {
    /// The machine: that of the job, or a table A-C.
    pub machine: String,
    /// Its rotary axes, the one next to the workpiece first.
    pub axes: [String; 2],
    /// Height parameter of the row.
    pub height: f64,
    /// Share of the face by which the lines of `sheared` are sheared.
    pub shear: f64,
    /// The axis in the column planes, as this plan has it.
    pub column: OrientationFigures,
    /// The axis along the flank's parameter lines.
    pub iso: OrientationFigures,
    /// The axis along lines sheared to and fro.
    pub sheared: OrientationFigures,
}

/// The rotary axes along one row, over the way of the contact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OrientationFigures {
    /// The machine reaches all of it.
    Reached(RotaryFigures),
    /// It does not.
    NotReached {
        /// Why.
        not_reached: String,
    },
}

/// Figures of both rotary axes along a row.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RotaryFigures {
    /// Travel.
    pub travel_deg: [f64; 2],
    /// Largest rate.
    pub max_rate_deg_per_mm: [f64; 2],
    /// Largest second difference.
    pub max_second_deg_per_mm2: [f64; 2],
    /// How often the axes turn back.
    pub reversals: [usize; 2],
    /// Least and greatest lean of the cutter's axis into the feed.
    pub lean_deg: [f64; 2],
    /// Length of the row.
    pub path_mm: f64,
}

impl OrientationFigures {
    /// The figures of a row.
    pub fn new(row: &RowSmoothness) -> Self {
        Self::Reached(RotaryFigures {
            travel_deg: row.rotary.map(|change| change.travel.to_degrees()),
            max_rate_deg_per_mm: row.rotary.map(|change| change.rate.to_degrees()),
            max_second_deg_per_mm2: row.rotary.map(|change| change.second.to_degrees()),
            reversals: row.rotary.map(|change| change.reversals),
            lean_deg: row.lean.map(f64::to_degrees),
            path_mm: row.path,
        })
    }

    /// Why there are none.
    pub fn not_reached(reason: String) -> Self {
        Self::NotReached { not_reached: reason }
    }

    /// The figures, where the machine reaches the row.
    pub fn reached(&self) -> Option<&RotaryFigures> {
        if let Self::Reached(figures) = self { Some(figures) } else { None }
    }
}
