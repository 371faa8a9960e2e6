//! Stock, strokes, load of the worm, time and cost of a planned gear.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use generating_grinding::job::{CycleRule, LoadedJob, Stock, StrokeOfJob, StrokeShift, Technology};
use generating_grinding::page::html_page;
use generating_grinding::workflow::programs::OnGrinding;
use generating_grinding::workflow::referee::{self, Cutting};
use generating_grinding::workflow::removal::{CycleResult, put_on_stock};
use generating_grinding::workflow::{JobResult, Outcome, plan_job};
use grinding_technology::Ground;
use job::read_job_of;
use job::tables::OneOrSides;
use motion::track;
use run::RunFailure;
use std::path::PathBuf;
use verdict::Status;

fn load(name: &str) -> LoadedJob {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/cycles").join(name);
    let mut loaded: LoadedJob = read_job_of(&path).unwrap();
    (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (5, 5);
    loaded
}

fn planned(loaded: &LoadedJob) -> Outcome {
    plan_job(loaded, &Silent).unwrap_or_else(|e| panic!("{e:?}"))
}

fn run(change: impl FnOnce(&mut LoadedJob)) -> Outcome {
    let mut loaded = load("planet-gear.toml");
    change(&mut loaded);
    planned(&loaded)
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
    let by_law = time.grinding_by_law_s.unwrap();
    assert!((by_law / time.grinding_s - 1.0).abs() < 1e-3, "{by_law} s by the law, {} s", time.grinding_s);
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
    assert_eq!(with.result.verdict.status(), without.result.verdict.status());
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
        loaded.job.stock.as_mut().unwrap().allowance_um = Some(OneOrSides::Both(20.0));
    });
    assert!(codes(&thin).contains(&"stroke-cuts-air"), "{:?}", codes(&thin));
    // A flank that does not clean up is no flank of the drawing, however well it is ground where there is material.
    assert_eq!(thin.result.verdict.status(), Status::Missed);
    let reason = thin.result.verdict.reason().unwrap();
    assert!(reason.code == "no-stock" && reason.way_out.contains("stock.allowance_um"), "{reason:?}");
}

