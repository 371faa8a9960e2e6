//! Toothed bodies: gears from drawing data, and the worm for a gear.

use flankwright::exchange::Diagnostic;
use flankwright::geometry::{Flank, Gear, GearData, Sides, ThicknessMeasure, WormChoice, worm_for_gear};
use numpy::ndarray::ArrayView1;
use numpy::{PyArray2, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::arrays::shaped;
use crate::failure::Failure;

/// An involute gear.
#[pyclass(frozen, module = "flankwright._core")]
pub struct CoreGear {
    /// The gear.
    pub gear: Gear,
}

/// A worm that meshes with a gear.
#[pyclass(frozen, module = "flankwright._core")]
pub struct CoreWorm {
    worm: flankwright::geometry::WormForGear,
}

/// A flank by its name.
pub fn flank_of(py: Python<'_>, name: &str) -> PyResult<Flank> {
    Flank::BOTH.into_iter().find(|flank| flank.name() == name).ok_or_else(|| {
        let finding = Diagnostic::with_code("unknown-value", format!("there is no flank \"{name}\""));
        let finding = finding.field("flank").value(name.to_owned()).allowed("left, right");
        Failure::bad_input(&finding.way_out("choose one of these")).raised(py)
    })
}

/// Places on a flank, one by one.
pub fn places<'a>(
    py: Python<'_>,
    w: &'a PyReadonlyArray1<'_, f64>,
    z: &'a PyReadonlyArray1<'_, f64>,
) -> PyResult<(ArrayView1<'a, f64>, ArrayView1<'a, f64>)> {
    let (w, z) = (w.as_array(), z.as_array());
    if w.len() != z.len() {
        let finding = Diagnostic::with_code("invalid-list", "w and z have other numbers of places");
        let finding = finding.field("z").value(z.len().to_string()).allowed(w.len().to_string());
        return Err(Failure::bad_input(&finding.way_out("give as many of each")).raised(py));
    }
    Ok((w, z))
}

fn vectors<'py>(
    py: Python<'py>,
    w: &PyReadonlyArray1<'py, f64>,
    z: &PyReadonlyArray1<'py, f64>,
    at: impl Fn(f64, f64) -> [f64; 3] + Sync,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let (w, z) = places(py, w, z)?;
    let values: Vec<f64> = py.detach(|| w.iter().zip(z).flat_map(|(&w, &z)| at(w, z)).collect());
    shaped(py, (w.len(), 3), values)
}

#[pymethods]
impl CoreGear {
    /// Angles in rad, lengths in mm; `measure` is one of `profile_shift` (1), `normal_tooth_thickness` (mm), `span` (teeth, mm), `over_balls` (ball,
    /// size in mm).
    #[new]
    fn new(
        py: Python<'_>,
        teeth: i32,
        normal_module: f64,
        pressure_angle: (f64, f64),
        helix_angle: f64,
        cone_angle: f64,
        measure: (String, f64, f64),
    ) -> PyResult<Self> {
        let (left, right) = pressure_angle;
        let pressure_angle = Sides { left, right };
        let data =
            GearData { teeth, normal_module, pressure_angle, helix_angle, profile_shift: 0.0, cone_angle };
        let (kind, first, second) = measure;
        let measure = match kind.as_str() {
            "normal_tooth_thickness" => ThicknessMeasure::NormalThickness(first),
            "span" if first >= 1.0 && first.fract() == 0.0 && first <= f64::from(u32::MAX) => {
                ThicknessMeasure::Span { teeth: first as u32, length: second }
            }
            "span" => {
                let finding =
                    Diagnostic::with_code("invalid-number", "the span is over a whole number of teeth");
                let finding = finding.field("span").value(first.to_string()).allowed("1 or more");
                return Err(Failure::bad_input(&finding.way_out("give (teeth, length)")).raised(py));
            }
            "over_balls" => ThicknessMeasure::OverBalls { ball: first, size: second },
            _ => ThicknessMeasure::ProfileShift(first),
        };
        let made = measure
            .profile_shift(data)
            .and_then(|profile_shift| Gear::new(GearData { profile_shift, ..data }));
        let gear = made.map_err(|error| Failure::from(&error).raised(py))?;
        Ok(Self { gear })
    }

