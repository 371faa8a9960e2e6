//! The grinding cycle of a job: feed, overrun, areas of the worm and the threads that grind.

use crate::job::Job;
use crate::workflow::roughing_pass::RoughingArea;
use crate::workflow::stroke_plan::StrokePlan;
use run::RunFailure;

/// Least overrun at both ends of the feed stroke, mm.
const LEAST_OVERRUN: f64 = 1.0;

/// What a job says of grinding beside the flank.
#[derive(Clone, Debug)]
pub struct Cycle {
    /// Feed per revolution of the gear, mm; `None` where the job gives none.
    pub feed_per_revolution: Option<f64>,
    /// How far the feed stroke goes on beyond the contact at both ends, mm: at least one feed mark.
    pub overrun: f64,
    /// Finishing areas that the job asks for.
    pub areas: Option<usize>,
    /// Roughing areas beside them.
    pub roughing: Vec<RoughingArea>,
    /// The strokes of a pass; `None` where every thread grinds.
    pub strokes: Option<StrokePlan>,
}

impl Cycle {
    /// Of a job.
    ///
    /// # Errors
    /// A finding on `grinding.active_threads`.
    pub(super) fn of_job(job: &Job) -> Result<Self, RunFailure> {
        let grinding = &job.grinding;
        let mark = grinding.feed_per_revolution.unwrap_or(0.0);
        let threads = job.worm.threads as usize;
        let teeth = job.gear.teeth.unsigned_abs() as usize;
        Ok(Self {
            feed_per_revolution: grinding.feed_per_revolution,
            overrun: grinding.overrun.unwrap_or(LEAST_OVERRUN).max(LEAST_OVERRUN).max(mark),
            areas: grinding.areas.map(|n| n as usize),
            roughing: RoughingArea::of_job(job),
            strokes: match &grinding.active_threads {
                Some(active) => StrokePlan::of_active(threads, teeth, active)?,
                None => None,
            },
        })
    }
}