#[test]
fn what_is_not_worked_out_is_said() {
    let path =
        PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/beveloid-cylindrical-worm.toml");
    let mut loaded: LoadedJob = read_job_of(&path).unwrap();
    (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (5, 5);
    loaded.job.stock = load("planet-gear.toml").job.stock.map(|stock| Stock { profile: Vec::new(), ..stock });
    let one = planned(&loaded);
    assert!(one.result.removal.is_none());
    assert!(codes(&one).contains(&"removal-not-worked-out"), "{:?}", codes(&one));
}

/// Time of the grinding programs over that by the law of moves from rest to rest.
fn time_over_law(outcome: &Outcome) -> f64 {
    let time = outcome.result.removal.as_ref().unwrap().part_time.unwrap();
    time.grinding_s / time.grinding_by_law_s.unwrap()
}

/// A flank that is ground by itself: only its stock counts.
#[test]
fn one_flank_is_ground_by_itself() {
    let outcome = run(|loaded| {
        loaded.job.grinding.flanks = job::tables::Flanks::Left;
        loaded.job.stock.as_mut().unwrap().allowance_um = Some(OneOrSides::Each { left: 110.0, right: -5.0 });
    });
    let removal = outcome.result.removal.as_ref().unwrap();
    assert_eq!(removal.strokes.len(), 3);
    for stroke in &removal.strokes {
        assert!(stroke.flanks.left.is_some() && stroke.flanks.right.is_none());
        assert!(stroke.left_um.right.is_none());
    }
    // What is missing on the flank that is not ground is not judged.
    assert_eq!(outcome.result.verdict.status(), Status::Met, "{:?}", outcome.result.verdict);
    let both = run(without_programs);
    let left = |outcome: &Outcome| outcome.result.removal.as_ref().unwrap().strokes[0].flanks.left.unwrap();
    assert_eq!(left(&outcome).depth_um, left(&both).depth_um);
    assert!((time_over_law(&outcome) - 1.0).abs() < 0.01, "{}", time_over_law(&outcome));
    let page = html_page(&outcome, &[]).unwrap();
    assert!(page.contains("<h2>Stock, strokes and cost</h2>"));
}

/// A motion that brings the flanks into contact one after the other has every stroke twice.
#[test]
fn flanks_are_ground_one_after_the_other() {
    let mut together = run(without_programs);
    let mut execution = together.execution.clone();
    execution.motion.phase.left += 0.3;
    assert!(!execution.grinds_both_at_once());
    let cycle = put_on_stock(&mut together.prepared, &execution).unwrap().unwrap();
    let both = together.result.removal.as_ref().unwrap();
    let strokes = &cycle.cycle.strokes;
    assert_eq!(strokes.len(), 6);
    for (k, both) in both.strokes.iter().enumerate() {
        let [left, right] = [&strokes[k], &strokes[k + 3]];
        assert!(
            left.stroke.ground == Ground::Only(Flank::Left)
                && right.stroke.ground == Ground::Only(Flank::Right)
        );
        let taken = left.volume + right.volume;
        assert!((taken - both.volume_mm3).abs() < 1e-9 * (1.0 + taken), "{taken} {}", both.volume_mm3);
    }
    // Programs drive a flank's own strokes for it.
    let technology = &together.prepared.technology;
    assert_eq!((technology.strokes.len(), technology.strokes_of_a_pass()), (6, 3));
    assert!(
        technology.strokes.iter().map(|stroke| stroke.ground).eq(strokes.iter().map(|f| f.stroke.ground))
    );
    // Cycles within the limits know that every stroke is made twice.
    let fastest = cycle.offers.unwrap().optimum.best.cycle.unwrap();
    assert!(fastest.time > both.cycles.as_ref().unwrap().fastest.part_s);
}

/// A shift that is not straight loads the worm where it stands: the example of a ratio that varies, on stock.
#[test]
fn a_ratio_that_varies_is_worked_out() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/variable-ratio.toml");
    let mut loaded: LoadedJob = read_job_of(&path).unwrap();
    (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (5, 5);
    let cycle = load("planet-gear.toml").job;
    loaded.job.stock = cycle.stock.map(|stock| Stock { profile: Vec::new(), run_out: None, ..stock });
    let technology = cycle.technology.unwrap();
    loaded.job.technology = Some(Technology { times: None, cost: None, ..technology });
    let outcome = planned(&loaded);
    let removal = outcome.result.removal.as_ref().unwrap();
    let law = &outcome.execution.motion.shift;
    assert!(!law.is_affine());
    let stroke = removal.strokes.last().unwrap();
    let [from, to] = stroke.contact_mm;
    assert!((stroke.diagonal_ratio - (law.value(to) - law.value(from)) / (to - from)).abs() < 1e-12);
    let load = removal.worm_load.as_ref().unwrap();
    assert!(load.parts_per_dressing > 0 && load.removed_mm3_per_mm.left.iter().all(|v| *v == 0.0));
    // Where the shift is steeper the load is thinner: the largest stands where it is flattest.
    let largest = load.removed_mm3_per_mm.right.iter().copied().fold(0.0, f64::max);
    let mean = load.removed_mm3_per_mm.right.iter().sum::<f64>() / load.removed_mm3_per_mm.right.len() as f64;
    assert!(largest > 1.2 * mean, "{largest} {mean}");
}

/// The cheapest cycle never costs more than the others, by the rates of the shop.
#[test]
fn the_cheapest_cycle_is_taken_where_it_is_asked_for() {
    let outcome = run(|loaded| {
        without_programs(loaded);
        let machine = loaded.job.machine.as_mut().unwrap();
        (machine.roughing_stock_um, machine.spark_out) = (Vec::new(), 0);
        loaded.job.grinding.feed_per_revolution = None;
        let technology = loaded.job.technology.as_mut().unwrap();
        technology.cycle = Some(CycleRule::Cheapest);
        technology.cost.as_mut().unwrap().worm_price = 30_000.0;
    });
    let removal = outcome.result.removal.as_ref().unwrap();
    let cycles = removal.cycles.as_ref().unwrap();
    let cheapest = cycles.cheapest.unwrap();
    let cost = |cycle: &CycleResult| cycle.cost_per_part.unwrap();
    assert!(cost(&cheapest) <= cost(&cycles.fastest).min(cost(&cycles.standard)));
    assert!(cheapest.part_s >= cycles.fastest.part_s);
    assert_eq!(removal.strokes.len(), cheapest.roughing_strokes + 1);
}

/// What a rule chooses keeps the limits and comes near one with every stroke; the fastest is never slower than the standard cycle.
#[test]
fn cycles_by_a_rule_use_their_limits() {
    for (name, rule) in [("truck-gear.toml", CycleRule::Standard), ("ev-gear.toml", CycleRule::Fastest)] {
        let mut loaded = load(name);
        assert_eq!(loaded.job.technology.as_ref().unwrap().cycle, Some(rule));
        without_programs(&mut loaded);
        let outcome = planned(&loaded);
        let removal = outcome.result.removal.as_ref().unwrap();
        for (k, stroke) in removal.strokes.iter().enumerate() {
            let near = stroke.nearest_limit.as_ref().unwrap();
            assert!(near.share > 0.97 && near.share <= 1.0 + 1e-9, "{name}, stroke {}: {near:?}", k + 1);
        }
        let cycles = removal.cycles.as_ref().unwrap();
        assert!(cycles.fastest.part_s <= cycles.standard.part_s);
        let chosen = if rule == CycleRule::Standard { cycles.standard } else { cycles.fastest };
        assert_eq!(removal.strokes.len(), chosen.roughing_strokes + 1);
        let finishing = removal.strokes.last().unwrap();
        assert!((finishing.flanks.left.unwrap().depth_um - chosen.finishing_um).abs() < 0.1);
    }
}

/// A stroke that leaves other amounts on either flank, as the referee's rays find them before and after: within 0.01 um of what is stated.
/// Without modifications: those that lie on the worm's lines are displaced with the contact by the infeed, 0.7 um here.
#[test]
fn rays_find_what_a_stroke_leaves() {
    let mut loaded = load("spur-gear.toml");
    without_programs(&mut loaded);
    loaded.job.target.modifications = Some(Vec::new());
    let run = planned(&loaded);
    let outcome = &run.result.removal.as_ref().unwrap().strokes[0];
    let (left, infeed) = (outcome.left_um.map(|_, um| um.unwrap()), outcome.infeed_um * 1e-3);
    assert!(left.left != left.right);
    let lines = &run.prepared.setup.lines;
    // The other equation of both flanks: c_F = delta_d sin(alpha_n) - s B delta_phi_2.
    let turned = |flank: Flank| {
        let line = &lines[flank];
        (infeed * line.sin_an - 1e-3 * left[flank]) / (flank.sign() * line.lever)
    };
    assert!((turned(Flank::Left) - turned(Flank::Right)).abs() < 1e-12);
    let mut raised = run.execution.clone();
    raised.motion.delta_d = raised.motion.delta_d.raised(infeed);
    raised.motion.delta_phi_2 = raised.motion.delta_phi_2.raised(turned(Flank::Left));
    let cutting = Cutting { feed_per_revolution: None, strokes: None };
    let of = |execution| referee::run(&run.prepared.setup, execution, cutting, &Silent).unwrap();
    let (before, after) = (of(&raised), of(&run.execution));
    for flank in Flank::BOTH {
        let (before, after) = (before[flank].as_ref().unwrap(), after[flank].as_ref().unwrap());
        let stands = before.simulated.minus(&after.simulated);
        let off = stands.f.iter().map(|f| (1e3 * f - left[flank]).abs()).fold(0.0, f64::max);
        assert!(off < 0.01, "the {flank} flank keeps {} um, {off} um off", left[flank]);
    }
}

/// Programs up and down are proven; a text whose worm comes in where stock is met is not.
#[test]
fn strokes_up_and_down_are_driven_and_proven() {
    let loaded = load("spur-gear.toml");
    let run = planned(&loaded);
    let programs = run.result.programs.as_ref().unwrap();
    let grinding = programs.programs.iter().find(|program| program.job == "grinding").unwrap();
    let removal = run.result.removal.as_ref().unwrap();
    assert_eq!(grinding.passes.len(), removal.strokes.len());
    for (pass, stroke) in grinding.passes.iter().zip(&removal.strokes) {
        let ([from, to], [first, last]) = (pass.driven_mm, stroke.contact_mm);
        let sense = (to - from).signum();
        assert_eq!(sense > 0.0, stroke.direction == "up");
        assert!(
            sense * (first - from) > 0.0 && sense * (to - last) > 0.0,
            "{}: the whole contact",
            pass.name
        );
    }
    assert!(programs.clearance.as_ref().unwrap().statement.contains("in the tooth spaces"));
    assert!(!codes(&run).contains(&"approach-too-short"), "{:?}", codes(&run));
    // The same text on a blank with five times the stock: contact begins where the worm comes in.
    let mut thick = load("spur-gear.toml");
    thick.job.stock.as_mut().unwrap().allowance_um = Some(OneOrSides::Both(600.0));
    let bodies = OnGrinding::new(&thick, &Silent).unwrap();
    let built = &run.programs.as_ref().unwrap().built.programs;
    let text = built.iter().find(|program| program.file.contains("/grinding-")).unwrap();
    let machine = &run.prepared.machine.as_ref().unwrap().machine;
    let tracked = track(&text.read, machine, &text.words, &text.start).unwrap();
    let followed = bodies.follow(machine, &tracked).unwrap();
    assert!(followed.faults.iter().any(|fault| fault.code == "program-not-clear"), "{:?}", followed.faults);
    let own = OnGrinding::new(&loaded, &Silent).unwrap().follow(machine, &tracked).unwrap();
    assert!(own.faults.is_empty(), "{:?}", own.faults);
}

#[test]
fn no_cycle_within_the_limits_names_the_one_that_binds() {
    let mut loaded = load("ev-gear.toml");
    without_programs(&mut loaded);
    let limits = &mut loaded.job.technology.as_mut().unwrap().limits;
    (limits.least_feed, limits.Qw_finishing) = (Some(0.5), Some(0.2));
    let Err(RunFailure::NotProducible(finding)) = plan_job(&loaded, &Silent) else { panic!("a cycle") };
    assert_eq!(finding.code, "no-feasible-plan");
    assert_eq!(finding.field.as_deref(), Some("technology.limits.Qw_finishing"));
}

/// A stroke that shifts by another ratio leaves another twist: what it is to leave has to cover it, or the finished flank is damaged before it
/// is ground.
#[test]
fn roughing_with_a_ratio_of_its_own_stays_above_the_finished_flank() {
    let judged = |left_um: f64, ratio: f64| {
        let mut loaded = load("truck-gear.toml");
        without_programs(&mut loaded);
        let technology = loaded.job.technology.as_mut().unwrap();
        technology.cycle = None;
        technology.strokes = [(left_um, Some(ratio)), (0.0, None)]
            .map(|(left_um, ratio)| StrokeOfJob {
                left_um: OneOrSides::Both(left_um),
                feed_per_revolution: Some(0.3),
                cutting_speed_m_per_s: None,
                direction: None,
                shift: ratio.map(|ratio| StrokeShift { ratio: Some(ratio), ..StrokeShift::default() }),
                overrun: None,
                dwell_s: None,
                zone: None,
                modification_share: None,
            })
            .to_vec();
        planned(&loaded).result
    };
    let item = |result: &JobResult| {
        let found = result.verdict.judged().iter().find(|one| one.item.contains("left flank after stroke 1"));
        found.unwrap_or_else(|| panic!("{:?}", result.verdict)).clone()
    };
    // A pair of words before the number says which side it is on.
    let height = |result: &JobResult| -> f64 {
        let detail = item(result).detail;
        let number = detail.split(' ').find_map(|word| word.parse::<f64>().ok()).unwrap();
        if detail.contains("below") { -number } else { number }
    };
    let covered = judged(60.0, 0.0);
    assert_eq!(
        (covered.verdict.status(), item(&covered).status),
        (Status::Met, Status::Met),
        "{:?}",
        covered.verdict
    );
    // The ratio of the plan leaves the plan's flank, raised as it was asked for.
    let planned_ratio = covered.settings.settings.diagonal_ratio;
    assert!(
        (height(&judged(1.0, planned_ratio)) - 1.0).abs() < 0.03,
        "{}",
        height(&judged(1.0, planned_ratio))
    );
    // Without a shift the natural twist takes more than the stroke leaves.
    let bare = judged(0.1, 0.0);
    assert_eq!(bare.verdict.status(), Status::Missed);
    assert_eq!(bare.verdict.reason().unwrap().code, "roughing-below-finished");
    assert!(height(&bare) < -0.1, "{}", height(&bare));
}
