//! `[explore]` of the electronic gearbox: every combination of scale, clock, interpolation and encoder judged by its error budget at the
//! flank, ranked by cost; the cheapest that is accurate enough is simulated.

use super::couple::{coupling, of_feed};
use super::figures::{budget, counting};
use super::result::{BestSetUpResult, ExploreResult, SetUpResult};
use super::stimulus::{Driven, of_motion};
use crate::job::{GearboxExplore, GearboxJob};
use control::Extremes;
use electronic_gearbox::Error as GearboxError;
use electronic_gearbox::coefficient::GearGeometry;
use foundation::numerics::Progress;
use job::Diagnostic;
use run::RunFailure;
use run::control::{interpolation, on_field};
use std::f64::consts::TAU;
use verdict::Remark;

/// Set-ups that one job may compare.
pub const MOST_SET_UPS: usize = 20_000;

/// The rule of the ranking, in words.
const RANKING: &str = "accurate and fast enough before the others, those by cost, then by error; the others by error, those without a coupling last";

/// Judges all set-ups; the remark says why none is accurate enough, if so.
///
/// # Errors
/// [`RunFailure`]: more than [`MOST_SET_UPS`], and what the interpolator or the motion says of the simulated one.
pub(super) fn explore(
    job: &GearboxJob,
    given: &GearboxExplore,
    gear: &GearGeometry,
    driven: &Driven,
    progress: &dyn Progress,
) -> Result<(ExploreResult, Option<Remark>), RunFailure> {
    let (speed, acceleration) = drive(given, driven);
    let jobs = set_ups(job, given)?;
    progress.start("set-ups", jobs.len() as u64);
    let travel = travel(job, driven);
    let mut set_ups = Vec::with_capacity(jobs.len());
    for (set_up, cost) in &jobs {
        set_ups.push(judge(set_up, *cost, gear, [speed, acceleration], travel, given.wanted_um)?);
        progress.advance(1);
    }
    progress.finish();
    set_ups.sort_by(|a, b| {
        let last = |s: &SetUpResult| s.flank_um.unwrap_or(f64::INFINITY);
        let by_error = last(a).total_cmp(&last(b));
        let by_cost =
            if a.feasible && b.feasible { a.cost.total_cmp(&b.cost) } else { std::cmp::Ordering::Equal };
        b.feasible.cmp(&a.feasible).then(by_cost).then(by_error).then(a.cost.total_cmp(&b.cost))
    });
    for (k, set_up) in set_ups.iter_mut().enumerate() {
        set_up.rank = k + 1;
    }
    let feasible = set_ups.iter().filter(|set_up| set_up.feasible).count();
    let first = set_ups.first().filter(|set_up| set_up.feasible);
    let best = first.map(|set_up| simulate(job, set_up, gear, driven)).transpose()?;
    let reason = if best.is_none() { Some(nothing(&set_ups, given, speed)) } else { None };
    let result = ExploreResult {
        wanted_um: given.wanted_um,
        speed_mm_per_min: 60.0 * speed,
        acceleration_mm_per_s2: acceleration,
        feasible,
        ranking: RANKING,
        best,
        set_ups,
    };
    Ok((result, reason))
}

/// Speed (mm/s) and acceleration (mm/s^2) that the budget is for.
fn drive(given: &GearboxExplore, driven: &Driven) -> (f64, f64) {
    let (speed, acceleration) = driven.motion.as_ref().map_or((0.0, 0.0), |motion| motion.greatest());
    (
        given.speed_mm_per_min.map_or(speed, |per_minute| per_minute / 60.0),
        given.acceleration_mm_per_s2.unwrap_or(acceleration),
    )
}

/// Way over which the rounding of a ratio adds up, mm.
fn travel(job: &GearboxJob, driven: &Driven) -> f64 {
    // Distance of the outermost lines; the scales to choose from have the same slide.
    interpolation(&job.feed, "").map_or(0.0, |interpolation| driven.travel(&interpolation))
}

