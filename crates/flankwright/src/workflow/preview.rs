//! The plan without its referee, for somebody who turns an amount and wants to see what becomes of the flank. What comes out is the exact
//! contact of the planned motions, as in a whole plan; it is not verified by the referee.

use super::execution::Execution;
use super::finding::{JobFailure, Remark, RunFailure};
use super::page::{characteristics, grinding_motion};
use super::partition::{Partition, StrokePlan};
use super::prepare::prepare;
use super::result::CharacteristicsUm;
use super::run::settings_result;
use super::tangential::{PreviewedPass, preview_passes};
use super::tip_land::TipLands;
use crate::exchange::{AnyJob, Diagnostic, LoadedJob, LoadedTangentialJob, Problem};
use crate::geometry::{Flank, Sides};
use crate::metrology::Topography;
use crate::report::charts::{self, ChartError, Svg};
use crate::report::generating::{
    FlankPicture, FlankReport, GrindingMotion, flank_picture, grinding_motion_chart,
};
use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;

/// A flank as planned.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PreviewFlank {
    /// Lengths of roll of the grid.
    pub w_mm: Vec<f64>,
    /// Axial positions of the grid.
    pub z_mm: Vec<f64>,
    /// Target, normal, `[profile][helix]`.
    pub target_um: Vec<Vec<f64>>,
    /// Exact contact with the tool as dressed, normal.
    pub planned_um: Vec<Vec<f64>>,
    /// Largest |planned - target|.
    pub max_deviation_um: f64,
    /// Root mean square of planned - target.
    pub rms_deviation_um: f64,
    /// Characteristics of the target.
    pub target_characteristics: CharacteristicsUm,
    /// Characteristics of the planned flank.
    pub planned_characteristics: CharacteristicsUm,
}

/// A plan without its referee.
#[derive(Clone, Debug, Serialize)]
pub struct Preview {
    /// Process.
    pub process: &'static str,
    /// Tolerance of the job.
    pub tolerance_um: f64,
    /// Settings, as in the result of a plan.
    pub settings: Value,
    /// Warnings.
    pub warnings: Vec<Remark>,
    /// Flanks that are ground.
    pub flanks: BTreeMap<&'static str, PreviewFlank>,
    #[serde(skip)]
    motions: Vec<GrindingMotion>,
}

/// A picture of a preview.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PreviewChart {
    /// A picture of the flanks.
    Flanks(FlankPicture),
    /// The grinding motion over the feed.
    Motions,
}

impl PreviewChart {
    /// The charts with their names.
    pub const ALL: [(&'static str, Self); 5] = [
        ("target", Self::Flanks(FlankPicture::Target)),
        ("planned", Self::Flanks(FlankPicture::Planned)),
        ("deviation", Self::Flanks(FlankPicture::Deviation)),
        ("sections", Self::Flanks(FlankPicture::Sections)),
        ("motions", Self::Motions),
    ];
}

/// Plans a job as far as the planned flank.
///
/// # Errors
/// [`JobFailure`] as for a plan; a process without a preview, a job that takes its bodies from a catalogue.
pub fn preview_job(job: &AnyJob) -> Result<Preview, JobFailure> {
    match job {
        AnyJob::Grinding(loaded) if loaded.job.catalogue.is_some() => {
            let message = "a job that takes worm and dresser from a catalogue has no preview";
            let finding = Diagnostic::new(Problem::NotYetSupported, message)
                .field("catalogue")
                .way_out("plan it: the best pair is looked for");
            Err(RunFailure::bad_input(finding).into())
        }
        AnyJob::Grinding(loaded) => Ok(of_grinding(loaded)?),
        AnyJob::Tangential(loaded) => Ok(of_tangential(loaded)?),
        other => {
            let process = other.info().process.name();
            let finding =
                Diagnostic::new(Problem::ProcessNotAvailable, format!("\"{process}\" has no preview"))
                    .field("job.process")
                    .value(format!("\"{process}\""))
                    .allowed("\"generating-grinding\", \"tangential-dressing\"")
                    .way_out("plan the job: it is done at once");
            Err(RunFailure::bad_input(finding).into())
        }
    }
}

impl Preview {
    /// A chart, as the report of the plan would have it; `None` without anything to draw.
    ///
    /// # Errors
    /// [`ChartError`] for values that cannot be drawn.
    pub fn chart(&self, chart: PreviewChart) -> Result<Option<Svg>, ChartError> {
        match chart {
            PreviewChart::Flanks(picture) => flank_picture(&self.pictured()?, picture),
            PreviewChart::Motions if self.motions.is_empty() => Ok(None),
            PreviewChart::Motions => grinding_motion_chart(&self.motions).map(Some),
        }
    }

