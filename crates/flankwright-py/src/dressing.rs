//! The dresser of a worm: its profile, what it leaves in a position, and the position in which it leaves what is wanted.

use flankwright::exchange::Diagnostic;
use flankwright::geometry::Flank;
use flankwright::process::dressing::Condition;
use flankwright::workflow::DressingModel;
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArray2, PyArray3, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::arrays::shaped;
use crate::beside::beside;
use crate::failure::Failure;
use crate::gear::flank_of;
use crate::job::CoreJob;
use crate::samples::of_samples;

/// Worm and dresser of a job.
#[pyclass(frozen, module = "flankwright._core")]
pub struct CoreDresser {
    model: DressingModel,
}

/// Values at every point of a dressed profile: deviation, axial position, dresser radius, profile parameter; all mm.
const TOLD: usize = 4;

/// A condition as Python gives it: `point` (flank, w, f), `map` (flank, t, w), `fixed` (axis, value); mm and rad.
type Given = (String, String, f64, f64);

fn condition(py: Python<'_>, (kind, of, first, second): &Given) -> PyResult<Condition> {
    Ok(match kind.as_str() {
        "point" => Condition::Point { flank: flank_of(py, of)?, w: *first, f: *second },
        "map" => Condition::Map { flank: flank_of(py, of)?, t: *first, w: *second },
        _ => Condition::Fixed { j: *first as usize, x: *second },
    })
}

impl CoreDresser {
    fn on_profile(&self, py: Python<'_>, flank: Flank, t: f64) -> PyResult<()> {
        let (from, to) = self.model.flank(flank).profile.interval();
        if t >= from && t <= to {
            return Ok(());
        }
        let finding = Diagnostic::with_code("invalid-number", "the dresser has no profile there");
        let finding = finding.field("t").value(t.to_string()).allowed(format!("{from} to {to} mm"));
        Err(Failure::bad_input(&finding.way_out("stay on the profile")).raised(py))
    }
}

#[pymethods]
impl CoreDresser {
    #[new]
    fn new(py: Python<'_>, job: &Bound<'_, CoreJob>) -> PyResult<Self> {
        let job = &job.get().job;
        let model = beside(py, || DressingModel::new(job))?.map_err(|e| Failure::from(&e).raised(py))?;
        Ok(Self { model })
    }

    /// Lengths of roll of the worm that generate the gear's tip and root, mm.
    fn range(&self, py: Python<'_>, flank: &str) -> PyResult<(f64, f64)> {
        let range = self.model.flank(flank_of(py, flank)?).range;
        Ok((range.w_nf, range.w_na))
    }

    /// Ends of the profile's parameter, mm.
    fn interval(&self, py: Python<'_>, flank: &str) -> PyResult<(f64, f64)> {
        Ok(self.model.flank(flank_of(py, flank)?).profile.interval())
    }

    /// Nominal kinematics: worm angle, crossing angle (rad), centre distance, offset (mm), screw parameter (mm/rad).
    fn chain(&self, py: Python<'_>, flank: &str) -> PyResult<[f64; 5]> {
        let chain = self.model.flank(flank_of(py, flank)?).chain;
        Ok([
            chain.worm_angle,
            chain.crossing_angle,
            chain.centre_distance,
            chain.offset,
            chain.screw_parameter,
        ])
    }

    /// The meridian at parameters t: radius, axial position (mm), radial and axial part of the outward normal.
    fn meridian<'py>(
        &self,
        py: Python<'py>,
        flank: &str,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let flank = flank_of(py, flank)?;
        let t = t.as_array();
        let mut values = Vec::with_capacity(4 * t.len());
        for &t in t {
            self.on_profile(py, flank, t)?;
            let at = self.model.flank(flank).profile.at(t);
            values.extend([at.r, at.z, at.n_r, at.n_z]);
        }
        shaped(py, (t.len(), 4), values)
    }

    /// The worm's flank in positions (rows of d_phi_S, d_gamma, d_d, d_v_yA: rad, rad, mm, mm) at lengths of roll: `[position][roll][value]`.
    #[pyo3(signature = (flank, corrections, rolls, progress=None))]
    fn dressed<'py>(
        &self,
        py: Python<'py>,
        flank: &str,
        corrections: PyReadonlyArray2<'py, f64>,
        rolls: Vec<f64>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let flank = flank_of(py, flank)?;
        let corrections = corrections.as_array();
        let values = of_samples(py, progress, corrections, |row| {
            let correction = std::array::from_fn(|k| row[k]);
            let points = self.model.dressed(flank, correction, &rolls).map_err(|e| Failure::from(&e))?;
            Ok(points.iter().flat_map(|at| [at.f, at.b, at.r_a, at.t]).collect())
        })?;
        shaped(py, (corrections.nrows(), rolls.len(), TOLD), values)
    }

    /// Derivatives of the worm's flank by the four corrections in one position: `[axis][roll]`, mm per rad or mm.
    fn sensitivities<'py>(
        &self,
        py: Python<'py>,
        flank: &str,
        correction: [f64; 4],
        rolls: Vec<f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let flank = flank_of(py, flank)?;
        let points = beside(py, || self.model.dressed(flank, correction, &rolls))?;
        let points = points.map_err(|e| Failure::from(&e).raised(py))?;
        let by = Array2::from_shape_fn((4, points.len()), |(axis, roll)| points[roll].df_dk[axis]);
        Ok(by.into_pyarray(py))
    }

    /// The position in which four conditions hold.
    fn solved(&self, py: Python<'_>, conditions: Vec<Given>, start: [f64; 4]) -> PyResult<[f64; 4]> {
        let conditions =
            conditions.iter().map(|given| condition(py, given)).collect::<PyResult<Vec<Condition>>>()?;
        let found = beside(py, || self.model.solved(&conditions, &start))?;
        found.map_err(|e| Failure::from(&e).raised(py))
    }

    /// The position that leaves so much (mm) in the middle of the worm's used profile and nothing at both ends.
    fn crowned(&self, py: Python<'_>, flank: &str, middle: f64) -> PyResult<[f64; 4]> {
        let flank = flank_of(py, flank)?;
        beside(py, || self.model.crowned(flank, middle))?.map_err(|e| Failure::from(&e).raised(py))
    }
}
