//! Times, dressing figures, life, cost, the fastest cycle.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::compare::{Shares, count, number, numbers};
use super::input::Input;
use grinding_technology::{Cycle, OptimumRow, OptimumTask, TechnologyError};

const RPM: f64 = 60.0;

pub(super) fn check(
    cycle: &Cycle,
    input: &Input,
    expected: &mut Expected<'_>,
    to: &Shares,
    ledger: &mut Ledger,
) -> Result<(), TechnologyError> {
    let bodies = &cycle.bodies;
    let dressing = input.dressing();
    let strokes = cycle.times(&input.axes(), input.clearance)?;
    let grinding = strokes.iter().map(grinding_technology::StrokeTime::sum).sum();
    let dressing_time = dressing.time(bodies, &input.axes(), input.clearance)?;
    let parts_per_dressing = cycle.level(&input.zones()).parts.floor();
    let part = input.part_times().part(grinding, &dressing_time, parts_per_dressing)?;
    if let Some(mut item) = expected.object("time", ledger) {
        for (mut item, time) in item.objects("strokes", ledger).into_iter().zip(&strokes) {
            let plain = [
                ("speed", time.speed),
                ("ramp_s", time.ramp),
                ("driven", time.driven),
                ("stroke_s", time.stroke),
                ("infeed_s", time.infeed),
                ("total_s", time.total),
                ("rapid_s", time.rapid),
                ("dwell_s", time.dwell),
                ("sum_s", time.sum()),
            ];
            numbers(&mut item, &plain, to.time, ledger);
            item.finish(ledger);
        }
        if let Some(mut item) = item.object("dressing", ledger) {
            let plain = [
                ("lead", dressing_time.lead),
                ("travel", dressing_time.travel),
                ("speed", dressing_time.speed),
                ("ramp_s", dressing_time.ramp),
                ("pass_s", dressing_time.pass),
                ("return_s", dressing_time.back),
                ("passes", dressing_time.passes as f64),
                ("total_s", dressing_time.total()),
            ];
            numbers(&mut item, &plain, to.time, ledger);
            item.finish(ledger);
        }
        numbers(&mut item, &[("grinding_s", grinding), ("part_s", part)], to.time, ledger);
        count(&mut item, "parts_per_dressing", parts_per_dressing, to.parts, ledger);
        item.finish(ledger);
    }
    if let Some(mut item) = expected.object("dressing", ledger) {
        let figures = dressing.figures(bodies)?;
        let plain = [
            ("q_d", figures.speed_ratio),
            ("advance_per_dresser_rev", figures.advance),
            ("contact_length", figures.contact_length),
            ("overlap", figures.overlap),
        ];
        numbers(&mut item, &plain, to.relative, ledger);
        item.finish(ledger);
    }
    let life = input.life().rows(bodies)?;
    if let Some(mut item) = expected.object("life", ledger) {
        let rows = item.objects("rows", ledger);
        ledger.equal(item.case(), "life.rows", rows.len().into(), life.rows.len().into());
        for (mut item, row) in rows.into_iter().zip(&life.rows) {
            let plain = [
                ("d", row.tip_diameter),
                ("n1_rpm", RPM * row.worm_speed),
                ("v_c", row.cutting_speed),
                ("gamma_deg", row.crossed_axes_angle.to_degrees()),
                ("n2_rpm", RPM * row.work_speed),
                ("wear_factor", row.wear_factor),
            ];
            numbers(&mut item, &plain, to.relative, ledger);
            number(&mut item, "parts_real", row.parts, to.parts, ledger);
            item.finish(ledger);
        }
        count(&mut item, "dressings", life.rows.len() as f64, to.parts, ledger);
        count(&mut item, "parts_per_worm", life.parts_per_worm(), to.parts, ledger);
        item.finish(ledger);
    }
    if let Some(mut item) = expected.object("cost_per_part", ledger) {
        let cost = input.rates().per_part(part, parts_per_dressing, life.parts_per_worm())?;
        let plain = [
            ("machine", cost.machine),
            ("worm", cost.worm),
            ("dresser", cost.dresser),
            ("change", cost.change),
            ("total", cost.total()),
        ];
        numbers(&mut item, &plain, to.time, ledger);
        item.finish(ledger);
    }
    match input.optimise() {
        Some(task) => optimum(&task, cycle, input, expected, to, ledger),
        None => Ok(()),
    }
}

fn optimum(
    task: &OptimumTask,
    cycle: &Cycle,
    input: &Input,
    expected: &mut Expected<'_>,
    to: &Shares,
    ledger: &mut Ledger,
) -> Result<(), TechnologyError> {
    let Some(mut item) = expected.object("optimise", ledger) else { return Ok(()) };
    let optimum = match task.solve(&cycle.bodies, &input.axes()) {
        Ok(optimum) => optimum,
        Err(error) => {
            item.refused(&error, ledger);
            return Ok(());
        }
    };
    if let Some(best) = item.object("best", ledger) {
        row(&optimum.best, best, to, ledger);
    }
    for (key, rows) in [("by_roughing_strokes", &optimum.by_roughing_strokes), ("pareto", &optimum.pareto)] {
        let items = item.objects(key, ledger);
        ledger.equal(item.case(), &item.name(key), items.len().into(), rows.len().into());
        for (item, actual) in items.into_iter().zip(rows) {
            row(actual, item, to, ledger);
        }
    }
    item.finish(ledger);
    Ok(())
}

fn row(actual: &OptimumRow, mut item: Expected<'_>, to: &Shares, ledger: &mut Ledger) {
    if let Some(value) = item.take("feasible") {
        let feasible = actual.cycle.is_some();
        ledger.equal(item.case(), &item.name("feasible"), value.clone(), feasible.into());
    }
    item.number("limit_factor", actual.limit_factor, 1e-12, ledger);
    match &actual.cycle {
        Some(cycle) => number(&mut item, "time_s", cycle.time, to.optimum_time, ledger),
        None => item.optional("time_s", None, 0.0, ledger),
    }
    // The optimum is flat: the file names these for information. Where the same number of strokes is the best they stand beside each other.
    item.informative(&[
        "roughing_strokes",
        "finishing_stock_um",
        "feed_roughing",
        "feed_finishing",
        "parts_real",
        "Qw_roughing",
        "Qw_finishing",
        "feed_mark_um",
    ]);
    item.finish(ledger);
}
