//! Least squares for more rows than memory should hold: rows come one by one, QR keeps a triangle, singular values give the
//! minimum-norm solution. Knows no gears.

use super::RankReport;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::qr::no_pivoting::factor::{qr_in_place, qr_in_place_scratch, recommended_block_size};
use faer::linalg::svd::{ComputeSvdVectors, svd, svd_scratch};
use faer::{Col, Mat, Par};

/// Rows collected before they are reduced; with fewer the triangle would be reduced again too often.
const BLOCK: usize = 1024;

/// The triangle [R c] of all rows [a | b] so far. The result depends on the order of the rows only, not on threads.
#[derive(Clone, Debug)]
pub struct RowReduction {
    columns: usize,
    /// Column by column; the first `filled` rows are in use.
    rows: Mat<f64>,
    filled: usize,
}

/// Minimum-norm solution of a reduced problem.
#[derive(Clone, Debug, PartialEq)]
pub struct MinimumNorm {
    /// Solution.
    pub x: Vec<f64>,
    /// Singular values and how many of them were kept.
    pub rank: RankReport,
    /// Orthonormal directions of x that belong to the singular values kept.
    pub directions: Vec<Vec<f64>>,
}

impl MinimumNorm {
    /// Steps of x that change A x by 1 in the mean of squares over `rows` rows, each in its own way: coordinates in which the
    /// problem is as well conditioned as can be.
    pub fn steps(&self, rows: usize) -> Vec<Vec<f64>> {
        let size = (rows as f64).sqrt();
        let scaled =
            |(direction, value): (&Vec<f64>, &f64)| direction.iter().map(|v| v * size / value).collect();
        self.directions.iter().zip(&self.rank.singular_values).map(scaled).collect()
    }
}

impl RowReduction {
    /// For rows of `columns` numbers and a right side; `expected` rows only decide how much memory is taken at once.
    pub fn new(columns: usize, expected: usize) -> Self {
        let block = expected.min(BLOCK.max(4 * columns));
        Self { columns, rows: Mat::zeros(block + columns + 1, columns + 1), filled: 0 }
    }

    /// Adds a row given by its entries (column, value), each column at most once, and its right side.
    ///
    /// # Panics
    /// If a column does not exist.
    #[inline]
    pub fn push(&mut self, entries: &[(usize, f64)], right: f64) {
        if self.filled == self.rows.nrows() {
            self.reduce();
        }
        for &(column, value) in entries {
            self.rows[(self.filled, column)] = value;
        }
        self.rows[(self.filled, self.columns)] = right;
        self.filled += 1;
    }

    /// Replaces the rows by their triangle.
    fn reduce(&mut self) {
        let (rows, columns) = (self.filled, self.columns + 1);
        let size = rows.min(columns);
        if size == 0 {
            return;
        }
        let block = recommended_block_size::<f64>(rows, columns);
        let mut factors = Mat::zeros(block, size);
        let mut memory =
            MemBuffer::new(qr_in_place_scratch::<f64>(rows, columns, block, Par::Seq, Default::default()));
        qr_in_place(
            self.rows.as_mut().subrows_mut(0, rows),
            factors.as_mut(),
            Par::Seq,
            MemStack::new(&mut memory),
            Default::default(),
        );
        for j in 0..columns {
            let column = self.rows.col_as_slice_mut(j);
            column[(j + 1).min(rows)..rows].fill(0.0);
        }
        self.filled = size;
    }

    /// Minimises |A x - b|; singular values below `cut` times the largest are dropped and the shortest x is taken.
    /// `None` if a number is not finite.
    pub fn solve(mut self, cut: f64) -> Option<MinimumNorm> {
        self.reduce();
        let size = self.filled.min(self.columns);
        let triangle = self.rows.as_ref().submatrix(0, 0, size, self.columns);
        let right = self.rows.as_ref().col(self.columns).subrows(0, size);
        let finite = (0..self.columns).all(|j| triangle.col(j).iter().all(|x| x.is_finite()))
            && right.iter().all(|x| x.is_finite());
        if !finite {
            return None;
        }
        let mut values = Col::zeros(size);
        let (mut u, mut v) = (Mat::zeros(size, size), Mat::zeros(self.columns, size));
        if size > 0 {
            let thin = ComputeSvdVectors::Thin;
            let mut memory = MemBuffer::new(svd_scratch::<f64>(
                size,
                self.columns,
                thin,
                thin,
                Par::Seq,
                Default::default(),
            ));
            svd(
                triangle,
                values.as_mut().as_diagonal_mut(),
                Some(u.as_mut()),
                Some(v.as_mut()),
                Par::Seq,
                MemStack::new(&mut memory),
                Default::default(),
            )
            .ok()?;
        }
        let singular_values: Vec<f64> = values.iter().copied().collect();
        let limit = cut * singular_values.first().copied().unwrap_or(0.0);
        let rank = singular_values.iter().filter(|&&s| s > limit && s > 0.0).count();
        let directions: Vec<Vec<f64>> = (0..rank).map(|k| v.col(k).iter().copied().collect()).collect();
        let mut x = vec![0.0; self.columns];
        for (k, direction) in directions.iter().enumerate() {
            let along: f64 = u.col(k).iter().zip(right.iter()).map(|(u, c)| u * c).sum();
            for (x, v) in x.iter_mut().zip(direction) {
                *x += v * along / singular_values[k];
            }
        }
        let rank = RankReport { singular_values, rank };
        x.iter().all(|x| x.is_finite()).then_some(MinimumNorm { x, rank, directions })
    }
}

#[cfg(test)]
mod tests {
    use super::super::weighted_least_squares;
    use super::*;
    use nalgebra::{DMatrix, DVector};

    /// Rows of rank 4 in 6 columns.
    fn row(i: usize) -> ([f64; 6], f64) {
        let x = i as f64 / 100.0;
        let base = [1.0, x.sin(), (1.3 * x).cos(), x * x];
        let last = [base[0] - 2.0 * base[1], base[2] + base[3]];
        ([base[0], base[1], base[2], base[3], last[0], last[1]], (2.0 * x).sin() + 0.1 * x)
    }

    #[test]
    fn many_rows_give_what_one_decomposition_gives() {
        for count in [3, 50, 1029, 1030, 3000] {
            let mut reduction = RowReduction::new(6, count);
            let mut a = DMatrix::zeros(count, 6);
            let mut b = DVector::zeros(count);
            for i in 0..count {
                let (row, right) = row(i);
                let entries: Vec<(usize, f64)> = row.iter().copied().enumerate().collect();
                reduction.push(&entries, right);
                a.row_mut(i).copy_from_slice(&row);
                b[i] = right;
            }
            let got = reduction.solve(1e-11).unwrap();
            let want = weighted_least_squares(&a, &b, None, 1e-11).unwrap();
            assert_eq!(got.rank.rank, count.min(4));
            for (got, want) in got.x.iter().zip(want.x.iter()) {
                assert!((got - want).abs() < 1e-9 * want.abs().max(1.0), "{count} rows: {got} {want}");
            }
        }
    }

    #[test]
    fn empty_and_bad_problems() {
        assert_eq!(RowReduction::new(2, 0).solve(1e-11).unwrap().x, [0.0; 2]);
        let mut bad = RowReduction::new(2, 1);
        bad.push(&[(0, f64::NAN)], 1.0);
        assert!(bad.solve(1e-11).is_none());
    }
}
