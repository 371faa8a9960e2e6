//! `[stock]` and `[technology]` against each other and against the worm.

use super::roughing;
use crate::job::{CycleRule, Job, StrokeOfJob, StrokeZone, Technology};
use foundation::geometry::Flank;
use job::{Diagnostic, Problem, shown_number};

pub(super) fn check(job: &Job, findings: &mut Vec<Diagnostic>) {
    pitches(job, findings);
    blank(job, findings);
    let Some(technology) = &job.technology else { return };
    let needs = |field: &str, text: &'static str, allowed: &'static str, way_out: &'static str| {
        Diagnostic::new(Problem::InvalidJob, text)
            .field(field)
            .value("a table")
            .allowed(allowed)
            .way_out(way_out)
    };
    if job.stock.is_none() {
        findings.push(needs(
            "technology",
            "what strokes take cannot be said without the stock",
            "a table [stock]",
            "give stock.allowance_um, or leave [technology] out",
        ));
    }
    let limits = &technology.limits;
    if technology.cost.is_some() && technology.life.is_none() {
        findings.push(needs(
            "technology.cost",
            "the worm's share of the cost cannot be said without its life",
            "tables technology.life and technology.cost",
            "give technology.life, or leave the cost out",
        ));
    }
    if technology.life.is_some() && limits.Vw_finishing.is_none() {
        findings.push(needs(
            "technology.life",
            "how many parts a dressing lasts cannot be said without what the worm may remove",
            "technology.limits.Vw_finishing beside it",
            "give technology.limits.Vw_finishing, or leave the life out",
        ));
    }
    if limits.Vw_finishing.is_some() && limits.zone_width.is_none() && job.worm.width.is_none() {
        findings.push(needs(
            "technology.limits.Vw_finishing",
            "what the worm may remove says nothing without its width",
            "worm.width or technology.limits.zone_width beside it",
            "give worm.width",
        ));
    }
    if technology.times.is_some() && job.machine.is_none() {
        findings.push(needs(
            "technology.times",
            "the time of a part is that of its programs, which need a machine",
            "a table [machine]",
            "name a machine, or leave the times out",
        ));
    }
    if technology.cost.is_some() && technology.times.is_none() {
        findings.push(needs(
            "technology.cost",
            "the cost of a part cannot be said without its time",
            "tables technology.times and technology.cost",
            "give technology.times (all its entries may be left out), or leave the cost out",
        ));
    }
    if let (Some(life), Some(first)) = (technology.life, job.worm.tip_diameter)
        && life.last_tip_diameter > first
    {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "the last worm is larger than the first")
                .field("technology.life.last_tip_diameter")
                .value(shown_number(life.last_tip_diameter))
                .allowed(format!("up to worm.tip_diameter = {first}"))
                .way_out("give the least tip diameter of the worm"),
        );
    }
    rules(job, technology, findings);
    ranges(technology, findings);
    for k in 0..technology.strokes.len() {
        stroke(job, technology, k, findings);
    }
}

/// One value for every tooth space.
fn pitches(job: &Job, findings: &mut Vec<Diagnostic>) {
    let Some(pitch) = job.stock.as_ref().and_then(|stock| stock.pitch_um.as_ref()) else { return };
    let spaces = job.gear.teeth.unsigned_abs() as usize;
    for (flank, list) in [("left", &pitch.left), ("right", &pitch.right)] {
        if list.len() != spaces {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "the list has not a value for every tooth space")
                    .field(format!("stock.pitch_um.{flank}"))
                    .value(format!("{} values", list.len()))
                    .allowed(format!("{spaces} values, one for each tooth space"))
                    .way_out("give a value for every space, 0 where there is none"),
            );
        }
    }
}

/// An amount over the flank, and how high the marks of the hob are.
fn blank(job: &Job, findings: &mut Vec<Diagnostic>) {
    let Some(stock) = &job.stock else { return };
    if stock.allowance_um.is_none() && stock.map.is_none() {
        findings.push(
            Diagnostic::new(Problem::MissingKey, "`stock` does not say how much stands on the flanks")
                .field("stock.allowance_um")
                .allowed("allowance_um, or map = \"FILE\"")
                .way_out("give the stock in um, e.g. allowance_um = 100"),
        );
    }
    let Some(hob) = &stock.hob else { return };
    let (height, body) = (hob.height_um.is_some(), hob.tip_diameter.is_some() && hob.threads.is_some());
    let part = hob.tip_diameter.is_some() != hob.threads.is_some();
    if height == body || part {
        let said = if height { "a height beside a hob" } else { "not enough" };
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "the height of the hob's marks is given by one of two ways")
                .field("stock.hob")
                .value(said)
                .allowed("height_um, or both tip_diameter and threads")
                .way_out("give height_um alone, or tip_diameter and threads of the hob"),
        );
    }
}

