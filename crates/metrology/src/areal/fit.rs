//! Weighted least squares of a flank by products of Legendre polynomials: Householder QR for points anywhere, discrete orthogonal
//! polynomials for whole grids. Knows no traces.

use super::tensor::TensorFit;
use super::terms::Term;
use super::{ArealDegree, ArealError, ArealFeatures, ArealField};
use crate::Topography;
use nalgebra::{DMatrix, DVector};

/// A point of a flank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArealPoint {
    /// Length of roll, mm.
    pub w: f64,
    /// Axial position, mm.
    pub z: f64,
    /// Deviation, mm; NaN where there is none.
    pub f: f64,
    /// Weight in the sum of squares, > 0; 1 where all are alike.
    pub weight: f64,
}

/// A fitted surface and what it leaves. The number of points counts independent ones: a smoothed trace has as many as its length
/// holds correlation lengths.
#[derive(Clone, Debug, PartialEq)]
pub struct ArealFit {
    field: ArealField,
    degree: ArealDegree,
    coefficients: Vec<f64>,
    /// (A^T W A)^-1.
    covariance: DMatrix<f64>,
    /// Points with a value.
    pub points: usize,
    /// Root mean square of what the surface leaves, mm.
    pub residual_rms: f64,
    /// Areal form: largest minus smallest residual, mm.
    pub form: f64,
    /// Standard deviation of a point of weight 1 from the residuals, mm; `None` with as many points as terms.
    pub scatter: Option<f64>,
    /// 1 - squares left over squares about the mean, weighted; 1 where there is nothing to explain.
    pub explained_share: f64,
}

/// Diagonal elements of the triangle below this share of the largest count as zero.
const DEGENERATE: f64 = 1e-10;

impl ArealFit {
    /// Of points anywhere in the field. Points without a value are left out.
    ///
    /// # Errors
    /// [`ArealError::InvalidNumber`] for places that are not finite and weights that are not above 0; [`ArealError::TooFewPoints`];
    /// [`ArealError::DegenerateField`].
    pub fn of_points(
        points: &[ArealPoint],
        field: &ArealField,
        degree: ArealDegree,
    ) -> Result<Self, ArealError> {
        let points: Vec<ArealPoint> = points.iter().copied().filter(|p| p.f.is_finite()).collect();
        for p in &points {
            let numbers =
                [("length of roll", p.w, "finite numbers"), ("axial position", p.z, "finite numbers")];
            if let Some((name, value, allowed)) = numbers.into_iter().find(|(_, x, _)| !x.is_finite()) {
                return Err(ArealError::InvalidNumber { name, value, allowed });
            }
            if !(p.weight.is_finite() && p.weight > 0.0) {
                let (name, allowed) = ("weight", "finite numbers above 0");
                return Err(ArealError::InvalidNumber { name, value: p.weight, allowed });
            }
        }
        let terms = degree.terms();
        if points.len() < terms.len() {
            return Err(ArealError::TooFewPoints { points: points.len(), terms: terms.len() });
        }
        let mut matrix = DMatrix::zeros(points.len(), terms.len());
        let mut right = DVector::zeros(points.len());
        for (i, p) in points.iter().enumerate() {
            let root = p.weight.sqrt();
            let (over_u, over_v) = (degree.legendre(field.u(p.w)), degree.legendre(field.v(p.z)));
            for (k, term) in terms.iter().enumerate() {
                matrix[(i, k)] = root * over_u[term.p] * over_v[term.q];
            }
            right[i] = root * p.f;
        }
        let qr = matrix.qr();
        let triangle = qr.r();
        let sizes = triangle.diagonal().map(f64::abs);
        // Written so that NaN is degenerate too.
        let share = sizes.min() / sizes.max();
        let degenerate = || ArealError::DegenerateField { share };
        if share.is_nan() || share < DEGENERATE {
            return Err(degenerate());
        }
        qr.q_tr_mul(&mut right);
        let projected = right.rows(0, terms.len()).into_owned();
        let solved = triangle.solve_upper_triangular(&projected).ok_or_else(degenerate)?;
        let one = DMatrix::identity(terms.len(), terms.len());
        let inverse = triangle.solve_upper_triangular(&one).ok_or_else(degenerate)?;
        let coefficients = solved.iter().copied().collect();
        Ok(Self::judged(*field, degree, coefficients, &inverse * inverse.transpose(), &points))
    }

