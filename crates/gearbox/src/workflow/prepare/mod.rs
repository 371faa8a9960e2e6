//! From a checked job of the electronic gearbox to gear, coupling, reference pulses, servo and set-ups to choose from. What stands
//! behind it reads no job. Every finding names the job's key.

mod additions;
mod chain;
mod driven;
mod measured;
mod offers;
mod servo;
mod set_up;

pub use additions::Compared;
pub use chain::Chain;
pub use driven::Driven;
pub use measured::{EncoderPart, LinePart, Measured};
pub use offers::{MOST_SET_UPS, Offer, Offers};
pub use servo::FollowedServo;
pub use set_up::SetUp;

use crate::job::{GearboxCorrection, LoadedGearboxJob};
use control::{Converter, Correction, Engaging};
use job::Diagnostic;
use job::tables::{JobInfo, Language};
use run::{JobFailure, RunFailure};

/// Most pulses that a trace may hold: some hundred megabytes of text.
pub const MOST_TRACED_PULSES: u64 = 5_000_000;

/// A job made ready for its run.
pub struct Prepared {
    /// Name, process and description of the job.
    pub info: JobInfo,
    /// Largest error allowed at the flank, um; `None` where the job gives none.
    pub tolerance_um: Option<f64>,
    /// What stands between slide and workpiece.
    pub chain: Chain,
    /// What the slide does.
    pub driven: Driven,
    /// What is measured wrongly.
    pub measured: Measured,
    /// Rotation that is added over feed and worm.
    pub corrections: Vec<Correction>,
    /// Speed of the worm, rad/s; 0 without one.
    pub worm_speed: f64,
    /// The converter of the part of a workpiece pulse.
    pub converter: Option<Converter>,
    /// How the workpiece comes into the gap.
    pub engaging: Option<Engaging>,
    /// Multipliers to compare with.
    pub compared: Option<Compared>,
    /// The servo of the workpiece spindle.
    pub servo: Option<FollowedServo>,
    /// Set-ups to choose from.
    pub offers: Option<Offers>,
    /// Whether every pulse is written.
    pub traced: bool,
    /// Whether every change of whole pulses and voltage is written.
    pub split_traced: bool,
    /// Language of the report.
    pub language: Language,
}

/// All that a run needs of a job.
///
/// # Errors
/// What is wrong with gear, scale, coupling, servo and lists on their keys; with the train at its place; a trace that is too long.
pub fn prepare(loaded: &LoadedGearboxJob) -> Result<Prepared, JobFailure> {
    let job = &loaded.job;
    let chain = Chain::of_job(job)?;
    let measured = Measured::of_job(job.errors.as_ref())?;
    let driven = Driven::of_job(loaded, &chain.interpolation)?;
    for (wanted, key) in [(job.output.pulse_trace, "pulse_trace"), (job.output.split_trace, "split_trace")] {
        if wanted {
            check_trace(&driven, job.feed.pulses_per_interval, key)?;
        }
    }
    let corrections = additions::corrections(GearboxCorrection::curves(job.correction.as_ref()), &chain)?;
    let servo = job
        .servo
        .as_ref()
        .map(|given| FollowedServo::of_job(job, given, &chain, &corrections))
        .transpose()?;
    let engaging = match (&job.engagement, &job.worm) {
        (Some(given), Some(worm)) => Some(additions::engaging(given, worm, job, &chain)?),
        _ => None,
    };
    let offers =
        job.explore.as_ref().map(|given| Offers::of_job(given, chain.set_up, &driven)).transpose()?;
    Ok(Prepared {
        info: job.job.clone(),
        tolerance_um: job.target.map(|target| target.tolerance_um),
        worm_speed: job.worm.as_ref().map_or(0.0, |worm| additions::followed_worm(worm, chain.teeth).speed),
        converter: job.split.as_ref().map(additions::converter).transpose()?,
        compared: job.compare.as_ref().map(additions::compared).transpose()?,
        engaging,
        measured,
        corrections,
        chain,
        driven,
        servo,
        offers,
        traced: job.output.pulse_trace,
        split_traced: job.output.split_trace,
        language: job.output.language,
    })
}

fn check_trace(driven: &Driven, pulses_per_interval: u32, key: &str) -> Result<(), RunFailure> {
    let pulses = driven.references.len() as u64 * u64::from(pulses_per_interval);
    if pulses <= MOST_TRACED_PULSES {
        return Ok(());
    }
    let message = format!("the trace would hold about {pulses} pulses");
    Err(RunFailure::bad_input(
        Diagnostic::with_code("trace-too-long", message)
            .field(format!("output.{key}"))
            .value(pulses)
            .allowed(format!("up to {MOST_TRACED_PULSES} pulses, reference pulses x pulses_per_interval"))
            .way_out(format!(
                "trace a shorter motion, or leave `{key}` out: errors.csv tells errors over the whole motion"
            )),
    ))
}
