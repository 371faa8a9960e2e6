//! What `result.json` says of stock, removal, worm, time and cost.

use super::offers::CycleOffers;
use foundation::geometry::Sides;
use grinding_technology::{Optimum, OptimumRow};
use schemars::JsonSchema;
use serde::Serialize;

/// Stock, strokes, load of the worm, time and cost of a run.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RemovalResult {
    /// Before the first stroke.
    pub stock: StockResult,
    /// In driving order.
    pub strokes: Vec<StrokeResult>,
    /// Cycles within the limits; absent without `technology.limits.Qw_roughing` and `Qw_finishing`, and where none keeps them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycles: Option<CyclesResult>,
    /// The last dressing stroke; absent without `technology.dressing`, and for a worm that is not dressed by a disc in line contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dressing: Option<DressingFiguresResult>,
    /// The worm's load; absent without `technology.limits.Vw_finishing`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub worm_load: Option<WormLoadResult>,
    /// The worm over its life; absent without `technology.life`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub worm_life: Option<WormLifeResult>,
    /// Time of a part; absent without programs or without `technology.times`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part_time: Option<PartTimeResult>,
    /// Cost of a part in the shop's currency; absent without its time or without `technology.cost`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost_per_part: Option<CostResult>,
    /// Figures over the shop's limits. A share above 1 says harder than what the shop calls safe, no more.
    pub indicators: Vec<IndicatorResult>,
}

/// Stock of all tooth spaces.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StockResult {
    /// All of it.
    pub volume_mm3: f64,
    /// Largest on each flank, normal.
    pub largest_um: Sides<f64>,
    /// Least on each flank, normal; 0 or less where material is missing.
    pub least_um: Sides<f64>,
}

/// How much of a limit is used.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LimitShare {
    /// Key of the limit.
    pub limit: &'static str,
    /// Figure over limit; of feed marks the feed over the one that they allow.
    pub share: f64,
}

/// Cycles within the limits, for the largest stock on both flanks.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CyclesResult {
    /// The stock that they are made for.
    pub stock_um: f64,
    /// Whether the limits of the machine's axes are in the times.
    pub on_machine: bool,
    /// Whether the share of dressing is in the times.
    pub with_dressing: bool,
    /// By the rule of thumb.
    pub standard: CycleResult,
    /// The fastest.
    pub fastest: CycleResult,
    /// The cheapest; absent without `technology.cost`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cheapest: Option<CycleResult>,
    /// The fastest for each number of roughing strokes from 0; absent where none keeps the limits.
    pub by_roughing_strokes: Vec<Option<CycleResult>>,
    /// The fastest with both limits of Q'_w multiplied by a factor.
    pub by_load: Vec<CycleResult>,
}

/// Roughing strokes of equal depth and one finishing stroke.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct CycleResult {
    /// Factor on both limits of Q'_w.
    pub limit_factor: f64,
    /// Roughing strokes.
    pub roughing_strokes: usize,
    /// Depth of the finishing stroke.
    pub finishing_um: f64,
    /// Feed per revolution of the workpiece of roughing, 0 without, and of finishing.
    pub feed_per_revolution_mm: [f64; 2],
    /// Largest Q'_w of roughing, 0 without, and of finishing.
    pub specific_rate_mm3_per_mm_s: [f64; 2],
    /// Height of the feed marks of finishing.
    pub feed_mark_um: f64,
    /// Time of a part.
    pub part_s: f64,
    /// Parts between two dressings if the width is used at its best; absent where the job does not bound the worm's load.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parts_per_dressing: Option<f64>,
    /// Cost of a part if the width is used at its best; absent without `technology.cost`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost_per_part: Option<f64>,
}

