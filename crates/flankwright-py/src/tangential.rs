//! Tangential dressing: the flank that design variables leave, and its exact derivatives by them.

use flankwright::contact::Measure;
use flankwright::exchange::{Diagnostic, TangentialJob};
use flankwright::geometry::Flank;
use flankwright::process::tangential_dressing::{
    Channel, FitGrid, LARGEST_EXPONENT, RollGrid, TangentialError, TangentialFlank, TangentialSettings,
    Variable,
};
use flankwright::workflow::tangential::{TangentialPrepared, prepare_tangential};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArray3, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::arrays::shaped;
use crate::beside::beside;
use crate::failure::Failure;
use crate::gear::flank_of;
use crate::job::CoreJob;
use crate::samples::of_samples;

/// The bodies of a job of tangential dressing, and the grid of one of its flanks.
#[pyclass(frozen, module = "flankwright._core")]
pub struct CoreTangential {
    prepared: TangentialPrepared,
    measure: Measure,
    flank: Flank,
    pass: Vec<Flank>,
    grid: RollGrid,
}

/// Numbers over the grid, mm to um.
fn um(values: &[f64]) -> impl Iterator<Item = f64> + '_ {
    values.iter().map(|f| f * 1e3)
}

fn failure(error: &TangentialError) -> Failure {
    let finding = Diagnostic::of(error);
    Failure::of_bodies(error.is_bad_input(), &finding)
}

fn variables(py: Python<'_>, names: &[String]) -> PyResult<Vec<Variable>> {
    let of = |name: &String| {
        let digits = name.find(|c: char| c.is_ascii_digit())?;
        let (channel, exponent) = name.split_at(digits);
        let exponent = exponent.parse().ok().filter(|&k| k <= LARGEST_EXPONENT)?;
        Some(Variable::power(Channel::of_name(channel)?, exponent))
    };
    let unknown = |name: &String| {
        let channels: Vec<&str> = Channel::ALL.iter().map(|channel| channel.name()).collect();
        let finding = Diagnostic::with_code("unknown-value", format!("there is no variable `{name}`"));
        let finding = finding.field("names").value(name.clone());
        let allowed =
            format!("a channel ({}) and an exponent from 0 to {LARGEST_EXPONENT}", channels.join(", "));
        Failure::bad_input(&finding.allowed(allowed).way_out("write for example Fz2")).raised(py)
    };
    names.iter().map(|name| of(name).ok_or_else(|| unknown(name))).collect()
}

impl CoreTangential {
    fn shape(&self) -> (usize, usize) {
        (self.grid.w.len(), self.grid.z.len())
    }

    fn of(&self, settings: &TangentialSettings) -> TangentialFlank<'_> {
        TangentialFlank::new(&self.prepared.model, self.flank, &self.pass, settings, self.measure)
    }

    fn on_grid<'py>(&self, py: Python<'py>, values: Vec<f64>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        shaped(py, self.shape(), values)
    }
}

#[pymethods]
impl CoreTangential {
    /// `points` each way, at equidistant radii (as the source has it) or equidistant in the length of roll.
    #[new]
    fn new(
        py: Python<'_>,
        job: &Bound<'_, CoreJob>,
        flank: &str,
        points: usize,
        radii: bool,
    ) -> PyResult<Self> {
        let flank = flank_of(py, flank)?;
        let Some(loaded) = job.get().job.of::<TangentialJob>() else {
            let finding =
                Diagnostic::with_code("process-not-available", "this is no job of tangential dressing");
            let finding = finding.field("job.process").allowed("\"tangential-dressing\"");
            return Err(
                Failure::bad_input(&finding.way_out("use Forward for generating grinding")).raised(py)
            );
        };
        let prepared =
            beside(py, || prepare_tangential(loaded))?.map_err(|error| Failure::from(&error).raised(py))?;
        let pass = prepared.passes.iter().find(|pass| pass.contains(&flank)).cloned();
        let Some(pass) = pass else {
            let finding = Diagnostic::with_code("invalid-job", "this flank is not ground by the job");
            let finding = finding.field("flank").value(flank.name());
            return Err(Failure::bad_input(&finding.way_out("take the other flank")).raised(py));
        };
        let measure = prepared.rules.measure;
        if points < 2 {
            let finding = Diagnostic::with_code("invalid-number", "a grid has at least two points each way");
            let finding = finding.field("points").value(points.to_string()).allowed("2 or more");
            return Err(Failure::bad_input(&finding.way_out("take 9")).raised(py));
        }
        let grid = if radii { FitGrid::Radii(points) } else { FitGrid::Equidistant(points, points) };
        let grid = grid.of(&prepared.model, flank);
        Ok(Self { prepared, measure, flank, pass, grid })
    }

    /// Channels: name, meaning, unit of a coefficient.
    #[staticmethod]
    fn channels() -> Vec<(&'static str, &'static str, &'static str)> {
        Channel::ALL.iter().map(|channel| (channel.name(), channel.meaning(), channel.unit())).collect()
    }

    /// Lengths of roll, mm.
    #[getter]
    fn w<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.grid.w)
    }

    /// Axial positions, mm.
    #[getter]
    fn z<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.grid.z)
    }

    /// Radii of the lengths of roll, mm.
    #[getter]
    fn radii<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let radii = self.grid.w.iter().map(|&w| self.prepared.model.radius(self.flank, w));
        radii.collect::<Vec<f64>>().into_pyarray(py)
    }

    /// What is wanted, um.
    #[getter]
    fn target<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let wanted = self.grid.points().map(|(w, z)| 1e3 * self.prepared.wanted(self.flank, w, z));
        self.on_grid(py, wanted.collect())
    }

    /// Flanks of all samples (rows) of variables (columns, named): `[sample][profile][helix]`, um.
    #[pyo3(signature = (names, samples, progress=None))]
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        names: Vec<String>,
        samples: PyReadonlyArray2<'py, f64>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let variables = variables(py, &names)?;
        let samples = samples.as_array();
        let values = of_samples(py, progress, samples, |row| {
            let settings = TangentialSettings::default().with(&variables, row);
            let found = self.of(&settings).deviations(&self.grid);
            found.map(|f| um(&f).collect()).map_err(|error| failure(&error))
        })?;
        let (nw, nz) = self.shape();
        shaped(py, (samples.nrows(), nw, nz), values)
    }

    /// Exact derivatives of the flank by variables, where they have these values: `[variable][profile][helix]`, um per mm or rad.
    fn sensitivities<'py>(
        &self,
        py: Python<'py>,
        names: Vec<String>,
        values: Vec<f64>,
    ) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let variables = variables(py, &names)?;
        let settings = TangentialSettings::default().with(&variables, &values);
        let found = beside(py, || self.of(&settings).linearised(&self.grid, &variables))?;
        let (_, by) = found.map_err(|error| failure(&error).raised(py))?;
        let (nw, nz) = self.shape();
        // A column a variable, stored column by column.
        shaped(py, (variables.len(), nw, nz), um(by.as_slice()).collect())
    }
}
