//! The beam measured with a mandrel: five unknowns from six places at which it switches (`docs/mathematics/skiving.md#light-barrier`).

use super::{BeamLine, Mandrel};
use crate::SkivingError;
use nalgebra::{DMatrix, DVector, Matrix5, Vector3, Vector5};

/// Axis along which the mandrel moved when the beam switched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Approach {
    /// X.
    X,
    /// Y.
    Y,
}

/// A place of the mandrel at which the beam switched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observation {
    /// X, Y of the axis, Z of the lower face, mm.
    pub place: Vector3<f64>,
    /// Along which axis it moved.
    pub along: Approach,
}

/// The beam with its uncertainty.
#[derive(Clone, Debug, PartialEq)]
pub struct Calibration {
    /// The beam.
    pub line: BeamLine,
    /// Covariance of x_0, y_0, tan delta, tan eps, r for a standard deviation of 1 mm of the gap at every switch.
    pub covariance: Matrix5<f64>,
    /// What is left at the observations, mm.
    pub residual: f64,
}

/// Steps of Gauss and Newton, and the last of them, mm.
const STEPS: usize = 50;
const LAST: f64 = 1e-13;
/// Relative size of a singular value below which the unknowns are not distinguished: the slopes act through the difference in height, which
/// is a hundredth of the heights themselves at worst.
const RANK: f64 = 1e-9;

impl Calibration {
    /// Fits the beam to observations, from a start on.
    ///
    /// # Errors
    /// [`SkivingError::CalibrationSingular`], [`SkivingError::InvalidNumber`].
    pub fn fit(
        mandrel: &Mandrel,
        observations: &[Observation],
        start: &BeamLine,
    ) -> Result<Self, SkivingError> {
        let singular = |reason| SkivingError::CalibrationSingular { reason };
        if observations.len() < 5 {
            return Err(singular("fewer than five observations"));
        }
        let numbers = observations.iter().flat_map(|seen| seen.place.iter().copied().collect::<Vec<_>>());
        for value in numbers.chain(start.numbers()).chain([mandrel.radius, mandrel.height]) {
            if !value.is_finite() {
                let field = "observation";
                return Err(SkivingError::InvalidNumber { field, value, allowed: "finite numbers" });
            }
        }
        let heights: Vec<f64> = observations.iter().map(|seen| seen.place.z).collect();
        if heights.iter().all(|z| *z == heights[0]) {
            return Err(singular("all observations at one height"));
        }
        // The beam's point is sought at the middle height: there its place and its slopes are separated.
        let level = heights.iter().sum::<f64>() / heights.len() as f64;
        let mut line = *start;
        for _ in 0..STEPS {
            let (matrix, right) = equations(mandrel, observations, &line, level);
            let svd = matrix.svd(true, true);
            if svd.singular_values.min() < RANK * svd.singular_values.max() {
                return Err(singular("the observations do not tell all five unknowns apart"));
            }
            let step = svd.solve(&right, 0.0).map_err(|_| singular("no solution of the equations"))?;
            line = moved(&line, &step, level);
            if !line.numbers().iter().all(|x| x.is_finite()) || line.radius <= -mandrel.radius {
                return Err(singular("the fit does not converge from this start"));
            }
            if step.amax() < LAST {
                let (matrix, right) = equations(mandrel, observations, &line, level);
                let normal = matrix.transpose() * &matrix;
                let inverse = Matrix5::from_fn(|i, j| normal[(i, j)])
                    .try_inverse()
                    .ok_or_else(|| singular("the observations do not tell all five unknowns apart"))?;
                // From the middle height down to height 0.
                let mut down = Matrix5::identity();
                (down[(0, 2)], down[(1, 3)]) = (-level, -level);
                let covariance = down * inverse * down.transpose();
                return Ok(Self { line, covariance, residual: right.amax() });
            }
        }
        Err(singular("the fit does not converge from this start"))
    }

    /// Standard deviations of x and y at a height, tan delta, tan eps and r, per unit of a switch's.
    pub fn deviations_at(&self, z: f64) -> [f64; 5] {
        let mut up = Matrix5::identity();
        (up[(0, 2)], up[(1, 3)]) = (z, z);
        let at = up * self.covariance * up.transpose();
        std::array::from_fn(|k| at[(k, k)].max(0.0).sqrt())
    }

    /// A start from the usual six observations: through in Y, one approach in X, at each of two heights; the radius as the maker gives it.
    ///
    /// # Errors
    /// [`SkivingError::CalibrationSingular`] without two heights of two observations along Y and one along X each.
    pub fn start(
        mandrel: &Mandrel,
        observations: &[Observation],
        radius: f64,
        approach_from_above: bool,
    ) -> Result<BeamLine, SkivingError> {
        let singular = || SkivingError::CalibrationSingular { reason: "fewer than five observations" };
        let first = observations.first().ok_or_else(singular)?.place.z;
        let last = observations.last().ok_or_else(singular)?.place.z;
        if first == last {
            return Err(SkivingError::CalibrationSingular { reason: "all observations at one height" });
        }
        let mean = |z: f64, along: Approach, of: fn(&Vector3<f64>) -> f64| {
            let seen: Vec<f64> = observations
                .iter()
                .filter(|seen| seen.along == along && seen.place.z == z)
                .map(|seen| of(&seen.place))
                .collect();
            if seen.is_empty() { Err(singular()) } else { Ok(seen.iter().sum::<f64>() / seen.len() as f64) }
        };
        let y = [mean(first, Approach::Y, |p| p.y)?, mean(last, Approach::Y, |p| p.y)?];
        let x = [mean(first, Approach::X, |p| p.x)?, mean(last, Approach::X, |p| p.x)?];
        let rise = last - first;
        let slope = nalgebra::Vector2::new((x[1] - x[0]) / rise, (y[1] - y[0]) / rise);
        let reach = mandrel.radius + radius * slope.x.hypot(1.0) + 0.5 * mandrel.height * slope.x.abs();
        let at = x[0] + if approach_from_above { -reach } else { reach };
        let middle = first + 0.5 * mandrel.height;
        Ok(BeamLine { point: nalgebra::Vector2::new(at, y[0]) - slope * middle, slope, radius })
    }
}

/// One row for every observation: how the gap goes with the unknowns, the point taken at a level.
fn equations(
    mandrel: &Mandrel,
    observations: &[Observation],
    line: &BeamLine,
    level: f64,
) -> (DMatrix<f64>, DVector<f64>) {
    let mut matrix = DMatrix::zeros(observations.len(), 5);
    let mut right = DVector::zeros(observations.len());
    for (i, seen) in observations.iter().enumerate() {
        let gap = mandrel.gap(line, &seen.place);
        let mut by = gap.by_line;
        // With the point at the level instead of at height 0 the slopes act from there.
        by[2] -= by[0] * level;
        by[3] -= by[1] * level;
        for (k, by) in by.iter().enumerate() {
            matrix[(i, k)] = *by;
        }
        right[i] = -gap.value;
    }
    (matrix, right)
}

fn moved(line: &BeamLine, step: &DVector<f64>, level: f64) -> BeamLine {
    let step: Vector5<f64> = Vector5::from_fn(|k, _| step[k]);
    let mut numbers = line.numbers();
    numbers[0] += step[0] - step[2] * level;
    numbers[1] += step[1] - step[3] * level;
    for k in 2..5 {
        numbers[k] += step[k];
    }
    BeamLine::from_numbers(numbers)
}
