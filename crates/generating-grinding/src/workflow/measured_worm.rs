//! Which axes of dressing a measured worm points to: deviations, the same all along the worm, with which the planned motion leaves what was
//! measured (`docs/mathematics/dressing.md#axes-and-their-deviations`).

use super::execution::{ExecutedFlank, Execution};
use super::prepare::Prepared;
use crate::job::{DegreeOfFreedom, LoadedJob, MeasuredWorm};
use crate::worm_file::{WormPoints, read_measured_worm};
use dressing::{
    DressedWorm, DressingError, MeasuredFlank, RecoveredDeviation, Recovery, recover_from_points,
};
use foundation::geometry::{Flank, Sides};
use job::{Diagnostic, Problem};
use run::RunFailure;
use schemars::JsonSchema;
use serde::Serialize;

const FIELD: &str = "measured_worm";

/// A measured worm as a job gives it.
#[derive(Clone, Debug)]
pub struct MeasuredWormTask {
    of: MeasuredWorm,
    points: WormPoints,
}

/// What a measured worm says of the dressing axes.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MeasuredWormResult {
    /// Measured points that the planned motion dresses.
    pub points: usize,
    /// Points beside the dressed area, which are not used.
    pub points_left_out: usize,
    /// Root of the mean square of measured less planned, each flank about its mean unless the thickness is known.
    pub rms_um: f64,
    /// The same less what the deviations explain.
    pub rms_left_um: f64,
    /// The axes with what each would be off by, under the names that `deviations.dressing` has.
    pub axes: Vec<WormAxis>,
}

/// An axis of dressing that would be off.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WormAxis {
    /// "d_phi_S_deg", "d_gamma_deg", "d_d_mm" or "d_v_yA_mm".
    pub axis: &'static str,
    /// Its deviation in the unit of the name.
    pub value: f64,
    /// Its standard uncertainty: from the noise, or from what is left where that is more; 0 for an axis that is taken to stand right.
    pub uncertainty: f64,
}

const NAMES: [&str; 4] = ["d_phi_S_deg", "d_gamma_deg", "d_d_mm", "d_v_yA_mm"];

impl MeasuredWormTask {
    /// Of a job.
    ///
    /// # Errors
    /// A finding on `measured_worm.file` for a table that cannot be read.
    pub(super) fn of_job(loaded: &LoadedJob) -> Result<Option<Self>, RunFailure> {
        let Some(of) = &loaded.job.measured_worm else { return Ok(None) };
        let points = read_measured_worm(&loaded.beside(&of.file)).map_err(|error| {
            let finding = Diagnostic::new(Problem::InvalidTable, error.to_string());
            RunFailure::bad_input(
                finding
                    .field("measured_worm.file")
                    .value(format!("{:?}", of.file))
                    .allowed("a table with the columns flank, w_mm, z_mm, um")
                    .way_out("correct the table, one row for each measured point of the worm"),
            )
        })?;
        Ok(Some(Self { of: of.clone(), points }))
    }
}

/// What the measured worm of a job says; `None` for a job without one.
///
/// # Errors
/// A finding on `measured_worm` for points that the motion does not dress, and for points that do not tell the axes apart.
pub(super) fn measured_worm(
    prepared: &Prepared,
    execution: &Execution,
) -> Result<Option<MeasuredWormResult>, RunFailure> {
    let (Some(task), Some(dresser)) = (&prepared.measured_worm, &execution.dresser) else { return Ok(None) };
    let corrections =
        |flank: Flank| Some(&execution.flanks[flank].as_ref().and_then(ExecutedFlank::dressing)?.corrections);
    let kept = Sides::from_fn(|flank| -> Vec<[f64; 3]> {
        let Some(corrections) = corrections(flank) else { return Vec::new() };
        let worm = DressedWorm::new(dresser, flank, corrections);
        task.points[flank].iter().filter(|[w, z, _]| worm.modification(*w, *z).is_some()).copied().collect()
    });
    let used: Vec<MeasuredFlank<'_>> = Flank::BOTH
        .into_iter()
        .filter(|&flank| !kept[flank].is_empty())
        .filter_map(|flank| {
            Some(MeasuredFlank { flank, corrections: corrections(flank)?, points: &kept[flank] })
        })
        .collect();
    let count = |points: &WormPoints| points.left.len() + points.right.len();
    if used.is_empty() {
        let finding =
            Diagnostic::new(Problem::InvalidTable, "the planned motion dresses none of the measured points")
                .field("measured_worm.file")
                .value(format!("{} points", count(&task.points)))
                .allowed("points of flanks that are ground, within the dressed length of the worm")
                .way_out("give lengths of roll and heights of the worm, not of the gear");
        return Err(RunFailure::bad_input(finding));
    }
    let held = DegreeOfFreedom::ALL.map(|axis| task.of.holds(axis).then_some(0.0));
    let known = Recovery { noise: task.of.noise_um * 1e-3, held };
    let radius = prepared.setup.worm_pitch_radius;
    let found =
        recover_from_points(dresser, radius, &used, &known, !task.of.thickness).map_err(|e| refused(&e))?;
    let before: Vec<f64> = used.iter().flat_map(|of| off(dresser, of, !task.of.thickness)).collect();
    let rms = (before.iter().map(|f| f * f).sum::<f64>() / before.len() as f64).sqrt();
    Ok(Some(MeasuredWormResult {
        points: count(&kept),
        points_left_out: count(&task.points) - count(&kept),
        rms_um: rms * 1e3,
        rms_left_um: found.residual_rms * 1e3,
        axes: axes(&found, &known),
    }))
}

/// Measured less planned, about its mean where `by_form`, mm.
fn off(dresser: &dressing::DresserTool, of: &MeasuredFlank<'_>, by_form: bool) -> Vec<f64> {
    let worm = DressedWorm::new(dresser, of.flank, of.corrections);
    let differences: Vec<f64> =
        of.points.iter().filter_map(|&[w, z, f]| Some(f - worm.modification(w, z)?.0)).collect();
    let mean = differences.iter().sum::<f64>() / differences.len().max(1) as f64;
    differences.into_iter().map(|f| if by_form { f - mean } else { f }).collect()
}

fn axes(found: &RecoveredDeviation, known: &Recovery) -> Vec<WormAxis> {
    // What the axes do not explain is uncertainty too.
    let scatter = (found.residual_rms / known.noise).max(1.0);
    let of = |j: usize| {
        let unit = if j < 2 { 180.0 / std::f64::consts::PI } else { 1.0 };
        WormAxis {
            axis: NAMES[j],
            value: found.deviation[j] * unit,
            uncertainty: scatter * found.standard_deviation[j] * unit,
        }
    };
    (0..4).map(of).collect()
}

fn refused(error: &DressingError) -> RunFailure {
    RunFailure::bad_input(Diagnostic::of(error).field(FIELD))
}