    fn pictured(&self) -> Result<Sides<Option<FlankReport>>, ChartError> {
        let mut flanks = Sides { left: None, right: None };
        for flank in Flank::BOTH {
            let Some(of) = self.flanks.get(flank.name()) else { continue };
            let map = |rows: &Vec<Vec<f64>>| {
                charts::Topography::new(of.w_mm.clone(), of.z_mm.clone(), rows.clone())
            };
            flanks[flank] = Some(FlankReport {
                amounts: Vec::new(),
                target: map(&of.target_um)?,
                planned: Some(map(&of.planned_um)?),
                simulated: None,
                target_values: characteristics(&of.target_characteristics),
                planned_values: Some(characteristics(&of.planned_characteristics)),
                simulated_values: None,
                max_deviation_um: Some(of.max_deviation_um),
                rms_deviation_um: Some(of.rms_deviation_um),
                model_difference_um: None,
                outside: Vec::new(),
                profiles: Vec::new(),
                helices: Vec::new(),
            });
        }
        Ok(flanks)
    }
}

fn previewed(target: &Topography, planned: &Topography, cos_b: f64) -> PreviewFlank {
    let deviation = planned.minus(target);
    PreviewFlank {
        w_mm: target.w.clone(),
        z_mm: target.z.clone(),
        target_um: target.rows_um(),
        planned_um: planned.rows_um(),
        max_deviation_um: deviation.largest() * 1e3,
        rms_deviation_um: deviation.rms() * 1e3,
        target_characteristics: CharacteristicsUm::of(target, cos_b),
        planned_characteristics: CharacteristicsUm::of(planned, cos_b),
    }
}

fn of_grinding(loaded: &LoadedJob) -> Result<Preview, RunFailure> {
    let job = &loaded.job;
    let ready = prepare(loaded)?;
    let plan = ready.task(job).plan().map_err(|e| RunFailure::from(&e))?;
    let execution = Execution::of_plan(job, &ready, &plan);
    let partition = Partition::of_job(job, &ready, execution.ratio, &execution.motion.shift)?;
    let strokes = StrokePlan::of_job(job)?;
    let tip_lands = TipLands::of_execution(job, &ready, &execution, true)?;
    let settings = settings_result(&ready, &execution, Some(&plan), partition, strokes, &tip_lands);
    let flanks = execution.flanks.iter().filter_map(|(flank, executed)| {
        let executed = executed.as_ref()?;
        let cos_b = ready.setup.lines[flank].cos_b2;
        Some((flank.name(), previewed(&executed.target, &executed.planned, cos_b)))
    });
    let mut warnings = ready.warnings.clone();
    warnings.extend(execution.warnings.iter().cloned());
    warnings.extend(tip_lands.warnings);
    Ok(Preview {
        process: job.job.process.name(),
        tolerance_um: ready.tolerance.tightest() * 1e3,
        settings: document(&settings)?,
        warnings,
        flanks: flanks.collect(),
        motions: vec![grinding_motion("both flanks", &execution.motion, execution.feed_range)],
    })
}

fn of_tangential(loaded: &LoadedTangentialJob) -> Result<Preview, RunFailure> {
    let previewed_passes = preview_passes(loaded)?;
    let mut flanks = BTreeMap::new();
    for PreviewedPass { flank, target, planned, cos_b } in &previewed_passes.flanks {
        flanks.insert(flank.name(), previewed(target, planned, *cos_b));
    }
    Ok(Preview {
        process: loaded.job.job.process.name(),
        tolerance_um: loaded.job.target.tolerance_um,
        settings: document(&previewed_passes.settings)?,
        warnings: previewed_passes.warnings,
        flanks,
        motions: Vec::new(),
    })
}

fn document(settings: &impl Serialize) -> Result<Value, RunFailure> {
    serde_json::to_value(settings).map_err(|error| {
        let message = format!("the settings cannot be written: {error}");
        RunFailure::bad_input(Diagnostic::new(Problem::InvalidJob, message).way_out("plan the job"))
    })
}
