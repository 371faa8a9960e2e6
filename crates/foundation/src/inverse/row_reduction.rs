//! Least squares for more rows than memory should hold: rows come one by one, QR keeps a triangle, pivots or singular values
//! give the minimum-norm solution. Knows no gears.

use super::RankReport;
use super::pivots::Pivoted;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::qr::no_pivoting::factor::{qr_in_place, qr_in_place_scratch, recommended_block_size};
use faer::linalg::svd::{ComputeSvdVectors, svd, svd_scratch};
use faer::{Col, ColRef, Mat, MatRef, Par};

/// Rows collected before they are reduced; with fewer the triangle would be reduced again too often.
const BLOCK: usize = 1024;

/// Rows are kept times this power of two, which changes no digit. faer's norms also sum the squares of numbers times 2^-511: of
/// numbers below 1 these are subnormal, and processors take a hundred times longer for those.
pub(super) const SCALE: f64 = (1u64 << 60) as f64;

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

    /// Adds a row given by its entries (column, value), each column at most once, and its right side. Numbers above 1e290 count
    /// as infinite.
    ///
    /// # Panics
    /// If a column does not exist.
    #[inline]
    pub fn push(&mut self, entries: &[(usize, f64)], right: f64) {
        if self.filled == self.rows.nrows() {
            self.reduce();
        }
        for &(column, value) in entries {
            self.rows[(self.filled, column)] = value * SCALE;
        }
        self.rows[(self.filled, self.columns)] = right * SCALE;
        self.filled += 1;
    }

    /// Adds the rows of a matrix [a | b] times [`SCALE`].
    ///
    /// # Panics
    /// Unless it has one column more than the reduction.
    pub(super) fn push_rows(&mut self, rows: MatRef<'_, f64>) {
        let mut from = 0;
        while from < rows.nrows() {
            if self.filled == self.rows.nrows() {
                self.reduce();
            }
            let count = (rows.nrows() - from).min(self.rows.nrows() - self.filled);
            self.rows.as_mut().subrows_mut(self.filled, count).copy_from(rows.subrows(from, count));
            self.filled += count;
            from += count;
        }
    }

    /// Adds all rows of another reduction with as many columns.
    ///
    /// # Panics
    /// If its columns are not as many.
    pub fn append(&mut self, other: &mut Self) {
        self.push_rows(other.triangle());
    }

    /// The largest root of the sum of squares of a column.
    pub fn largest_column(&mut self) -> f64 {
        let columns = self.columns;
        let triangle = self.triangle();
        (0..columns).map(|j| triangle.col(j).norm_l2() / SCALE).fold(0.0, f64::max)
    }

    /// The triangle [R c] of all rows so far times [`SCALE`].
    pub(super) fn triangle(&mut self) -> MatRef<'_, f64> {
        self.reduce();
        self.rows.as_ref().subrows(0, self.filled)
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

    /// R and c of the reduced rows, if all their numbers are finite.
    fn reduced(&mut self) -> Option<(MatRef<'_, f64>, ColRef<'_, f64>)> {
        self.reduce();
        let size = self.filled.min(self.columns);
        let triangle = self.rows.as_ref().submatrix(0, 0, size, self.columns);
        let right = self.rows.as_ref().col(self.columns).subrows(0, size);
        let finite = (0..self.columns).all(|j| triangle.col(j).iter().all(|x| x.is_finite()))
            && right.iter().all(|x| x.is_finite());
        finite.then_some((triangle, right))
    }

    /// The solution of [`Self::solve`] and the rank, without singular values where pivots leave no doubt about the rank:
    /// several times faster. `None` if a number is not finite.
    pub fn shortest(mut self, cut: f64) -> Option<(Vec<f64>, usize)> {
        let (triangle, right) = self.reduced()?;
        let pivoted = Pivoted::new(triangle, right.as_mat().to_owned(), cut);
        if pivoted.is_settled() {
            let x = pivoted.shortest();
            return x.iter().all(|x| x.is_finite()).then(|| (x, pivoted.rank()));
        }
        self.solve(cut).map(|solved| (solved.x, solved.rank.rank))
    }

    /// What is left for the columns after the first `leading` once those are fitted out of all rows (variable projection):
    /// its solution is the best for the last columns where the first ones always follow best. Pivots below `cut` times the
    /// largest are dropped. `None` if a number is not finite.
    ///
    /// # Panics
    /// If there are fewer columns than `leading`.
    pub fn beyond(mut self, leading: usize, cut: f64) -> Option<Self> {
        let all = self.triangle();
        let (rows, columns) = (all.nrows(), all.ncols());
        let finite = (0..columns).all(|j| all.col(j).iter().all(|x| x.is_finite()));
        if !finite {
            return None;
        }
        let size = rows.min(leading);
        let rights = all.submatrix(0, leading, size, columns - leading).to_owned();
        let pivoted = Pivoted::new(all.submatrix(0, 0, size, leading), rights, cut);
        let mut left = Self::new(columns - 1 - leading, rows);
        left.push_rows(pivoted.unreached());
        left.push_rows(all.submatrix(size, leading, rows - size, columns - leading));
        Some(left)
    }

    /// Minimises |A x - b|; singular values below `cut` times the largest are dropped and the shortest x is taken.
    /// `None` if a number is not finite.
    pub fn solve(mut self, cut: f64) -> Option<MinimumNorm> {
        let (triangle, right) = self.reduced()?;
        let (size, columns) = (triangle.nrows(), triangle.ncols());
        let mut values = Col::zeros(size);
        let (mut u, mut v) = (Mat::zeros(size, size), Mat::zeros(columns, size));
        if size > 0 {
            let thin = ComputeSvdVectors::Thin;
            let mut memory =
                MemBuffer::new(svd_scratch::<f64>(size, columns, thin, thin, Par::Seq, Default::default()));
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
        let mut x = vec![0.0; columns];
        for (k, direction) in directions.iter().enumerate() {
            let along: f64 = u.col(k).iter().zip(right.iter()).map(|(u, c)| u * c).sum();
            for (x, v) in x.iter_mut().zip(direction) {
                *x += v * along / singular_values[k];
            }
        }
        let singular_values = singular_values.into_iter().map(|value| value / SCALE).collect();
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
            let (x, rank) = reduction.clone().shortest(1e-11).unwrap();
            let got = reduction.solve(1e-11).unwrap();
            assert_eq!(rank, got.rank.rank);
            for (x, got) in x.iter().zip(&got.x) {
                assert!((x - got).abs() < 1e-9 * got.abs().max(1.0), "{count} rows: {x} {got}");
            }
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
        assert!(bad.clone().shortest(1e-11).is_none() && bad.solve(1e-11).is_none());
        assert_eq!(RowReduction::new(2, 0).shortest(1e-11).unwrap(), (vec![0.0; 2], 0));
        let mut zero = RowReduction::new(2, 2);
        zero.push(&[(0, 0.0)], 1.0);
        assert_eq!(zero.shortest(1e-11).unwrap(), (vec![0.0; 2], 0));
    }

    #[test]
    fn a_rank_in_doubt_is_left_to_the_singular_values() {
        for (small, open, wanted) in [(1e-7, false, 2), (1e-9, true, 2), (3e-11, true, 1), (1e-15, false, 1)]
        {
            let mut reduction = RowReduction::new(2, 2);
            reduction.push(&[(0, 1.0), (1, 1.0)], 2.0);
            reduction.push(&[(0, 1.0), (1, 1.0 + small)], 2.0);
            let (triangle, right) = reduction.reduced().unwrap();
            let pivoted = Pivoted::new(triangle, right.as_mat().to_owned(), 1e-11);
            assert_eq!(!pivoted.is_settled(), open, "{small}");
            let (x, rank) = reduction.shortest(1e-11).unwrap();
            assert_eq!(rank, wanted, "{small}");
            assert!((x[0] + x[1] - 2.0).abs() < 1e-9);
        }
    }
    #[test]
    fn the_last_columns_alone_are_found_as_with_all() {
        // Four columns of the six are independent; the last one here is none of their combinations.
        for leading in [0, 2, 5, 6] {
            let mut all = RowReduction::new(7, 60);
            for i in 0..60 {
                let (row, right) = row(i);
                let mut entries: Vec<(usize, f64)> = row.iter().copied().enumerate().collect();
                entries.push((6, (0.37 * i as f64).cos()));
                all.push(&entries, right);
            }
            let (want, rank) = all.clone().shortest(1e-11).unwrap();
            let (got, left) = all.beyond(leading, 1e-11).unwrap().shortest(1e-11).unwrap();
            assert_eq!((got.len(), rank), (7 - leading, 5));
            assert_eq!(left, [5, 3, 1, 1][[0, 2, 5, 6].iter().position(|&l| l == leading).unwrap()]);
            assert!((got[6 - leading] - want[6]).abs() < 1e-9, "{leading}: {got:?} {want:?}");
        }
    }
}
