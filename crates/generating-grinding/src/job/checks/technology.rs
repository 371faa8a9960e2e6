//! `[stock]` and `[technology]` against each other and against the worm.

use crate::job::Job;
use job::{Diagnostic, Problem, shown_number};

pub(super) fn check(job: &Job, findings: &mut Vec<Diagnostic>) {
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
}
