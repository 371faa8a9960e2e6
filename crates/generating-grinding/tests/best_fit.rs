//! Plans by a best fit: ordinary drawings with end reliefs, and the settings that carry a fitted profile.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use generating::{GrindingPlan, RatioReason};
use generating_grinding::job::{Job, LoadedJob};
use generating_grinding::workflow::{Execution, Outcome, Prepared, plan_job, prepare, simulate_job};
use job::{Source, parse_job_of};
use serde_json::{Value, json};
use verdict::Status;

/// Drawings as shops have them, one a line, with the names of their jobs.
const DRAWINGS: &str = include_str!("drawings.json");

pub fn drawing(name: &str) -> Value {
    let all: Vec<Value> = serde_json::from_str(DRAWINGS).unwrap();
    all.into_iter().find(|job| job["job"]["name"] == name).unwrap()
}

pub fn load(job: &Value) -> LoadedJob {
    parse_job_of::<Job>(Source::new("drawing.json", &job.to_string())).unwrap_or_else(|e| panic!("{e}"))
}

/// Largest deviation of a planned flank on points of no grid of the planner, mm.
fn farthest(ready: &Prepared, plan: &GrindingPlan) -> f64 {
    let grid = generating::PlanningGrid::new(&ready.setup, 23, 67);
    let of_flank = |flank: Flank| {
        let (made, target) = (plan.flanks[flank].as_ref()?, ready.targets[flank].as_ref()?);
        let ground = made.tool.ground(&ready.setup, flank, &grid, &plan.ideal.motion).unwrap();
        let wanted = grid.target(flank, target, ready.setup.lines[flank].cos_b2).unwrap();
        Some(ground.iter().zip(&wanted).map(|(g, t)| (g.f_n - t).abs()).fold(0.0, f64::max))
    };
    Flank::BOTH.into_iter().filter_map(of_flank).fold(0.0, f64::max)
}

/// The plan of a drawing, which is a best fit within the tolerance on points of no grid of the planner.
fn fitted(name: &str) -> (Prepared, Execution) {
    let ready = prepare(&load(&drawing(name))).unwrap_or_else(|e| panic!("{e:?}"));
    let plan = ready.task().plan().unwrap_or_else(|e| panic!("{name}: {e}"));
    assert_eq!(plan.choice.reason, RatioReason::BestFit, "{name}");
    let off = farthest(&ready, &plan);
    assert!(off <= ready.tolerance.tightest(), "{name}: {} um", off * 1e3);
    assert!(plan.determinant >= 0.1, "{name}: {}", plan.determinant);
    let execution = Execution::of_plan(&ready, &plan);
    (ready, execution)
}

fn refereed(loaded: &LoadedJob, run: impl Fn(&LoadedJob) -> Result<Outcome, run::RunFailure>) -> Outcome {
    let outcome = run(loaded).unwrap_or_else(|e| panic!("{e:?}"));
    assert_eq!(outcome.result.verdict.status(), Status::Met, "{:?}", outcome.result.verdict.reason());
    outcome
}

#[test]
fn the_referee_meets_an_end_relief_and_its_settings_run_again() {
    let mut job = drawing("d017");
    let planned = refereed(&load(&job), |loaded| plan_job(loaded, &Silent));
    for flank in planned.result.flanks.values() {
        // A tenth of the tolerance between plan and rays.
        assert!(
            flank.model_difference_um < 0.1 * planned.result.tolerance_um,
            "{}",
            flank.model_difference_um
        );
        // The drawing's values on the traces through the middle: within a tolerance beside 15 um of relief.
        let values: Vec<_> = flank.traces.iter().flat_map(|trace| &trace.values).collect();
        let symbols: Vec<&str> = values.iter().map(|value| value.symbol).collect();
        assert!(
            symbols.starts_with(&["C_alpha", "C_Halpha"]) && symbols.contains(&"C_alpha_a"),
            "{symbols:?}"
        );
        for value in values {
            assert!((value.made_um - value.target_um).abs() < planned.result.tolerance_um, "{value:?}");
        }
        for trace in &flank.traces {
            assert!(trace.tolerance_share > 1e-6 && trace.tolerance_share <= 1.0, "{trace:?}");
            assert!(trace.total_um >= trace.slope_um.abs() && trace.not_evaluated.is_empty(), "{trace:?}");
        }
    }
    let settings = serde_json::to_value(&planned.result.settings.settings).unwrap();
    assert!(
        settings["left"]["profile_pieces"]["breaks_mm"].as_array().is_some_and(|breaks| breaks.len() > 20)
    );
    job["settings"] = settings;
    let simulated = refereed(&load(&job), |loaded| simulate_job(loaded, &Silent));
    for (name, flank) in &planned.result.flanks {
        let again = &simulated.result.flanks[name];
        let rows = |f: &[Vec<f64>]| f.concat();
        for (a, b) in rows(&flank.planned_um).iter().zip(rows(&again.planned_um)) {
            // Settings pass through degrees and micrometres.
            assert!((a - b).abs() < 1e-5, "{a} {b}");
        }
    }
}

