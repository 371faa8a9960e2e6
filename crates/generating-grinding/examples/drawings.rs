//! Plans every job of a folder without the referee and says what the exact contact finds on points that no fit uses.
//!
//! `cargo run --profile demo -p flankwright-generating-grinding --example drawings -- FOLDER [--fit] [--referee] [NAME ...]`; with
//! `--fit` what the rules miss is planned by a best fit, with `--referee` the whole run of the rules follows, and its verdict.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use generating::{GrindingPlan, PlanningGrid};
use generating_grinding::job::{Job, LoadedJob};
use generating_grinding::workflow::{Prepared, plan_job, prepare};
use job::read_job_of;
use std::error::Error;
use std::path::PathBuf;
use std::time::Instant;

/// Points over profile and face width on which plans are judged here, moved off every grid of the planner.
const JUDGED: [usize; 2] = [37, 97];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1);
    let folder = PathBuf::from(arguments.next().ok_or("a folder with jobs is wanted")?);
    let mut names: Vec<_> = arguments.collect();
    let with_referee = names.iter().any(|name| name == "--referee");
    let by_fit = names.iter().any(|name| name == "--fit");
    names.retain(|name| name != "--referee" && name != "--fit");
    let mut jobs: Vec<PathBuf> =
        std::fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<Result<_, std::io::Error>>()?;
    jobs.retain(|path| {
        let named = |name| path.file_stem().is_some_and(|stem| stem == name);
        path.extension().is_some_and(|e| e == "json") && (names.is_empty() || names.iter().any(named))
    });
    jobs.sort();
    let (mut met, mut missed, mut refused) = (0, 0, 0);
    let mut times = Vec::new();
    for path in &jobs {
        let name = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        let loaded = read_job_of::<Job>(path)?;
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
        let planned = if by_fit { task.plan_or_fitted() } else { task.plan_or_tried() };
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
        if with_referee {
            refereed(&loaded);
        }
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

/// The verdict of the whole run, and how far plan and referee are apart.
fn refereed(loaded: &LoadedJob) {
    match plan_job(loaded, &Silent) {
        Ok(outcome) => {
            let result = &outcome.result;
            println!(
                "    {:?} {:?}",
                result.verdict.status(),
                result.verdict.reason().map(|reason| &reason.code)
            );
            for (name, flank) in &result.flanks {
                println!(
                    "    {name}: {:.3} um, model and referee apart by {:.4} um",
                    flank.max_deviation_um, flank.model_difference_um
                );
            }
        }
        Err(failure) => println!("    {failure:?}"),
    }
}
