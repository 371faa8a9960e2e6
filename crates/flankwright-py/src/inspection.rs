//! Measurements: one gear alone or against its job, a folder of them, a blank before grinding, switching angles of a skiving tool.

use std::path::PathBuf;

use flankwright::exchange::inspection::{DatumFace, SlopeReference};
use flankwright::exchange::job::Language;
use flankwright::exchange::{AnyJob, Diagnostic, Job, MillingJob, SkivingJob};
use flankwright::geometry::Sides;
use flankwright::numerics::Progress;
use flankwright::workflow::inspection::series::{
    SeriesOptions, inspect_series as evaluate, measured_parts_in,
};
use flankwright::workflow::inspection::{
    BlankStock, GearInspection, MeasuredStock, SheetOptions, Statements, blank_of_file, inspect_bevel,
    inspect_for_job, inspect_for_milling, inspect_gear, write_blank,
};
use flankwright::workflow::skiving::inspect_skiving;
use flankwright::workflow::{JobFailure, RunFailure};
use numpy::PyArray1;
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::shaped;
use crate::beside::beside;
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

/// `en` or `de`.
fn language(word: Option<&str>) -> Result<Option<Language>, Failure> {
    match word {
        None => Ok(None),
        Some("en") => Ok(Some(Language::En)),
        Some("de") => Ok(Some(Language::De)),
        Some(other) => {
            let finding = Diagnostic::with_code("unknown-value", format!("language does not take {other:?}"));
            let finding = finding.field("language").value(other).allowed("en, de");
            Err(Failure::bad_input(&finding.way_out("choose one of these")))
        }
    }
}