#[test]
fn a_fit_keeps_to_the_tip_of_the_worm_and_shifts_no_more_than_it_must() {
    // The contact of the free fit of d004 leaves the tip of the worm; d003 is a spur gear, whose end reliefs need no shift.
    for (name, ratio) in [("d004", None), ("d003", Some(0.0))] {
        let planned = refereed(&load(&drawing(name)), |loaded| plan_job(loaded, &Silent));
        let settings = &planned.result.settings;
        assert!(ratio.is_none_or(|ratio| settings.settings.diagonal_ratio == ratio), "{name}");
        let apart = planned.result.flanks.values().map(|flank| flank.model_difference_um).fold(0.0, f64::max);
        assert!(apart < 0.1 * planned.result.tolerance_um, "{name}: {apart} um");
    }
}

#[test]
fn pieces_of_a_profile_that_do_not_meet_are_refused_by_name() {
    let mut job = drawing("d031");
    let (_, execution) = fitted("d031");
    let mut settings = serde_json::to_value(execution.settings()).unwrap();
    settings["left"]["profile_pieces"]["coefficients"][3][0] = 4e3.into();
    job["settings"] = settings;
    let Err(failure) = simulate_job(&load(&job), &Silent) else { panic!("a profile with a step ran") };
    let said = format!("{failure:?}");
    assert!(said.contains("settings.left.profile_pieces"), "{said}");
}

#[test]
fn drawings_with_end_reliefs_are_made() {
    for name in ["d003", "d028", "d029"] {
        fitted(name);
    }
}

#[test]
fn a_plan_is_the_same_on_any_number_of_threads() {
    let once = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| fitted("d031").1.settings())
    };
    assert_eq!(once(1), once(3));
}

/// Every fourth of the ordinary drawings, from the second on: by the model, on points of no grid of the planner.
#[test]
fn thirty_ordinary_drawings_are_met() {
    let missed: Vec<String> = (1..120)
        .step_by(4)
        .filter_map(|k| {
            let name = format!("d{k:03}");
            let ready = prepare(&load(&drawing(&name))).unwrap_or_else(|e| panic!("{e:?}"));
            let plan = match ready.task().plan() {
                Ok(plan) => plan,
                Err(error) => return Some(format!("{name}: {error}")),
            };
            let off = farthest(&ready, &plan);
            (off > ready.tolerance.tightest()).then(|| format!("{name}: {} um", off * 1e3))
        })
        .collect();
    assert!(missed.is_empty(), "{missed:?}");
}

/// Points of the result grid are for reports: what is planned does not depend on them.
#[test]
fn the_grid_of_the_result_decides_nothing() {
    for name in ["d003", "d017", "d025"] {
        let on_grid = |points: u32| {
            let mut job = drawing(name);
            job["grid"] = json!({ "profile_points": points, "helix_points": points });
            let ready = prepare(&load(&job)).unwrap_or_else(|e| panic!("{e:?}"));
            let plan = ready.task().plan().unwrap_or_else(|e| panic!("{name}: {e}"));
            (farthest(&ready, &plan), ready.tolerance.tightest())
        };
        let (off, tolerance) = on_grid(41);
        for points in [11, 121] {
            let (other, _) = on_grid(points);
            // 2 % of the tolerance: points of the judging grid that fall elsewhere tell no more than that of one flank.
            assert!((other - off).abs() <= 0.02 * tolerance, "{name}, {points} points: {other} and {off} mm");
            assert_eq!(other <= tolerance, off <= tolerance, "{name}, {points} points");
        }
    }
}
