//! A skiving tool at its light barrier: tracks, deviations with other noise, what they say of tool, workpiece and setting.

use flankwright::exchange::Diagnostic;
use flankwright::geometry::{Flank, Sides};
use flankwright::process::skiving::Setting;
use flankwright::process::skiving::evaluation::Deviations;
use flankwright::workflow::skiving::MeasuringModel;
use numpy::ndarray::{Array2, ArrayView3};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArray3, PyArray4, PyReadonlyArray3};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::shaped;
use crate::beside::beside;
use crate::failure::Failure;
use crate::gear::flank_of;
use crate::job::CoreJob;
use crate::watch::{on_each, watched};

/// Edges, tracks and the measured tool of a job.
#[pyclass(frozen, module = "flankwright._core")]
pub struct CoreMeasuring {
    model: MeasuringModel,
}

/// `[flank][track][tooth]`, left first.
fn in_order(deviations: &Deviations) -> impl Iterator<Item = f64> + '_ {
    deviations.iter().map(|(.., f)| f)
}

impl CoreMeasuring {
    /// Tracks of a flank, and teeth.
    fn shape(&self) -> [usize; 2] {
        let bodies = self.model.bodies();
        [bodies.flanks.left.tracks.len(), bodies.teeth()]
    }

    fn given(&self, py: Python<'_>, of: ArrayView3<'_, f64>) -> PyResult<Deviations> {
        let [tracks, teeth] = self.shape();
        if of.dim() != (2, tracks, teeth) {
            let finding = Diagnostic::with_code("invalid-list", "the deviations have another shape");
            let finding = finding.field("deviations").value(format!("{:?}", of.shape()));
            let finding = finding.allowed(format!("(2, {tracks}, {teeth}): flank, track, tooth"));
            return Err(Failure::bad_input(&finding.way_out("give a number for each")).raised(py));
        }
        let rows = |k: usize| {
            of.outer_iter()
                .nth(k)
                .map_or_else(Vec::new, |of| of.outer_iter().map(|row| row.to_vec()).collect())
        };
        Ok(Deviations { of: Sides { left: rows(0), right: rows(1) } })
    }
}

#[pymethods]
impl CoreMeasuring {
    #[new]
    fn new(py: Python<'_>, job: &Bound<'_, CoreJob>) -> PyResult<Self> {
        let job = job.get();
        let made = watched(py, None, |_| MeasuringModel::new(&job.job))?;
        Ok(Self { model: made.map_err(|failure| Failure::from(&failure).raised(py))? })
    }

    #[getter]
    fn teeth(&self) -> usize {
        self.model.bodies().teeth()
    }

    /// What the job measures, `[flank][track][tooth]`, mm; nothing where it measures nothing.
    #[getter]
    fn deviations<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArray3<f64>>>> {
        let Some(measurement) = self.model.measurement() else { return Ok(None) };
        let values = in_order(&measurement.measured.deviations).collect();
        let [tracks, teeth] = self.shape();
        shaped(py, (2, tracks, teeth), values).map(Some)
    }

