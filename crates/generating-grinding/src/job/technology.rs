//! `[technology]`: strokes, limits of the shop, times beside grinding, life of the worm, rates.

use super::stroke::StrokeOfJob;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a shop allows and what it costs: with `[stock]` a plan says what each stroke takes, how many parts a dressing lasts, what a part takes
/// and costs.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Technology {
    /// Which strokes a part gets where the job lists none: by a rule of thumb, the fastest or the cheapest, all within the limits. Default "standard" where
    /// `technology.limits.Qw_roughing` and `Qw_finishing` are given and `machine.roughing_stock_um`, `machine.spark_out` and
    /// `grinding.feed_per_revolution` are not.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cycle: Option<CycleRule>,
    /// The strokes in driving order; default those of `cycle`, or of `machine.roughing_stock_um` and `machine.spark_out`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(extend("maxItems" = 40))]
    pub strokes: Vec<StrokeOfJob>,
    /// The shop's own limits; each by itself.
    #[serde(default)]
    pub limits: TechnologyLimits,
    /// Times of a part beside grinding.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub times: Option<PartTimes>,
    /// How the worm is dressed, for the figures of dressing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dressing: Option<DressingOfShop>,
    /// Diameters of the worm over its life.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub life: Option<WormLife>,
    /// The shop's rates.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cost: Option<CostRates>,
    /// Jump of the worm along its axis from one part to the next, mm; default 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = -100, "maximum" = 100, "x-way-out" = "give the jump in mm, or leave it out"))]
    pub step_per_part: Option<f64>,
}

/// How strokes are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum CycleRule {
    /// A quarter of the stock for finishing, the fewest roughing strokes that feed 0.2 mm per revolution, every feed at its limit.
    Standard,
    /// The least time of a part.
    Fastest,
    /// The least cost of a part by `technology.cost`.
    Cheapest,
}

/// Limits that the shop knows from its wheels, its steel and its coolant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case, reason = "Q'_w and V'_w are written with capitals")]
pub struct TechnologyLimits {
    /// Specific removal rate Q'_w of roughing strokes, mm^3/(mm s).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give Q'_w in mm^3/(mm s), e.g. 10"))]
    pub Qw_roughing: Option<f64>,
    /// The same of the strokes that leave nothing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give Q'_w in mm^3/(mm s), e.g. 5"))]
    pub Qw_finishing: Option<f64>,
    /// Specific removed volume V'_w of the worm between two dressings, roughing, mm^3/mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100_000, "x-way-out" = "give V'_w in mm^3/mm, e.g. 1500"))]
    pub Vw_roughing: Option<f64>,
    /// The same of finishing, or of a worm without areas for roughing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100_000, "x-way-out" = "give V'_w in mm^3/mm, e.g. 800"))]
    pub Vw_finishing: Option<f64>,
    /// Width of the worm that is used between two dressings, mm; default `worm.width`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the width in mm"))]
    pub zone_width: Option<f64>,
    /// Height of the feed marks that finishing leaves, um; default 0.5.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100, "x-way-out" = "give the height in um, e.g. 0.5"))]
    pub feed_mark_um: Option<f64>,
    /// Least feed per revolution of the workpiece, mm; default 0.02.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 20, "x-way-out" = "give the feed in mm, e.g. 0.02"))]
    pub least_feed: Option<f64>,
    /// Largest feed per revolution of the workpiece, mm; default 1.2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 20, "x-way-out" = "give the feed in mm, e.g. 1.2"))]
    pub largest_feed: Option<f64>,
    /// Least depth of a finishing stroke, normal, um; default 10.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the depth in um, e.g. 10"))]
    pub least_finishing_um: Option<f64>,
    /// Largest depth of a finishing stroke, normal, um; default 50.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 2000, "x-way-out" = "give the depth in um, e.g. 50"))]
    pub most_finishing_um: Option<f64>,
    /// Most roughing strokes; default 4.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("maximum" = 20, "x-way-out" = "give a number of strokes, e.g. 4"))]
    pub most_roughing_strokes: Option<u32>,
    /// Peripheral speed of the wheel that no stroke and no dressing exceeds, m/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 200, "x-way-out" = "give the speed in m/s, e.g. 63"))]
    pub wheel_speed_m_per_s: Option<f64>,
    /// Speed of the worm's spindle that no stroke and no dressing exceeds, 1/min.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100_000, "x-way-out" = "give the speed in 1/min"))]
    pub worm_speed_rpm: Option<f64>,
    /// Speed of the workpiece's spindle that no stroke exceeds, 1/min.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 100_000, "x-way-out" = "give the speed in 1/min"))]
    pub work_speed_rpm: Option<f64>,
    /// Between the parts of it for roughing and finishing, mm; default 2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("minimum" = 0, "maximum" = 100, "x-way-out" = "give the distance in mm, e.g. 2"))]
    pub zone_gap: Option<f64>,
}

