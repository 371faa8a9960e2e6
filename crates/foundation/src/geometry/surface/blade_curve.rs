//! Curves between which a ruled blade is spanned, with three derivatives and bounds of the higher ones.

use super::bounds::largest;
use crate::geometry::GeometryError;
use crate::numerics::{CubicSpline, SplineError};
use nalgebra::Vector3;
use std::fmt::Debug;

/// A smooth curve C(u) in space, mm.
pub trait BladeCurve: Send + Sync + Debug {
    /// Where the parameter has a meaning.
    fn domain(&self) -> [f64; 2];

    /// C and its first three derivatives.
    fn derivatives(&self, u: f64) -> [Vector3<f64>; 4];

    /// Upper bounds of |C''| and |C'''| over an interval: true everywhere in it, not sampled.
    fn bounds(&self, interval: [f64; 2]) -> [f64; 2];
}

/// A curve in cylindrical coordinates whose radius, azimuth (from +y, counter-clockwise) and height are cubic polynomials of u, from
/// the constant term upwards. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CylindricalCurve {
    radius: [f64; 4],
    azimuth: [f64; 4],
    height: [f64; 4],
}

/// A curve of three splines over the same parameter. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct SplineCurve {
    coordinates: [CubicSpline; 3],
}

/// A cubic polynomial and its three derivatives.
fn cubic([a, b, c, d]: &[f64; 4], u: f64) -> [f64; 4] {
    [a + u * (b + u * (c + u * d)), b + u * (2.0 * c + u * 3.0 * d), 2.0 * c + 6.0 * d * u, 6.0 * d]
}

/// Bounds of the magnitudes of a cubic and its three derivatives over an interval: value and slope about its middle.
fn cubic_bounds(coefficients: &[f64; 4], [from, to]: [f64; 2]) -> [f64; 4] {
    let at = cubic(coefficients, (from + to) / 2.0).map(f64::abs);
    let h = ((to - from) / 2.0).abs();
    [
        at[0] + h * (at[1] + h * (at[2] / 2.0 + h * at[3] / 6.0)),
        at[1] + h * (at[2] + h * at[3] / 2.0),
        at[2] + h * at[3],
        at[3],
    ]
}

impl CylindricalCurve {
    /// A curve from its three polynomials.
    ///
    /// # Errors
    /// [`GeometryError::InvalidNumber`] for coefficients that are not finite.
    pub fn new(radius: [f64; 4], azimuth: [f64; 4], height: [f64; 4]) -> Result<Self, GeometryError> {
        for (field, coefficients) in [
            ("radius of a blade curve", radius),
            ("azimuth of a blade curve", azimuth),
            ("height of a blade curve", height),
        ] {
            if let Some(&value) = coefficients.iter().find(|c| !c.is_finite()) {
                return Err(GeometryError::InvalidNumber { field, value, allowed: "finite coefficients" });
            }
        }
        Ok(Self { radius, azimuth, height })
    }
}

impl BladeCurve for CylindricalCurve {
    fn domain(&self) -> [f64; 2] {
        [f64::NEG_INFINITY, f64::INFINITY]
    }

    fn derivatives(&self, u: f64) -> [Vector3<f64>; 4] {
        let [r, r1, r2, r3] = cubic(&self.radius, u);
        let [t, t1, t2, t3] = cubic(&self.azimuth, u);
        let z = cubic(&self.height, u);
        let (sin, cos) = t.sin_cos();
        // Outwards and round the axis at the azimuth; round is the derivative of outwards, outwards against that of round.
        let place = |outwards: f64, round: f64, z: f64| {
            Vector3::new(-outwards * sin - round * cos, outwards * cos - round * sin, z)
        };
        [
            place(r, 0.0, z[0]),
            place(r1, r * t1, z[1]),
            place(r2 - r * t1 * t1, 2.0 * r1 * t1 + r * t2, z[2]),
            place(
                r3 - 3.0 * t1 * (r1 * t1 + r * t2),
                3.0 * (r2 * t1 + r1 * t2) + r * (t3 - t1 * t1 * t1),
                z[3],
            ),
        ]
    }

    fn bounds(&self, interval: [f64; 2]) -> [f64; 2] {
        let [r, r1, r2, r3] = cubic_bounds(&self.radius, interval);
        let [_, t1, t2, t3] = cubic_bounds(&self.azimuth, interval);
        let [_, _, z2, z3] = cubic_bounds(&self.height, interval);
        let length = |outwards: f64, round: f64, z: f64| outwards.hypot(round).hypot(z);
        [
            length(r2 + r * t1 * t1, 2.0 * r1 * t1 + r * t2, z2),
            length(
                r3 + 3.0 * t1 * (r1 * t1 + r * t2),
                3.0 * (r2 * t1 + r1 * t2) + r * (t3 + t1 * t1 * t1),
                z3,
            ),
        ]
    }
}

impl SplineCurve {
    /// The curve through points at ascending parameters.
    ///
    /// # Errors
    /// [`SplineError`] for fewer than four points, parameters out of order and numbers that are not finite.
    pub fn new(parameters: &[f64], points: &[Vector3<f64>]) -> Result<Self, SplineError> {
        let along = |axis: usize| {
            let values: Vec<f64> = points.iter().map(|p| p[axis]).collect();
            CubicSpline::new(parameters, &values)
        };
        Ok(Self { coordinates: [along(0)?, along(1)?, along(2)?] })
    }
}

impl BladeCurve for SplineCurve {
    fn domain(&self) -> [f64; 2] {
        self.coordinates[0].domain()
    }

    fn derivatives(&self, u: f64) -> [Vector3<f64>; 4] {
        let [x, y, z] = [0, 1, 2].map(|axis| self.coordinates[axis].derivatives(u));
        std::array::from_fn(|order| Vector3::new(x[order], y[order], z[order]))
    }

    fn bounds(&self, interval: [f64; 2]) -> [f64; 2] {
        let axes = [0, 1, 2].map(|axis| self.coordinates[axis].ranges(interval).map(largest));
        [2, 3].map(|order| axes[0][order].hypot(axes[1][order]).hypot(axes[2][order]))
    }
}