/// Where the strokes come from: a rule, a list, or `[machine]`.
fn rules(job: &Job, technology: &Technology, findings: &mut Vec<Diagnostic>) {
    let listed = !technology.strokes.is_empty();
    if let (Some(_), true) = (technology.cycle, listed) {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "the job lists its strokes and asks for a rule as well")
                .field("technology.cycle")
                .value("beside technology.strokes")
                .allowed("one of both")
                .way_out("leave technology.cycle or technology.strokes out"),
        );
    }
    let limits = &technology.limits;
    if technology.cycle == Some(CycleRule::Cheapest) && technology.cost.is_none() {
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "what a part costs cannot be said without the shop's rates")
                .field("technology.cycle")
                .value("\"cheapest\" without technology.cost")
                .allowed("technology.cost beside it; \"standard\" or \"fastest\" without")
                .way_out(
                    "give technology.cost with technology.life and technology.times, or ask for the fastest",
                ),
        );
    }
    if technology.cycle.is_some() {
        for (key, given) in [("Qw_roughing", limits.Qw_roughing), ("Qw_finishing", limits.Qw_finishing)] {
            if given.is_none() {
                findings.push(
                    Diagnostic::new(
                        Problem::InvalidJob,
                        "strokes are chosen within limits of the removal rate",
                    )
                    .field("technology.cycle")
                    .value(format!("without technology.limits.{key}"))
                    .allowed("both limits of Q'_w beside it")
                    .way_out(format!("give technology.limits.{key}, or list technology.strokes")),
                );
            }
        }
    }
    let Some(machine) = job.machine.as_ref().filter(|_| listed || technology.cycle.is_some()) else { return };
    let both = |key: &'static str, value: String| {
        let text = "the strokes are those of [technology], and [machine] names some as well";
        Diagnostic::new(Problem::InvalidJob, text)
            .field(key)
            .value(value)
            .allowed("nothing beside technology.strokes or technology.cycle")
            .way_out("put them into technology.strokes, or leave that out")
    };
    if !machine.roughing_stock_um.is_empty() {
        findings.push(both("machine.roughing_stock_um", format!("{:?}", machine.roughing_stock_um)));
    }
    if machine.spark_out > 0 {
        findings.push(both("machine.spark_out", machine.spark_out.to_string()));
    }
}

/// Least values above largest ones.
fn ranges(technology: &Technology, findings: &mut Vec<Diagnostic>) {
    let limits = &technology.limits;
    for (low, high, [low_key, high_key], unit) in [
        (limits.least_feed, limits.largest_feed, ["least_feed", "largest_feed"], "mm"),
        (
            limits.least_finishing_um,
            limits.most_finishing_um,
            ["least_finishing_um", "most_finishing_um"],
            "um",
        ),
    ] {
        let (Some(low), Some(high)) = (low, high) else { continue };
        if high < low {
            findings.push(
                Diagnostic::new(Problem::InvalidNumber, "the largest value is below the least")
                    .field(format!("technology.limits.{high_key}"))
                    .value(shown_number(high))
                    .allowed(format!(">= technology.limits.{low_key} = {} {unit}", shown_number(low)))
                    .way_out("exchange both, or leave one out"),
            );
        }
    }
}

/// A stroke against the one before, the limits and the areas of the worm.
fn stroke(job: &Job, technology: &Technology, k: usize, findings: &mut Vec<Diagnostic>) {
    let this = &technology.strokes[k];
    let key = |name: &str| format!("technology.strokes[{k}].{name}");
    let left = |stroke: &StrokeOfJob, flank: Flank| stroke.left_um.sides()[flank];
    let finishes = Flank::BOTH.iter().all(|&flank| left(this, flank) == 0.0);
    for flank in Flank::BOTH {
        let um = left(this, flank);
        let before = k.checked_sub(1).map(|before| left(&technology.strokes[before], flank));
        let order = |allowed: String, way_out: &'static str| {
            let text = format!("stroke {} is out of order on the {flank} flank", k + 1);
            Diagnostic::with_code("stroke-order", text)
                .field(key("left_um"))
                .value(shown_number(um))
                .allowed(allowed)
                .way_out(way_out)
        };
        if let Some(before) = before.filter(|before| um > *before) {
            findings.push(order(
                format!("0 to {} um, what the stroke before leaves", shown_number(before)),
                "order the strokes from roughing to finishing",
            ));
        } else if k + 1 == technology.strokes.len() && um != 0.0 {
            findings.push(order("0 um for the last stroke".into(), "let the last stroke leave 0 um"));
        }
    }
    if let (Some(feed), Some(most)) = (this.feed_per_revolution, technology.limits.largest_feed)
        && feed > most
    {
        findings.push(
            Diagnostic::new(Problem::InvalidNumber, "the feed is beyond the limit")
                .field(key("feed_per_revolution"))
                .value(shown_number(feed))
                .allowed(format!("up to technology.limits.largest_feed = {} mm", shown_number(most)))
                .way_out("lower the feed, or raise the limit"),
        );
    }
    let areas = job.grinding.roughing_areas > 0;
    let shift = this.shift.unwrap_or_default();
    for (name, given) in [("shift.ratio", shift.ratio), ("shift.origin", shift.origin)] {
        let Some(value) = given else { continue };
        let why = match (finishes, areas) {
            (true, _) => "the flank depends on how the stroke that leaves nothing shifts: the plan decides",
            (false, true) if name == "shift.origin" => {
                "strokes that leave stock begin where their areas lie on the worm"
            }
            (false, _) => continue,
        };
        findings.push(
            Diagnostic::new(Problem::InvalidJob, why)
                .field(key(name))
                .value(shown_number(value))
                .allowed("nothing for this stroke")
                .way_out("leave it out, or give grinding.diagonal_ratio or grinding.roughing_ratio"),
        );
    }
    roughing::area_of_stroke(job, technology, (k, finishes), findings);
    if let Some(zone) = this.zone
        && (zone == StrokeZone::All) == areas
    {
        let (allowed, way_out) = if areas {
            ("\"roughing\" or \"finishing\" with grinding.roughing_areas", "name the area, or leave it out")
        } else {
            (
                "\"all\" for a worm without grinding.roughing_areas",
                "give grinding.roughing_areas, or leave it out",
            )
        };
        findings.push(
            Diagnostic::new(Problem::InvalidJob, "the worm has no such area")
                .field(key("zone"))
                .value(zone.name())
                .allowed(allowed)
                .way_out(way_out),
        );
    }
}
