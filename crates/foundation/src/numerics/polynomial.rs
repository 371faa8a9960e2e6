//! Polynomials in two variables with dense coefficients: ring operations, shift of the origin, evaluation.

use super::jet::Jet2;

/// sum c_ij u^i v^j. The table of coefficients is dense; degrees of a few tens are meant, not hundreds.
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial2 {
    /// Row i holds the coefficients of u^i, ascending in v; at least one row and column.
    rows: Vec<Vec<f64>>,
}

impl Polynomial2 {
    /// A constant.
    pub fn constant(c: f64) -> Self {
        Self { rows: vec![vec![c]] }
    }

    /// a u + b v + c.
    pub fn linear(a: f64, b: f64, c: f64) -> Self {
        Self::from_terms([(0, 0, c), (1, 0, a), (0, 1, b)])
    }

    /// The sum of terms (i, j, c_ij); equal exponents add up.
    pub fn from_terms(terms: impl IntoIterator<Item = (usize, usize, f64)>) -> Self {
        let terms: Vec<_> = terms.into_iter().collect();
        let height = 1 + terms.iter().map(|t| t.0).max().unwrap_or(0);
        let width = 1 + terms.iter().map(|t| t.1).max().unwrap_or(0);
        let mut rows = vec![vec![0.0; width]; height];
        for (i, j, c) in terms {
            rows[i][j] += c;
        }
        Self { rows }
    }

    /// Coefficient of u^i v^j (zero beyond the table).
    pub fn coefficient(&self, i: usize, j: usize) -> f64 {
        self.rows.get(i).and_then(|row| row.get(j)).copied().unwrap_or(0.0)
    }

    /// Terms (i, j, c_ij) with c_ij different from zero, ascending in i, then in j.
    pub fn terms(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        self.rows
            .iter()
            .enumerate()
            .flat_map(|(i, row)| row.iter().enumerate().map(move |(j, &c)| (i, j, c)))
            .filter(|term| term.2 != 0.0)
    }

    /// Largest i + j among the terms; zero for the zero polynomial.
    pub fn degree(&self) -> usize {
        self.terms().map(|(i, j, _)| i + j).max().unwrap_or(0)
    }

    /// Sum of two polynomials.
    pub fn add(&self, other: &Self) -> Self {
        Self::from_terms(self.terms().chain(other.terms()))
    }

    /// The polynomial times a number.
    pub fn scale(&self, factor: f64) -> Self {
        Self::from_terms(self.terms().map(|(i, j, c)| (i, j, factor * c)))
    }

    /// Product of two polynomials.
    pub fn multiply(&self, other: &Self) -> Self {
        let pairs =
            self.terms().flat_map(|(i, j, a)| other.terms().map(move |(k, l, b)| (i + k, j + l, a * b)));
        Self::from_terms(pairs)
    }

    /// q(u, v) = p(u + du, v + dv).
    pub fn shifted(&self, du: f64, dv: f64) -> Self {
        let mut rows = self.rows.clone();
        for row in &mut rows {
            taylor_shift(row, dv);
        }
        for j in 0..rows[0].len() {
            let mut column: Vec<f64> = rows.iter().map(|row| row[j]).collect();
            taylor_shift(&mut column, du);
            for (row, c) in rows.iter_mut().zip(column) {
                row[j] = c;
            }
        }
        Self { rows }
    }

    /// q(u, v) = p(u, -v).
    pub fn mirrored_v(&self) -> Self {
        Self::from_terms(self.terms().map(|(i, j, c)| (i, j, if j % 2 == 1 { -c } else { c })))
    }

    /// Value at (u, v).
    #[inline]
    pub fn value(&self, u: f64, v: f64) -> f64 {
        self.rows.iter().rev().fold(0.0, |sum, row| sum * u + row.iter().rev().fold(0.0, |s, c| s * v + c))
    }

    /// Value, gradient and second derivatives at (u, v).
    #[inline]
    pub fn jet(&self, u: f64, v: f64) -> Jet2 {
        let mut jet = Jet2::default();
        for row in self.rows.iter().rev() {
            let [p, p1, p2] =
                row.iter().rev().fold([0.0; 3], |[p, p1, p2], c| [p * v + c, p1 * v + p, p2 * v + 2.0 * p1]);
            jet = Jet2 {
                fuu: jet.fuu * u + 2.0 * jet.fu,
                fu: jet.fu * u + jet.f,
                f: jet.f * u + p,
                fuv: jet.fuv * u + jet.fv,
                fv: jet.fv * u + p1,
                fvv: jet.fvv * u + p2,
            };
        }
        jet
    }
}

/// Coefficients of p(x + d) from those of p(x), in place, by repeated synthetic division.
fn taylor_shift(coefficients: &mut [f64], d: f64) {
    for start in 0..coefficients.len() {
        for k in (start..coefficients.len() - 1).rev() {
            coefficients[k] += d * coefficients[k + 1];
        }
    }
}
