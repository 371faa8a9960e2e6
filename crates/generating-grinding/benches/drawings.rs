//! Plans the 120 ordinary drawings of `tests/drawings.json`, or another file that holds an array of jobs: seconds of each plan in process,
//! without the referee, their median and 95th percentile, and what the exact contact finds on points that no fit uses.
//!
//! `cargo bench -p flankwright-generating-grinding --bench drawings -- [FILE.json] [--every N] [--rules] [--referee] [--machine NAME] [NAME ...]`;
//! with `--every` each Nth drawing, with `--rules` by the rules of planning alone, with `--referee` the whole run and its verdict, with
//! `--machine` the whole run on a machine of `machines/` with the proof of its program. `make drawings` runs them all.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use generating::{GrindingPlan, PlanningGrid};
use generating_grinding::job::{Job, LoadedJob};
use generating_grinding::workflow::{FlankResult, Prepared, plan_job, prepare};
use job::{Source, parse_job_of};
use serde_json::{Value, json};
use std::error::Error;
use std::num::NonZero;
use std::path::PathBuf;
use std::time::Instant;
use verdict::Status;

/// Points over profile and face width on which plans are judged here, moved off every grid of the planner.
const JUDGED: [usize; 2] = [37, 97];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut flag = |name: &str| {
        let before = arguments.len();
        arguments.retain(|argument| argument != name);
        arguments.len() < before
    };
    // Cargo adds it.
    flag("--bench");
    let (with_referee, by_rules) = (flag("--referee"), flag("--rules"));
    let mut value_of = |name: &str| {
        let place = arguments.iter().position(|argument| argument == name)?;
        arguments.remove(place);
        (place < arguments.len()).then(|| arguments.remove(place))
    };
    let machine = value_of("--machine");
    let every = value_of("--every").map_or(Ok(NonZero::<usize>::MIN), |every| every.parse())?;
    let file = match arguments.iter().position(|argument| argument.ends_with(".json")) {
        Some(place) => PathBuf::from(arguments.remove(place)),
        None => PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/drawings.json")),
    };
    let mut all: Vec<Value> = serde_json::from_str(&std::fs::read_to_string(file)?)?;
    if let Some(machine) = &machine {
        let file = format!("{}/../../machines/{machine}.toml", env!("CARGO_MANIFEST_DIR"));
        for job in &mut all {
            job["machine"] = json!({ "file": file });
            job["output"] = json!({ "programs": ["siemens"], "tables": [] });
        }
    }
    let named = |job: &Value| {
        let name = job["job"]["name"].as_str().unwrap_or("unnamed").to_owned();
        (name, job.to_string())
    };
    let mut jobs: Vec<(String, String)> = all.iter().step_by(every.get()).map(named).collect();
    jobs.retain(|(name, _)| arguments.is_empty() || arguments.contains(name));
    let (mut met, mut missed, mut refused) = (0, 0, 0);
    let mut times = Vec::new();
    let mut counts = [0; 3];
    for (name, text) in &jobs {
        let loaded = parse_job_of::<Job>(Source::new("drawing.json", text))?;
        if with_referee || machine.is_some() {
            refereed(name, &loaded, &mut counts);
            continue;
        }
        let ready = match prepare(&loaded) {
            Ok(ready) => ready,
            Err(failure) => {
                refused += 1;
                println!("{name} refused before planning: {failure:?}");
                continue;
            }
        };
        let tolerance = ready.tolerance.tightest() * 1e3;
        let begun = Instant::now();
        let task = ready.task();
        let planned = if by_rules { task.plan_by_rules() } else { task.plan_or_tried() };
        let took = begun.elapsed().as_secs_f64();
        times.push(took);
        match planned {
            Ok(plan) => {
                let off = judged(&ready, &plan);
                let (word, count) = if off.is_some_and(|off| off <= tolerance) {
                    ("met", &mut met)
                } else {
                    ("missed", &mut missed)
                };
                *count += 1;
                println!(
                    "{name} {word} {:.3} of {tolerance} um, ratio {:.4} ({:?}), determinant {:.3}, {took:.3} s",
                    off.unwrap_or(f64::NAN),
                    plan.choice.ratio,
                    plan.choice.reason,
                    plan.determinant,
                );
            }
            Err(no) => {
                refused += 1;
                println!("{name} refused {} ({took:.3} s)", no.error);
            }
        }
    }
    if with_referee || machine.is_some() {
        let [met, missed, refused] = counts;
        println!("{met} met, {missed} missed, {refused} refused of {}", jobs.len());
        return Ok(());
    }
    times.sort_by(f64::total_cmp);
    let at = |share: f64| times.get((share * (times.len() as f64 - 1.0)) as usize).copied().unwrap_or(0.0);
    println!("{met} met, {missed} missed, {refused} refused of {}", jobs.len());
    println!("seconds: median {:.3}, 95 % {:.3}, longest {:.3}", at(0.5), at(0.95), at(1.0));
    Ok(())
}

/// Largest deviation of the planned flank, um; `None` where the contact is lost.
fn judged(ready: &Prepared, plan: &GrindingPlan) -> Option<f64> {
    let setup = &ready.setup;
    let grid = PlanningGrid::new(setup, JUDGED[0], JUDGED[1]);
    let mut largest: f64 = 0.0;
    for flank in Flank::BOTH {
        let (Some(made), Some(target)) = (&plan.flanks[flank], &ready.targets[flank]) else { continue };
        let ground = made.tool.ground(setup, flank, &grid, &plan.ideal.motion).ok()?;
        let wanted = grid.target(flank, target, setup.lines[flank].cos_b2).ok()?;
        largest = ground.iter().zip(&wanted).map(|(g, t)| (g.f_n - t).abs()).fold(largest, f64::max);
    }
    Some(largest * 1e3)
}

/// The verdict of the whole run, the largest deviation that the referee finds and how far plan and referee are apart.
fn refereed(name: &str, loaded: &LoadedJob, counts: &mut [usize; 3]) {
    match plan_job(loaded, &Silent) {
        Ok(outcome) => {
            let result = &outcome.result;
            counts[usize::from(result.verdict.status() != Status::Met)] += 1;
            let largest =
                |value: fn(&FlankResult) -> f64| result.flanks.values().map(value).fold(0.0, f64::max);
            println!(
                "{name} {:?} {} {:.3} of {} um, apart {:.4} um, ratio {:.4}, {:?}",
                result.verdict.status(),
                result.verdict.reason().map_or("", |reason| reason.code),
                largest(|flank| flank.max_deviation_um),
                result.tolerance_um,
                largest(|flank| flank.model_difference_um),
                result.settings.settings.diagonal_ratio,
                result.timing_s,
            );
        }
        Err(failure) => {
            counts[2] += 1;
            println!("{name} refused {failure:?}");
        }
    }
}
