//! Rows of bounds with their columns in fours, as cubic splines have them, and their share of the normal equations of a step. Bounds that have
//! rows in common share them, and the last variables, which nearly every bound knows, stand apart.

use super::parts::{Part, Scaling, dot, plus};
use super::{Affine, Band, ConeProgramme};
use nalgebra::DMatrix;
use std::ops::Range;

/// Columns that are taken together: a cubic B-spline has so many that count at a place.
const TOGETHER: usize = 4;
type Columns = [f64; TOGETHER];

/// Adds columns of a row. Plain loops over four numbers: they are vectors whatever the compiler makes of iterators.
fn add(to: &mut [f64], by: f64, row: &Columns) {
    let to = &mut to[..TOGETHER];
    for k in 0..TOGETHER {
        to[k] += by * row[k];
    }
}

/// How the variables of a programme stand: its own, a few more so that every piece is whole, the common ones.
#[derive(Clone, Copy)]
pub(super) struct Layout {
    own: usize,
    common: usize,
}

impl Layout {
    pub(super) fn new(programme: &ConeProgramme) -> Self {
        Self { own: programme.cost.len() - programme.common, common: programme.common }
    }

    pub(super) fn columns(&self) -> usize {
        self.first_common() + self.common
    }

    /// Variables that no bound knows.
    pub(super) fn fill(&self) -> Range<usize> {
        self.own..self.first_common()
    }

    fn first_common(&self) -> usize {
        self.own + TOGETHER - 1
    }

    /// Where a variable of the programme stands.
    pub(super) fn place(&self, variable: usize) -> usize {
        if variable < self.own { variable } else { variable + TOGETHER - 1 }
    }
}

/// What a bound has beside the rows that it shares: one row, two whose first is no smaller than the size of the second, or three whose first is
/// no shorter than the vector of the others.
struct Bound {
    constant: Part,
    /// Factor of the first of the shared rows.
    sign: f64,
    /// Factors of the common variables.
    common: Vec<Part>,
}

/// Rows of one or two bounds.
pub(super) struct Rows {
    /// First column of each piece, ascending; pieces have no column in common.
    firsts: Vec<usize>,
    /// Factors of the pieces, as many for each as there are rows that have any.
    factors: Vec<Columns>,
    /// Rows that have any.
    rows: Range<usize>,
    bounds: Vec<Bound>,
}

/// The normal equations of a step.
pub(super) struct Normal {
    /// The lower triangle.
    matrix: DMatrix<f64>,
    /// Rows of the common variables, over the columns before them.
    common: Vec<Vec<f64>>,
}

impl Normal {
    pub(super) fn new(quadratic: &DMatrix<f64>, layout: Layout) -> Self {
        let common = vec![vec![0.0; layout.first_common()]; layout.common];
        Self { matrix: quadratic.clone(), common }
    }

    pub(super) fn matrix(mut self) -> DMatrix<f64> {
        for (j, row) in self.common.iter().enumerate() {
            for (k, value) in row.iter().enumerate() {
                self.matrix[(row.len() + j, k)] += value;
            }
        }
        self.matrix
    }
}

impl Rows {
    /// All of a programme.
    pub(super) fn all(programme: &ConeProgramme, layout: Layout) -> Vec<Self> {
        let positive = programme.positive.iter().map(std::slice::from_ref);
        let strips = programme.strips.iter().map(<[Affine; 2]>::as_slice);
        let cones = programme.cones.iter().map(<[Affine; 3]>::as_slice);
        let alone = positive.chain(strips).chain(cones).map(|rows| Self::alone(rows, layout));
        alone.chain(programme.bands.iter().map(|band| Self::of_band(band, layout))).collect()
    }

    fn alone(rows: &[Affine], layout: Layout) -> Self {
        let own = |row: &Affine| -> Vec<(usize, f64)> {
            row.entries.iter().copied().filter(|entry| entry.0 < layout.own).collect()
        };
        let mut bound = Bound { constant: [0.0; 3], sign: 1.0, common: vec![[0.0; 3]; layout.common] };
        for (j, row) in rows.iter().enumerate() {
            bound.add(j, row, layout);
        }
        let shared: Vec<Vec<(usize, f64)>> = rows.iter().map(own).collect();
        Self::new(&shared, vec![bound])
    }

    fn of_band(Band { middle, others, ends }: &Band, layout: Layout) -> Self {
        let bounds = ends.iter().zip([1.0, -1.0]).map(|(end, sign)| {
            let mut bound = Bound { constant: [0.0; 3], sign, common: vec![[0.0; 3]; layout.common] };
            bound.add(0, end, layout);
            bound
        });
        let [b, c] = others;
        Self::new(&[middle, b, c].map(Vec::clone), bounds.collect())
    }

