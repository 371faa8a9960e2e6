//! Reference pulses of a job, from the motion of its slide or from its train, and what the gearbox says of a train that cannot be.

use super::couple::{of_feed, slide_motion};
use crate::job::{LoadedGearboxJob, reference_train};
use crate::reference_train::ReferenceTrain;
use control::{Interpolation, SlideMotion};
use electronic_gearbox::pulse::EventInterpolator;
use electronic_gearbox::{Error as GearboxError, TrainFault};
use job::Diagnostic;
use run::JobFailure;

/// What drives the interpolator.
#[derive(Clone, Debug)]
pub(super) struct Driven {
    /// Reference pulses (tick, sign), checked.
    pub references: Vec<(u64, i64)>,
    /// The motion that they come from.
    pub motion: Option<SlideMotion>,
    /// Tick up to which the run goes.
    pub last_tick: u64,
}

impl Driven {
    /// Length of the stimulus, s.
    pub fn duration(&self, interpolation: &Interpolation) -> f64 {
        self.last_tick as f64 / interpolation.clock
    }

    /// Distance between the outermost places of the slide, mm; of a train as far as its reference pulses tell.
    pub fn travel(&self, interpolation: &Interpolation) -> f64 {
        let (mut place, mut least, mut greatest) = (0i64, 0i64, 0i64);
        for (_, sign) in &self.references {
            place += sign;
            (least, greatest) = (least.min(place), greatest.max(place));
        }
        (greatest - least) as f64 * interpolation.pitch
    }
}

/// The reference pulses of a job.
///
/// # Errors
/// What is wrong with the motion, its scale or the train, at its place.
pub(super) fn driven(loaded: &LoadedGearboxJob, interpolation: &Interpolation) -> Result<Driven, JobFailure> {
    let stimulus = &loaded.job.stimulus;
    if let Some(motion) = slide_motion(stimulus)? {
        return Ok(of_motion(motion, stimulus.rest_or_default(), interpolation)?);
    }
    let Some(train) = reference_train(loaded)? else {
        return Ok(Driven { references: Vec::new(), motion: None, last_tick: 0 });
    };
    let references = train.references().to_vec();
    checked(loaded, &train, interpolation)?;
    let last = references.last().map_or(0, |(tick, _)| *tick);
    Ok(Driven { references, motion: None, last_tick: stimulus.last_tick.unwrap_or(last) })
}

/// The reference pulses of a motion with a rest (s) behind it.
///
/// # Errors
/// What is wrong with scale, clock or motion.
pub(super) fn of_motion(
    motion: SlideMotion,
    rest: f64,
    interpolation: &Interpolation,
) -> Result<Driven, run::RunFailure> {
    let references = interpolation.references(&motion).map_err(|error| of_feed(&error))?;
    let end = ((motion.duration() + rest) * interpolation.clock).ceil() as u64;
    let last_tick = references.last().map_or(end, |(tick, _)| end.max(*tick));
    Ok(Driven { references, motion: Some(motion), last_tick })
}

/// Sends the train through an interpolator without output: what it refuses has its place.
fn checked(
    loaded: &LoadedGearboxJob,
    train: &ReferenceTrain,
    interpolation: &Interpolation,
) -> Result<(), JobFailure> {
    let mut machine = EventInterpolator::new(interpolation.settings);
    for &(tick, sign) in train.references() {
        machine.reference(tick, sign, |_| {}).map_err(|error| refused(loaded, train, &error))?;
    }
    Ok(())
}

fn refused(loaded: &LoadedGearboxJob, train: &ReferenceTrain, error: &GearboxError) -> JobFailure {
    let finding = Diagnostic::with_code(error.code(), error.to_string()).way_out(error.way_out());
    let GearboxError::BadReferenceTrain { index, fault } = *error else {
        return run::control::on_field(error, "stimulus").into();
    };
    let table = loaded.job.stimulus.references.is_some();
    let finding = match fault {
        TrainFault::Tick { tick, least } => {
            let field = if table { "tick".to_owned() } else { format!("stimulus.reference_ticks[{index}]") };
            finding.field(field).value(tick).allowed(format!(">= {least}"))
        }
        TrainFault::Sign { sign } => {
            let field = if table { "sign".to_owned() } else { format!("stimulus.reference_signs[{index}]") };
            finding.field(field).value(sign).allowed("1, -1")
        }
    };
    train.error(index, finding).into()
}
