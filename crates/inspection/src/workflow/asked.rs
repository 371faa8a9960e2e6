//! What a job asks of the measurement of its gear, read once.

use super::bands::Bands;
use foundation::geometry::{Flank, Sides};
use generating::FlankTarget;
use generating_grinding::job::{Inspection as InspectionTable, LoadedJob};
use generating_grinding::workflow::prepare::prepare;
use job::tables::{JobInfo, Language};
use run::RunFailure;

/// What a measurement is judged by, and what may answer it.
pub struct Asked {
    /// Name, process and title block of the job.
    pub info: JobInfo,
    /// Language of its report.
    pub language: Language,
    /// Tolerance of a characteristic, normal, um.
    pub tolerance_um: f64,
    /// Bands in which traces have to lie.
    pub bands: Bands,
    /// Tests, settings that may be turned, the measurement that is simulated where there is no file.
    pub table: InspectionTable,
    /// Wanted flanks, without compensation.
    targets: Sides<Option<FlankTarget>>,
}

impl Asked {
    /// Of a job.
    ///
    /// # Errors
    /// Those of the job; bands that are none.
    pub fn of_job(loaded: &LoadedJob) -> Result<Self, RunFailure> {
        let table = loaded.job.inspection.clone().unwrap_or_default();
        let bands = Bands::of_table(&table)?;
        let mut plain = loaded.clone();
        plain.job.compensation = None;
        Ok(Self {
            info: loaded.job.job.clone(),
            language: loaded.job.output.language,
            tolerance_um: table.tolerance_um.unwrap_or(loaded.job.target.tolerance_um),
            bands,
            table,
            targets: prepare(&plain)?.targets,
        })
    }

    /// Whether a flank is to be ground.
    pub fn asks_for(&self, flank: Flank) -> bool {
        self.targets[flank].is_some()
    }

    /// Transverse deviation that is wanted, > 0 material, mm; NaN where none is defined.
    pub fn design(&self) -> impl Fn(Flank, f64, f64) -> f64 + Sync + '_ {
        |flank, w, z| self.targets[flank].as_ref().map_or(0.0, |t| t.value(w, z).unwrap_or(f64::NAN))
    }
}
