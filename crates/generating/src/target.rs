//! The target of one flank, split into what the class can carry as it stands and what it cannot (`docs/mathematics/planning.md`).

use super::GeneratingError;
use super::least_squares::{DEFAULT_GRID, Samples};
use foundation::modification::Modification;
use foundation::numerics::{Jet2, Polynomial2, equidistant};
use nalgebra::{DMatrix, DVector};

/// Exponents of the class used for fits: u^i y^j with i + j <= 3, and u^4, u^5.
const CLASS: [(usize, usize); 12] =
    [(0, 0), (0, 1), (0, 2), (0, 3), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (3, 0), (4, 0), (5, 0)];

/// Exponents without mixed terms: all that a radial plan may correct
/// (`docs/mathematics/generating-contact.md#what-the-grinding-motion-leaves-to-first-order`).
const PURE: [(usize, usize); 9] = [(0, 0), (0, 1), (0, 2), (0, 3), (1, 0), (2, 0), (3, 0), (4, 0), (5, 0)];

/// All exponents of a polynomial of third degree.
const CUBIC: [(usize, usize); 10] =
    [(0, 0), (0, 1), (0, 2), (0, 3), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (3, 0)];

/// Least-squares fit into the class on fixed points; the matrix is inverted once.
#[derive(Clone, Debug)]
pub struct ClassFit {
    operator: DMatrix<f64>,
    exponents: &'static [(usize, usize)],
    scales: Vec<f64>,
}

impl ClassFit {
    /// Into the whole class, for points (u, y) that determine it (>= 6 x 4 different ones).
    pub fn new(points: &[(f64, f64)]) -> Self {
        Self::with_exponents(points, &CLASS)
    }

    /// Into the terms pure in u or in y only.
    pub fn without_mixed_terms(points: &[(f64, f64)]) -> Self {
        Self::with_exponents(points, &PURE)
    }

    /// Into the polynomials of third degree.
    pub fn cubic(points: &[(f64, f64)]) -> Self {
        Self::with_exponents(points, &CUBIC)
    }

    fn with_exponents(points: &[(f64, f64)], exponents: &'static [(usize, usize)]) -> Self {
        let extent =
            |pick: fn(&(f64, f64)) -> f64| points.iter().map(|p| pick(p).abs()).fold(1e-12, f64::max);
        let (eu, ey) = (extent(|p| p.0), extent(|p| p.1));
        let scales: Vec<f64> =
            exponents.iter().map(|&(i, j)| eu.powi(i as i32) * ey.powi(j as i32)).collect();
        let matrix = DMatrix::from_fn(points.len(), exponents.len(), |row, k| {
            let (i, j) = exponents[k];
            points[row].0.powi(i as i32) * points[row].1.powi(j as i32) / scales[k]
        });
        // Scaled columns have entries up to 1, so 1e-12 of sqrt(rows) is far below any singular value that matters.
        let cut = 1e-12 * (points.len() as f64).sqrt();
        let operator =
            matrix.pseudo_inverse(cut).unwrap_or_else(|_| DMatrix::zeros(exponents.len(), points.len()));
        Self { operator, exponents, scales }
    }

    /// The polynomial nearest to `values` at the points.
    pub fn fit(&self, values: &[f64]) -> Polynomial2 {
        let x = &self.operator * DVector::from_column_slice(values);
        let terms = self.exponents.iter().zip(x.iter().zip(&self.scales));
        Polynomial2::from_terms(terms.map(|(&(i, j), (x, s))| (i, j, x / s)))
    }
}

/// A target flank f_t(w, z), split. Transverse, mm.
#[derive(Clone, Debug)]
pub struct FlankTarget {
    /// The whole target.
    pub modification: Modification,
    /// The part within the class as a polynomial in u = w - w_m, y = z - z_m, with the best fit of `rest`.
    pub polynomial: Polynomial2,
    /// The same without that fit.
    pub of_class: Polynomial2,
    /// Parts of w alone that are no polynomials (reliefs, arcs): carried by the profile as they stand.
    pub reliefs: Vec<Modification>,
    /// Parts that are neither: the tool's lines may carry them as they stand.
    pub rest: Vec<Modification>,
    /// `rest` on the grid of general decompositions, with the tolerances that weigh it.
    pub rest_samples: Option<Samples>,
    /// Largest residual over the field when `rest` is only best-fitted by `polynomial`, mm (0 if there is none).
    pub outside: f64,
}

/// What carries the parts of a target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carrier {
    /// A dresser made for the target carries what depends on the profile only, lines the rest of the class.
    Dresser,
    /// As `Dresser`, on a conical workpiece: a dresser leaves lines of equal rack height there, not of equal roll, so
    /// that only polynomials of third degree fit.
    DresserOnCone,
    /// The lines of a freely made tool carry everything.
    Lines,
}

impl FlankTarget {
    /// Splits a target that a dresser made for it may carry.
    ///
    /// # Errors
    /// Evaluation errors of the modification over its field.
    pub fn new(modification: Modification) -> Result<Self, GeneratingError> {
        Self::split(modification, Carrier::Dresser, None)
    }