    /// Names of the settings in their order.
    #[staticmethod]
    fn settings() -> Vec<&'static str> {
        Setting::ALL.map(setting_name).to_vec()
    }

    /// Tracks of a flank: places along the edge, virtual contact points and normals of the tool, levers.
    fn tracks<'py>(&self, py: Python<'py>, flank: &str) -> PyResult<Bound<'py, PyDict>> {
        let of = &self.model.bodies().flanks[flank_of(py, flank)?].tracks;
        let all = PyDict::new(py);
        let number = |of: &dyn Fn(usize) -> f64, count: usize| (0..count).map(of).collect::<Vec<f64>>();
        for (key, values) in [
            ("place", number(&|k| of[k].0.place, of.len())),
            ("w", number(&|k| of[k].0.contact.w, of.len())),
            ("lever", number(&|k| of[k].0.contact.lever, of.len())),
        ] {
            all.set_item(key, PyArray1::from_vec(py, values))?;
        }
        for (key, vectors) in [
            ("point", Array2::from_shape_fn((of.len(), 3), |(k, i)| of[k].0.contact.point[i])),
            ("normal", Array2::from_shape_fn((of.len(), 3), |(k, i)| of[k].0.contact.normal[i])),
        ] {
            all.set_item(key, vectors.into_pyarray(py))?;
        }
        Ok(all)
    }

    /// Change of the workpiece's flank at the tracks by the settings: `[setting][track]`, mm/mm and mm/rad.
    fn sensitivities<'py>(&self, py: Python<'py>, flank: &str) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let rows = self.model.sensitivities(flank_of(py, flank)?);
        Ok(Array2::from_shape_fn((4, rows.len()), |(k, track)| rows[track][k]).into_pyarray(py))
    }

    /// Measured deviations with the noise that begins at each seed: `[seed][flank][track][tooth]`, mm.
    #[pyo3(signature = (seeds, progress=None))]
    fn repeated<'py>(
        &self,
        py: Python<'py>,
        seeds: Vec<u64>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArray4<f64>>> {
        if self.model.measurement().is_none() {
            let finding = Diagnostic::with_code("missing-key", "the job measures nothing");
            let finding = finding.field("tool_errors");
            let finding = finding.way_out("add `[tool_errors]`; an empty table is a tool without errors");
            return Err(Failure::bad_input(&finding).raised(py));
        }
        let once = |_: usize, &seed: &u64| {
            let measured = self.model.repeated(seed).transpose().map_err(|e| Failure::from(&e))?;
            Ok(measured.iter().flat_map(|tool| in_order(&tool.deviations)).collect())
        };
        let values: Result<Vec<Vec<f64>>, Failure> =
            on_each(py, progress, "measurements", &seeds, once)?.into_iter().collect();
        let values = values.map_err(|failure| failure.raised(py))?;
        let [tracks, teeth] = self.shape();
        shaped(py, (seeds.len(), 2, tracks, teeth), values.concat())
    }

    /// What deviations (mm) say of the tool and the setting; lengths mm, angles rad.
    fn evaluated<'py>(
        &self,
        py: Python<'py>,
        deviations: PyReadonlyArray3<'py, f64>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let deviations = self.given(py, deviations.as_array())?;
        let found = beside(py, || self.model.evaluated(&deviations))?;
        let (found, fit) = found.map_err(|failure| Failure::from(&failure).raised(py))?;
        let [tracks, _] = self.shape();
        let all = PyDict::new(py);
        all.set_item("clocking", found.clocking)?;
        all.set_item("single_pitch", PyArray1::from_vec(py, found.pitch.single))?;
        all.set_item("cumulative_pitch", PyArray1::from_vec(py, found.pitch.cumulative))?;
        all.set_item("thickness", PyArray1::from_vec(py, found.pitch.thickness))?;
        all.set_item("eccentricity", PyArray1::from_slice(py, &found.mounting.eccentricity))?;
        all.set_item("wobble", PyArray1::from_slice(py, &found.mounting.wobble))?;
        for (key, of) in [("profile", &found.profile.track_means), ("workpiece", &found.profile.workpiece)] {
            let both = Array2::from_shape_fn((2, tracks), |(k, track)| of[Flank::BOTH[k]][track]);
            all.set_item(key, both.into_pyarray(py))?;
        }
        all.set_item("change", PyArray1::from_slice(py, &fit.change))?;
        all.set_item("limited", fit.limited.into_iter().map(setting_name).collect::<Vec<_>>())?;
        all.set_item("residual", shaped(py, (2, tracks), fit.residual)?)?;
        Ok(all)
    }
}

fn setting_name(setting: Setting) -> &'static str {
    match setting {
        Setting::CentreDistance => "centre_distance",
        Setting::CrossedAxesAngle => "crossed_axes_angle_deg",
        Setting::ToolShift => "tool_shift",
        Setting::ToolAngle => "tool_angle_deg",
    }
}
