//! The columns of the fit: the B-splines of every function of the class, and one row of them.

use super::super::GeneratingError;
use super::{Arguments, FitSettings, FlankCoordinates, RollScale, Samples, WormFunctions};
use crate::numerics::{BSpline, BSplineBasis};

/// What a function of the class is multiplied with and what it depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Term {
    Constant,
    Linear,
    Quadratic,
    Profile,
    Kinematic,
}

/// Kinks as values of the arguments.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ArgumentKinks {
    /// In X.
    pub x: Vec<f64>,
    /// In the argument of the profile.
    pub profile: Vec<f64>,
    /// In X_K.
    pub path: Vec<f64>,
}

impl ArgumentKinks {
    pub(super) fn new<G: FlankCoordinates>(settings: &FitSettings, coordinates: &G) -> Self {
        let of = |points: &[[f64; 2]], pick: fn(Arguments) -> f64| {
            points.iter().map(|&[w, z]| pick(coordinates.arguments(w, z))).collect()
        };
        Self {
            x: of(&settings.kinks.lines, |a| a.x),
            profile: of(&settings.kinks.profile, |a| a.profile),
            path: of(&settings.kinks.path, |a| a.path),
        }
    }
}

/// All columns.
#[derive(Clone, Debug)]
pub(super) struct Columns {
    parts: Vec<(Term, BSplineBasis)>,
    scale: RollScale,
    degree: usize,
    count: usize,
}

impl Columns {
    /// # Errors
    /// `TooFewPoints`, `NoExtent`, `InvalidSpline`.
    pub fn new(
        samples: &Samples,
        arguments: &[Arguments],
        settings: &FitSettings,
        kinks: &ArgumentKinks,
    ) -> Result<Self, GeneratingError> {
        let class = settings.class;
        let [w_low, w_high] = range(samples.points().iter().map(|p| p[0]));
        let scale = RollScale::new([w_low, w_high]);
        let uses = [
            (class.constant, Term::Constant),
            (class.linear, Term::Linear),
            (class.quadratic, Term::Quadratic),
            (class.profile, Term::Profile),
            (class.kinematic, Term::Kinematic),
        ];
        // Asked before anything is allocated: absurd numbers of intervals end here.
        let needed = settings.coefficients().saturating_sub(class.ambiguity(settings.degree));
        if samples.count() < needed.max(1) {
            return Err(GeneratingError::TooFewPoints { points: samples.count(), needed: needed.max(1) });
        }
        let basis = |name: &'static str, pick: fn(&Arguments) -> f64, kinks: &[f64]| {
            let [low, high] = range(arguments.iter().map(pick));
            // A range that only rounding made has no extent.
            if high - low <= 1e-12 * low.abs().max(high.abs()) {
                return Err(GeneratingError::NoExtent { coordinate: name, value: low });
            }
            BSplineBasis::uniform([low, high], settings.intervals, settings.degree, kinks)
                .map_err(GeneratingError::InvalidSpline)
        };
        let mut parts = Vec::new();
        for (_, term) in uses.into_iter().filter(|(used, _)| *used) {
            let space = match term {
                Term::Constant | Term::Linear | Term::Quadratic => basis("X", |a| a.x, &kinks.x),
                Term::Profile => basis("w", |a| a.profile, &kinks.profile),
                Term::Kinematic => basis("X_K", |a| a.path, &kinks.path),
            };
            parts.push((term, space?));
        }
        let count = parts.iter().map(|(_, basis)| basis.count()).sum::<usize>();
        let needed = count.saturating_sub(class.ambiguity(settings.degree));
        if samples.count() < needed {
            return Err(GeneratingError::TooFewPoints { points: samples.count(), needed });
        }
        Ok(Self { parts, scale, degree: settings.degree, count })
    }

    /// Number of columns.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Entries of the row of a point, times `weight`, into `row`. `values` is scratch of degree + 1 places.
    #[inline]
    pub fn row(
        &self,
        w: f64,
        arguments: &Arguments,
        weight: f64,
        values: &mut Vec<f64>,
        row: &mut Vec<(usize, f64)>,
    ) {
        values.resize(self.degree + 1, 0.0);
        row.clear();
        let u = self.scale.u(w);
        let mut offset = 0;
        for (term, basis) in &self.parts {
            let (argument, factor) = match term {
                Term::Constant => (arguments.x, weight),
                Term::Linear => (arguments.x, weight * u),
                Term::Quadratic => (arguments.x, weight * u * u),
                Term::Profile => (arguments.profile, weight),
                Term::Kinematic => (arguments.path, weight),
            };
            let first = offset + basis.values(argument, values);
            row.extend(values.iter().enumerate().map(|(k, b)| (first + k, b * factor)));
            offset += basis.count();
        }
    }

    /// The functions with coefficients `x`.
    ///
    /// # Errors
    /// `InvalidSpline` for coefficients whose pieces overflow.
    pub fn functions(&self, x: &[f64]) -> Result<WormFunctions, GeneratingError> {
        let mut functions = WormFunctions::none(self.scale);
        let mut offset = 0;
        for (term, basis) in &self.parts {
            let coefficients = x[offset..offset + basis.count()].to_vec();
            offset += basis.count();
            let spline = BSpline::new(basis.clone(), coefficients).map_err(GeneratingError::InvalidSpline)?;
            let place = match term {
                Term::Constant => &mut functions.constant,
                Term::Linear => &mut functions.linear,
                Term::Quadratic => &mut functions.quadratic,
                Term::Profile => &mut functions.profile,
                Term::Kinematic => &mut functions.kinematic,
            };
            *place = Some(spline);
        }
        Ok(functions)
    }
}

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
}
