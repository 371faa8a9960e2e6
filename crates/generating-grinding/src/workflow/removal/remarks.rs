//! Figures over the limits of the shop, and what to know of stock, strokes, width and time.

use super::result::{DressingFiguresResult, IndicatorResult, PartTimeResult, RemovalResult, WormLoadResult};
use super::strokes::largest;
use super::time::of_one_control;
use super::{RPM, UM};
use crate::workflow::prepare::RemovalTask;
use crate::workflow::programs::result::ProgramsResult;
use foundation::geometry::Flank;
use foundation::numerics::extremes;
use grinding_technology::{Cycle, StrokeFigures, WidthUse};
use job::shown_number;
use verdict::{Remark, Verdict};

/// Two figures of the same time are equal within this share.
const SAME_TIME: f64 = 0.01;

/// Figures over the limits of the shop.
pub(super) fn indicators(
    cycle: &Cycle,
    task: &RemovalTask,
    load: Option<&WormLoadResult>,
) -> Vec<IndicatorResult> {
    let rate = |roughing: bool| {
        let strokes = cycle.strokes.iter().filter(|figures| figures.stroke.finishes() != roughing);
        strokes.map(|figures| largest(figures, |flank| flank.rate_bound)).fold(0.0, f64::max)
    };
    let mark = cycle.strokes.iter().filter(|figures| figures.stroke.finishes());
    let mark =
        UM * mark.map(|figures| largest(figures, |flank| flank.feed_mark)).fold(f64::INFINITY, f64::min);
    let mut found = Vec::new();
    let mut add = |limit: &'static str, value: f64, allowed: Option<f64>| {
        if let Some(allowed) = allowed {
            found.push(IndicatorResult { limit, value, allowed, share: value / allowed });
        }
    };
    add("technology.limits.Qw_roughing", rate(true), task.rates.roughing);
    add("technology.limits.Qw_finishing", rate(false), task.rates.finishing);
    add("technology.limits.feed_mark_um", mark, task.feed_mark.map(|mark| UM * mark));
    let fastest = |of: fn(&StrokeFigures) -> f64| cycle.strokes.iter().map(of).fold(0.0, f64::max);
    let speeds = &task.speeds;
    add("technology.limits.wheel_speed_m_per_s", fastest(|f| f.stroke.cutting_speed), speeds.wheel);
    for (key, speed, limit) in [
        ("technology.limits.worm_speed_rpm", fastest(|f| f.speeds[0]), speeds.worm),
        ("technology.limits.work_speed_rpm", fastest(|f| f.speeds[1]), speeds.work),
    ] {
        add(key, RPM * speed, limit.map(|limit| RPM * limit));
    }
    if let Some(load) = load {
        let removed = &load.removed_mm3_per_mm;
        let most = removed.left.iter().chain(&removed.right).copied().fold(0.0, f64::max);
        add("technology.limits.Vw_finishing", most, task.loads.finishing);
    }
    found
}

/// Judges whether the flanks clean up: material that is missing before grinding is missing after it.
pub fn judge_stock(verdict: &mut Verdict, result: &RemovalResult) {
    let ground = |flank: Flank| result.strokes.iter().any(|stroke| stroke.flanks[flank].is_some());
    for flank in Flank::BOTH.into_iter().filter(|&flank| ground(flank)) {
        let least = result.stock.least_um[flank];
        let detail =
            format!("{least:.1} to {:.1} µm over the finished flank", result.stock.largest_um[flank]);
        verdict.judge(format!("stock on the {flank} flank"), least > 0.0, detail, || {
            Remark::new(
                "no-stock",
                format!(
                    "material is missing on the {flank} flank, up to {:.1} um: it does not clean up there",
                    -least
                ),
                format!(
                    "raise stock.allowance_um by {:.1} um or more, or centre the blank (stock.run_out)",
                    (10.0 * -least).floor() / 10.0 + 0.1
                ),
            )
        });
    }
}

