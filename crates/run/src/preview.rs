//! The plan without its referee, for somebody who turns an amount and wants to see what becomes of the flank. What comes out is the exact
//! contact of the planned motions, as in a whole plan; it is not verified by the referee.

use super::characteristics::CharacteristicsUm;
use super::finding::{Remark, RunFailure};
use super::grinding_motion::{GrindingMotion, grinding_motion_chart};
use foundation::geometry::{Flank, Sides};
use job::{Diagnostic, Problem};
use metrology::Topography;
use report::charts::{self, ChartError, Svg};
use report::{DrawnFlanks, FlankPicture, FlankStages, flank_picture};
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;

/// A flank as planned.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
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
#[derive(Clone, Debug, Serialize, JsonSchema)]
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
    /// Motions over the feed, for the chart `motions`.
    #[serde(skip)]
    pub motions: Vec<GrindingMotion>,
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

    fn pictured(&self) -> Result<DrawnFlanks, ChartError> {
        Sides::try_from_fn(|flank: Flank| {
            let Some(of) = self.flanks.get(flank.name()) else { return Ok(None) };
            let map = |rows: &Vec<Vec<f64>>| {
                charts::Topography::new(of.w_mm.clone(), of.z_mm.clone(), rows.clone())
            };
            Ok(Some(FlankStages {
                target: map(&of.target_um)?,
                planned: map(&of.planned_um)?,
                simulated: None,
                profile_marks: Vec::new(),
                helix_marks: Vec::new(),
                profiles: Vec::new(),
                helices: Vec::new(),
            }))
        })
    }
}

impl PreviewFlank {
    /// A flank from what is wanted and what is planned, normal; `cos_b` is the cosine of the base helix angle.
    pub fn of(target: &Topography, planned: &Topography, cos_b: f64) -> Self {
        let deviation = planned.minus(target);
        Self {
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
}

impl Preview {
    /// Settings as the document that a preview holds.
    ///
    /// # Errors
    /// Settings that JSON cannot hold.
    pub fn settings_of(settings: &impl Serialize) -> Result<Value, RunFailure> {
        serde_json::to_value(settings).map_err(|error| {
            let message = format!("the settings cannot be written as JSON: {error}");
            RunFailure::bad_input(Diagnostic::new(Problem::InvalidJob, message).way_out("plan the job"))
        })
    }
}
