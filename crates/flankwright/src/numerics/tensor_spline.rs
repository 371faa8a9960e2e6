//! The tensor-product cubic spline in two variables: C2 in both, one bicubic polynomial per cell.

use super::jet::Jet2;
use super::knots::{Knots, SplineError};
use super::spline::interpolate;

/// Piecewise bicubic function of (u, v) with continuous second derivatives. Outside the knots the polynomial of
/// the border cell continues. An evaluation is a cell lookup and a Horner scheme: no allocation, no branches
/// inside the cell.
#[derive(Clone, Debug, PartialEq)]
pub struct TensorSpline {
    u: Knots,
    v: Knots,
    /// Per cell (u slow), coefficient of du^k dv^l at `[k][l]`; du, dv = distances from the cell's first knots.
    cells: Vec<[[f64; 4]; 4]>,
}

impl TensorSpline {
    /// Interpolates `values[i][j]` at (u_i, v_j) with not-a-knot ends both ways; every bicubic polynomial is
    /// reproduced exactly.
    ///
    /// # Errors
    /// [`SplineError`] for fewer than four knots on an axis, knots out of order, numbers that are not finite and
    /// a table of another shape.
    pub fn new(u: &[f64], v: &[f64], values: &[Vec<f64>]) -> Result<Self, SplineError> {
        let u = Knots::new(u, 4, 0)?;
        let v = Knots::new(v, 4, 1)?;
        let (rows, columns) = (u.values().len(), v.values().len());
        if values.len() != rows || values.iter().any(|row| row.len() != columns) {
            let found = values.iter().map(Vec::len).sum();
            return Err(SplineError::ShapeMismatch { expected: rows * columns, found });
        }
        if let Some(index) = values.iter().flatten().position(|f| !f.is_finite()) {
            return Err(SplineError::ValueNotFinite { index });
        }

        // Splines along u, one per column; each of their coefficients is then a function of v.
        let along_u: Vec<Vec<[f64; 4]>> = (0..columns)
            .map(|j| interpolate(u.values(), &values.iter().map(|row| row[j]).collect::<Vec<_>>()))
            .collect();
        let mut cells = vec![[[0.0; 4]; 4]; (rows - 1) * (columns - 1)];
        for i in 0..rows - 1 {
            for k in 0..4 {
                let coefficient: Vec<f64> = along_u.iter().map(|column| column[i][k]).collect();
                for (j, piece) in interpolate(v.values(), &coefficient).into_iter().enumerate() {
                    cells[i * (columns - 1) + j][k] = piece;
                }
            }
        }
        Self::from_cells(u, v, cells)
    }

    /// A spline from ready cells; the caller answers for continuity.
    pub(super) fn from_cells(u: Knots, v: Knots, cells: Vec<[[f64; 4]; 4]>) -> Result<Self, SplineError> {
        match cells.iter().position(|cell| cell.iter().flatten().any(|c| !c.is_finite())) {
            Some(index) => Err(SplineError::ValueNotFinite { index }),
            None => Ok(Self { u, v, cells }),
        }
    }

    /// First and last knot of each variable: `[[u_first, u_last], [v_first, v_last]]`.
    pub fn domain(&self) -> [[f64; 2]; 2] {
        [&self.u, &self.v].map(|knots| [knots.values()[0], knots.values()[knots.intervals()]])
    }

    /// Value at (u, v).
    #[inline]
    pub fn value(&self, u: f64, v: f64) -> f64 {
        let (cell, du, dv) = self.cell(u, v);
        let row = |c: &[f64; 4]| c[0] + dv * (c[1] + dv * (c[2] + dv * c[3]));
        row(&cell[0]) + du * (row(&cell[1]) + du * (row(&cell[2]) + du * row(&cell[3])))
    }

    /// Value, gradient and second derivatives at (u, v).
    #[inline]
    pub fn jet(&self, u: f64, v: f64) -> Jet2 {
        let (cell, du, dv) = self.cell(u, v);
        let mut p = [0.0; 4];
        let mut p1 = [0.0; 4];
        let mut p2 = [0.0; 4];
        for k in 0..4 {
            let [a, b, c, d] = cell[k];
            p[k] = a + dv * (b + dv * (c + dv * d));
            p1[k] = b + dv * (2.0 * c + dv * 3.0 * d);
            p2[k] = 2.0 * c + 6.0 * d * dv;
        }
        let value = |q: &[f64; 4]| q[0] + du * (q[1] + du * (q[2] + du * q[3]));
        let slope = |q: &[f64; 4]| q[1] + du * (2.0 * q[2] + du * 3.0 * q[3]);
        Jet2 {
            f: value(&p),
            fu: slope(&p),
            fv: value(&p1),
            fuu: 2.0 * p[2] + 6.0 * p[3] * du,
            fuv: slope(&p1),
            fvv: value(&p2),
        }
    }

    #[inline]
    fn cell(&self, u: f64, v: f64) -> (&[[f64; 4]; 4], f64, f64) {
        let (i, du) = self.u.locate(u);
        let (j, dv) = self.v.locate(v);
        (&self.cells[i * self.v.intervals() + j], du, dv)
    }
}