/// Every combination as a job of its own, with its cost.
fn set_ups(job: &GearboxJob, given: &GearboxExplore) -> Result<Vec<(GearboxJob, f64)>, RunFailure> {
    let counts = [given.scales.len(), given.clocks.len(), given.interpolations.len(), given.encoders.len()];
    let combinations: usize = counts.iter().map(|count| count.max(&1)).product();
    if combinations > MOST_SET_UPS {
        let message = format!("the lists of [explore] make {combinations} combinations");
        return Err(RunFailure::bad_input(
            Diagnostic::with_code("too-many-combinations", message)
                .field("explore")
                .value(combinations)
                .allowed(format!("up to {MOST_SET_UPS}"))
                .way_out("leave entries out; compare a few of each first"),
        ));
    }
    let plain = GearboxJob { explore: None, servo: None, ..job.clone() };
    let mut all = vec![(plain, 0.0)];
    all = varied(all, &given.scales, |job, choice| {
        job.feed.pulses_per_metre = choice.pulses_per_metre;
        choice.cost
    });
    all = varied(all, &given.clocks, |job, choice| {
        job.feed.clock_hz = choice.clock_hz;
        choice.cost
    });
    all = varied(all, &given.interpolations, |job, choice| {
        job.feed.pulses_per_interval = choice.pulses_per_interval;
        choice.cost
    });
    all = varied(all, &given.encoders, |job, choice| {
        job.workpiece.pulses_per_revolution = choice.pulses_per_revolution;
        choice.cost
    });
    Ok(all)
}

/// Every job with every choice, which `set` puts into it and gives the cost of; the jobs themselves without choices.
fn varied<C>(
    jobs: Vec<(GearboxJob, f64)>,
    choices: &[C],
    set: impl Fn(&mut GearboxJob, &C) -> f64,
) -> Vec<(GearboxJob, f64)> {
    if choices.is_empty() {
        return jobs;
    }
    let with = |(job, cost): &(GearboxJob, f64), choice: &C| {
        let mut job = job.clone();
        let more = set(&mut job, choice);
        (job, cost + more)
    };
    jobs.iter().flat_map(|job| choices.iter().map(move |choice| with(job, choice))).collect()
}

/// The budget of one set-up.
fn judge(
    job: &GearboxJob,
    cost: f64,
    gear: &GearGeometry,
    drive: [f64; 2],
    travel: f64,
    wanted_um: f64,
) -> Result<SetUpResult, RunFailure> {
    let interpolation = interpolation(&job.feed, "")?;
    let pressure_angle = job.gear.normal_pressure_angle_deg.to_radians();
    let budget =
        budget(gear, pressure_angle, &interpolation, drive, None).map_err(|error| of_feed(&error))?;
    let flank = |millimetres: f64| millimetres * 1e3 * budget.flank_share;
    let p = f64::from(interpolation.settings.pulses_per_interval());
    let part_um = TAU * gear.flank_per_angle() / (f64::from(job.workpiece.pulses_per_revolution) * p);
    let resolution_um = 0.5 * part_um;
    let mut set_up = SetUpResult {
        rank: 0,
        pulses_per_metre: job.feed.pulses_per_metre,
        clock_hz: job.feed.clock_hz,
        pulses_per_interval: job.feed.pulses_per_interval,
        pulses_per_revolution: job.workpiece.pulses_per_revolution,
        cost,
        quantisation_um: flank(budget.quantisation),
        clock_um: flank(budget.truncation + budget.synchronisation),
        acceleration_um: flank(budget.acceleration),
        resolution_um,
        rounding_um: None,
        flank_um: None,
        greatest_speed_mm_per_min: 60.0 * budget.greatest_speed,
        feasible: false,
        refused: None,
    };
    match coupling(gear, &job.workpiece, &interpolation) {
        Ok(rotation) => {
            // Half the stretch in which counting stays, beyond the half part that is resolution already.
            let [below, above] = counting(&rotation);
            let counted = (0.5 * (above - below) - 0.5) * part_um;
            let word = rotation.error_per_metre(interpolation.pitch / p).abs() * 1e-3 * travel;
            let rounding = counted + word * gear.flank_per_angle();
            let sum = budget.flank_um + resolution_um + rounding;
            (set_up.rounding_um, set_up.flank_um) = (Some(rounding), Some(sum));
            set_up.refused = if budget.speed > budget.greatest_speed {
                Some("interpolator-too-fast")
            } else if sum > wanted_um {
                Some("not-accurate-enough")
            } else {
                None
            };
            set_up.feasible = set_up.refused.is_none();
        }
        Err(error @ GearboxError::CoefficientTooLarge { .. }) => set_up.refused = Some(error.code()),
        Err(error) => return Err(on_field(&error, "explore")),
    }
    Ok(set_up)
}

