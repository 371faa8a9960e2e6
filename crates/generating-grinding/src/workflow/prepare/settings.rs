//! The settings that stand in a job, with the profile forms that they give the dresser built.

use super::Prepared;
use super::tools::dresser_profile;
use crate::job::{FlankSettings, LoadedJob, Settings};
use foundation::geometry::{Flank, Sides};
use foundation::modification::Modification;
use run::RunFailure;

/// Settings to be run.
pub struct GivenSettings {
    /// As the job has them.
    pub settings: Settings,
    /// Profile forms that the dresser carries on each ground flank.
    pub reliefs: Sides<Vec<Modification>>,
}

impl GivenSettings {
    /// Of a job; `None` for one without `[settings]`.
    ///
    /// # Errors
    /// [`RunFailure`] for a modification that is impossible or no function of the profile alone.
    pub fn of_job(loaded: &LoadedJob, prepared: &Prepared) -> Result<Option<Self>, RunFailure> {
        let Some(settings) = loaded.job.settings.clone() else { return Ok(None) };
        let reliefs = Sides::try_from_fn(|flank| match (&prepared.targets[flank], settings.flank(flank)) {
            (Some(_), Some(given)) => {
                let place = format!("settings.{flank}.reliefs");
                let field = &prepared.setup.fields[flank];
                dresser_profile(loaded, &given.reliefs, flank, field, (&place, "the motions"))
                    .map(|made| made.terms())
                    .map_err(RunFailure::bad_input)
            }
            _ => Ok(Vec::new()),
        })?;
        Ok(Some(Self { settings, reliefs }))
    }

    /// What is set on one flank.
    pub fn flank(&self, flank: Flank) -> Option<&FlankSettings> {
        self.settings.flank(flank)
    }
}
