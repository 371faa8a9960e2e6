//! Penalised least squares for splines: values at places, third differences small, and just enough on the second ones to choose among the
//! decompositions with the same sum.

use super::bases::{Bases, Kind, Place};
use foundation::inverse::PanelCholesky;
use nalgebra::{DMatrix, DVector};

/// Weight of the second differences against that of the third: chooses among equal decompositions and hardly bends anything.
const BEND: f64 = 1e-7;
/// Weight of the coefficients of F_K themselves, and of F_L, for the same reason: small travel of the axes.
const TRAVEL: f64 = 1e-8;
/// Makes the normal matrix regular where no place determines a coefficient.
const RIDGE: f64 = 1e-12;

/// Places with their rows.
#[derive(Clone, Debug)]
pub struct Rows {
    rows: Vec<Vec<(usize, f64)>>,
    columns: usize,
}

impl Rows {
    /// The rows of places.
    pub fn new(bases: &Bases, places: &[Place]) -> Self {
        let rows = places
            .iter()
            .map(|place| {
                let mut row = Vec::new();
                bases.row(place, &mut row);
                row
            })
            .collect();
        Self { rows, columns: bases.columns() }
    }

    /// The sum of the functions at each place.
    pub fn values(&self, x: &[f64]) -> Vec<f64> {
        self.rows.iter().map(|row| row.iter().map(|&(column, factor)| x[column] * factor).sum()).collect()
    }

    /// A^T A / n and A^T b / n.
    fn normal(&self, values: &[f64]) -> (DMatrix<f64>, DVector<f64>) {
        let mut matrix = DMatrix::zeros(self.columns, self.columns);
        let mut right = DVector::zeros(self.columns);
        let share = 1.0 / self.rows.len().max(1) as f64;
        for (row, value) in self.rows.iter().zip(values) {
            for (i, &(column, factor)) in row.iter().enumerate() {
                let scaled = factor * share;
                right[column] += scaled * value;
                for &(other, along) in &row[..=i] {
                    // `row` ascends: the lower triangle.
                    matrix[(column, other)] += scaled * along;
                }
            }
        }
        (matrix, right)
    }
}

/// A quadratic form, in the lower triangle.
fn add_form(matrix: &mut DMatrix<f64>, form: Vec<(usize, usize, f64)>) {
    for (row, column, value) in form {
        matrix[(column, row)] += value;
    }
}

/// Fits to values at places.
pub struct Smoother<'a> {
    bases: &'a Bases,
    /// A^T A / n and A^T b / n.
    normal: (DMatrix<f64>, DVector<f64>),
}

impl<'a> Smoother<'a> {
    /// Of functions, to values at places.
    pub fn new(bases: &'a Bases, rows: &Rows, values: &[f64]) -> Self {
        Self { bases, normal: rows.normal(values) }
    }

    /// Coefficients that make mean((value - fit)^2) + `smoothness` mean(third differences^2) + `beyond` mean(second differences beyond the
    /// flank^2) + the choice among equals small. `None` where a number is not finite.
    pub fn fit(&self, smoothness: f64, beyond: f64) -> Option<Vec<f64>> {
        let (mut matrix, right) = (self.normal.0.clone(), &self.normal.1);
        for block in &self.bases.blocks {
            let mut form = Vec::new();
            block.differences(&[-1.0, 3.0, -3.0, 1.0], smoothness, &mut form);
            block.differences(&[1.0, -2.0, 1.0], BEND, &mut form);
            let travel = match block.kind {
                Kind::Kinematic | Kind::Linear => TRAVEL,
                Kind::Constant | Kind::Profile => 0.0,
            };
            block.differences(&[1.0], travel + RIDGE, &mut form);
            block.straight_beyond(beyond, &mut form);
            add_form(&mut matrix, form);
        }
        let solved = PanelCholesky::new(&matrix)?.solve(right.as_slice());
        solved.iter().all(|x| x.is_finite()).then_some(solved)
    }
}
