//! Dresser and worm of a job of generating grinding, asked again and again: what the dresser is, what it leaves in one position, and
//! in which position it leaves what is wanted. Plans nothing, proves nothing.

use super::prepare::prepare;
use crate::job::Job;
use crate::workflow::generating_finding;
use dressing::{
    Condition, ConditionSolver, DressedProfile, DresserTool, DressingError, FlankDresser, ProfilePoint,
    fit_profile,
};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;
use generating::{GeneratingError, Tool};
use job::AnyJob;
use run::RunFailure;

/// The conjugate dresser of a job's worm, in place.
#[derive(Clone, Debug)]
pub struct DressingModel {
    tool: DresserTool,
    reference_radius: f64,
}

fn failure(error: DressingError) -> RunFailure {
    generating_finding::failure(&GeneratingError::from(error))
}

impl DressingModel {
    /// Worm and dresser of a job of generating grinding.
    ///
    /// # Errors
    /// [`RunFailure`] as for a plan; a job of another process, a tool that is not dressed.
    pub fn new(job: &AnyJob) -> Result<Self, RunFailure> {
        let Some(loaded) = job.of::<Job>() else {
            return Err(RunFailure::other_process(job, "\"generating-grinding\""));
        };
        let setup = prepare(loaded)?.setup;
        match setup.tool {
            Tool::Dressed(tool) => Ok(Self { tool: *tool, reference_radius: setup.worm_pitch_radius }),
            Tool::Made | Tool::Given(_) => Err(generating_finding::failure(&GeneratingError::NotDressed)),
        }
    }

    /// One flank of the dresser, and the worm flank that it dresses.
    pub fn flank(&self, flank: Flank) -> &FlankDresser {
        &self.tool.flanks[flank]
    }

    /// What the dresser leaves in one position at lengths of roll of the worm (mm).
    ///
    /// # Errors
    /// [`RunFailure`]: no contact, or a length of roll beyond what the profile dresses.
    pub fn dressed(
        &self,
        flank: Flank,
        correction: DressingCorrection,
        rolls: &[f64],
    ) -> Result<Vec<ProfilePoint>, RunFailure> {
        DressedProfile::new(&self.tool, flank, correction).at_rolls(rolls).map_err(failure)
    }

    /// The position in which four conditions hold, sought from `start`.
    ///
    /// # Errors
    /// [`RunFailure`]: another number of conditions, conditions that depend on each other or cannot be met.
    pub fn solved(
        &self,
        conditions: &[Condition],
        start: &DressingCorrection,
    ) -> Result<DressingCorrection, RunFailure> {
        ConditionSolver::new(&self.tool, self.reference_radius).solve(conditions, start).map_err(failure)
    }

    /// The position that leaves `middle` (mm, normal) in the middle of the used profile of the worm and nothing at both ends.
    ///
    /// # Errors
    /// As [`DressingModel::solved`], with the share of the amount that was reached.
    pub fn crowned(&self, flank: Flank, middle: f64) -> Result<DressingCorrection, RunFailure> {
        let fit = fit_profile(&self.tool, flank, self.reference_radius, middle, &[0.0; 4]);
        fit.map(|fit| fit.dk).map_err(failure)
    }
}
