//! The electronic gearbox: coupling, budget, errors over time, pulses.

use electronic_gearbox::pulse::PulseKind;
use flankwright::exchange::Diagnostic;
use flankwright::workflow::gearbox::GearboxModel;
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::shaped;
use crate::failure::Failure;
use crate::job::CoreJob;
use crate::samples::of_samples;
use crate::watch::watched;

/// The gearbox of a job.
#[pyclass(frozen, module = "flankwright._core")]
pub struct CoreGearbox {
    model: GearboxModel,
}

/// What a budget tells, in mm but for the last two: um at the flank, and mm/s.
const BUDGET: [&str; 6] =
    ["quantisation", "truncation", "synchronisation", "acceleration", "flank_um", "greatest_speed"];

#[pymethods]
impl CoreGearbox {
    #[new]
    fn new(py: Python<'_>, job: &Bound<'_, CoreJob>) -> PyResult<Self> {
        let job = job.get();
        let made = watched(py, None, |_| GearboxModel::new(&job.job))?;
        Ok(Self { model: made.map_err(|failure| Failure::from(&failure).raised(py))? })
    }

    /// Clock, Hz.
    #[getter]
    fn clock(&self) -> f64 {
        self.model.clock()
    }

    /// The coupling, as JSON.
    fn coupling(&self, py: Python<'_>) -> PyResult<String> {
        serde_json::to_string(&self.model.coupling())
            .map_err(|error| Failure::internal(error.to_string()).raised(py))
    }

    /// Names of what a budget tells.
    #[staticmethod]
    fn budget_names() -> Vec<&'static str> {
        BUDGET.to_vec()
    }

    /// Budgets at rows of speed (mm/s) and acceleration (mm/s^2): `[row][name]`.
    fn budget<'py>(
        &self,
        py: Python<'py>,
        drives: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let drives = drives.as_array();
        let values = of_samples(py, None, drives, |row| {
            let budget = self.model.budget(row[0], row[1]).map_err(|e| Failure::from(&e))?;
            Ok(vec![
                budget.quantisation,
                budget.truncation,
                budget.synchronisation,
                budget.acceleration,
                budget.flank_um,
                budget.greatest_speed,
            ])
        })?;
        shaped(py, (drives.nrows(), BUDGET.len()), values)
    }

    /// Errors over the job's motion: `[stretch][time s, along the feed least and greatest mm, angle least and greatest rad]`.
    fn errors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let run = watched(py, None, |_| self.model.run())?;
        let bins = run.map_err(|failure| Failure::from(&failure).raised(py))?.bins;
        let of = |bin: usize, k: usize| {
            let bin = &bins[bin];
            [bin.time, bin.axial.least, bin.axial.greatest, bin.angle.least, bin.angle.greatest][k]
        };
        Ok(Array2::from_shape_fn((bins.len(), 5), |(bin, k)| of(bin, k)).into_pyarray(py))
    }

    /// Reference pulses of the job: ticks, signs, and the tick up to which it runs.
    fn references<'py>(
        &self,
        py: Python<'py>,
    ) -> (Bound<'py, PyArray1<u64>>, Bound<'py, PyArray1<i64>>, u64) {
        let (pulses, last) = self.model.references();
        let (ticks, signs): (Vec<u64>, Vec<i64>) = pulses.iter().copied().unzip();
        (ticks.into_pyarray(py), signs.into_pyarray(py), last)
    }

    /// Every pulse that reference pulses cause: tick, sign, kind (R, Z, K), turned parts.
    fn pulses<'py>(
        &self,
        py: Python<'py>,
        ticks: Vec<u64>,
        signs: Vec<i64>,
        last_tick: u64,
    ) -> PyResult<Bound<'py, PyDict>> {
        if ticks.len() != signs.len() {
            let finding =
                Diagnostic::with_code("invalid-list", "ticks and signs have other numbers of pulses");
            let finding = finding.field("signs").value(signs.len().to_string());
            let finding = finding.allowed(ticks.len().to_string()).way_out("give a sign for each tick");
            return Err(Failure::bad_input(&finding).raised(py));
        }
        let references: Vec<(u64, i64)> = ticks.into_iter().zip(signs).collect();
        let pulses = watched(py, None, |_| self.model.pulses(&references, last_tick))?;
        let pulses = pulses.map_err(|failure| Failure::from(&failure).raised(py))?;
        let all = PyDict::new(py);
        let ticks: Vec<u64> = pulses.iter().map(|(at, _)| at.tick).collect();
        let signs: Vec<i64> = pulses.iter().map(|(at, _)| at.pulse.direction.sign()).collect();
        let turned: Vec<i64> = pulses.iter().map(|(_, turned)| *turned).collect();
        let kinds: Vec<u8> = pulses.iter().map(|(at, _)| kind(at.pulse.kind)).collect();
        all.set_item("tick", ticks.into_pyarray(py))?;
        all.set_item("sign", signs.into_pyarray(py))?;
        all.set_item("kind", kinds.into_pyarray(py))?;
        all.set_item("turned", turned.into_pyarray(py))?;
        Ok(all)
    }
}

/// Letters of the kinds as bytes.
fn kind(kind: PulseKind) -> u8 {
    match kind {
        PulseKind::Reference => b'R',
        PulseKind::Intermediate => b'Z',
        PulseKind::Correction => b'K',
    }
}
