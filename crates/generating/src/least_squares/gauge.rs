//! The gauge: which of the decompositions with the same sum is handed out.

use super::super::GeneratingError;
use super::{FlankCoordinates, Samples, WormFunctions};
use foundation::numerics::{BSpline, extremes};

/// Which of the decompositions with the same sum one is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SplineGauge {
    /// F_K = F_K' = 0 in the middle of the samples, and F_P = F_P' = 0 there if there is a profile: smallest motion.
    Centred,
    /// The coefficients of least length. The functions that would take over what `Centred` moves are not in the class, or
    /// the lines are curved.
    MinimumNorm,
}

/// A function of X or of w without curvature, on its way from one function to another: a + b X + c w.
#[derive(Clone, Copy)]
struct Moved {
    a: f64,
    b: f64,
    c: f64,
}

impl WormFunctions {
    /// The same sum in the gauge `Centred` if class and coordinates allow it exactly, else as it is. Splines reproduce
    /// straight lines, so nothing is lost by moving one.
    pub(super) fn centred<G: FlankCoordinates>(
        self,
        coordinates: &G,
        samples: &Samples,
    ) -> Result<(Self, SplineGauge), GeneratingError> {
        let (Some(relations), Some(_), Some(_)) = (coordinates.straight(), &self.constant, &self.linear)
        else {
            return Ok((self, SplineGauge::MinimumNorm));
        };
        let z = extremes(samples.points().iter().map(|p| p[1]));
        let middle = coordinates.arguments(self.scale.middle, 0.5 * (z[0] + z[1]));
        let (kinematic, from_path) = without_line(self.kinematic, middle.path, relations.path)?;
        let (profile, from_profile) = without_line(self.profile, middle.profile, relations.profile)?;
        let moved = Moved {
            a: from_path.a + from_profile.a,
            b: from_path.b + from_profile.b,
            c: from_path.c + from_profile.c,
        };
        // w = middle + half u: the part c w goes to F_C (constant) and F_L (factor u).
        let add = |function: Option<BSpline>, a: f64, b: f64| {
            function.map(|f| f.plus_line(a, b)).transpose().map_err(GeneratingError::InvalidSpline)
        };
        let functions = Self {
            constant: add(self.constant, moved.a + moved.c * self.scale.middle, moved.b)?,
            linear: add(self.linear, moved.c * self.scale.half, 0.0)?,
            profile,
            kinematic,
            ..self
        };
        Ok((functions, SplineGauge::Centred))
    }
}

/// Takes value and slope at `middle` out of a function whose argument is shares[0] X + shares[1] w.
fn without_line(
    function: Option<BSpline>,
    middle: f64,
    shares: [f64; 2],
) -> Result<(Option<BSpline>, Moved), GeneratingError> {
    let Some(function) = function else { return Ok((None, Moved { a: 0.0, b: 0.0, c: 0.0 })) };
    let [value, slope, _] = function.jet(middle);
    let constant = value - slope * middle;
    let function = function.plus_line(-constant, -slope).map_err(GeneratingError::InvalidSpline)?;
    Ok((Some(function), Moved { a: constant, b: slope * shares[0], c: slope * shares[1] }))
}