    /// Of a whole grid, all points alike; a grid with gaps is fitted point by point.
    ///
    /// # Errors
    /// As [`ArealFit::of_points`].
    pub fn of_grid(grid: &Topography, field: &ArealField, degree: ArealDegree) -> Result<Self, ArealError> {
        let at =
            |i: usize, j: usize| ArealPoint { w: grid.w[i], z: grid.z[j], f: grid.at(i, j), weight: 1.0 };
        let points: Vec<ArealPoint> = (0..grid.w.len())
            .flat_map(|i| (0..grid.z.len()).map(move |j| (i, j)))
            .map(|(i, j)| at(i, j))
            .collect();
        if grid.f.iter().any(|f| !f.is_finite()) {
            return Self::of_points(&points, field, degree);
        }
        let places =
            |x: &[f64], scaled: &dyn Fn(f64) -> f64| x.iter().map(|&x| scaled(x)).collect::<Vec<_>>();
        let (u, v) = (places(&grid.w, &|w| field.u(w)), places(&grid.z, &|z| field.v(z)));
        let fit = TensorFit::new(&u, &v, &grid.f, degree)?;
        Ok(Self::judged(*field, degree, fit.coefficients, fit.covariance, &points))
    }

    /// The fit with its residuals.
    fn judged(
        field: ArealField,
        degree: ArealDegree,
        coefficients: Vec<f64>,
        covariance: DMatrix<f64>,
        points: &[ArealPoint],
    ) -> Self {
        let terms = coefficients.len();
        let mut fit = Self {
            field,
            degree,
            coefficients,
            covariance,
            points: points.len(),
            residual_rms: 0.0,
            form: 0.0,
            scatter: None,
            explained_share: 1.0,
        };
        let weights: f64 = points.iter().map(|p| p.weight).sum();
        let mean = points.iter().map(|p| p.weight * p.f).sum::<f64>() / weights;
        let (mut plain, mut left, mut total) = (0.0, 0.0, 0.0);
        let mut reach = [f64::INFINITY, f64::NEG_INFINITY];
        for p in points {
            let residual = p.f - fit.value(p.w, p.z);
            plain += residual * residual;
            left += p.weight * residual * residual;
            total += p.weight * (p.f - mean).powi(2);
            reach = [reach[0].min(residual), reach[1].max(residual)];
        }
        fit.residual_rms = (plain / points.len() as f64).sqrt();
        fit.form = reach[1] - reach[0];
        fit.scatter = (points.len() > terms).then(|| (left / (points.len() - terms) as f64).sqrt());
        if total > 0.0 {
            fit.explained_share = 1.0 - left / total;
        }
        fit
    }

    /// The field to which the coefficients belong.
    pub fn field(&self) -> &ArealField {
        &self.field
    }

    /// Its degree.
    pub fn degree(&self) -> ArealDegree {
        self.degree
    }

    /// Coefficients a_pq in the order of [`ArealDegree::terms`], mm.
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// The fitted surface at (w, z), mm.
    pub fn value(&self, w: f64, z: f64) -> f64 {
        let (u, v) = (self.degree.legendre(self.field.u(w)), self.degree.legendre(self.field.v(z)));
        self.degree.terms().iter().zip(&self.coefficients).map(|(t, a)| a * u[t.p] * v[t.q]).sum()
    }

    /// The features.
    pub fn features(&self) -> ArealFeatures {
        ArealFeatures::of(|term| self.coefficients[term.place()])
    }

    /// Standard uncertainties of the features for points that scatter independently by `sigma` (mm, of weight 1).
    pub fn uncertainties(&self, sigma: f64) -> ArealFeatures {
        let root = |term: Term| sigma * self.covariance[(term.place(), term.place())].sqrt();
        ArealFeatures::of(root).sizes()
    }
}