impl CyclesResult {
    /// Of cycles within the limits.
    pub(super) fn of(offers: &CycleOffers) -> Self {
        let row = |row: &OptimumRow| {
            let cycle = row.cycle?;
            Some(CycleResult {
                limit_factor: row.limit_factor,
                roughing_strokes: row.roughing_strokes,
                finishing_um: 1e3 * cycle.finishing,
                feed_per_revolution_mm: cycle.feeds,
                specific_rate_mm3_per_mm_s: cycle.rates,
                feed_mark_um: 1e3 * cycle.feed_mark,
                part_s: cycle.time,
                parts_per_dressing: offers.with_dressing.then_some(cycle.parts),
                cost_per_part: offers.cost.map(|cost| cost.per_part(cycle.time, cycle.parts)),
            })
        };
        let Optimum { best, cheapest, standard, by_roughing_strokes, pareto } = &offers.optimum;
        let fastest = row(best).unwrap_or_default();
        Self {
            stock_um: 1e3 * offers.stock,
            on_machine: offers.on_machine,
            with_dressing: offers.with_dressing,
            standard: row(standard).unwrap_or(fastest),
            fastest,
            cheapest: cheapest.as_ref().and_then(row),
            by_roughing_strokes: by_roughing_strokes.iter().map(row).collect(),
            by_load: pareto.iter().filter_map(row).collect(),
        }
    }
}

/// One stroke.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StrokeResult {
    /// "roughing", "finishing" or "spark-out", which takes nothing.
    pub stage: &'static str,
    /// Stock that it leaves on each flank, normal; null for a flank that it does not grind.
    pub left_um: Sides<Option<f64>>,
    /// Of the worm's tip.
    pub cutting_speed_m_per_s: f64,
    /// Feed per revolution of the workpiece.
    pub feed_per_revolution_mm: f64,
    /// "up" for a feed z_V2 that rises, "down".
    pub direction: &'static str,
    /// Area of the worm: "all", "roughing" or "finishing".
    pub zone: String,
    /// Pause after it.
    pub dwell_s: f64,
    /// Largest height of the feed marks.
    pub feed_mark_um: f64,
    /// The limit that it comes nearest to; absent where it takes nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nearest_limit: Option<LimitShare>,
    /// Diagonal ratio; from end to end of the contact where it varies.
    pub diagonal_ratio: f64,
    /// Added to the centre distance.
    pub infeed_um: f64,
    /// Worm.
    pub worm_speed_rpm: f64,
    /// Workpiece.
    pub work_speed_rpm: f64,
    /// Axial feed.
    pub feed_mm_per_s: f64,
    /// "climb" or "conventional".
    pub sense: &'static str,
    /// Feed z_V2 of the first and of the last contact.
    pub contact_mm: [f64; 2],
    /// Way before the contact lines on which stock is ground already.
    pub approach_mm: f64,
    /// Way from the first to the last contact with the overrun at both ends.
    pub travel_mm: f64,
    /// What it takes.
    pub volume_mm3: f64,
    /// Largest removal rate.
    pub largest_rate_mm3_per_s: f64,
    /// Place on the worm for the first part.
    pub worm_mm: [f64; 2],
    /// Times from the first contact on.
    pub time_s: Vec<f64>,
    /// Removal rate at these times.
    pub rate_mm3_per_s: Vec<f64>,
    /// Each flank that it grinds; null for the other.
    pub flanks: Sides<Option<FlankRemovalResult>>,
    /// Q'_w over flank and feed; absent where the stroke takes nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate_map: Option<RateMapResult>,
}

/// Q'_w over flank and feed, the largest over the tooth spaces.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RateMapResult {
    /// Feeds z_V2, rising.
    pub feed_mm: Vec<f64>,
    /// Each flank that the stroke grinds; null for the other.
    pub flanks: Sides<Option<FlankRateResult>>,
}

/// Q'_w on one flank.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FlankRateResult {
    /// Diameters of the places along the profile, rising.
    pub diameter_mm: Vec<f64>,
    /// Q'_w: for each diameter its values over the feed.
    pub specific_rate_mm3_per_mm_s: Vec<Vec<f64>>,
}

