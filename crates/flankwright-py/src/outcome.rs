//! The result of a task.

use std::path::PathBuf;
use std::time::Instant;

use flankwright::workflow::inspection::series::{InspectionSeries, write_inspection_series};
use flankwright::workflow::{FlankMaps, TaskOutcome};
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::beside::beside;
use crate::failure::Failure;

/// A task that was carried out.
#[pyclass(frozen, module = "flankwright._core")]
pub struct CoreResult {
    /// Its result.
    pub held: Held,
    /// How long that took, s.
    #[pyo3(get)]
    pub seconds: f64,
}

/// What tasks come to.
pub enum Held {
    /// A task on a job.
    Completed(Box<dyn TaskOutcome>),
    /// A series of measured parts.
    Series(Box<InspectionSeries>),
}

/// Rows as an array; `None` where they are not equally long.
pub fn array(rows: &[Vec<f64>]) -> Option<Array2<f64>> {
    let columns = rows.first().map_or(0, Vec::len);
    let flat: Vec<f64> = rows.iter().flatten().copied().collect();
    Array2::from_shape_vec((rows.len(), columns), flat).ok()
}

impl CoreResult {
    /// Carries work out and takes the time.
    ///
    /// # Errors
    /// That of the work.
    pub fn of<E>(work: impl FnOnce() -> Result<Held, E>) -> Result<Self, E> {
        let begun = Instant::now();
        work().map(|held| Self { held, seconds: begun.elapsed().as_secs_f64() })
    }
}

#[pymethods]
impl CoreResult {
    /// `met`, `missed` or nothing.
    #[getter]
    fn status(&self) -> Option<String> {
        let Held::Completed(completed) = &self.held else { return None };
        let status = serde_json::to_value(completed.status()?).ok()?;
        status.as_str().map(str::to_owned)
    }

    /// The document, as JSON.
    fn document(&self, py: Python<'_>) -> PyResult<String> {
        let document = beside(py, || match &self.held {
            Held::Completed(completed) => {
                completed.document().and_then(|document| serde_json::to_string(&document))
            }
            Held::Series(series) => serde_json::to_string(&series.result),
        })?;
        document.map_err(|error| Failure::internal(error.to_string()).raised(py))
    }

    /// Writes all files; their paths, the page last.
    fn write(&self, py: Python<'_>, directory: PathBuf) -> PyResult<Vec<PathBuf>> {
        let written = beside(py, || match &self.held {
            Held::Completed(completed) => completed.write(&directory),
            Held::Series(series) => write_inspection_series(series, &directory),
        })?;
        written.map_err(|error| PyOSError::new_err(error.to_string()))
    }

    /// The flanks of a ground gear: name, then `w`, `z` (mm) and `target`, `planned`, `simulated` (um, normal) over them.
    fn flanks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let flanks: Vec<FlankMaps<'_>> = match &self.held {
            Held::Completed(completed) => completed.flanks(),
            Held::Series(_) => Vec::new(),
        };
        let all = PyDict::new(py);
        for flank in flanks {
            let one = PyDict::new(py);
            one.set_item("w", PyArray1::from_slice(py, flank.w_mm))?;
            one.set_item("z", PyArray1::from_slice(py, flank.z_mm))?;
            for (key, rows) in [
                ("target", flank.target_um),
                ("planned", flank.planned_um),
                ("simulated", flank.simulated_um),
            ] {
                let array: Option<Bound<'py, PyArray2<f64>>> = array(rows).map(|rows| rows.into_pyarray(py));
                one.set_item(key, array)?;
            }
            all.set_item(flank.name, one)?;
        }
        Ok(all)
    }
}
