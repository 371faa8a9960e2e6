//! What a flank should be: values of modifications on a field.

use flankwright::exchange::Diagnostic;
use flankwright::modification::{EvaluationField, Modification, ModificationError, ModificationSpec};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::failure::Failure;
use crate::gear::places;

/// A modification of one flank on its evaluation field.
#[pyclass(frozen, module = "flankwright._core")]
pub struct CoreModification {
    modification: Modification,
}

fn failure(error: &ModificationError) -> Failure {
    Failure::bad_input(&Diagnostic::of(error))
}

#[pymethods]
impl CoreModification {
    /// `spec` is JSON as in a job, or a list of them; `roll` and `face` are the field (mm).
    #[new]
    fn new(
        py: Python<'_>,
        spec: &str,
        roll: [f64; 2],
        face: [f64; 2],
        base_radius: f64,
        base_helix_angle: f64,
    ) -> PyResult<Self> {
        let made = || -> Result<Modification, Failure> {
            let spec = serde_json::from_str(spec).map_err(|error| Failure::internal(error.to_string()))?;
            let spec = ModificationSpec::from_json(&spec).map_err(|error| failure(&error))?;
            let field = EvaluationField::new(roll, face, base_radius, base_helix_angle);
            let field = field.map_err(|error| failure(&error))?;
            Modification::build(&spec, &field).map_err(|error| failure(&error))
        };
        Ok(Self { modification: made().map_err(|failure| failure.raised(py))? })
    }

    /// f_t at places (w, z), transverse, mm, positive = material left.
    fn values<'py>(
        &self,
        py: Python<'py>,
        w: PyReadonlyArray1<'py, f64>,
        z: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let (w, z) = places(py, &w, &z)?;
        let values: Result<Vec<f64>, _> =
            py.detach(|| w.iter().zip(z).map(|(&w, &z)| self.modification.value(w, z)).collect());
        let values = values.map_err(|error| Failure::bad_input(&Diagnostic::of(&error)).raised(py))?;
        Ok(values.into_pyarray(py))
    }

    /// cos(beta_b): normal over transverse values.
    #[getter]
    fn normal_factor(&self) -> f64 {
        self.modification.field().normal_factor()
    }
}
