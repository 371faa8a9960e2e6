//! Measurements: one gear alone or against its job, a folder of them, switching angles of a skiving tool.

use std::path::PathBuf;

use flankwright::exchange::inspection::{DatumFace, SlopeReference};
use flankwright::exchange::{Diagnostic, Job, SkivingJob};
use flankwright::geometry::Sides;
use flankwright::numerics::Progress;
use flankwright::workflow::inspection::series::{
    SeriesOptions, inspect_series as evaluate, measured_parts_in,
};
use flankwright::workflow::inspection::{SheetOptions, Statements, inspect_for_job, inspect_gear};
use flankwright::workflow::skiving::inspect_skiving;
use flankwright::workflow::{JobFailure, RunFailure};
use pyo3::prelude::*;

use crate::failure::Failure;
use crate::job::CoreJob;
use crate::outcome::{CoreResult, Held};
use crate::watch::watched;

/// What files do not tell: other end, signs of slopes (left, right), `+z` or `-z`, lengths of helix and profile slopes (`face-width`,
/// `range`).
type Stated = (bool, Option<(f64, f64)>, Option<String>, Option<String>, Option<String>);

fn statements(stated: Stated) -> Result<Statements, Failure> {
    let (other_end, signs, face, helix, profile) = stated;
    let wrong = |field: &str, value: &str, allowed: &str| {
        let finding = Diagnostic::with_code("unknown-value", format!("{field} does not take {value:?}"));
        let finding = finding.field(field.to_owned()).value(value.to_owned()).allowed(allowed.to_owned());
        Failure::bad_input(&finding.way_out("choose one of these"))
    };
    let over = |field: &str, of: Option<String>| match of.as_deref() {
        None => Ok(None),
        Some("face-width") => Ok(Some(SlopeReference::FaceWidth)),
        Some("range") => Ok(Some(SlopeReference::Range)),
        Some(other) => Err(wrong(field, other, "face-width, range")),
    };
    let datum_face = match face.as_deref() {
        None => None,
        Some("+z") => Some(DatumFace::PlusZ),
        Some("-z") => Some(DatumFace::MinusZ),
        Some(other) => return Err(wrong("datum_face", other, "+z, -z")),
    };
    if let Some((left, right)) = signs.filter(|(left, right)| left.abs() != 1.0 || right.abs() != 1.0) {
        return Err(wrong("slope_signs", &format!("{left}, {right}"), "1 or -1 for each flank"));
    }
    Ok(Statements {
        other_end,
        slope_signs: signs.map(|(left, right)| Sides { left, right }),
        datum_face,
        helix_slope_over: over("helix_slope_over", helix)?,
        profile_slope_over: over("profile_slope_over", profile)?,
    })
}

/// Evaluates a measurement, alone or against a job.
#[pyfunction]
#[pyo3(signature = (file, job, stated, tolerance_class=None, progress=None))]
pub fn inspect(
    py: Python<'_>,
    file: PathBuf,
    job: Option<&Bound<'_, CoreJob>>,
    stated: Stated,
    tolerance_class: Option<i32>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<CoreResult> {
    let statements = statements(stated).map_err(|failure| failure.raised(py))?;
    let job = job.map(Bound::get);
    let work = |progress: &dyn Progress| -> Result<Held, JobFailure> {
        let Some(job) = job.map(|job| &job.job) else {
            return Ok(Held::Completed(Box::new(inspect_gear(&file, &statements, tolerance_class)?)));
        };
        if let Some(loaded) = job.of::<SkivingJob>() {
            return Ok(Held::Completed(Box::new(inspect_skiving(loaded, &file, progress)?)));
        }
        if let Some(loaded) = job.of::<Job>() {
            let found = inspect_for_job(loaded, &file, &statements, tolerance_class, progress)?;
            return Ok(Held::Completed(Box::new(found)));
        }
        let message = "measurements are compared with a job of generating grinding or of a skiving tool";
        let finding = Diagnostic::with_code("process-not-available", message).field("job.process");
        let finding =
            finding.value(job.info().process.name()).allowed("generating-grinding, skiving-tool-measuring");
        let finding = finding.way_out("leave the job out, or take the one by which the part was made");
        Err(RunFailure::bad_input(finding).into())
    };
    let done = watched(py, progress, |progress| CoreResult::of(|| work(progress)))?;
    done.map_err(|failure| Failure::from(&failure).raised(py))
}

/// Evaluates a folder of measurements as a series.
#[pyfunction]
#[pyo3(signature = (folder, stated, tolerance_class=None))]
pub fn inspect_series(
    py: Python<'_>,
    folder: PathBuf,
    stated: Stated,
    tolerance_class: Option<i32>,
) -> PyResult<CoreResult> {
    let statements = statements(stated).map_err(|failure| failure.raised(py))?;
    let work = || -> Result<Held, JobFailure> {
        let found = measured_parts_in(&folder)?;
        let options = SeriesOptions {
            sheet: SheetOptions { tolerance_class, ..SheetOptions::default() },
            statements,
            left_out: found.left_out,
            ..SeriesOptions::default()
        };
        Ok(Held::Series(Box::new(evaluate(&found.parts, &options)?)))
    };
    let done = watched(py, None, |_| CoreResult::of(work))?;
    done.map_err(|failure| Failure::from(&failure).raised(py))
}
