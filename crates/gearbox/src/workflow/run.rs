//! `gearbox`: from a checked job to counters, errors and their budget, the servo and the choice of a set-up.

use super::additions::{self, SplitChange, SplitFollower};
use super::explore::explore;
use super::finding::of_feed;
use super::prepare::{Chain, Prepared, prepare};
use super::result::GearboxResult;
use super::{figures, following, judge, measuring, remarks};
use crate::job::LoadedGearboxJob;
use control::{EngagingRecord, FollowingRecord, InterpolationRun, MultiplierRun};
use electronic_gearbox::pulse::TimedPulse;
use foundation::numerics::Progress;
use run::JobFailure;
use run::control::{interpolator_alarms, on_field};
use std::collections::BTreeMap;
use std::time::Instant;

/// Everything that a run produces.
pub struct GearboxOutcome {
    /// The document of `result.json`.
    pub result: GearboxResult,
    /// What was made of the job.
    pub prepared: Prepared,
    /// The run of the interpolator, with its errors over time.
    pub run: InterpolationRun,
    /// The servo over time, where the job has one.
    pub servo: Option<FollowingRecord>,
    /// Every pulse with the parts of rotation that it turned, where the job asks for it.
    pub trace: Option<Vec<(TimedPulse, i64)>>,
    /// Every change of whole pulses and voltage, where the job asks for it.
    pub split_trace: Option<Vec<SplitChange>>,
    /// The engagement over time, where the job has one.
    pub engaging: Option<EngagingRecord>,
    /// Multipliers that were compared, in the order of the result behind its first line.
    pub compared: Vec<MultiplierRun>,
}

/// Runs the gearbox on the stimulus of a job.
///
/// # Errors
/// [`JobFailure`], bad input always. Alarms of the interpolator and set-ups that are not accurate enough are none: warnings and
/// the verdict tell them.
pub fn run_gearbox(loaded: &LoadedGearboxJob, progress: &dyn Progress) -> Result<GearboxOutcome, JobFailure> {
    let mut timing = BTreeMap::new();
    let begun = Instant::now();
    let prepared = prepare(loaded)?;
    let Prepared { chain, driven, .. } = &prepared;
    let Chain { gear, interpolation, rotation, .. } = chain;
    timing.insert("reference pulses", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    progress.start("interpolation", 1);
    let mut trace = prepared.traced.then(Vec::new);
    let mut follower = match prepared.converter {
        Some(converter) => Some(SplitFollower::new(chain, converter, prepared.split_traced)?),
        None => None,
    };
    let run = interpolation
        .run(
            &driven.references,
            driven.last_tick,
            driven.motion.as_ref(),
            Some(rotation),
            &mut |pulse, turned| {
                trace.iter_mut().for_each(|trace| trace.push((pulse, turned)));
                follower.iter_mut().for_each(|follower| follower.pulse(pulse, turned));
            },
        )
        .map_err(|error| on_field(&error, "workpiece.pulses_per_revolution"))?;
    progress.advance(1);
    progress.finish();
    timing.insert("interpolation", begun.elapsed().as_secs_f64());

    let (mut budget, mut along_feed, mut angle) = (None, None, None);
    if let Some(motion) = &driven.motion {
        let (speed, acceleration) = motion.greatest();
        let at = |drive: [f64; 2], least: Option<f64>| {
            figures::budget(chain, interpolation, drive, least).map_err(|error| of_feed(&error))
        };
        budget = Some(figures::budget_result(&at([speed, acceleration], None)?, acceleration));
        let limits = |budget| {
            let limits = figures::limits(&budget, interpolation, &driven.references);
            figures::with_lines(limits, driven, interpolation.pitch)
        };
        // Where lines are too far apart they pass more slowly, where they are too close faster.
        let seen = speed * (1.0 + motion.line_errors().steepness());
        // A motion from rest to rest comes down to standstill; constant speed has no acceleration.
        let whole = limits(at([seen, acceleration], Some(0.0))?);
        let steady = limits(at([seen, 0.0], None)?);
        along_feed = Some(figures::along_feed(&run, whole, steady, gear.flank_per_axial()));
        angle = figures::angle(&run, whole, chain, driven.travel(interpolation));
    }

    let begun = Instant::now();
    let (mut servo, mut servo_record) = (None, None);
    if let Some(followed) = &prepared.servo {
        progress.start("servo", 1);
        let (result, record) = following::follow(followed, driven, gear.flank_per_angle())?;
        progress.advance(1);
        progress.finish();
        (servo, servo_record) = (Some(result), Some(record));
        timing.insert("servo", begun.elapsed().as_secs_f64());
    }

    let begun = Instant::now();
    let explored = match &prepared.offers {
        Some(offers) => {
            let explored = explore(offers, chain, driven, &prepared.measured, progress)?;
            timing.insert("explore", begun.elapsed().as_secs_f64());
            Some(explored)
        }
        None => None,
    };

    let (split, split_trace) = follower.map(|follower| follower.finish(chain)).unzip();
    let corrections = additions::corrections(&prepared.corrections, chain, driven, prepared.worm_speed)?;
    let begun = Instant::now();
    let (mut engagement, mut engaged) = (None, None);
    if let Some(engaging) = &prepared.engaging {
        let record = engaging.run().map_err(|error| on_field(&error, "engagement"))?;
        engagement = Some(additions::engagement(engaging, &record, chain));
        engaged = Some(record);
        timing.insert("engagement", begun.elapsed().as_secs_f64());
    }
    let begun = Instant::now();
    let (mut compared, mut compared_runs) = (Vec::new(), Vec::new());
    if let Some(wanted) = &prepared.compared {
        (compared, compared_runs) = additions::comparison(wanted, &run, chain, driven)?;
        timing.insert("comparison", begun.elapsed().as_secs_f64());
    }
    let errors = measuring::measuring(&prepared.measured, chain, driven);

    let settings = figures::settings(chain, driven);
    let pulses = figures::pulses(&run, interpolation, rotation);
    let alarms = interpolator_alarms(&chain.set_up.feed, &run.status);
    let judged = judge::Judged {
        alarms: &alarms,
        along_feed: along_feed.as_ref(),
        angle: angle.as_ref(),
        servo: servo.as_ref(),
        encoder: errors.as_ref().and_then(|errors| errors.encoder.as_ref()),
        split: split.as_ref(),
        engagement: engagement.as_ref(),
        explored: explored.as_ref().map(|(explored, reason)| (explored, reason.as_ref())),
    };
    let verdict = judge::verdict(prepared.tolerance_um, &judged);
    let mut warnings = alarms;
    warnings.extend(remarks::warnings(
        &settings,
        &pulses,
        budget.as_ref(),
        along_feed.as_ref(),
        servo.as_ref(),
    ));
    warnings.extend(remarks::of_additions(&corrections, split.as_ref()));
    let result = GearboxResult {
        job: prepared.info.name.clone(),
        process: prepared.info.process.name().to_owned(),
        version: env!("CARGO_PKG_VERSION"),
        verdict,
        tolerance_um: prepared.tolerance_um,
        warnings,
        settings,
        coupling: figures::coupling(chain),
        pulses,
        budget,
        along_feed,
        angle,
        errors,
        corrections,
        split,
        engagement,
        compare: compared,
        servo,
        explore: explored.map(|(explored, _)| explored),
        timing_s: timing,
    };
    Ok(GearboxOutcome {
        result,
        prepared,
        run,
        servo: servo_record,
        trace,
        split_trace: split_trace.flatten(),
        engaging: engaged,
        compared: compared_runs,
    })
}
