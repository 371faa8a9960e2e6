//! Cholesky factors of small dense matrices by panels of four rows: a tile of four by four stays in registers while it is summed up.

use nalgebra::DMatrix;

/// Rows of a panel.
const ROWS: usize = 4;
/// A tile, column by column.
type Tile = [[f64; ROWS]; ROWS];

/// The lower factor L of a matrix L L^T. Panel p has rows 4 p to 4 p + 3 up to the diagonal, column by column.
#[derive(Clone, Debug)]
pub struct PanelCholesky {
    panels: Vec<Vec<f64>>,
    size: usize,
}

/// tile - rows columns^T.
fn subtract(tile: Tile, rows: &[f64], columns: &[f64]) -> Tile {
    let [mut a, mut b, mut c, mut d] = tile;
    for k in 0..rows.len() / ROWS {
        let (row, column) = (&rows[ROWS * k..ROWS * (k + 1)], &columns[ROWS * k..ROWS * (k + 1)]);
        for i in 0..ROWS {
            a[i] -= row[i] * column[0];
            b[i] -= row[i] * column[1];
            c[i] -= row[i] * column[2];
            d[i] -= row[i] * column[3];
        }
    }
    [a, b, c, d]
}

/// The columns of a tile of a panel, whose first column is the `first`.
fn tile(panel: &[f64], first: usize) -> Tile {
    let mut tile = [[0.0; ROWS]; ROWS];
    for j in 0..ROWS {
        tile[j].copy_from_slice(&panel[ROWS * (first + j)..ROWS * (first + j + 1)]);
    }
    tile
}

impl PanelCholesky {
    /// Of the lower triangle of a symmetric matrix; `None` where rounding makes it indefinite.
    pub fn new(matrix: &DMatrix<f64>) -> Option<Self> {
        let size = matrix.nrows();
        let entries = matrix.as_slice();
        let count = size.div_ceil(ROWS);
        let mut panels: Vec<Vec<f64>> = Vec::with_capacity(count);
        for p in 0..count {
            let mut panel = vec![0.0; ROWS * ROWS * (p + 1)];
            let (first, rows) = (ROWS * p, ROWS.min(size - ROWS * p));
            for column in 0..first + ROWS {
                let own = &mut panel[ROWS * column..ROWS * (column + 1)];
                match column < size {
                    true => own[..rows].copy_from_slice(&entries[column * size + first..][..rows]),
                    // What fills the last panel up.
                    false => own[column - first] = 1.0,
                }
            }
            for (q, other) in panels.iter().enumerate() {
                let before = ROWS * ROWS * q;
                let mut own = subtract(tile(&panel, ROWS * q), &panel[..before], &other[..before]);
                let diagonal = tile(other, ROWS * q);
                for j in 0..ROWS {
                    for m in 0..j {
                        let by = diagonal[m][j];
                        for i in 0..ROWS {
                            own[j][i] -= own[m][i] * by;
                        }
                    }
                    let by = diagonal[j][j].recip();
                    own[j].iter_mut().for_each(|x| *x *= by);
                }
                panel[before..before + ROWS * ROWS].copy_from_slice(own.as_flattened());
            }
            let before = ROWS * ROWS * p;
            let mut own = subtract(tile(&panel, first), &panel[..before], &panel[..before]);
            for j in 0..ROWS {
                for m in 0..j {
                    let by = own[m][j];
                    for i in j..ROWS {
                        own[j][i] -= own[m][i] * by;
                    }
                }
                let pivot = own[j][j];
                if !(pivot > 0.0 && pivot.is_finite()) {
                    return None;
                }
                let by = pivot.sqrt().recip();
                own[j].iter_mut().for_each(|x| *x *= by);
                own[j][..j].fill(0.0);
            }
            panel[before..].copy_from_slice(own.as_flattened());
            panels.push(panel);
        }
        Some(Self { panels, size })
    }

    /// x with L L^T x = right.
    pub fn solve(&self, right: &[f64]) -> Vec<f64> {
        let mut x = right.to_vec();
        x.resize(ROWS * self.panels.len(), 0.0);
        for (p, panel) in self.panels.iter().enumerate() {
            let (before, from) = x.split_at_mut(ROWS * p);
            let own = &mut from[..ROWS];
            for (k, x) in before.iter().enumerate() {
                let column = &panel[ROWS * k..ROWS * (k + 1)];
                for i in 0..ROWS {
                    own[i] -= column[i] * x;
                }
            }
            let diagonal = tile(panel, ROWS * p);
            for j in 0..ROWS {
                own[j] /= diagonal[j][j];
                for i in j + 1..ROWS {
                    own[i] -= diagonal[j][i] * own[j];
                }
            }
        }
        for (p, panel) in self.panels.iter().enumerate().rev() {
            let (before, from) = x.split_at_mut(ROWS * p);
            let own = &mut from[..ROWS];
            let diagonal = tile(panel, ROWS * p);
            for j in (0..ROWS).rev() {
                for i in j + 1..ROWS {
                    own[j] -= diagonal[j][i] * own[i];
                }
                own[j] /= diagonal[j][j];
            }
            for (k, x) in before.iter_mut().enumerate() {
                let l = &panel[ROWS * k..ROWS * (k + 1)];
                *x -= l[0] * own[0] + l[1] * own[1] + l[2] * own[2] + l[3] * own[3];
            }
        }
        x.truncate(self.size);
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DVector;

    #[test]
    fn solutions_of_every_size_are_those_of_another_factor() {
        for size in 1..30 {
            let number = |i: usize, j: usize| ((i * 7919 + j * 104_729 + size) % 1009) as f64 / 1009.0 - 0.5;
            let square = DMatrix::from_fn(size, size, number);
            let matrix = &square * square.transpose() + DMatrix::identity(size, size) * 0.1;
            let right = DVector::from_fn(size, |i, _| number(i, 3));
            let x = DVector::from_vec(PanelCholesky::new(&matrix).unwrap().solve(right.as_slice()));
            assert!((&matrix * &x - &right).amax() < 1e-12, "{size}");
        }
    }

    #[test]
    fn indefinite_matrices_have_no_factor() {
        let matrix = DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 2.0, 1.0]);
        assert!(PanelCholesky::new(&matrix).is_none());
    }
}