    #[getter]
    fn profile_shift(&self) -> f64 {
        self.gear.data().profile_shift
    }

    #[getter]
    fn pitch_radius(&self) -> f64 {
        self.gear.pitch_radius()
    }

    #[getter]
    fn transverse_module(&self) -> f64 {
        self.gear.transverse_module()
    }

    fn base_radius(&self, py: Python<'_>, flank: &str) -> PyResult<f64> {
        Ok(self.gear.flank(flank_of(py, flank)?).base_radius)
    }

    fn base_helix_angle(&self, py: Python<'_>, flank: &str) -> PyResult<f64> {
        Ok(self.gear.flank(flank_of(py, flank)?).base_helix_angle)
    }

    fn length_of_roll(&self, py: Python<'_>, flank: &str, radius: f64) -> PyResult<f64> {
        let flank = self.gear.flank(flank_of(py, flank)?);
        flank.length_of_roll(radius).map_err(|error| Failure::from(&error).raised(py))
    }

    fn radius(&self, py: Python<'_>, flank: &str, length_of_roll: f64) -> PyResult<f64> {
        Ok(self.gear.flank(flank_of(py, flank)?).radius(length_of_roll))
    }

    /// Span over so many teeth: length, radius at which it touches, least face width; mm.
    fn span(&self, py: Python<'_>, teeth: u32) -> PyResult<(f64, f64, f64)> {
        let span = self.gear.span(teeth).map_err(|error| Failure::from(&error).raised(py))?;
        Ok((span.length, span.contact_radius, span.least_face_width))
    }

    /// Measure over (between) balls in the section z, mm.
    fn over_balls(&self, py: Python<'_>, ball: f64, z: f64) -> PyResult<f64> {
        let found = self.gear.over_balls(ball, z).map_err(|error| Failure::from(&error).raised(py))?;
        Ok(found.size)
    }

    /// Points of a flank at places (w, z), `[place][x, y, z]`, mm.
    fn points<'py>(
        &self,
        py: Python<'py>,
        flank: &str,
        w: PyReadonlyArray1<'py, f64>,
        z: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let flank = self.gear.flank(flank_of(py, flank)?);
        vectors(py, &w, &z, |w, z| flank.point(w, z).into())
    }

    /// Normals out of the material.
    fn normals<'py>(
        &self,
        py: Python<'py>,
        flank: &str,
        w: PyReadonlyArray1<'py, f64>,
        z: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let flank = self.gear.flank(flank_of(py, flank)?);
        vectors(py, &w, &z, |w, z| flank.normal(w, z).into())
    }

    /// The worm for this gear: threads, hand (+1, -1), pitch or tip diameter (mm), angles in rad.
    #[expect(clippy::too_many_arguments, reason = "what is chosen of a worm")]
    fn worm(
        &self,
        py: Python<'_>,
        threads: i32,
        hand: f64,
        pitch_diameter: Option<f64>,
        tip_diameter: Option<f64>,
        pressure_angle: Option<f64>,
        profile_shift: f64,
        cone_angle: f64,
    ) -> PyResult<CoreWorm> {
        let choice = WormChoice {
            threads,
            hand,
            pitch_diameter,
            tip_diameter,
            pressure_angle,
            profile_shift,
            cone_angle,
        };
        let worm = worm_for_gear(&self.gear, &choice).map_err(|error| Failure::from(&error).raised(py))?;
        Ok(CoreWorm { worm })
    }
}

#[pymethods]
impl CoreWorm {
    /// The worm as a toothed body.
    fn gear(&self) -> CoreGear {
        CoreGear { gear: self.worm.worm }
    }

    #[getter]
    fn crossed_axes_angle(&self) -> f64 {
        self.worm.crossed_axes_angle
    }

    #[getter]
    fn tip_radius(&self) -> f64 {
        self.worm.tip_radius
    }

    #[getter]
    fn pitch_radius(&self) -> f64 {
        self.worm.worm.pitch_radius()
    }

    #[getter]
    fn helix_angle(&self) -> f64 {
        self.worm.worm.data().helix_angle
    }
}
