//! The plan of a milling job with what its rows leave, asked place by place. No referee, no programs.

use super::finding::failure;
use super::prepare::{MillingBodies, prepare_milling};
use super::referee::predict;
use crate::job::MillingJob;
use crate::{MillingPlan, Prediction, plan_all};
use foundation::numerics::Progress;
use job::AnyJob;
use run::RunFailure;

/// A planned space.
#[derive(Clone, Debug)]
pub struct MillingModel {
    bodies: MillingBodies,
    plan: MillingPlan,
}

impl MillingModel {
    /// Plans the space of a job of five-axis milling.
    ///
    /// # Errors
    /// [`RunFailure`] as for a plan; a job of another process.
    pub fn new(job: &AnyJob, progress: &dyn Progress) -> Result<Self, RunFailure> {
        let Some(loaded) = job.of::<MillingJob>() else {
            return Err(RunFailure::other_process(job, "\"five-axis-milling\""));
        };
        let bodies = prepare_milling(loaded)?.bodies;
        progress.start("plan", 1);
        let plan = plan_all(&bodies.parts, &bodies.options).map_err(|error| failure(&error))?;
        progress.finish();
        Ok(Self { bodies, plan })
    }

    /// The plan.
    pub fn plan(&self) -> &MillingPlan {
        &self.plan
    }

    /// What the rows of a flank (by its number in the plan) leave at all places of height and length parameters, row-major; `None` where
    /// no row comes by.
    ///
    /// # Errors
    /// [`RunFailure`]: a place where the model gives no value.
    ///
    /// # Panics
    /// For a number that the plan does not have.
    pub fn predicted(
        &self,
        flank: usize,
        heights: &[f64],
        lengths: &[f64],
    ) -> Result<Vec<Option<Prediction>>, RunFailure> {
        predict(&self.bodies, &self.plan.flanks[flank], heights, lengths)
    }
}
