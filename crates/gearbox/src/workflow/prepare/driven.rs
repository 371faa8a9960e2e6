//! Reference pulses of a job, from the motion of its slide or from its train, and what the gearbox says of a train that cannot be.

use super::measured::Measured;
use crate::job::{LoadedGearboxJob, Move as JobMove, Stimulus, reference_train};
use crate::reference_train::ReferenceTrain;
use crate::workflow::finding::of_feed;
use control::{Interpolation, Move, SlideMotion};
use electronic_gearbox::pulse::EventInterpolator;
use electronic_gearbox::{Error as GearboxError, TrainFault};
use job::Diagnostic;
use run::{JobFailure, RunFailure};

/// What drives the interpolator.
#[derive(Clone, Debug)]
pub struct Driven {
    /// Reference pulses (tick, sign), checked.
    pub references: Vec<(u64, i64)>,
    /// The motion that they come from.
    pub motion: Option<SlideMotion>,
    /// Time at rest behind a motion, s.
    pub rest: f64,
    /// Tick up to which the run goes.
    pub last_tick: u64,
}

impl Driven {
    /// The reference pulses of a job.
    ///
    /// # Errors
    /// What is wrong with the motion, its scale or the train, at its place.
    pub fn of_job(loaded: &LoadedGearboxJob, interpolation: &Interpolation) -> Result<Self, JobFailure> {
        let stimulus = &loaded.job.stimulus;
        let rest = stimulus.rest_or_default();
        if let Some(motion) = slide_motion(stimulus)? {
            let lines = Measured::of_job(loaded.job.errors.as_ref())?.lines;
            let motion = motion.with_line_errors(lines);
            return Ok(Self::of_motion(motion, rest, interpolation)?);
        }
        let Some(train) = reference_train(loaded)? else {
            return Ok(Self { references: Vec::new(), motion: None, rest, last_tick: 0 });
        };
        let references = train.references().to_vec();
        checked(loaded, &train, interpolation)?;
        let last = references.last().map_or(0, |(tick, _)| *tick);
        Ok(Self { references, motion: None, rest, last_tick: stimulus.last_tick.unwrap_or(last) })
    }

    /// The reference pulses of a motion with a rest (s) behind it.
    ///
    /// # Errors
    /// What is wrong with scale, clock or motion.
    pub fn of_motion(
        motion: SlideMotion,
        rest: f64,
        interpolation: &Interpolation,
    ) -> Result<Self, RunFailure> {
        let references = interpolation.references(&motion).map_err(|error| of_feed(&error))?;
        let end = ((motion.duration() + rest) * interpolation.clock).ceil() as u64;
        let last_tick = references.last().map_or(end, |(tick, _)| end.max(*tick));
        Ok(Self { references, motion: Some(motion), rest, last_tick })
    }

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

/// The motion of a stimulus without its rest; `None` for a train of pulses.
fn slide_motion(stimulus: &Stimulus) -> Result<Option<SlideMotion>, RunFailure> {
    let Some(moves) = &stimulus.motion else { return Ok(None) };
    let moves: Vec<Move> = moves
        .iter()
        .map(|step| match step {
            JobMove::Travel(travel) => Move::To {
                position: travel.to,
                speed: travel.speed_mm_per_min / 60.0,
                acceleration: travel.acceleration_mm_per_s2,
            },
            JobMove::Dwell(dwell) => Move::Rest { duration: dwell.dwell_s },
        })
        .collect();
    SlideMotion::of_moves(stimulus.start_or_default(), &moves).map(Some).map_err(|error| of_feed(&error))
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
