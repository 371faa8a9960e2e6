//! The reference pulses of a job, from its lists or from the table that it names.

use super::{GearboxJob, extent};
use crate::reference_train::{ReferenceTrain, read_reference_train};
use job::checks::contradiction;
use job::{JobError, Loaded};

/// The reference pulses of the job; `None` if its stimulus is a motion. Whether ticks rise and signs are +1 or -1 is left to
/// the gearbox; [`ReferenceTrain::error`] puts its answer at the right place.
///
/// # Errors
/// As [`read_reference_train`]; `invalid-job` for a `last_tick` before the last reference pulse, and for a train that lasts
/// longer than a day or for too many samples of the servo.
pub fn reference_train(loaded: &Loaded<GearboxJob>) -> Result<Option<ReferenceTrain>, JobError> {
    let stimulus = &loaded.job.stimulus;
    let (train, key) = match (&stimulus.references, &stimulus.reference_ticks, &stimulus.reference_signs) {
        (Some(file), ..) => (read_reference_train(&loaded.beside(file))?, "references"),
        (None, Some(ticks), Some(signs)) => {
            let places = (0..ticks.len())
                .map(|i| loaded.document.span_of(&format!("stimulus.reference_ticks[{i}]")))
                .collect();
            let references = ticks.iter().copied().zip(signs.iter().copied()).collect();
            (ReferenceTrain::new(references, loaded.document.source().clone(), places), "reference_ticks")
        }
        _ => return Ok(None),
    };
    let last = train.references().iter().map(|(tick, _)| *tick).max().unwrap_or(0);
    if let Some(given) = stimulus.last_tick.filter(|given| *given < last) {
        return Err(loaded.error(contradiction(
            "the train ends before its last reference pulse",
            "stimulus.last_tick",
            given.to_string(),
            &format!(">= {last}, the last reference pulse"),
            "give a later tick, or leave `last_tick` out",
        )));
    }
    let key = if stimulus.last_tick.is_some() { "last_tick" } else { key };
    let time = stimulus.last_tick.unwrap_or(last) as f64 / loaded.job.feed.clock_hz;
    match extent::too_long(&loaded.job, time, &format!("stimulus.{key}")) {
        Some(finding) => Err(loaded.error(finding)),
        None => Ok(Some(train)),
    }
}