/// How the worm is dressed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DressingFiguresResult {
    /// Strokes of a flank.
    pub strokes: usize,
    /// 1 or 2.
    pub flanks_at_a_time: usize,
    /// Taken from the flank by the last stroke, normal.
    pub depth_um: f64,
    /// Worm.
    pub worm_speed_rpm: f64,
    /// Dresser.
    pub dresser_speed_rpm: f64,
    /// Peripheral speed of the dresser over that of the worm, above 0 where both run the same way at the contact.
    pub speed_ratio: f64,
    /// Way of the dresser along the worm's axis per revolution of the worm.
    pub traverse_per_worm_revolution_mm: f64,
    /// Way of the thread past the dresser per revolution of the dresser.
    pub thread_per_dresser_revolution_mm: f64,
    /// Length of the contact along the thread.
    pub contact_length_mm: f64,
    /// Contact length over the way of the thread per revolution of the dresser.
    pub overlap: f64,
    /// Parts that a dresser lasts; absent without `technology.cost` or without a limit of V'_w.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parts_per_dresser: Option<f64>,
}

/// An area of the worm, or all of it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ZoneLoadResult {
    /// "all", "roughing" or "finishing".
    pub zone: String,
    /// What one part takes of it.
    pub per_part_mm3: f64,
    /// Largest V'_w allowed.
    pub allowed_mm3_per_mm: f64,
    /// Where the strokes of the first part use it.
    pub used_mm: [f64; 2],
    /// Width at which all areas last equally long within the width of the worm.
    pub balanced_width_mm: f64,
}

/// One flank under a stroke: the largest over the profile.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FlankRemovalResult {
    /// Largest depth of cut, normal.
    pub depth_um: f64,
    /// Length of the contact on the tooth.
    pub contact_length_mm: f64,
    /// Area of the contact.
    pub contact_area_mm2: f64,
    /// Q'_w.
    pub specific_rate_mm3_per_mm_s: f64,
    /// Equivalent chip thickness.
    pub chip_thickness_um: f64,
    /// What one thread takes in one passage.
    pub passage_um: f64,
}

/// What the worm removes between two dressings.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WormLoadResult {
    /// Parts between two dressings if the width were used at its best.
    pub parts_by_load: f64,
    /// Parts that the width has room for at this jump from part to part; absent without one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parts_by_width: Option<usize>,
    /// Parts at the job's jump from part to part before a place of the worm has removed more than is allowed.
    pub parts_per_dressing: usize,
    /// Areas of the worm; widths in balance last equally long.
    pub zones: Vec<ZoneLoadResult>,
    /// First place on the worm.
    pub from_mm: f64,
    /// V'_w of so many parts for each millimetre of the worm's width, the largest over the profile.
    pub removed_mm3_per_mm: Sides<Vec<f64>>,
}

/// One worm from its first to its last diameter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WormLifeResult {
    /// States between two dressings.
    pub dressings: usize,
    /// Parts in all.
    pub parts_per_worm: f64,
    /// Crossed-axes angle of the new and of the last worm.
    pub crossed_axes_angle_deg: [f64; 2],
    /// Speed of the new and of the last worm for the same cutting speed.
    pub worm_speed_rpm: [f64; 2],
}

/// Time of a part; those of grinding and dressing are the programs' own.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PartTimeResult {
    /// All grinding programs.
    pub grinding_s: f64,
    /// The same by the law of moves from rest to rest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grinding_by_law_s: Option<f64>,
    /// All dressing programs.
    pub dressing_s: f64,
    /// Share of dressing in a part.
    pub dressing_per_part_s: f64,
    /// Loading, indexing and whatever else there is.
    pub auxiliary_s: f64,
    /// All of it.
    pub part_s: f64,
}

/// Cost of a part.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CostResult {
    /// Machine with its operator.
    pub machine: f64,
    /// Worm.
    pub worm: f64,
    /// Dresser.
    pub dresser: f64,
    /// Changing the worm.
    pub change: f64,
    /// All of it.
    pub total: f64,
}

/// A figure and the shop's limit for it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct IndicatorResult {
    /// Key of the limit.
    pub limit: &'static str,
    /// The largest figure.
    pub value: f64,
    /// The limit.
    pub allowed: f64,
    /// Figure over limit.
    pub share: f64,
}