/// Times of a part beside grinding, s.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartTimes {
    /// Loading and unloading.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 10_000, "x-way-out" = "give the time in s"))]
    pub load_s: f64,
    /// Finding the tooth spaces.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 10_000, "x-way-out" = "give the time in s"))]
    pub index_s: f64,
    /// Whatever else there is.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 10_000, "x-way-out" = "give the time in s"))]
    pub other_s: f64,
    /// Beside each dressing.
    #[serde(default)]
    #[schemars(extend("minimum" = 0, "maximum" = 10_000, "x-way-out" = "give the time in s"))]
    pub dressing_aux_s: f64,
}

/// The last dressing stroke; its speeds are `machine.dressing_worm_speed_rpm` and `machine.dresser_speed_rpm`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DressingOfShop {
    /// Taken from the worm's flank by the last dressing stroke, normal, um.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the depth in um, e.g. 10"))]
    pub depth_um: f64,
    /// Whether the dresser runs with the worm at the contact or against it; default "same".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rotation: Option<DressingRotation>,
    /// Overlap that the shop asks for: contact length over the way of the thread per revolution of the dresser; a smaller one is a warning.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the overlap, e.g. 2"))]
    pub least_overlap: Option<f64>,
}

/// How the dresser runs at the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum DressingRotation {
    /// With the worm.
    Same,
    /// Against it.
    Opposite,
}

/// A new worm has `worm.tip_diameter`; each dressing takes a little of it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WormLife {
    /// Least tip diameter, mm.
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the least tip diameter in mm"))]
    pub last_tip_diameter: f64,
    /// Taken from the radius by one dressing, mm.
    #[schemars(extend("minimum" = 0.001, "maximum" = 10, "x-way-out" = "give the amount in mm, e.g. 0.1"))]
    pub radial_per_dressing: f64,
}

/// Rates in the shop's currency.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CostRates {
    /// Machine with its operator, per hour.
    #[schemars(extend("minimum" = 0, "maximum" = 1_000_000, "x-way-out" = "give the rate per hour"))]
    pub machine_per_hour: f64,
    /// A worm.
    #[schemars(extend("minimum" = 0, "maximum" = 10_000_000, "x-way-out" = "give the price"))]
    pub worm_price: f64,
    /// Time to change it, min.
    #[schemars(extend("minimum" = 0, "maximum" = 10_000, "x-way-out" = "give the time in minutes"))]
    pub worm_change_min: f64,
    /// A dresser.
    #[schemars(extend("minimum" = 0, "maximum" = 10_000_000, "x-way-out" = "give the price"))]
    pub dresser_price: f64,
    /// Dressings that it lasts.
    #[schemars(extend("minimum" = 1, "maximum" = 10_000_000, "x-way-out" = "give a number of dressings, e.g. 5000"))]
    pub dressings_per_dresser: u32,
}
