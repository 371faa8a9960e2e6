//! Stock, strokes, load of the worm, time and cost of a planned gear.

use foundation::numerics::Silent;
use generating_grinding::job::LoadedJob;
use generating_grinding::page::html_page;
use generating_grinding::workflow::{Outcome, plan_job};
use job::read_job_of;
use job::tables::OneOrSides;
use std::path::PathBuf;

fn load() -> LoadedJob {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/grinding-cycle.toml");
    let mut loaded: LoadedJob = read_job_of(&path).unwrap();
    (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (5, 5);
    loaded
}

fn run(change: impl FnOnce(&mut LoadedJob)) -> Outcome {
    let mut loaded = load();
    change(&mut loaded);
    plan_job(&loaded, &Silent).unwrap_or_else(|e| panic!("{e:?}"))
}

fn codes(outcome: &Outcome) -> Vec<&str> {
    outcome.result.warnings.iter().map(|remark| remark.code).collect()
}

/// Without programs, which take most of the time of these tests.
fn without_programs(loaded: &mut LoadedJob) {
    loaded.job.output.programs.clear();
}

#[test]
fn a_cycle_is_told_from_stock_to_cost() {
    let outcome = run(|_| ());
    let removal = outcome.result.removal.as_ref().unwrap();
    let taken: f64 = removal.strokes.iter().map(|stroke| stroke.volume_mm3).sum();
    assert!((taken / removal.stock.volume_mm3 - 1.0).abs() < 1e-6, "the last stroke leaves nothing");
    let stages: Vec<&str> = removal.strokes.iter().map(|stroke| stroke.stage).collect();
    assert_eq!(stages, ["roughing", "finishing", "spark-out"]);
    assert_eq!(removal.strokes[2].volume_mm3, 0.0, "spark-out takes nothing");
    // The time of a part is that of its programs.
    let programs = &outcome.result.programs.as_ref().unwrap().programs;
    let of = |station: &str| -> f64 {
        programs.iter().filter(|program| program.job == station).map(|program| program.duration_s).sum()
    };
    let time = removal.part_time.unwrap();
    assert_eq!((time.grinding_s, time.dressing_s), (of("grinding"), of("dressing")));
    let load = removal.worm_load.as_ref().unwrap();
    let share = (of("dressing") + 12.0) / load.parts_per_dressing as f64;
    assert!((time.part_s - (of("grinding") + 8.5 + share)).abs() < 1e-9);
    let cost = removal.cost_per_part.unwrap();
    assert!((cost.machine - 95.0 / 3600.0 * time.part_s).abs() < 1e-9);
    let parts = removal.worm_life.unwrap().parts_per_worm;
    assert!((cost.worm - 780.0 / parts).abs() < 1e-9);
    // No place of the worm has removed more than is allowed.
    let most = load.removed_mm3_per_mm.left.iter().chain(&load.removed_mm3_per_mm.right);
    assert!(most.copied().fold(0.0, f64::max) <= 1200.0);
    let page = html_page(&outcome, &[]).unwrap();
    for part in
        ["<h2>Stock, strokes and cost</h2>", "removal-rate-over-time", "load-of-the-worm", "Cost per part"]
    {
        assert!(page.contains(part), "{part}");
    }
}

#[test]
fn the_flank_does_not_depend_on_it() {
    let with = run(without_programs);
    let without = run(|loaded| {
        without_programs(loaded);
        loaded.job.stock = None;
        loaded.job.technology = None;
    });
    assert!(without.result.removal.is_none());
    assert_eq!(with.result.flanks, without.result.flanks);
    assert_eq!(with.result.verdict, without.result.verdict);
}

#[test]
fn limits_stock_and_strokes_are_held_against_each_other() {
    let harder = run(|loaded| {
        without_programs(loaded);
        loaded.job.technology.as_mut().unwrap().limits.Qw_roughing = Some(2.0);
    });
    assert!(codes(&harder).contains(&"limit-exceeded"), "{:?}", codes(&harder));
    let thin = run(|loaded| {
        without_programs(loaded);
        loaded.job.stock.as_mut().unwrap().allowance_um = OneOrSides::Both(20.0);
    });
    for code in ["no-stock", "stroke-cuts-air"] {
        assert!(codes(&thin).contains(&code), "{:?}", codes(&thin));
    }
}

#[test]
fn what_is_not_worked_out_is_said() {
    let one = run(|loaded| {
        without_programs(loaded);
        loaded.job.grinding.flanks = job::tables::Flanks::Left;
    });
    assert!(one.result.removal.is_none());
    assert!(codes(&one).contains(&"removal-not-worked-out"), "{:?}", codes(&one));
}
