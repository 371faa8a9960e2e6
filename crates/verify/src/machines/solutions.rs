//! Blocks `inverse` and `stroke`: from poses to axis positions.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::{Reference, Tolerances};
use super::cases::{each, pose_rows};
use super::input::{JobName, MountsInput, PoseInput, RuleInput, axis_key, machine, period};
use machine::{Follower, Machine, Positions, Solution};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct InverseCase {
    #[serde(rename = "name")]
    _name: String,
    machine: String,
    job: JobName,
    pose: PoseInput,
    mount: MountsInput,
    #[serde(default)]
    rule: RuleInput,
    #[serde(rename = "expected")]
    _expected: Value,
}

fn tolerance(tolerances: Tolerances<'_>, periodic: bool) -> f64 {
    tolerances.get(if periodic { "axes_deg" } else { "axes_mm" })
}

/// Compares the positions of all axes of a job, angles modulo a turn or with full turns.
fn axes(
    item: &mut Expected<'_>,
    machine: &Machine,
    numbers: &[usize],
    at: &Positions,
    full_turns: bool,
    file: &Reference<'_>,
    ledger: &mut Ledger,
) {
    for &axis in numbers {
        let actual = machine.axes()[axis].joint.shown(at[axis]);
        let key = axis_key(machine, axis);
        let period = period(machine, axis);
        let within = tolerance(file.tolerances(), period.is_some());
        match period.filter(|_| !full_turns) {
            Some(period) => item.periodic(&key, actual, period, within, ledger),
            None => item.number(&key, actual, within, ledger),
        }
    }
}

/// How far the axes of a solution are off those listed, in tolerances' units; what is not listed is far off.
fn distance(machine: &Machine, numbers: &[usize], at: &Positions, listed: &Value) -> f64 {
    let apart = |&axis: &usize| {
        let Some(expected) = listed[axis_key(machine, axis).as_str()].as_f64() else { return f64::INFINITY };
        let apart = machine.axes()[axis].joint.shown(at[axis]) - expected;
        period(machine, axis).map_or(apart, |period| apart - period * (apart / period).round()).abs()
    };
    numbers.iter().map(apart).fold(0.0, f64::max)
}

/// Block `inverse`: the set of solutions is complete, each is judged, and the right one is chosen.
pub(crate) fn inverse(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    each("inverse", block, ledger, |case: &InverseCase, expected, ledger| {
        let machine = machine(file, &case.machine)?.machine;
        let station = case.job.station();
        let mounts = case.mount.at(station);
        let pose = case.pose.spindles(&mounts);
        pose_rows(expected, &pose, file, ledger);
        let found = machine.judged(station, case.rule.solve(&machine, station, &pose, None)?)?;
        let numbers = machine.axes_at(station)?;
        let mut left: Vec<&Solution> = found.iter().collect();
        let listed = expected.objects("solutions", ledger);
        ledger.equal(expected.case(), "number of solutions", listed.len().into(), left.len().into());
        for mut item in listed {
            let wanted = item.peek("axes").cloned().unwrap_or_default();
            let nearest = (0..left.len()).min_by(|&a, &b| {
                let off = |k: usize| distance(&machine, &numbers, &left[k].at, &wanted);
                off(a).total_cmp(&off(b))
            });
            let Some(nearest) = nearest else {
                item.refused(&"no solution is left for it", ledger);
                continue;
            };
            let solution = left.swap_remove(nearest);
            if let Some(mut wanted) = item.object("axes", ledger) {
                axes(&mut wanted, &machine, &numbers, &solution.at, false, file, ledger);
                wanted.finish(ledger);
            }
            if let Some(within) = item.take("within_limits") {
                ledger.equal(item.case(), "within_limits", within.clone(), solution.beyond.is_empty().into());
            }
            if let Some(violated) = item.take("violated") {
                let sorted = |mut names: Vec<&str>| {
                    names.sort_unstable();
                    names.join(" ")
                };
                let given = violated.as_array().into_iter().flatten().filter_map(Value::as_str).collect();
                let names = solution.beyond.iter().map(|&k| machine.axes()[k].name.as_str()).collect();
                ledger.equal(item.case(), "violated", sorted(given).into(), sorted(names).into());
            }
            item.finish(ledger);
        }
        match (expected.peek("chosen"), machine.first(&found)) {
            (Some(Value::Null), chosen) => {
                expected.informative(&["chosen"]);
                ledger.equal(expected.case(), "chosen", false.into(), chosen.is_ok().into());
            }
            (_, Ok(chosen)) => {
                if let Some(mut item) = expected.object("chosen", ledger) {
                    axes(&mut item, &machine, &numbers, &chosen.at, false, file, ledger);
                    item.finish(ledger);
                }
            }
            (_, Err(error)) => {
                if let Some(mut item) = expected.object("chosen", ledger) {
                    item.refused(&error, ledger);
                }
            }
        }
        Ok(())
    });
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StrokeCase {
    #[serde(rename = "name")]
    _name: String,
    machine: String,
    job: JobName,
    mount: MountsInput,
    #[serde(default)]
    rule: RuleInput,
    rows: Vec<PoseInput>,
    #[serde(rename = "expected")]
    _expected: Value,
}

/// Block `stroke`: positions with full turns along a stroke.
pub(crate) fn stroke(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    each("stroke", block, ledger, |case: &StrokeCase, expected, ledger| {
        let machine = machine(file, &case.machine)?.machine;
        let station = case.job.station();
        let mounts = case.mount.at(station);
        let numbers = machine.axes_at(station)?;
        let mut follower =
            Follower::new(&machine, station, [mounts.tool.sense(), mounts.counterpart.sense()]);
        let listed = expected.objects("axes", ledger);
        ledger.equal(expected.case(), "number of rows", listed.len().into(), case.rows.len().into());
        for (mut item, row) in listed.into_iter().zip(&case.rows) {
            let found = case.rule.solve(&machine, station, &row.spindles(&mounts), follower.worm())?;
            let at = follower.next(found, row.angles())?;
            axes(&mut item, &machine, &numbers, &at, true, file, ledger);
            item.finish(ledger);
        }
        Ok(())
    });
}
