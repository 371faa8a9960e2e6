//! Passes as planned, without their referee.

use super::plan::{plan_pass, task_of};
use super::prepare::TangentialPrepared;
use super::remarks::flank_warnings;
use super::settings::{SettledPass, job_settings};
use crate::job::TangentialSettings;
use crate::{FitLimits, TangentialError};
use foundation::geometry::Flank;
use foundation::numerics::Silent;
use metrology::Topography;
use run::RunFailure;
use verdict::Remark;

/// A flank as planned.
pub struct PreviewedPass {
    /// The flank.
    pub flank: Flank,
    /// What is wanted, in the measure of the job, mm.
    pub target: Topography,
    /// What the exact contact gives, in the measure of the job, mm.
    pub planned: Topography,
    /// Cosine of the base helix angle.
    pub cos_b: f64,
}

/// All passes of a job.
pub struct Previewed {
    /// Settings, as in the result of a plan.
    pub settings: TangentialSettings,
    /// Flanks of all passes.
    pub flanks: Vec<PreviewedPass>,
    /// Remarks.
    pub warnings: Vec<Remark>,
}

/// Plans all passes of a job.
///
/// # Errors
/// As the plan.
pub fn preview_passes(ready: &TangentialPrepared) -> Result<Previewed, RunFailure> {
    let mut passes = Vec::with_capacity(ready.passes.len());
    let mut flanks = Vec::new();
    let mut warnings = Vec::new();
    for pass in &ready.passes {
        let plan = plan_pass(ready, pass, &Silent)?;
        let wanted = |flank: Flank, w: f64, z: f64| ready.wanted(flank, w, z);
        let task = task_of(ready, pass, &wanted, FitLimits::STEADY);
        let judged = task
            .judge(&plan.settings, ready.rules.judged_on)
            .map_err(|error: TangentialError| RunFailure::from(&error))?;
        for of in &judged {
            let over = |f: Vec<f64>| Topography { w: of.grid.w.clone(), z: of.grid.z.clone(), f };
            let planned = over(of.points.iter().map(|point| point.deviation).collect());
            let target = over(of.points.iter().zip(&of.error).map(|(p, e)| p.deviation - e).collect());
            let cos_b = ready.model.pair.work.flank(of.flank).base_helix_angle.cos();
            warnings.extend(flank_warnings(of));
            flanks.push(PreviewedPass { flank: of.flank, target, planned, cos_b });
        }
        passes.push(SettledPass { flanks: pass.clone(), settings: plan.settings.clone(), plan: Some(plan) });
    }
    Ok(Previewed { settings: job_settings(ready, &passes), flanks, warnings })
}
