//! `gearbox`: from a checked job to counters, errors and their budget, the servo and the choice of a set-up.

use super::couple::{coupling, geometry, of_feed};
use super::explore::explore;
use super::result::{CouplingResult, GearboxResult};
use super::stimulus::{Driven, driven};
use super::{figures, following, judge, remarks};
use crate::job::{GearboxJob, LoadedGearboxJob};
use control::{FollowingRecord, Interpolation, InterpolationRun, Rotation};
use electronic_gearbox::coefficient::GearGeometry;
use electronic_gearbox::pulse::TimedPulse;
use foundation::numerics::Progress;
use job::Diagnostic;
use run::control::{interpolation, interpolator_alarms, on_field, rotation_refused};
use run::{JobFailure, RunFailure};
use std::collections::BTreeMap;
use std::time::Instant;

/// Most pulses that a trace may hold: some hundred megabytes of text.
pub const MOST_TRACED_PULSES: u64 = 5_000_000;

/// Everything that a run produces.
pub struct GearboxOutcome {
    /// The document of `result.json`.
    pub result: GearboxResult,
    /// The run of the interpolator, with its errors over time.
    pub run: InterpolationRun,
    /// The servo over time, where the job has one.
    pub servo: Option<FollowingRecord>,
    /// Every pulse with the parts of rotation that it turned, where the job asks for it.
    pub trace: Option<Vec<(TimedPulse, i64)>>,
}

