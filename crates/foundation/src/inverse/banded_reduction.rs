//! QR of rows that are dense in a few columns, the border, and touch a short stretch of all others, the band: rows sorted by
//! their stretch are reduced stretch by stretch. Hands over to [`RowReduction`]. Knows no gears.

use super::RowReduction;
use super::row_reduction::SCALE;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::householder::{
    apply_block_householder_sequence_transpose_on_the_left_in_place_scratch as apply_scratch,
    apply_block_householder_sequence_transpose_on_the_left_in_place_with_conj as apply_transposed,
};
use faer::linalg::qr::no_pivoting::factor::{qr_in_place, qr_in_place_scratch, recommended_block_size};
use faer::{Conj, Mat, Par};

/// Rows of one stretch collected before they are reduced.
const BLOCK: usize = 256;

/// The triangle of all rows so far, in three parts: columns of the band that no row will touch any more, the stretch in
/// work, and what is left in the border. The result depends on the order of the rows only, not on threads.
///
/// With m rows, stretches of s columns and a border of b: about 2 m (s (s + b) + b^2) operations, against 2 m (band + b)^2
/// without regard to the band.
#[derive(Clone, Debug)]
pub struct BandedReduction {
    band: usize,
    stretch: usize,
    border: usize,
    /// First column of the stretch in work.
    first: usize,
    /// Rows of that stretch: its columns, the border, the right side; times [`SCALE`], like all numbers here.
    rows: Mat<f64>,
    filled: usize,
    /// Rows done: band, border, right side.
    done: Mat<f64>,
    done_rows: usize,
    rest: RowReduction,
    memory: Mat<f64>,
}

impl BandedReduction {
    /// For rows with `stretch` neighbouring columns among the first `band`, and any of the following `border` columns;
    /// `expected` rows only decide how much memory is taken at once.
    pub fn new(band: usize, stretch: usize, border: usize, expected: usize) -> Self {
        let block = expected.clamp(stretch, BLOCK.max(stretch));
        let memory = Mat::zeros(recommended_block_size::<f64>(block + stretch, stretch), stretch);
        Self {
            band,
            stretch,
            border,
            first: 0,
            rows: Mat::zeros(block + stretch, stretch + border + 1),
            filled: 0,
            done: Mat::zeros(band, band + border + 1),
            done_rows: 0,
            rest: RowReduction::new(border, expected),
            memory,
        }
    }

    /// Adds a row: its first `stretch` entries are the columns from `entries[0].0` on, the others lie in the border.
    /// Rows come with ascending first columns.
    ///
    /// # Panics
    /// If a column does not exist, or a row begins before the one before it.
    #[inline]
    pub fn push(&mut self, entries: &[(usize, f64)], right: f64) {
        let (inside, border) = entries.split_at(self.stretch);
        let first = inside.first().map_or(0, |entry| entry.0);
        if first != self.first {
            assert!(first > self.first, "rows are sorted by their first column");
            self.advance(first);
        }
        if self.filled == self.rows.nrows() {
            self.reduce();
        }
        for &(column, value) in inside {
            self.rows[(self.filled, column - self.first)] = value * SCALE;
        }
        for &(column, value) in border {
            self.rows[(self.filled, column - self.band + self.stretch)] = value * SCALE;
        }
        self.rows[(self.filled, self.stretch + self.border)] = right * SCALE;
        self.filled += 1;
    }

    /// Reduces the rows of the stretch to a triangle; what is left in the border alone moves on.
    fn reduce(&mut self) {
        let (rows, stretch) = (self.filled, self.stretch);
        let size = rows.min(stretch);
        if size == 0 {
            return;
        }
        let block = recommended_block_size::<f64>(rows, stretch).min(self.memory.nrows());
        let mut factors = self.memory.as_mut().submatrix_mut(0, 0, block, size);
        let scratch = qr_in_place_scratch::<f64>(rows, stretch, block, Par::Seq, Default::default());
        let mut memory = MemBuffer::new(scratch.or(apply_scratch::<f64>(rows, block, self.border + 1)));
        let (mut inside, border) = self.rows.as_mut().subrows_mut(0, rows).split_at_col_mut(stretch);
        qr_in_place(
            inside.as_mut(),
            factors.as_mut(),
            Par::Seq,
            MemStack::new(&mut memory),
            Default::default(),
        );
        apply_transposed(
            inside.as_ref().subcols(0, size),
            factors.as_ref(),
            Conj::No,
            border,
            Par::Seq,
            MemStack::new(&mut memory),
        );
        let width = self.border + 1;
        self.rest.push_rows(self.rows.as_ref().submatrix(size, stretch, rows - size, width));
        for j in 0..stretch + width {
            let kept = if j < stretch { (j + 1).min(size) } else { size };
            self.rows.col_as_slice_mut(j)[kept..rows].fill(0.0);
        }
        self.filled = size;
    }

