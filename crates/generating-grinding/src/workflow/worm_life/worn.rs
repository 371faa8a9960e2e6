//! The job with its worm at another diameter, its addendum kept.

use crate::job::LoadedJob;
use crate::workflow::prepare::setup_of_job;
use run::RunFailure;

/// The job without what a study of the flank does not ask: programs, control, stock, technology.
pub fn plain(loaded: &LoadedJob) -> LoadedJob {
    let mut plain = loaded.clone();
    let job = &mut plain.job;
    (job.explore, job.stock, job.technology, job.control) = (None, None, None, None);
    (job.deviations, job.measured_worm) = (None, None);
    job.output.programs.clear();
    plain
}

/// Tip diameter of the job's worm, mm.
///
/// # Errors
/// [`RunFailure`] of bodies that are none.
pub fn first_tip_diameter(loaded: &LoadedJob) -> Result<f64, RunFailure> {
    let setup = setup_of_job(&loaded.job)?;
    Ok(2.0 * setup.worm_tip_radius)
}

/// The job with its worm dressed down to a tip diameter, mm.
pub fn worn(loaded: &LoadedJob, tip_diameter: f64) -> LoadedJob {
    let mut worn = loaded.clone();
    let worm = &mut worn.job.worm;
    match (worm.pitch_diameter, worm.tip_diameter) {
        (Some(pitch), Some(tip)) => worm.pitch_diameter = Some(pitch + tip_diameter - tip),
        // The default addendum follows from the tip diameter alone.
        _ => worm.pitch_diameter = None,
    }
    worm.tip_diameter = Some(tip_diameter);
    worn
}