/// What to know.
pub(super) fn remarks(
    result: &RemovalResult,
    cycle: &Cycle,
    (task, programs): (&RemovalTask, Option<&ProgramsResult>),
) -> Vec<Remark> {
    let mut remarks = Vec::new();
    for (k, stroke) in result.strokes.iter().enumerate() {
        let left: Vec<(Flank, f64)> =
            stroke.left_um.iter().filter_map(|(flank, um)| Some((flank, (*um)?))).collect();
        if stroke.volume_mm3 <= 0.0 && left.iter().any(|(_, um)| *um > 0.0) {
            let left: Vec<String> =
                left.iter().map(|(flank, um)| format!("{um:.1} um on the {flank} flank")).collect();
            remarks.push(Remark {
                code: "stroke-cuts-air",
                text: format!(
                    "stroke {} leaves {}, which is more than the stock: it takes nothing",
                    k + 1,
                    left.join(" and ")
                ),
                way_out: "take it out of technology.strokes or machine.roughing_stock_um, or raise stock.allowance_um"
                    .into(),
            });
        }
    }
    for indicator in result.indicators.iter().filter(|indicator| indicator.share > 1.0) {
        remarks.push(Remark {
            code: "limit-exceeded",
            text: format!(
                "{} = {} is exceeded: {} ({:.0} % of it). The limit is the shop's own; the figure says harder than what it calls safe, not burnt",
                indicator.limit,
                shown_number(indicator.allowed),
                shown_number((indicator.value * 1e3).round() / 1e3),
                100.0 * indicator.share
            ),
            way_out: "spread the stock over more strokes, lower the feed, or dress sooner".into(),
        });
    }
    remarks.extend(result.dressing.as_ref().and_then(|dressing| low_overlap(dressing, task)));
    remarks.extend((task.spaces_left_out > 0).then(|| Remark {
        code: "stock-of-some-spaces",
        text: format!(
            "the table of the stock leaves out {} tooth spaces: they get the mean of the others",
            task.spaces_left_out
        ),
        way_out: "measure every tooth, or keep some stock more than the measured teeth need".into(),
    }));
    remarks.extend(short_approach(cycle, programs));
    remarks.extend(narrow_worm(cycle, task));
    remarks.extend(result.part_time.as_ref().and_then(other_time));
    remarks
}

/// An overlap below that of the shop.
fn low_overlap(dressing: &DressingFiguresResult, task: &RemovalTask) -> Option<Remark> {
    let least = task.dressing?.least_overlap.filter(|least| dressing.overlap < *least)?;
    Some(Remark {
        code: "dressing-overlap-low",
        text: format!(
            "the overlap of dressing is {:.3}, the shop asks for {}",
            dressing.overlap,
            shown_number(least)
        ),
        way_out: format!(
            "dress slower (machine.dressing_worm_speed_rpm = {:.1}) or turn the dresser faster (machine.dresser_speed_rpm)",
            (10.0 * dressing.worm_speed_rpm * dressing.overlap / least).floor() / 10.0
        ),
    })
}

/// A worm that comes in when it should grind already plunges into the end of the teeth.
fn short_approach(cycle: &Cycle, programs: Option<&ProgramsResult>) -> Option<Remark> {
    let programs = programs?;
    let passes: Vec<_> = of_one_control(programs, "grinding").flat_map(|program| &program.passes).collect();
    if passes.len() != cycle.strokes.len() {
        return None;
    }
    let missing = |(figures, driven): (&StrokeFigures, [f64; 2])| {
        if figures.volume > 0.0 { figures.sign() * (driven[0] - figures.contact[0]) } else { 0.0 }
    };
    let short =
        cycle.strokes.iter().zip(passes.iter().map(|pass| pass.driven_mm)).map(missing).fold(0.0, f64::max);
    (short > 0.0).then(|| Remark {
        code: "approach-too-short",
        text: format!(
            "contact begins before the worm has come in: it plunges into the end of the teeth, {short:.1} mm of way are missing"
        ),
        way_out: format!("raise grinding.overrun by {:.1} mm, or spread the stock over more strokes", short.ceil()),
    })
}

/// A stroke that meets stock beyond the end of the worm.
fn narrow_worm(cycle: &Cycle, task: &RemovalTask) -> Option<Remark> {
    let width = task.worm_width.filter(|width| cycle.parts_by_width(*width) == WidthUse::Parts(0))?;
    let used = extremes(cycle.strokes.iter().flat_map(|figures| figures.occupation));
    Some(Remark {
        code: "worm-too-short-for-stock",
        text: format!(
            "strokes meet stock from {:.1} to {:.1} mm along the worm, which reaches from {:.1} to {:.1} mm: what its ends do not take is left to the strokes behind",
            used[0],
            used[1],
            -0.5 * width,
            0.5 * width
        ),
        way_out: "take a wider worm, a smaller diagonal ratio, or spread the stock over more strokes".into(),
    })
}

/// Programs that take longer, or less, than the law of moves from rest to rest says.
fn other_time(time: &PartTimeResult) -> Option<Remark> {
    let by_law = time.grinding_by_law_s?;
    let off = time.grinding_s / by_law - 1.0;
    (off.abs() > SAME_TIME).then(|| Remark {
        code: "time-differs",
        text: format!(
            "the grinding programs take {:.2} s, strokes by the law of moves from rest to rest {by_law:.2} s",
            time.grinding_s
        ),
        way_out: "take the programs' time: it has what axes and areas of the worm add".into(),
    })
}
