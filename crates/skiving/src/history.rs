//! The life of skiving tools as a file of JSON lines, one measurement a line: what was measured when, after how many workpieces. Reads
//! it, checks it, adds to it; fits no trend. The time stands in the measurement, never taken from a clock, so that a run can be repeated.

mod append;
mod line;
mod order;
mod read;
mod time;

pub use append::{append_history, extend_history};
pub use read::{History, parse_history, read_history};
pub(crate) use time::{FORM as MOMENT, is_moment};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::wear::WearPoint;
use foundation::geometry::Flank;

/// One measurement of a tool.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HistoryRecord {
    /// The tool, by any name that is its own.
    #[schemars(length(min = 1, max = 120))]
    pub tool: String,
    /// When it was measured: date and time with zone (RFC 3339), e.g. `2026-03-14T09:30:00Z`.
    #[schemars(length(min = 20, max = 40))]
    pub time: String,
    /// Workpieces cut since the edge was last ground.
    #[schemars(extend("minimum" = 0, "x-way-out" = "count the workpieces since the edge was ground"))]
    pub parts: f64,
    /// How often the tool has been resharpened.
    pub resharpened: u32,
    /// Profiles of both flanks.
    pub flanks: RecordedFlanks,
    /// Pitch.
    pub pitch: RecordedPitch,
    /// How the tool was mounted.
    pub mounting: RecordedMounting,
    /// Edges that left the tolerance band.
    pub out_of_band: Vec<RecordedEdge>,
    /// Version of the program that evaluated the measurement.
    #[schemars(length(min = 1, max = 60))]
    pub version: String,
}

/// Profiles of both flanks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordedFlanks {
    /// Edges that make left flanks of the workpiece.
    pub left: RecordedFlank,
    /// Edges that make right flanks.
    pub right: RecordedFlank,
}

/// Mean profile of all edges of a flank.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordedFlank {
    /// Places x = -1..1 of the tracks.
    #[schemars(length(min = 1, max = 1000), inner(range(min = -1.0, max = 1.0)))]
    pub places: Vec<f64>,
    /// Mean deviation over the teeth at each, um; > 0 is material beyond the nominal edge.
    #[schemars(length(min = 1, max = 1000))]
    pub track_mean_um: Vec<f64>,
    /// Standard deviation of such a mean, um.
    #[schemars(extend("exclusiveMinimum" = 0, "x-way-out" = "give the noise of a mean; 0.05 where it is not known"))]
    pub sigma_um: f64,
}

/// Pitch of the tooth centres.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordedPitch {
    /// F_p, um.
    #[schemars(extend("minimum" = 0))]
    pub total_um: f64,
    /// f_p,max, um.
    #[schemars(extend("minimum" = 0))]
    pub largest_single_um: f64,
}

/// How the tool was mounted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordedMounting {
    /// Eccentricity in x and y of the spindle, um.
    pub eccentricity_um: [f64; 2],
    /// Wobble about x and y of the spindle, urad.
    pub wobble_urad: [f64; 2],
}

/// An edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordedEdge {
    /// Flank of the workpiece that it makes.
    pub flank: Flank,
    /// Its tooth, from 0.
    pub tooth: u32,
}

impl HistoryRecord {
    /// What is recorded of a flank.
    pub fn flank(&self, flank: Flank) -> &RecordedFlank {
        match flank {
            Flank::Left => &self.flanks.left,
            Flank::Right => &self.flanks.right,
        }
    }

    /// The flank's wear for a trend, mm.
    pub fn wear_point(&self, flank: Flank) -> WearPoint {
        let of = self.flank(flank);
        let means: Vec<f64> = of.track_mean_um.iter().map(|um| 1e-3 * um).collect();
        WearPoint::of_track_means(self.parts, &means, 1e-3 * of.sigma_um)
    }
}

#[cfg(test)]
mod tests;