    fn new(shared: &[Vec<(usize, f64)>], bounds: Vec<Bound>) -> Self {
        let from = shared.iter().take_while(|row| row.is_empty()).count();
        let rows = from..shared.len();
        let mut columns: Vec<usize> = shared.iter().flatten().map(|entry| entry.0).collect();
        columns.sort_unstable();
        let mut firsts: Vec<usize> = Vec::new();
        for column in columns {
            if firsts.last().is_none_or(|first| column >= first + TOGETHER) {
                firsts.push(column);
            }
        }
        let mut factors = vec![[0.0; TOGETHER]; firsts.len() * rows.len()];
        for (j, row) in shared[rows.clone()].iter().enumerate() {
            for (column, factor) in row {
                let piece = firsts.partition_point(|first| first <= column) - 1;
                factors[piece * rows.len() + j][column - firsts[piece]] += factor;
            }
        }
        Self { firsts, factors, rows, bounds }
    }

    /// Constants of the bounds.
    pub(super) fn constants(&self) -> impl Iterator<Item = &Part> {
        self.bounds.iter().map(|bound| &bound.constant)
    }

    /// Adds A x of each bound to the parts.
    pub(super) fn times(&self, x: &[f64], layout: Layout, parts: &mut Vec<Part>) {
        let mut shared = [0.0; 3];
        let count = self.rows.len();
        for (piece, &first) in self.firsts.iter().enumerate() {
            let x = &x[first..first + TOGETHER];
            for j in 0..count {
                let a = &self.factors[piece * count + j];
                shared[self.rows.start + j] += a[0] * x[0] + a[1] * x[1] + a[2] * x[2] + a[3] * x[3];
            }
        }
        let common = &x[layout.first_common()..];
        for bound in &self.bounds {
            let mut part = [bound.sign * shared[0], shared[1], shared[2]];
            for (factors, x) in bound.common.iter().zip(common) {
                part = plus(&part, *x, factors);
            }
            parts.push(part);
        }
    }

    /// Adds A^T parts; there is one part for each bound.
    pub(super) fn add_transposed(&self, parts: &[Part], to: &mut [f64], layout: Layout) {
        let mut shared = [0.0; 3];
        for (bound, part) in self.bounds.iter().zip(parts) {
            shared = plus(&shared, 1.0, &[bound.sign * part[0], part[1], part[2]]);
            for (k, factors) in bound.common.iter().enumerate() {
                to[layout.first_common() + k] += dot(factors, part);
            }
        }
        self.add_rows(&shared, to);
    }

    /// Adds the shared rows, each by its number.
    fn add_rows(&self, by: &Part, to: &mut [f64]) {
        let count = self.rows.len();
        for (piece, &first) in self.firsts.iter().enumerate() {
            let to = &mut to[first..first + TOGETHER];
            for j in 0..count {
                add(to, by[self.rows.start + j], &self.factors[piece * count + j]);
            }
        }
    }

    /// How many bounds.
    pub(super) fn count(&self) -> usize {
        self.bounds.len()
    }

    /// Adds A^T W^-2 A; there is one scaling for each bound.
    pub(super) fn add_square(&self, scalings: &[Scaling], to: &mut Normal, layout: Layout) {
        // Over the shared rows, and these over the common variables.
        let mut square = [[0.0; 3]; 3];
        let first = layout.first_common();
        for (bound, scaling) in self.bounds.iter().zip(scalings) {
            let weights = scaling.inverse_square();
            let signs = [bound.sign, 1.0, 1.0];
            for r in 0..3 {
                for s in 0..3 {
                    square[r][s] += signs[r] * signs[s] * weights[r][s];
                }
            }
            for (j, factors) in bound.common.iter().enumerate() {
                let weighed = weights.map(|row| dot(&row, factors));
                for (k, other) in bound.common[..=j].iter().enumerate() {
                    to.matrix[(first + j, first + k)] += dot(&weighed, other);
                }
                let along = [bound.sign * weighed[0], weighed[1], weighed[2]];
                self.add_rows(&along, &mut to.common[j]);
            }
        }
        match self.rows.len() {
            0 => {}
            1 => self.add_products::<1>(&square, to),
            2 => self.add_products::<2>(&square, to),
            _ => self.add_products::<3>(&square, to),
        }
    }

    fn add_products<const ROWS: usize>(&self, square: &[Part; 3], to: &mut Normal) {
        let start = self.rows.start;
        let height = to.matrix.nrows();
        let matrix = to.matrix.as_mut_slice();
        let pieces = self.firsts.len();
        for i in 0..pieces {
            let mut own = [[0.0; TOGETHER]; ROWS];
            for r in 0..ROWS {
                for s in 0..ROWS {
                    add(&mut own[r], square[start + r][start + s], &self.factors[i * ROWS + s]);
                }
            }
            for other in i..pieces {
                let row = self.firsts[other];
                let factors = &self.factors[other * ROWS..(other + 1) * ROWS];
                for k in 0..TOGETHER {
                    // Pieces ascend: the lower triangle, down each column, and of a piece with itself the whole square.
                    let from = (self.firsts[i] + k) * height + row;
                    let below = &mut matrix[from..from + TOGETHER];
                    for r in 0..ROWS {
                        add(below, own[r][k], &factors[r]);
                    }
                }
            }
        }
    }
}

impl Bound {
    /// Constant and common variables of a row.
    fn add(&mut self, row: usize, of: &Affine, layout: Layout) {
        self.constant[row] = of.constant;
        for &(variable, factor) in of.entries.iter().filter(|entry| entry.0 >= layout.own) {
            self.common[variable - layout.own][row] += factor;
        }
    }
}
