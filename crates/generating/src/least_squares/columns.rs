//! The columns of the fit: the B-splines of every function of the class, and one row of them.

use super::super::GeneratingError;
use super::{Arguments, FitSettings, FlankCoordinates, RollScale, Samples, WormFunctions};
use foundation::numerics::{BSpline, BSplineBasis, extremes};

/// What functions depend on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Argument {
    Lines,
    Profile,
    Path,
}

impl Argument {
    #[inline]
    fn of(self, arguments: &Arguments) -> f64 {
        match self {
            Self::Lines => arguments.x,
            Self::Profile => arguments.profile,
            Self::Path => arguments.path,
        }
    }
}

/// Functions of one argument: the same B-splines times powers of u. The columns of one B-spline are neighbours.
#[derive(Clone, Debug)]
struct Group {
    argument: Argument,
    basis: BSplineBasis,
    powers: Vec<i32>,
}

impl Group {
    fn count(&self) -> usize {
        self.basis.count() * self.powers.len()
    }
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
    /// Of the kinks of the settings.
    pub fn new<G: FlankCoordinates>(settings: &FitSettings, coordinates: &G) -> Self {
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

/// All columns, those of the first group first.
#[derive(Clone, Debug)]
pub(super) struct Columns {
    groups: Vec<Group>,
    scale: RollScale,
    degree: usize,
    count: usize,
}

/// Places for the values of one row.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    values: Vec<f64>,
    factors: Vec<f64>,
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
        let [w_low, w_high] = extremes(samples.points().iter().map(|p| p[0]));
        let scale = RollScale::new([w_low, w_high]);
        let powers = |uses: &[(bool, i32)]| uses.iter().filter(|(used, _)| *used).map(|(_, p)| *p).collect();
        let lines: Vec<i32> = powers(&[(class.constant, 0), (class.linear, 1), (class.quadratic, 2)]);
        // Asked before anything is allocated: absurd numbers of intervals end here.
        let needed = settings.coefficients().saturating_sub(class.ambiguity(settings.degree));
        if samples.count() < needed.max(1) {
            return Err(GeneratingError::TooFewPoints { points: samples.count(), needed: needed.max(1) });
        }
        let mut groups = Vec::new();
        for (argument, powers, name, kinks) in [
            (Argument::Lines, lines, "X", &kinks.x),
            (Argument::Profile, powers(&[(class.profile, 0)]), "w", &kinks.profile),
            (Argument::Path, powers(&[(class.kinematic, 0)]), "X_K", &kinks.path),
        ] {
            if powers.is_empty() {
                continue;
            }
            let [low, high] = extremes(arguments.iter().map(|a| argument.of(a)));
            // A range that only rounding made has no extent.
            if high - low <= 1e-12 * low.abs().max(high.abs()) {
                return Err(GeneratingError::NoExtent { coordinate: name, value: low });
            }
            let basis = BSplineBasis::uniform([low, high], settings.intervals, settings.degree, kinks)
                .map_err(GeneratingError::InvalidSpline)?;
            groups.push(Group { argument, basis, powers });
        }
        let count = groups.iter().map(Group::count).sum::<usize>();
        let needed = count.saturating_sub(class.ambiguity(settings.degree));
        if samples.count() < needed {
            return Err(GeneratingError::TooFewPoints { points: samples.count(), needed });
        }
        Ok(Self { groups, scale, degree: settings.degree, count })
    }

    /// Number of columns.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Columns of the first group, those of them that a row touches, and all others.
    pub fn band(&self) -> [usize; 3] {
        self.groups.first().map_or([0; 3], |group| {
            let band = group.count();
            [band, (self.degree + 1) * group.powers.len(), self.count - band]
        })
    }

    /// The samples in the order of the first column that their rows touch.
    pub fn sorted(&self, arguments: &[Arguments]) -> Vec<usize> {
        let Some(group) = self.groups.first() else { return (0..arguments.len()).collect() };
        let place = |a: &Arguments| group.basis.first(group.argument.of(a));
        let firsts: Vec<usize> = arguments.iter().map(place).collect();
        let mut next = vec![0; group.basis.count() + 1];
        firsts.iter().for_each(|&first| next[first + 1] += 1);
        for first in 1..next.len() {
            next[first] += next[first - 1];
        }
        let mut order = vec![0; firsts.len()];
        for (i, &first) in firsts.iter().enumerate() {
            order[next[first]] = i;
            next[first] += 1;
        }
        order
    }

    /// Entries of the row of a point, times `weight`, into `row`, with ascending columns.
    #[inline]
    pub fn row(
        &self,
        w: f64,
        arguments: &Arguments,
        weight: f64,
        scratch: &mut Scratch,
        row: &mut Vec<(usize, f64)>,
    ) {
        let Scratch { values, factors } = scratch;
        values.resize(self.degree + 1, 0.0);
        row.clear();
        let u = self.scale.u(w);
        let mut offset = 0;
        for group in &self.groups {
            factors.clear();
            factors.extend(group.powers.iter().map(|&p| weight * u.powi(p)));
            let first = group.basis.values(group.argument.of(arguments), values);
            let mut column = offset + group.powers.len() * first;
            for b in values.iter() {
                for factor in factors.iter() {
                    row.push((column, b * factor));
                    column += 1;
                }
            }
            offset += group.count();
        }
    }

    /// The functions with coefficients `x`.
    ///
    /// # Errors
    /// `InvalidSpline` for coefficients whose pieces overflow.
    pub fn functions(&self, x: &[f64]) -> Result<WormFunctions, GeneratingError> {
        let mut functions = WormFunctions::none(self.scale);
        let mut offset = 0;
        for group in &self.groups {
            let own = &x[offset..offset + group.count()];
            offset += group.count();
            for (k, power) in group.powers.iter().enumerate() {
                let coefficients = own.iter().skip(k).step_by(group.powers.len()).copied().collect();
                let spline = BSpline::new(group.basis.clone(), coefficients)
                    .map_err(GeneratingError::InvalidSpline)?;
                let place = match (group.argument, power) {
                    (Argument::Lines, 0) => &mut functions.constant,
                    (Argument::Lines, 1) => &mut functions.linear,
                    (Argument::Lines, _) => &mut functions.quadratic,
                    (Argument::Profile, _) => &mut functions.profile,
                    (Argument::Path, _) => &mut functions.kinematic,
                };
                *place = Some(spline);
            }
        }
        Ok(functions)
    }
}
