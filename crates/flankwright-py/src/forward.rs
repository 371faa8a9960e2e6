//! The flank of a process whose axes are off, for many sets of deviations at once.

use flankwright::exchange::Diagnostic;
use flankwright::geometry::Flank;
use flankwright::workflow::{Deviation, ForwardModel};
use numpy::{IntoPyArray, PyArray1, PyArray4, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::shaped;
use crate::failure::Failure;
use crate::job::CoreJob;
use crate::outcome::array;
use crate::samples::{of_each_sample, of_samples};
use crate::watch::watched;

/// A planned process, ready to be run with deviations.
#[pyclass(frozen, module = "flankwright._core")]
pub struct CoreForward {
    model: ForwardModel,
    flanks: Vec<Flank>,
}

/// Flanks of all samples, and the exceptions of those that have none.
type Each<'py> = (Bound<'py, PyArray4<f64>>, Vec<(usize, Py<PyAny>)>);

impl CoreForward {
    fn columns(&self, py: Python<'_>, names: &[String]) -> PyResult<Vec<Deviation>> {
        let all = Deviation::all();
        let of = |name: &String| all.iter().copied().find(|deviation| deviation.name() == *name);
        let unknown = |name: &String| {
            let known: Vec<String> = all.iter().map(|deviation| deviation.name()).collect();
            let finding = Diagnostic::with_code("unknown-value", format!("there is no deviation `{name}`"));
            let finding = finding.field("names").value(name.clone()).allowed(known.join(", "));
            Failure::bad_input(&finding.way_out("choose among these")).raised(py)
        };
        names.iter().map(|name| of(name).ok_or_else(|| unknown(name))).collect()
    }
}

#[pymethods]
impl CoreForward {
    /// Plans a job, or takes its settings.
    #[new]
    fn new(py: Python<'_>, job: &Bound<'_, CoreJob>, points: [usize; 2]) -> PyResult<Self> {
        let job = job.get();
        let model = watched(py, None, |_| ForwardModel::new(&job.job, points))?;
        let model = model.map_err(|failure| Failure::from(&failure).raised(py))?;
        let flanks = Flank::BOTH.into_iter().filter(|&flank| model.target()[flank].is_some()).collect();
        Ok(Self { model, flanks })
    }

    /// Names of what may be off.
    #[staticmethod]
    fn names() -> Vec<String> {
        Deviation::all().into_iter().map(Deviation::name).collect()
    }

    /// Flanks that are ground, in the order of results.
    #[getter]
    fn flanks(&self) -> Vec<&'static str> {
        self.flanks.iter().map(|flank| flank.name()).collect()
    }

    /// Lengths of roll and axial positions of a flank (mm), and its target (um, normal).
    fn grid<'py>(&self, py: Python<'py>, flank: usize) -> PyResult<Bound<'py, PyDict>> {
        let grid = PyDict::new(py);
        let of = self.flanks.get(flank).and_then(|&flank| self.model.target()[flank].as_ref());
        if let Some(target) = of {
            grid.set_item("w", PyArray1::from_slice(py, &target.w))?;
            grid.set_item("z", PyArray1::from_slice(py, &target.z))?;
            grid.set_item("target", array(&target.rows_um()).map(|rows| rows.into_pyarray(py)))?;
        }
        Ok(grid)
    }

    /// Flanks of all samples (rows) of deviations (columns, named): `[sample][flank][profile][helix]`, um, normal; NaN for a sample that was
    /// refused. And the exceptions of those, by sample. Unless all are wanted, the first one is raised.
    #[pyo3(signature = (names, samples, progress=None, every=false))]
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        names: Vec<String>,
        samples: PyReadonlyArray2<'py, f64>,
        progress: Option<&Bound<'py, PyAny>>,
        every: bool,
    ) -> PyResult<Each<'py>> {
        let columns = self.columns(py, &names)?;
        let samples = samples.as_array();
        if samples.ncols() != columns.len() {
            let finding = Diagnostic::with_code(
                "invalid-list",
                "the samples have another number of columns than names",
            );
            let finding = finding.field("samples").value(samples.ncols().to_string());
            let finding = finding.allowed(columns.len().to_string()).way_out("give one column a name");
            return Err(Failure::bad_input(&finding).raised(py));
        }
        let shape = self.flanks.first().and_then(|&flank| self.model.target()[flank].as_ref());
        let [nw, nz] = shape.map_or([0, 0], |target| [target.w.len(), target.z.len()]);
        let each = self.flanks.len() * nw * nz;
        let one = |row: &[f64]| {
            let deviations: Vec<(Deviation, f64)> =
                columns.iter().copied().zip(row.iter().copied()).collect();
            let ground = self.model.flanks(&deviations).map_err(|failure| Failure::from(&failure))?;
            let mut values = Vec::with_capacity(each);
            for &flank in &self.flanks {
                values.extend(ground[flank].iter().flatten().map(|f| f * 1e3));
            }
            Ok(values)
        };
        let (values, failures) = if every {
            of_each_sample(py, progress, samples, each, one)?
        } else {
            (of_samples(py, progress, samples, one)?, Vec::new())
        };
        let refused = |(k, failure): (usize, Failure)| (k, failure.raised(py).into_value(py).into_any());
        let values = shaped(py, (samples.nrows(), self.flanks.len(), nw, nz), values)?;
        Ok((values, failures.into_iter().map(refused).collect()))
    }
}