    /// Goes on to the stretch that begins at `first`.
    fn advance(&mut self, first: usize) {
        self.reduce();
        let passed = (first - self.first).min(self.stretch);
        let finished = passed.min(self.filled);
        for i in 0..finished {
            for j in 0..self.stretch + self.border + 1 {
                let column = if j < self.stretch { self.first + j } else { self.band + j - self.stretch };
                self.done[(self.done_rows + i, column)] = self.rows[(i, j)];
            }
        }
        self.done_rows += finished;
        // What stays has nothing in the columns passed.
        let (kept, filled) = (self.filled - finished, self.filled);
        for j in 0..self.stretch + self.border + 1 {
            let from =
                if j < self.stretch - passed { Some(j + passed) } else { (j >= self.stretch).then_some(j) };
            for i in 0..filled {
                let value = match from {
                    Some(from) if i < kept => self.rows[(i + finished, from)],
                    _ => 0.0,
                };
                self.rows[(i, j)] = value;
            }
        }
        self.filled = kept;
        self.first = first;
    }

    /// The triangle of all rows, columns of the band first.
    pub fn finish(mut self) -> RowReduction {
        self.advance(self.first + self.stretch);
        let columns = self.band + self.border;
        let rest = self.rest.triangle();
        let mut all = RowReduction::new(columns, self.done_rows + rest.nrows());
        all.push_rows(self.done.as_ref().subrows(0, self.done_rows));
        let mut below = Mat::zeros(rest.nrows(), columns + 1);
        below.as_mut().subcols_mut(self.band, self.border + 1).copy_from(rest);
        all.push_rows(below.as_ref());
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of a stretch of 4 columns that advances by 2, with a border of 3, sorted; rank below the number of columns where
    /// few rows touch a stretch.
    fn row(i: usize, count: usize) -> (Vec<(usize, f64)>, f64) {
        let mut first = 2 * (i * 5 / count);
        // One stretch is left out.
        if first == 4 {
            first = 6;
        }
        let number = |k: usize| ((1.7 * i as f64 + 0.31) * (k as f64 + 0.6)).sin();
        let inside = (0..4).map(|k| (first + k, number(k)));
        let border = (0..3).map(|k| (12 + k, number(k + 7)));
        (inside.chain(border).collect(), number(20))
    }

    #[test]
    fn banded_rows_give_what_dense_rows_give() {
        for count in [1, 6, 11, 40, 500, 3000] {
            let mut banded = BandedReduction::new(12, 4, 3, count);
            let mut dense = RowReduction::new(15, count);
            for i in 0..count {
                let (entries, right) = row(i, count);
                banded.push(&entries, right);
                dense.push(&entries, right);
            }
            let (banded, dense) = (banded.finish().solve(1e-11).unwrap(), dense.solve(1e-11).unwrap());
            assert_eq!(banded.rank.rank, dense.rank.rank, "{count} rows");
            assert_eq!(dense.rank.rank == 15, count >= 40, "{count} rows");
            for (a, b) in banded.x.iter().zip(&dense.x) {
                assert!((a - b).abs() < 1e-9, "{count} rows: {a} {b}");
            }
            let values = banded.rank.singular_values.iter().zip(&dense.rank.singular_values);
            assert!(values.into_iter().all(|(a, b)| (a - b).abs() < 1e-12 * dense.rank.singular_values[0]));
        }
    }

    #[test]
    fn no_rows_and_no_border() {
        assert_eq!(BandedReduction::new(4, 2, 1, 0).finish().shortest(1e-11).unwrap(), (vec![0.0; 5], 0));
        let mut lone = BandedReduction::new(2, 2, 0, 2);
        lone.push(&[(0, 1.0), (1, 1.0)], 3.0);
        lone.push(&[(0, 1.0), (1, -1.0)], 1.0);
        let (x, rank) = lone.finish().shortest(1e-11).unwrap();
        assert!(rank == 2 && (x[0] - 2.0).abs() < 1e-14 && (x[1] - 1.0).abs() < 1e-14, "{x:?}");
    }
}
