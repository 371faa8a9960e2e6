//! What the lines of a tool carry beside the closed decomposition: parts of the target that stand on the lines as they are, and
//! corrections of the command. Functions of the workpiece point; knows no tool.

use super::FlankLines;
use super::least_squares::{DiagonalCoordinates, SplineDecomposition};
use foundation::kinematics::PiecewisePolynomial;
use foundation::modification::Modification;
use foundation::numerics::{Jet2, Polynomial2, SplineError, TensorSpline, fit_tensor_spline};
use std::sync::Arc;

/// A function on the evaluation field in (w, z), continued beyond it along its tangent plane: corrections are known on the
/// field only, while a tool is asked a little beyond.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldSpline {
    spline: TensorSpline,
}

impl FieldSpline {
    /// The smoothest spline of `cells` cells near the values at (w, z, f), mm.
    ///
    /// # Errors
    /// [`SplineError`] for too few points.
    pub fn near(points: &[[f64; 3]], cells: [usize; 2]) -> Result<Self, SplineError> {
        fit_tensor_spline(points, cells).map(|spline| Self { spline })
    }

    /// Value and derivatives at (w, z).
    pub fn jet(&self, w: f64, z: f64) -> Jet2 {
        let [[w0, w1], [z0, z1]] = self.spline.domain();
        let (inner_w, inner_z) = (w.clamp(w0, w1), z.clamp(z0, z1));
        let at = self.spline.jet(inner_w, inner_z);
        if inner_w == w && inner_z == z {
            return at;
        }
        let (dw, dz) = (w - inner_w, z - inner_z);
        Jet2 { f: at.f + at.fu * dw + at.fv * dz, fu: at.fu, fv: at.fv, ..Jet2::default() }
    }
}

/// Parts of a target fitted into worm functions and a grinding motion by least squares (`docs/mathematics/planning.md#producibility`).
pub type RestFit = SplineDecomposition<DiagonalCoordinates>;

/// Parts of the command, transverse, mm, that the tool's lines carry as they stand.
#[derive(Clone, Debug, Default)]
pub struct Carried {
    /// Polynomial in u = w - w_m, y = z - z_m.
    pub polynomial: Option<Polynomial2>,
    /// Parts of the target.
    pub terms: Vec<Modification>,
    /// What least squares found for parts that do not stand on the lines as they are: its worm functions.
    pub fitted: Option<Arc<RestFit>>,
    /// Corrections of the command, one for each round that found more.
    pub corrections: Vec<Arc<FieldSpline>>,
}

impl Carried {
    /// Whether there is nothing to carry.
    pub fn is_empty(&self) -> bool {
        self.polynomial.is_none()
            && self.terms.is_empty()
            && self.fitted.is_none()
            && self.corrections.is_empty()
    }

    /// The sum at (w, z) with derivatives; `None` where a part has no value.
    pub fn jet(&self, lines: &FlankLines, w: f64, z: f64) -> Option<Jet2> {
        let mut sum = Jet2::default();
        if let Some(polynomial) = &self.polynomial {
            sum += polynomial.jet(w - lines.w_m, z - lines.z_m);
        }
        for term in &self.terms {
            sum += term.jet(w, z).ok()?;
        }
        if let Some(fitted) = &self.fitted {
            sum += fitted.dressing_jet(w, z);
        }
        for correction in &self.corrections {
            sum += correction.jet(w, z);
        }
        Some(sum)
    }
}

/// The functions of one flank that are fitted to the whole target: what lines and motion carry, and the profile of the dresser over w_2,
/// transverse, mm.
#[derive(Clone, Debug)]
pub struct FittedFlank {
    /// What lines and motion carry.
    pub fit: Arc<RestFit>,
    /// The profile, of a dresser that is made for the job.
    pub profile: Option<PiecewisePolynomial>,
}

/// Points over profile and face width at which a part of the target is held against its lines.
const SAMPLES: [usize; 2] = [9, 25];

/// How far a part of the target is from being carried by lines of direction tan(rho_2) = t with three values each (both ends
/// and the middle of the profile; what lies between is a parabola): largest misfit over the field, transverse, mm.
/// Infinite where the part has no value on one of those lines.
pub fn misfit_of_lines(term: &Modification, lines: &FlankLines, t: f64) -> f64 {
    let ([w0, w1], [z0, z1]) = (lines.roll, lines.face);
    let share = |k: usize, n: usize| k as f64 / (n - 1) as f64;
    let mut largest: f64 = 0.0;
    for i in 0..SAMPLES[0] {
        let x = share(i, SAMPLES[0]);
        let w = w0 + x * (w1 - w0);
        let weights = [(1.0 - x) * (1.0 - 2.0 * x), 4.0 * x * (1.0 - x), x * (2.0 * x - 1.0)];
        for j in 0..SAMPLES[1] {
            let z = z0 + share(j, SAMPLES[1]) * (z1 - z0);
            let mut misfit = match term.value(w, z) {
                Ok(f) => f,
                Err(_) => return f64::INFINITY,
            };
            for (weight, at) in weights.into_iter().zip([w0, 0.5 * (w0 + w1), w1]) {
                match term.value(at, z + t * (w - at)) {
                    Ok(f) => misfit -= weight * f,
                    Err(_) => return f64::INFINITY,
                }
            }
            largest = largest.max(misfit.abs());
        }
    }
    largest
}
