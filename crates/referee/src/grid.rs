//! Where the rays stand: a rectangular grid of lengths of roll and axial positions.

use super::RemovalError;

/// Rays stand on the unmodified flank at (w_i, z_j), along its outward normals. Row-major, w slow. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct RayGrid {
    w: Vec<f64>,
    z: Vec<f64>,
}

impl RayGrid {
    /// From ascending lengths of roll (> 0) and ascending axial positions.
    ///
    /// # Errors
    /// [`RemovalError::InvalidGrid`].
    pub fn new(w: Vec<f64>, z: Vec<f64>) -> Result<Self, RemovalError> {
        for (axis, values, least) in [("w", &w, 0.0), ("z", &z, f64::NEG_INFINITY)] {
            if values.is_empty() {
                return Err(RemovalError::InvalidGrid { axis, index: 0, value: f64::NAN });
            }
            let mut below = least;
            for (index, &value) in values.iter().enumerate() {
                if !(value.is_finite() && value > below) {
                    return Err(RemovalError::InvalidGrid { axis, index, value });
                }
                below = value;
            }
        }
        Ok(Self { w, z })
    }

    /// Equidistant from end to end: `rows` lengths of roll and `columns` axial positions (one: the middle).
    ///
    /// # Errors
    /// [`RemovalError::InvalidGrid`].
    pub fn equidistant(w: [f64; 2], rows: usize, z: [f64; 2], columns: usize) -> Result<Self, RemovalError> {
        let axis = |[from, to]: [f64; 2], count: usize| match count {
            1 => vec![0.5 * (from + to)],
            _ => (0..count).map(|k| from + (to - from) * k as f64 / (count - 1) as f64).collect(),
        };
        Self::new(axis(w, rows), axis(z, columns))
    }

    /// The fewest equidistant rays from end to end with at most the given distances, but at least four each way, so
    /// that a C2 spline goes through them.
    ///
    /// # Errors
    /// [`RemovalError::InvalidGrid`]; [`RemovalError::InvalidNumber`] for distances that are not positive.
    pub fn spaced(w: [f64; 2], w_step: f64, z: [f64; 2], z_step: f64) -> Result<Self, RemovalError> {
        super::error::positive("ray spacing in w", w_step)?;
        super::error::positive("ray spacing in z", z_step)?;
        let count = |[from, to]: [f64; 2], step: f64| ((to - from) / step).ceil().max(3.0) as usize + 1;
        Self::equidistant(w, count(w, w_step), z, count(z, z_step))
    }

    /// Lengths of roll.
    pub fn w(&self) -> &[f64] {
        &self.w
    }

    /// Axial positions.
    pub fn z(&self) -> &[f64] {
        &self.z
    }

    /// Number of rays.
    pub fn count(&self) -> usize {
        self.w.len() * self.z.len()
    }

    /// (w, z) of a ray.
    pub fn ray(&self, index: usize) -> (f64, f64) {
        (self.w[index / self.z.len()], self.z[index % self.z.len()])
    }

    /// Middles of a sample of cells, those at the border included: every `w_stride`-th in w, every `z_stride`-th in z.
    pub(super) fn cell_middles(&self, w_stride: usize, z_stride: usize) -> Vec<(f64, f64)> {
        let middles = |values: &[f64], stride: usize| -> Vec<f64> {
            let cells = values.len().saturating_sub(1);
            (0..cells)
                .filter(|i| i % stride == 0 || i + 1 == cells)
                .map(|i| 0.5 * (values[i] + values[i + 1]))
                .collect()
        };
        let z = middles(&self.z, z_stride);
        middles(&self.w, w_stride).into_iter().flat_map(|w| z.iter().map(move |&z| (w, z))).collect()
    }
}