/// Runs the motion of the job through a set-up.
fn simulate(
    job: &GearboxJob,
    set_up: &SetUpResult,
    gear: &GearGeometry,
    driven: &Driven,
) -> Result<BestSetUpResult, RunFailure> {
    let unmeasured = BestSetUpResult { set_up: *set_up, measured_steady_um: None, measured_whole_um: None };
    let Some(motion) = &driven.motion else { return Ok(unmeasured) };
    let mut feed = job.feed;
    feed.pulses_per_metre = set_up.pulses_per_metre;
    feed.clock_hz = set_up.clock_hz;
    feed.pulses_per_interval = set_up.pulses_per_interval;
    let workpiece =
        crate::job::GearboxWorkpiece { pulses_per_revolution: set_up.pulses_per_revolution, ..job.workpiece };
    let interpolation = interpolation(&feed, "")?;
    let refused = |error: GearboxError| on_field(&error, "explore");
    let rotation = coupling(gear, &workpiece, &interpolation).map_err(refused)?;
    let again = of_motion(motion.clone(), job.stimulus.rest_or_default(), &interpolation)?;
    let run = interpolation
        .run(&again.references, again.last_tick, Some(motion), Some(&rotation), &mut |_, _| {})
        .map_err(refused)?;
    let largest = |e: Extremes, um: f64| e.greatest.max(-e.least) * um;
    Ok(BestSetUpResult {
        measured_steady_um: run.steady.map(|e| largest(e, 1e3 * gear.flank_per_axial())),
        measured_whole_um: run.angle.map(|e| largest(e, gear.flank_per_angle())),
        ..unmeasured
    })
}

/// Why nothing is accurate enough, by the part that weighs most in the most accurate set-up.
fn nothing(set_ups: &[SetUpResult], given: &GearboxExplore, speed: f64) -> Remark {
    let code = "no-set-up-accurate-enough";
    let wanted = given.wanted_um;
    let makeable = || set_ups.iter().filter_map(|s| Some((s, s.flank_um?, s.rounding_um?)));
    let fast = makeable().find(|(s, ..)| s.refused != Some("interpolator-too-fast"));
    let Some((best, sum, rounding)) = fast else {
        return if makeable().next().is_some() {
            Remark {
                code,
                text: format!("no set-up follows a feed of {:.6} mm/min", 60.0 * speed),
                way_out: "feed slower, or offer faster clocks, coarser scales or fewer pulses per interval"
                    .into(),
            }
        } else {
            Remark {
                code,
                text: "for every set-up the coefficient is too large for a rate multiplier".into(),
                way_out: "offer finer scales or encoders with fewer pulses, or take rate = \"exact\"".into(),
            }
        };
    };
    let parts = [
        (
            "the staircase of the interpolation",
            best.quantisation_um,
            "offer a finer scale or more pulses per interval",
        ),
        ("the clock", best.clock_um, "offer a faster clock, or feed slower"),
        (
            "the acceleration",
            best.acceleration_um,
            "offer a finer scale, accelerate more slowly or feed faster",
        ),
        (
            "the resolution of the rotation",
            best.resolution_um,
            "offer an encoder with more pulses per revolution or more pulses per interval",
        ),
        (
            "the rounding of the rotation",
            rounding,
            "take rate = \"exact\", or offer an encoder with more pulses per revolution",
        ),
    ];
    let mut largest = parts[0];
    for part in parts {
        if part.1 > largest.1 {
            largest = part;
        }
    }
    let (name, um, help) = largest;
    Remark {
        code,
        text: format!(
            "no set-up reaches {wanted} um; the most accurate one ({} pulses per metre, {} Hz, P = {}, {} pulses per revolution) is at {sum:.4} um, \
             of which {name} takes {um:.4} um",
            best.pulses_per_metre, best.clock_hz, best.pulses_per_interval, best.pulses_per_revolution
        ),
        way_out: help.into(),
    }
}
