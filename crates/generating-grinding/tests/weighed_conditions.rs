//! Conditions of dressing that are met as nearly as their weights ask, from the job to the page.

use foundation::numerics::Silent;
use generating_grinding::job::{Job, LoadedJob};
use generating_grinding::page::page;
use generating_grinding::workflow::{ConditionResult, Outcome, plan_job};
use job::read_job_of;
use report::Block;
use std::path::Path;
use verdict::Status;

fn example() -> LoadedJob {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/dressing/weighed-points.toml");
    let mut loaded = read_job_of::<Job>(Path::new(file)).unwrap();
    (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (11, 9);
    loaded.job.grinding.feed_per_revolution = None;
    loaded
}

fn planned(change: impl Fn(&mut Job)) -> Outcome {
    let mut loaded = example();
    change(&mut loaded.job);
    plan_job(&loaded, &Silent).unwrap()
}

/// Of the left flank.
fn condition<'a>(of: &'a Outcome, kind: &str, at: f64) -> &'a ConditionResult {
    let all = &of.result.settings.dressing_conditions;
    let found = all
        .iter()
        .find(|c| c.kind == kind && c.at == [at] && c.flank == Some(foundation::geometry::Flank::Left));
    found.unwrap_or_else(|| panic!("{kind} {at}: {all:?}"))
}

/// Largest offset of the dresser on the left flank, mm.
fn offset(of: &Outcome) -> f64 {
    let dressing = of.execution.flanks.left.as_ref().unwrap().dressing().unwrap();
    let (from, to) = dressing.corrections[3].interval();
    (0..=20)
        .map(|k| dressing.corrections[3].value(from + (to - from) * f64::from(k) / 20.0).abs())
        .fold(0.0, f64::max)
}

/// The example meets its target with less travel of the offset than four exact conditions take; the referee finds the planned flank; what is
/// left of each condition is what its weight allows.
#[test]
fn weights_trade_misses_of_the_profile_for_travel() {
    let of = planned(|_| {});
    assert_eq!(of.result.verdict.status(), Status::Met, "{:?}", of.result.verdict);
    for flank in of.result.flanks.values() {
        assert!(flank.model_difference_um < 0.02, "{}", flank.model_difference_um);
    }
    assert_eq!(of.result.settings.dressing_conditions.len(), 14);
    let middle = condition(&of, "point", 0.5);
    assert!(middle.weight.is_none() && middle.largest_miss < 1e-4, "{middle:?}");
    let exact =
        planned(|job| job.dressing.conditions = generating_grinding::job::Dressing::default().conditions);
    assert!(exact.result.settings.dressing_conditions.is_empty());
    let (less, more) = (offset(&of), offset(&exact));
    assert!(less < 0.1 * more, "{less} of {more} mm");
    // The worm is missed by about as much as the gear.
    let left = of.result.flanks["left"].max_deviation_um;
    let worst = [0.0, 0.25, 0.75, 1.0].map(|at| condition(&of, "point", at).largest_miss);
    let worst = worst.into_iter().fold(0.0, f64::max);
    assert!(left < 3.0 * worst + 0.1 && worst < 3.0 * left + 0.1, "{left} {worst}");
}

#[test]
fn a_page_tells_what_is_left_of_each_condition() {
    let of = planned(|_| {});
    let shown = page(&of, &[]).unwrap();
    let section = shown.sections.iter().find(|section| section.id == "dressing-corrections").unwrap();
    let table = section.blocks.iter().find_map(|block| match block {
        Block::Table(table) if table.caption.starts_with("Conditions of dressing") => Some(table),
        _ => None,
    });
    let table = table.expect("the table");
    assert_eq!(table.rows.len(), 14);
    assert!(table.rows.iter().any(|row| row.contains(&"exact".to_owned())));
    assert!(table.rows.iter().any(|row| row.contains(&"offset of the dresser".to_owned())));
}
