//! The tensor-product cubic spline in two variables: C2 in both, one bicubic polynomial per cell.

use super::bernstein::{bernstein, derivative, shifted};
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

    /// The first derivatives d/du and d/dv at (u, v), each with its own gradient and second derivatives: up to the third
    /// derivatives of the spline, which jump at the knots.
    pub fn slope_jets(&self, u: f64, v: f64) -> [Jet2; 2] {
        let (cell, du, dv) = self.cell(u, v);
        // [l][k]: l-th derivative by v of the coefficient of du^k.
        let mut p = [[0.0; 4]; 4];
        for k in 0..4 {
            let [a, b, c, d] = cell[k];
            p[0][k] = a + dv * (b + dv * (c + dv * d));
            p[1][k] = b + dv * (2.0 * c + dv * 3.0 * d);
            p[2][k] = 2.0 * c + 6.0 * d * dv;
            p[3][k] = 6.0 * d;
        }
        let value = |q: &[f64; 4]| q[0] + du * (q[1] + du * (q[2] + du * q[3]));
        let slope = |q: &[f64; 4]| q[1] + du * (2.0 * q[2] + du * 3.0 * q[3]);
        let bend = |q: &[f64; 4]| 2.0 * q[2] + 6.0 * q[3] * du;
        let [p0, p1, p2, p3] = &p;
        [
            Jet2 {
                f: slope(p0),
                fu: bend(p0),
                fv: slope(p1),
                fuu: 6.0 * p0[3],
                fuv: bend(p1),
                fvv: slope(p2),
            },
            Jet2 {
                f: value(p1),
                fu: slope(p1),
                fv: value(p2),
                fuu: bend(p1),
                fuv: slope(p2),
                fvv: value(p3),
            },
        ]
    }

    /// The polynomials over the parts of the cells in a box of arguments (ascending), u slow.
    pub fn patches(&self, u: [f64; 2], v: [f64; 2]) -> impl Iterator<Item = BicubicPatch> {
        self.u.parts(u).flat_map(move |(i, u_ends)| {
            self.v.parts(v).map(move |(j, v_ends)| {
                let cell = &self.cells[i * self.v.intervals() + j];
                let by_v = cell.map(|row| shifted(row, v_ends[0]));
                BicubicPatch {
                    coefficients: columns_of(&by_v, |column| shifted(column, u_ends[0])),
                    sides: [u_ends[1] - u_ends[0], v_ends[1] - v_ends[0]],
                }
            })
        })
    }

    #[inline]
    fn cell(&self, u: f64, v: f64) -> (&[[f64; 4]; 4], f64, f64) {
        let (i, du) = self.u.locate(u);
        let (j, dv) = self.v.locate(v);
        (&self.cells[i * self.v.intervals() + j], du, dv)
    }
}

/// A bicubic polynomial over a rectangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BicubicPatch {
    /// Coefficient of du^k dv^l at `[k][l]`, distances from the rectangle's first corner.
    coefficients: [[f64; 4]; 4],
    sides: [f64; 2],
}

/// A function of cubics applied to each column.
fn columns_of(rows: &[[f64; 4]; 4], f: impl Fn([f64; 4]) -> [f64; 4]) -> [[f64; 4]; 4] {
    let columns: [[f64; 4]; 4] = std::array::from_fn(|l| f(std::array::from_fn(|k| rows[k][l])));
    std::array::from_fn(|k| std::array::from_fn(|l| columns[l][k]))
}

impl BicubicPatch {
    /// The Bezier net of a derivative, its orders by u and v given: over the rectangle the derivative stays inside the net's hull,
    /// also as one component of a vector with others of the same rectangle.
    pub fn control_net(&self, [by_u, by_v]: [usize; 2]) -> [[f64; 4]; 4] {
        let repeated = |order: usize, piece: [f64; 4]| (0..order).fold(piece, |p, _| derivative(p));
        let [u, v] = self.sides;
        let rows = self.coefficients.map(|row| bernstein(repeated(by_v, row), v));
        columns_of(&rows, |column| bernstein(repeated(by_u, column), u))
    }
}
