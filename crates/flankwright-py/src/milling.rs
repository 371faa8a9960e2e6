//! A milled space: its flanks, the cutter at every row and column, its paths, and what the rows leave.

use flankwright::process::milling::{CutterLocation, FlankPlan};
use flankwright::workflow::milling::MillingModel;
use numpy::ndarray::{Array2, Array3};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::arrays::shaped;
use crate::beside::beside;
use crate::failure::Failure;
use crate::gear::places;
use crate::job::CoreJob;
use crate::watch::watched;

/// A planned space.
#[pyclass(frozen, module = "flankwright._core")]
pub struct CoreMilling {
    model: MillingModel,
}

impl CoreMilling {
    fn flank(&self, py: Python<'_>, number: usize) -> PyResult<&FlankPlan> {
        let found = self.model.plan().flanks.get(number);
        found.ok_or_else(|| Failure::internal(format!("there is no flank {number}")).raised(py))
    }
}

/// A number of every location, `[row][column]`.
fn of_locations(plan: &FlankPlan, of: impl Fn(&CutterLocation) -> f64) -> Array2<f64> {
    let columns = plan.rows.first().map_or(0, |row| row.locations.len());
    Array2::from_shape_fn((plan.rows.len(), columns), |(row, column)| of(&plan.rows[row].locations[column]))
}

/// A vector of every place, `[row][column][x, y, z]`.
fn vectors(plan: &FlankPlan, of: impl Fn(usize, usize) -> [f64; 3]) -> Array3<f64> {
    let columns = plan.lines.path.columns.len();
    Array3::from_shape_fn((plan.rows.len(), columns, 3), |(row, column, k)| of(row, column)[k])
}

#[pymethods]
impl CoreMilling {
    #[new]
    #[pyo3(signature = (job, progress=None))]
    fn new(py: Python<'_>, job: &Bound<'_, CoreJob>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let job = job.get();
        let made = watched(py, progress, |progress| MillingModel::new(&job.job, progress))?;
        Ok(Self { model: made.map_err(|failure| Failure::from(&failure).raised(py))? })
    }

    /// Flanks in the order of the plan.
    #[getter]
    fn flanks(&self) -> Vec<&'static str> {
        self.model.plan().flanks.iter().map(|flank| flank.side.name()).collect()
    }

    /// Height parameters at root and tip, length parameters of the face.
    fn range(&self, py: Python<'_>, flank: usize) -> PyResult<([f64; 2], [f64; 2])> {
        let active = &self.flank(py, flank)?.active;
        Ok((active.height_span(), active.face))
    }

    /// Points and unit normals out of the material at places (height, length) one by one: `[place][x, y, z, n_x, n_y, n_z]`.
    fn surface<'py>(
        &self,
        py: Python<'py>,
        flank: usize,
        heights: PyReadonlyArray1<'py, f64>,
        lengths: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let surface = &self.flank(py, flank)?.active.surface;
        let (heights, lengths) = places(py, &heights, &lengths)?;
        let values: Vec<f64> = py.detach(|| {
            let at = |(&a, &b): (&f64, &f64)| {
                let jet = surface.jet(a, b);
                jet.point.iter().chain(jet.normal.iter()).copied().collect::<Vec<f64>>()
            };
            heights.iter().zip(lengths).flat_map(at).collect()
        });
        shaped(py, (heights.len(), 6), values)
    }

    /// The cutter at every row and column.
    fn rows<'py>(&self, py: Python<'py>, flank: usize) -> PyResult<Bound<'py, PyDict>> {
        let plan = self.flank(py, flank)?;
        let columns = &plan.lines.path.columns;
        let place = |row: usize, column: usize| &columns[column].places[row];
        let at = |row: usize, column: usize| &plan.rows[row].locations[column];
        let all = PyDict::new(py);
        let lead: Vec<f64> = columns.iter().map(|column| column.lead.u).collect();
        all.set_item("lead", PyArray1::from_vec(py, lead))?;
        for (key, vectors) in [
            ("tip", vectors(plan, |row, column| at(row, column).tip.into())),
            ("axis", vectors(plan, |row, column| at(row, column).axis.into())),
            ("contact", vectors(plan, |row, column| place(row, column).jet.point.into())),
            ("normal", vectors(plan, |row, column| place(row, column).jet.normal.into())),
        ] {
            all.set_item(key, vectors.into_pyarray(py))?;
        }
        let shape = (plan.rows.len(), columns.len());
        let of_places = |of: &dyn Fn(usize, usize) -> f64| Array2::from_shape_fn(shape, |(r, c)| of(r, c));
        for (key, numbers) in [
            ("height", of_places(&|row, column| place(row, column).height)),
            ("length", of_places(&|row, column| place(row, column).length)),
            ("contact_height", of_locations(plan, |at| at.contact_height)),
            ("contact_radius", of_locations(plan, |at| at.contact_radius)),
            ("tilt", of_locations(plan, |at| at.tilt)),
        ] {
            all.set_item(key, numbers.into_pyarray(py))?;
        }
        let beside = Array2::from_shape_fn(shape, |(row, column)| place(row, column).is_virtual);
        all.set_item("beside_face", beside.into_pyarray(py))?;
        Ok(all)
    }

    /// All paths in the order of cutting: operation, and `[place][x, y, z, i, j, k]` of tip (mm) and axis.
    fn paths<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let all = PyList::empty(py);
        for operation in &self.model.plan().operations {
            let name = operation.kind.to_string();
            for path in &operation.paths {
                let values: Vec<f64> = path
                    .places
                    .iter()
                    .flat_map(|at| at.tip.iter().chain(at.axis.iter()).copied().collect::<Vec<f64>>())
                    .collect();
                all.append((name.as_str(), shaped(py, (path.places.len(), 6), values)?))?;
            }
        }
        Ok(all)
    }

    /// What the rows leave, mm, > 0 stock: scallop and chord over heights and lengths, NaN where no row comes by.
    fn predicted<'py>(
        &self,
        py: Python<'py>,
        flank: usize,
        heights: Vec<f64>,
        lengths: Vec<f64>,
    ) -> PyResult<[Bound<'py, PyArray2<f64>>; 2]> {
        self.flank(py, flank)?;
        let found = beside(py, || self.model.predicted(flank, &heights, &lengths))?;
        let found = found.map_err(|failure| Failure::from(&failure).raised(py))?;
        let shape = (heights.len(), lengths.len());
        let of = |part: fn(&flankwright::process::milling::Prediction) -> f64| {
            let values = found.iter().map(|at| at.as_ref().map_or(f64::NAN, part)).collect();
            shaped(py, shape, values)
        };
        Ok([of(|at| at.scallop)?, of(|at| at.chord)?])
    }
}
