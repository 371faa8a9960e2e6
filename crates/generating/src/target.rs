//! The target of one flank, split into what the class can carry as it stands and what it cannot (`docs/mathematics/planning.md`).

use super::class_fit::ClassFit;
use super::least_squares::{DEFAULT_GRID, Samples};
use super::{GeneratingError, MovedProfile};
use foundation::modification::Modification;
use foundation::numerics::{Jet2, Polynomial2, equidistant};
use std::sync::Arc;

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
    /// Where the reliefs of a dresser that exists are laid, if not where it was designed for.
    pub moved: Option<Arc<MovedProfile>>,
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

/// The length of roll for which a dresser was designed where it makes (w, z) of the gear, mm.
pub type PlaceOfDresser<'a> = &'a dyn Fn(f64, f64) -> f64;

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
        Self::split(modification, Carrier::Dresser, Some((given, &|w, _| w)))
    }

    /// The same for a dresser whose profile the conditions of dressing lay elsewhere: `place` is the length of roll for which the dresser
    /// was designed where it makes (w, z) of the gear.
    ///
    /// # Errors
    /// Evaluation errors of the modifications, of the dresser's also beyond its field.
    pub fn with_moved_dresser(
        modification: Modification,
        given: Modification,
        moved: Arc<MovedProfile>,
        place: PlaceOfDresser<'_>,
    ) -> Result<Self, GeneratingError> {
        let target = Self::split(modification, Carrier::Dresser, Some((given, place)))?;
        Ok(Self { moved: Some(moved), ..target })
    }

    fn split(
        modification: Modification,
        carrier: Carrier,
        given: Option<(Modification, PlaceOfDresser<'_>)>,
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
                    if let Some((given, place)) = &given {
                        f -= given.value(place(w, z), z)?;
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
        reliefs.extend(given.map(|(given, _)| given));
        Ok(Self { modification, polynomial, of_class, reliefs, moved: None, rest, rest_samples, outside })
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
