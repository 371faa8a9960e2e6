//! A skiving tool at its light barrier, asked again and again: what it would be measured as with other noise, and what deviations
//! say of tool, workpiece and setting. No referee, no programs.

use super::finding::failure;
use super::measurement::Measurement;
use super::prepare::{SkivingBodies, prepare_skiving};
use super::run::measured_of_job;
use crate::evaluation::{Deviations, Evaluation, MeasuredTool, correction, evaluate};
use crate::job::SkivingJob;
use crate::{SettingFit, setting_sensitivity};
use foundation::geometry::Flank;
use job::AnyJob;
use run::{JobFailure, RunFailure};

/// Edges, tracks and poses of a job, and its measured tool if it has one.
#[derive(Clone, Debug)]
pub struct MeasuringModel {
    bodies: SkivingBodies,
    measurement: Option<Measurement>,
}

impl MeasuringModel {
    /// Edges and poses of a job of measuring a skiving tool; its readings, or those of the tool of `[tool_errors]`.
    ///
    /// # Errors
    /// [`JobFailure`] as for a plan; a job of another process.
    pub fn new(job: &AnyJob) -> Result<Self, JobFailure> {
        let Some(loaded) = job.of::<SkivingJob>() else {
            return Err(RunFailure::other_process(job, "\"skiving-tool-measuring\"").into());
        };
        let prepared = prepare_skiving(loaded)?;
        let measurement = measured_of_job(&prepared)?;
        Ok(Self { bodies: prepared.bodies, measurement })
    }

    /// Edges, tracks and poses.
    pub fn bodies(&self) -> &SkivingBodies {
        &self.bodies
    }

    /// What was measured; `None` for a job without readings and tool errors.
    pub fn measurement(&self) -> Option<&Measurement> {
        self.measurement.as_ref()
    }

    /// The measurement once more with the noise that begins at `seed`; `None` where nothing is measured.
    ///
    /// # Errors
    /// [`RunFailure`]: readings that cannot be distinguished.
    pub fn repeated(&self, seed: u64) -> Option<Result<MeasuredTool, RunFailure>> {
        let measurement = self.measurement.as_ref()?;
        Some(measurement.repeated(&self.bodies).measured(seed).map_err(|error| failure(&error)))
    }

    /// What deviations (mm, normal to the flank) say of the tool, and the change of the setting that answers them.
    ///
    /// # Errors
    /// [`RunFailure`]: deviations that are not finite.
    pub fn evaluated(&self, deviations: &Deviations) -> Result<(Evaluation, SettingFit), RunFailure> {
        let bodies = &self.bodies;
        let found = evaluate(&bodies.flanks, deviations, &bodies.options).map_err(|error| failure(&error))?;
        let settings = (&bodies.free[..], &bodies.setting_limits);
        let fit = correction(&bodies.flanks, &found, settings).map_err(|error| failure(&error))?;
        Ok((found, fit))
    }

    /// Change of the workpiece's flank at every track per unit of [d, gamma, z_V1, phi_1]: mm/mm and mm/rad.
    pub fn sensitivities(&self, flank: Flank) -> Vec<[f64; 4]> {
        let of = &self.bodies.flanks[flank];
        let motion = of.edge.pair().motion();
        of.tracks.iter().map(|(track, _)| setting_sensitivity(motion, &track.contact)).collect()
    }
}
