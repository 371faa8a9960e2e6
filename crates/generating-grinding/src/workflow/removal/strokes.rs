//! What each stroke takes, how fast, where, and how near it comes to the limits.

use super::result::{FlankRateResult, FlankRemovalResult, LimitShare, RateMapResult, StrokeResult};
use super::{RPM, UM};
use crate::workflow::prepare::RemovalTask;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::equidistant;
use grinding_technology::{Cycle, Direction, FlankStroke, Sense, ShiftRatios, StrokeFigures};

/// Intervals of the removal rate over a stroke.
const INTERVALS: usize = 60;
/// Feeds of a map of Q'_w.
const MAP_FEEDS: usize = 41;

/// Times from the first contact on and the removal rate at each.
fn over_time(cycle: &Cycle, k: usize) -> [Vec<f64>; 2] {
    let figures = &cycle.strokes[k];
    let [first, last] = figures.contact;
    let at = |i: usize| first + (last - first) * i as f64 / INTERVALS as f64;
    let feeds: Vec<f64> = (0..=INTERVALS).map(at).collect();
    let time = feeds.iter().map(|v| (v - first).abs() / figures.feed).collect();
    [time, cycle.rates(k, &feeds)]
}

/// Figures of the stroke `k`, from 0.
pub(super) fn stroke_result(cycle: &Cycle, k: usize, task: &RemovalTask) -> StrokeResult {
    let figures = &cycle.strokes[k];
    let [time, rate] = over_time(cycle, k);
    let most = |list: &[f64]| list.iter().copied().fold(0.0, f64::max);
    let leaves = !figures.stroke.finishes();
    StrokeResult {
        stage: match (leaves, figures.volume > 0.0) {
            (true, _) => "roughing",
            (false, true) => "finishing",
            (false, false) => "spark-out",
        },
        left_um: of_ground(figures, |flank| UM * figures.stroke.left[flank]),
        cutting_speed_m_per_s: figures.stroke.cutting_speed,
        feed_per_revolution_mm: figures.stroke.feed_per_revolution,
        direction: match figures.stroke.direction {
            Direction::Up => "up",
            Direction::Down => "down",
        },
        zone: figures.stroke.zone.clone(),
        dwell_s: figures.stroke.dwell,
        feed_mark_um: UM * largest(figures, |flank| flank.feed_mark),
        nearest_limit: nearest_limit(figures, task),
        diagonal_ratio: ShiftRatios::of(&figures.stroke.shift.law, figures.contact).mean,
        infeed_um: UM * figures.infeed.delta_d,
        worm_speed_rpm: RPM * figures.speeds[0],
        work_speed_rpm: RPM * figures.speeds[1],
        feed_mm_per_s: figures.feed,
        sense: match figures.sense {
            Sense::Climb => "climb",
            Sense::Conventional => "conventional",
        },
        contact_mm: figures.contact,
        approach_mm: figures.approach,
        travel_mm: figures.travel,
        volume_mm3: figures.volume,
        largest_rate_mm3_per_s: most(&rate),
        worm_mm: figures.occupation,
        time_s: time,
        rate_mm3_per_s: rate,
        rate_map: (figures.volume > 0.0).then(|| rate_map(cycle, k)),
        flanks: of_ground(figures, |flank| {
            let flank: &FlankStroke = &figures.flanks[flank];
            FlankRemovalResult {
                depth_um: UM * flank.deepest,
                contact_length_mm: most(&flank.contact_length),
                contact_area_mm2: flank.contact_area,
                specific_rate_mm3_per_mm_s: most(&flank.rate_bound),
                chip_thickness_um: UM * flank.chip_thickness,
                passage_um: UM * most(&flank.passage),
            }
        }),
    }
}

/// Q'_w over flank and feed.
fn rate_map(cycle: &Cycle, k: usize) -> RateMapResult {
    let [a, b] = cycle.strokes[k].contact;
    let feeds = equidistant([a.min(b), a.max(b)], MAP_FEEDS);
    let flanks = of_ground(&cycle.strokes[k], |flank| {
        let engagement = &cycle.bodies.flanks[flank];
        FlankRateResult {
            diameter_mm: engagement.stations().map(|w| 2.0 * engagement.work().radius(w)).to_vec(),
            specific_rate_mm3_per_mm_s: cycle.largest_specific_rates(k, flank, &feeds),
        }
    });
    RateMapResult { flanks, feed_mm: feeds }
}

/// A figure of each flank that a stroke grinds.
fn of_ground<T>(figures: &StrokeFigures, of: impl Fn(Flank) -> T) -> Sides<Option<T>> {
    Sides::from_fn(|flank| figures.stroke.ground.has(flank).then(|| of(flank)))
}

/// Largest of a figure over the stations of the flanks that are ground.
pub(super) fn largest<const N: usize>(figures: &StrokeFigures, of: fn(&FlankStroke) -> [f64; N]) -> f64 {
    figures.stroke.ground.flanks().flat_map(|flank| of(&figures.flanks[flank])).fold(0.0, f64::max)
}

/// The limit that a stroke comes nearest to; `None` for one that takes nothing, or without limits.
fn nearest_limit(figures: &StrokeFigures, task: &RemovalTask) -> Option<LimitShare> {
    if figures.volume <= 0.0 {
        return None;
    }
    let rate = largest(figures, |flank| flank.rate_bound);
    let (key, allowed) = if figures.stroke.finishes() {
        ("technology.limits.Qw_finishing", task.rates.finishing)
    } else {
        ("technology.limits.Qw_roughing", task.rates.roughing)
    };
    let rate = allowed.map(|allowed| LimitShare { limit: key, share: rate / allowed });
    // Marks go with the square of the feed: the share is that of the feed.
    let mark = largest(figures, |flank| flank.feed_mark) / task.cycle_limits.feed_mark;
    let mark = figures
        .stroke
        .finishes()
        .then(|| LimitShare { limit: "technology.limits.feed_mark_um", share: mark.sqrt() });
    let feed = LimitShare {
        limit: "technology.limits.largest_feed",
        share: figures.stroke.feed_per_revolution / task.cycle_limits.feed[1],
    };
    rate.into_iter().chain(mark).chain([feed]).max_by(|a, b| a.share.total_cmp(&b.share))
}