/// Runs the gearbox on the stimulus of a job.
///
/// # Errors
/// [`JobFailure`], bad input always. Alarms of the interpolator and set-ups that are not accurate enough are none: warnings and
/// the verdict tell them.
pub fn run_gearbox(loaded: &LoadedGearboxJob, progress: &dyn Progress) -> Result<GearboxOutcome, JobFailure> {
    let job = &loaded.job;
    let mut timing = BTreeMap::new();
    let begun = Instant::now();
    let Chain { gear, interpolation, rotation } = chain(job)?;
    let driven = driven(loaded, &interpolation)?;
    if job.output.pulse_trace {
        check_trace(&driven, job.feed.pulses_per_interval)?;
    }
    timing.insert("reference pulses", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    progress.start("interpolation", 1);
    let mut trace = job.output.pulse_trace.then(Vec::new);
    let run = interpolation
        .run(
            &driven.references,
            driven.last_tick,
            driven.motion.as_ref(),
            Some(&rotation),
            &mut |pulse, turned| trace.iter_mut().for_each(|trace| trace.push((pulse, turned))),
        )
        .map_err(|error| on_field(&error, "workpiece.pulses_per_revolution"))?;
    progress.advance(1);
    progress.finish();
    timing.insert("interpolation", begun.elapsed().as_secs_f64());

    let pressure_angle = job.gear.normal_pressure_angle_deg.to_radians();
    let (mut budget, mut along_feed, mut angle) = (None, None, None);
    if let Some(motion) = &driven.motion {
        let (speed, acceleration) = motion.greatest();
        let at = |drive: [f64; 2], least: Option<f64>| {
            figures::budget(&gear, pressure_angle, &interpolation, drive, least)
                .map_err(|error| of_feed(&error))
        };
        budget = Some(figures::budget_result(&at([speed, acceleration], None)?, acceleration));
        let limits = |budget| figures::limits(&budget, &interpolation, &driven.references);
        // A motion from rest to rest comes down to standstill; constant speed has no acceleration.
        let whole = limits(at([speed, acceleration], Some(0.0))?);
        let steady = limits(at([speed, 0.0], None)?);
        along_feed = Some(figures::along_feed(&run, whole, steady, gear.flank_per_axial()));
        let travel = driven.travel(&interpolation);
        angle = figures::angle(&run, whole, &gear, &interpolation, &rotation, travel);
    }

    let begun = Instant::now();
    let (mut servo, mut servo_record) = (None, None);
    if let Some(given) = &job.servo {
        progress.start("servo", 1);
        let um_per_radian = gear.flank_per_angle();
        let (result, record) =
            following::follow(job, given, &driven, &interpolation, &rotation, um_per_radian)?;
        progress.advance(1);
        progress.finish();
        (servo, servo_record) = (Some(result), Some(record));
        timing.insert("servo", begun.elapsed().as_secs_f64());
    }

    let begun = Instant::now();
    let explored = match &job.explore {
        Some(given) => {
            let explored = explore(job, given, &gear, &driven, progress)?;
            timing.insert("explore", begun.elapsed().as_secs_f64());
            Some(explored)
        }
        None => None,
    };

    let settings = figures::settings(job, &interpolation, &driven);
    let pulses = figures::pulses(&run, &interpolation, &rotation);
    let alarms = interpolator_alarms(&job.feed, &run.status);
    let judged = judge::Judged {
        alarms: &alarms,
        along_feed: along_feed.as_ref(),
        angle: angle.as_ref(),
        servo: servo.as_ref(),
        explored: explored.as_ref().map(|(explored, reason)| (explored, reason.as_ref())),
    };
    let verdict = judge::verdict(job.target.as_ref(), &judged);
    let mut warnings = alarms;
    warnings.extend(remarks::warnings(
        &settings,
        &pulses,
        budget.as_ref(),
        along_feed.as_ref(),
        servo.as_ref(),
    ));
    let result = GearboxResult {
        job: job.job.name.clone(),
        process: job.job.process.name().to_owned(),
        version: env!("CARGO_PKG_VERSION"),
        verdict,
        tolerance_um: job.target.map(|target| target.tolerance_um),
        warnings,
        settings,
        coupling: figures::coupling(job, &gear, &interpolation, &rotation),
        pulses,
        budget,
        along_feed,
        angle,
        servo,
        explore: explored.map(|(explored, _)| explored),
        timing_s: timing,
    };
    Ok(GearboxOutcome { result, run, servo: servo_record, trace })
}

/// What the lead asks for and what the coupling of a job makes of it.
///
/// # Errors
/// [`RunFailure`]: a gear, scale or coefficient that cannot be.
pub fn coupling_of_job(job: &GearboxJob) -> Result<CouplingResult, RunFailure> {
    let Chain { gear, interpolation, rotation } = chain(job)?;
    Ok(figures::coupling(job, &gear, &interpolation, &rotation))
}

/// What stands between the slide and the workpiece.
pub(super) struct Chain {
    /// The workpiece.
    pub gear: GearGeometry,
    /// The interpolator of the slide.
    pub interpolation: Interpolation,
    /// How its pulses turn the workpiece.
    pub rotation: Rotation,
}

/// The chain of a job.
pub(super) fn chain(job: &GearboxJob) -> Result<Chain, RunFailure> {
    let gear = geometry(&job.gear)?;
    let interpolation = interpolation(&job.feed, "")?;
    let rotation = coupling(&gear, &job.workpiece, &interpolation)
        .map_err(|error| rotation_refused(&error, job.workpiece.encoder(), ""))?;
    Ok(Chain { gear, interpolation, rotation })
}

fn check_trace(driven: &Driven, pulses_per_interval: u32) -> Result<(), RunFailure> {
    let pulses = driven.references.len() as u64 * u64::from(pulses_per_interval);
    if pulses <= MOST_TRACED_PULSES {
        return Ok(());
    }
    let message = format!("the trace would hold about {pulses} pulses");
    Err(RunFailure::bad_input(
        Diagnostic::with_code("trace-too-long", message)
            .field("output.pulse_trace")
            .value(pulses)
            .allowed(format!("up to {MOST_TRACED_PULSES} pulses, reference pulses x pulses_per_interval"))
            .way_out("trace a shorter motion, or leave `pulse_trace` out: errors.csv tells errors over the whole motion"),
    ))
}
