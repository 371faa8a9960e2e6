//! The settings that stand in a job, with the profile forms that they give the dresser built.

use super::Prepared;
use crate::job::{FlankSettings, LoadedJob, Settings};
use foundation::geometry::{Flank, Sides};
use foundation::modification::{EvaluationField, Modification, ModificationSpec};
use job::{Diagnostic, Problem};
use run::{RunFailure, job_files, modification_finding};

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
                settings_reliefs(loaded, &given.reliefs, flank, &prepared.setup.fields[flank])
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

/// The profile forms of `[settings]` of one flank, built.
///
/// # Errors
/// [`RunFailure`] for a modification that is impossible or no function of the profile alone.
fn settings_reliefs(
    loaded: &LoadedJob,
    specs: &[ModificationSpec],
    flank: Flank,
    field: &EvaluationField,
) -> Result<Vec<Modification>, RunFailure> {
    let entry = format!("settings.{flank}.reliefs");
    let built = Modification::for_flank(specs, flank, field, &job_files(loaded))
        .map_err(|e| RunFailure::bad_input(modification_finding(&e, &entry)))?;
    if !built.terms().iter().all(Modification::depends_on_profile_only) {
        let finding =
            Diagnostic::new(Problem::InvalidJob, "a dresser can only carry modifications of the profile")
                .field(entry)
                .allowed("profile crowning, profile slope, tip or root relief")
                .way_out("leave helix modifications to the motions");
        return Err(RunFailure::bad_input(finding));
    }
    Ok(built.terms())
}