    /// Splits a target by what carries it.
    ///
    /// # Errors
    /// Evaluation errors of the modification over its field.
    pub fn carried_by(modification: Modification, carrier: Carrier) -> Result<Self, GeneratingError> {
        Self::split(modification, carrier, None)
    }

    /// Splits a target to be made with a dresser whose profile is given: `given` is what it leaves on the gear (a function
    /// of w). Reliefs of the target are then best-fitted into the class.
    ///
    /// # Errors
    /// Evaluation errors of the modifications over their field.
    pub fn with_given_dresser(
        modification: Modification,
        given: Modification,
    ) -> Result<Self, GeneratingError> {
        given.check_field()?;
        Self::split(modification, Carrier::Dresser, Some(given))
    }

    fn split(
        modification: Modification,
        carrier: Carrier,
        given: Option<Modification>,
    ) -> Result<Self, GeneratingError> {
        modification.check_field()?;
        let in_class = |i: usize, j: usize| match carrier {
            Carrier::Dresser => i + j <= 3 || j == 0,
            Carrier::DresserOnCone => i + j <= 3,
            Carrier::Lines => true,
        };
        let mut of_class = Polynomial2::constant(0.0);
        let mut reliefs = Vec::new();
        let mut rest = Vec::new();
        for term in modification.terms() {
            let profile_only = || carrier == Carrier::Dresser && term.depends_on_profile_only();
            match term.polynomial() {
                Some(p) if p.terms().all(|(i, j, _)| in_class(i, j)) => of_class = of_class.add(&p),
                _ if given.is_none() && profile_only() => reliefs.push(term),
                _ => rest.push(term),
            }
        }
        let mut polynomial = of_class.clone();
        let mut outside = 0.0;
        if !rest.is_empty() || given.is_some() {
            let field = modification.field();
            let (w_m, z_m) = (field.roll_middle(), field.face_middle());
            let [nw, nz] = DEFAULT_GRID;
            let mut points = Vec::with_capacity(nw * nz);
            let mut values = Vec::with_capacity(nw * nz);
            let faces = equidistant(field.face(), nz);
            for w in equidistant(field.roll(), nw) {
                for &z in &faces {
                    let mut f = 0.0;
                    for term in &rest {
                        f += term.value(w, z)?;
                    }
                    if let Some(given) = &given {
                        f -= given.value(w, z)?;
                    }
                    points.push((w - w_m, z - z_m));
                    values.push(f);
                }
            }
            let fitted = ClassFit::new(&points).fit(&values);
            outside = points
                .iter()
                .zip(&values)
                .map(|(p, f)| (fitted.value(p.0, p.1) - f).abs())
                .fold(0.0, f64::max);
            polynomial = polynomial.add(&fitted);
            if given.is_some() {
                // What a given dresser leaves has to be taken back by the class, whatever the lines carry.
                of_class = polynomial.clone();
                rest.clear();
            }
        }
        let rest_samples = if rest.is_empty() { None } else { Some(samples_of(&modification, &rest)?) };
        reliefs.extend(given);
        Ok(Self { modification, polynomial, of_class, reliefs, rest, rest_samples, outside })
    }

    /// Weighs what has to be best-fitted by a tolerance over (w, z), mm.
    ///
    /// # Errors
    /// `ToleranceNotPositive`.
    pub fn weighed_by(mut self, tolerance: impl Fn(f64, f64) -> f64) -> Result<Self, GeneratingError> {
        self.rest_samples = self.rest_samples.map(|samples| samples.with_tolerance(tolerance)).transpose()?;
        Ok(self)
    }

    /// The best fit of `rest` into the class.
    pub fn fit_of_rest(&self) -> Polynomial2 {
        self.polynomial.add(&self.of_class.scale(-1.0))
    }

    /// The target value, transverse, mm.
    ///
    /// # Errors
    /// Evaluation errors of the modification.
    pub fn value(&self, w: f64, z: f64) -> Result<f64, GeneratingError> {
        Ok(self.modification.value(w, z)?)
    }
}

/// Sum of reliefs at roll w with two derivatives by w; `None` where one of them does not exist.
pub fn relief_jet(reliefs: &[Modification], w: f64, z: f64) -> Option<[f64; 3]> {
    let mut sum = Jet2::default();
    for relief in reliefs {
        sum += relief.jet(w, z).ok()?;
    }
    Some([sum.f, sum.fu, sum.fuu])
}

/// The sum of some parts of a target on the grid of general decompositions.
fn samples_of(whole: &Modification, parts: &[Modification]) -> Result<Samples, GeneratingError> {
    let field = whole.field();
    let [nw, nz] = DEFAULT_GRID;
    let mut points = Vec::with_capacity(nw * nz);
    for w in equidistant(field.roll(), nw) {
        for z in equidistant(field.face(), nz) {
            let mut f = 0.0;
            for part in parts {
                f += part.value(w, z)?;
            }
            points.push([w, z, f]);
        }
    }
    Samples::of_points(&points)
}