/// Evaluates a measurement, alone or against a job.
#[pyfunction]
#[pyo3(signature = (file, job, stated, tolerance_class=None, language=None, progress=None))]
pub fn inspect(
    py: Python<'_>,
    file: PathBuf,
    job: Option<&Bound<'_, CoreJob>>,
    stated: Stated,
    tolerance_class: Option<i32>,
    language: Option<&str>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<CoreResult> {
    let statements = statements(stated).map_err(|failure| failure.raised(py))?;
    let language = self::language(language).map_err(|failure| failure.raised(py))?;
    let told = |mut found: GearInspection| {
        found.language = language.unwrap_or(found.language);
        Held::Completed(Box::new(found))
    };
    let job = job.map(Bound::get);
    let work = |progress: &dyn Progress| -> Result<Held, JobFailure> {
        let Some(job) = job.map(|job| &job.job) else {
            return Ok(told(inspect_gear(&file, &statements, tolerance_class)?));
        };
        if let Some(loaded) = job.of::<SkivingJob>() {
            let mut loaded = loaded.clone();
            loaded.job.output.language = language.unwrap_or(loaded.job.output.language);
            return Ok(Held::Completed(Box::new(inspect_skiving(&loaded, &file, progress)?)));
        }
        if let Some(loaded) = job.of::<Job>() {
            return Ok(told(inspect_for_job(loaded, &file, &statements, tolerance_class, progress)?));
        }
        if let Some(loaded) = job.of::<MillingJob>().filter(|loaded| loaded.job.bevel.is_some()) {
            let mut found = inspect_bevel(loaded, &file, tolerance_class, progress)?;
            found.language = language.unwrap_or(found.language);
            return Ok(Held::Completed(Box::new(found)));
        }
        if let Some(loaded) = job.of::<MillingJob>() {
            return Ok(told(inspect_for_milling(loaded, &file, &statements, tolerance_class, progress)?));
        }
        let message = "measurements are compared with a job of generating grinding, five-axis milling or of a skiving tool";
        let way_out = "leave the job out, or take the one by which the part was made";
        Err(other_process(
            job,
            message,
            "generating-grinding, five-axis-milling, skiving-tool-measuring",
            way_out,
        ))
    };
    let done = watched(py, progress, |progress| CoreResult::of(|| work(progress)))?;
    done.map_err(|failure| Failure::from(&failure).raised(py))
}

fn other_process(
    job: &AnyJob,
    message: &'static str,
    allowed: &'static str,
    way_out: &'static str,
) -> JobFailure {
    let finding = Diagnostic::with_code("process-not-available", message).field("job.process");
    let finding = finding.value(job.info().process.name()).allowed(allowed);
    RunFailure::bad_input(finding.way_out(way_out)).into()
}

/// Evaluates a folder of measurements as a series.
#[pyfunction]
#[pyo3(signature = (folder, stated, tolerance_class=None, language=None))]
pub fn inspect_series(
    py: Python<'_>,
    folder: PathBuf,
    stated: Stated,
    tolerance_class: Option<i32>,
    language: Option<&str>,
) -> PyResult<CoreResult> {
    let statements = statements(stated).map_err(|failure| failure.raised(py))?;
    let language = self::language(language).map_err(|failure| failure.raised(py))?;
    let work = || -> Result<Held, JobFailure> {
        let found = measured_parts_in(&folder)?;
        let options = SeriesOptions {
            sheet: SheetOptions { tolerance_class, ..SheetOptions::default() },
            statements,
            left_out: found.left_out,
            language: language.unwrap_or_default(),
            ..SeriesOptions::default()
        };
        Ok(Held::Series(Box::new(evaluate(&found.parts, &options)?)))
    };
    let done = watched(py, None, |_| CoreResult::of(work))?;
    done.map_err(|failure| Failure::from(&failure).raised(py))
}

/// The stock of a measured blank.
#[pyclass(frozen, module = "flankwright._core")]
pub struct CoreBlank {
    found: BlankStock,
}

#[pymethods]
impl CoreBlank {
    /// Reads the measurement of a blank of the gear of a job.
    #[new]
    fn new(py: Python<'_>, file: PathBuf, job: &Bound<'_, CoreJob>, stated: Stated) -> PyResult<Self> {
        let statements = statements(stated).map_err(|failure| failure.raised(py))?;
        let job = &job.get().job;
        let found = beside(py, || match job.of::<Job>() {
            Some(loaded) => blank_of_file(loaded, &file, &statements),
            None => {
                let message = "blanks are measured for a job of generating grinding";
                let way_out = "take the job by which the gear is going to be ground";
                Err(other_process(job, message, "generating-grinding", way_out))
            }
        })?;
        found.map(|found| Self { found }).map_err(|failure| Failure::from(&failure).raised(py))
    }

    /// The document, as JSON.
    fn document(&self, py: Python<'_>) -> PyResult<String> {
        let text = serde_json::to_string(&self.found.result);
        text.map_err(|error| Failure::internal(error.to_string()).raised(py))
    }

    /// Of each flank that was measured: `w`, `z` (mm), `spaces`, and `stock` (um) over spaces, w and z, beyond the allowance of the job.
    fn flanks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for (flank, stock) in self.found.flanks.iter() {
            let Some(MeasuredStock { w, z, spaces }) = stock else { continue };
            let one = PyDict::new(py);
            one.set_item("w", PyArray1::from_slice(py, w))?;
            one.set_item("z", PyArray1::from_slice(py, z))?;
            one.set_item("spaces", spaces.iter().map(|(space, _)| *space).collect::<Vec<usize>>())?;
            let values: Vec<f64> = spaces.iter().flat_map(|(_, um)| um.iter().copied()).collect();
            one.set_item("stock", shaped(py, (spaces.len(), w.len(), z.len()), values)?)?;
            all.set_item(flank.name(), one)?;
        }
        Ok(all)
    }

    /// Writes the table and the document; their paths, the table first.
    fn write(&self, py: Python<'_>, directory: PathBuf) -> PyResult<Vec<PathBuf>> {
        let written = beside(py, || write_blank(&self.found, &directory))?;
        written.map_err(|error| PyOSError::new_err(error.to_string()))
    }
}
