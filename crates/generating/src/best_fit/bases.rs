//! The splines of one flank at one diagonal ratio: F_C(X), F_L(X) u, F_P(w), F_K(X_K), and the row that a place has in them.

use super::super::GeneratingError;
use super::super::least_squares::{Arguments, FunctionClass, RollScale, WormFunctions};
use foundation::numerics::{BSpline, BSplineBasis};

/// Cubic splines.
const DEGREE: usize = 3;
/// The profile reaches beyond both ends of the flank by this share of its length, as far as the contact runs ahead there, but to no smaller a
/// share of the length of roll at the root.
const BEYOND_PROFILE: f64 = 0.25;
const LEAST_ROLL: f64 = 0.3;

/// A place at which the functions are asked: their arguments and the length of roll that F_L is multiplied by, mm.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Length of roll.
    pub w: f64,
    /// X, w, X_K.
    pub at: Arguments,
}

impl Place {
    /// The place at a share of the way to another.
    pub fn towards(&self, other: &Self, share: f64) -> Self {
        let between = |a: f64, b: f64| a + share * (b - a);
        Self {
            w: between(self.w, other.w),
            at: Arguments {
                x: between(self.at.x, other.at.x),
                profile: between(self.at.profile, other.at.profile),
                path: between(self.at.path, other.at.path),
            },
        }
    }
}

/// One function: its B-splines and where its coefficients stand.
#[derive(Clone, Debug)]
pub struct Block {
    /// The B-splines.
    pub basis: BSplineBasis,
    /// Range of its argument over the flank.
    flank: [f64; 2],
    /// Column of the first coefficient.
    pub first: usize,
    /// What it is.
    pub kind: Kind,
}

impl Block {
    /// Its argument at a place.
    pub fn argument(&self, place: &Place) -> f64 {
        match self.kind {
            Kind::Constant | Kind::Linear => place.at.x,
            Kind::Profile => place.at.profile,
            Kind::Kinematic => place.at.path,
        }
    }

    /// Column of the first B-spline that counts at `x`, and `[B, B', B'']` of those from there: the polynomials go on beyond the ends as the
    /// functions made of them do, those of the profile straight.
    pub fn jets(&self, x: f64) -> (usize, [[f64; 3]; DEGREE + 1]) {
        let mut jets = [[0.0; 3]; DEGREE + 1];
        let [low, high] = self.basis.interval();
        if self.kind != Kind::Profile || (low..=high).contains(&x) {
            let first = self.basis.jets(x, &mut jets);
            return (self.first + first, jets);
        }
        let end = x.clamp(low, high);
        let first = self.basis.jets(end, &mut jets);
        (self.first + first, jets.map(|[f, f1, _]| [f + f1 * (x - end), f1, 0.0]))
    }

    /// Distance of its knots.
    fn step(&self) -> f64 {
        let [low, high] = self.basis.interval();
        (high - low) / (self.basis.count() - DEGREE) as f64
    }

    /// Adds the squares of second differences beyond the flank, where hardly any place tells what the function is: it goes on straight.
    pub fn straight_beyond(&self, weight: f64, form: &mut Vec<(usize, usize, f64)>) {
        let count = self.basis.count().saturating_sub(2);
        let [low, _] = self.basis.interval();
        // About the middle of a B-spline: coefficients stand evenly but for the last two at each end.
        let step = self.step();
        let middle = |j: usize| low + (j as f64 - 0.5 * (DEGREE - 1) as f64) * step;
        for j in (0..count).filter(|&j| !(self.flank[0]..=self.flank[1]).contains(&middle(j + 1))) {
            square(&[1.0, -2.0, 1.0], weight / count as f64, self.first + j, form);
        }
    }

    /// Adds the squares of differences of neighbouring coefficients, each over the number of them, times a weight, to a quadratic form as
    /// (row, column, value), row <= column.
    pub fn differences(&self, stencil: &[f64], weight: f64, form: &mut Vec<(usize, usize, f64)>) {
        let count = self.basis.count().saturating_sub(stencil.len() - 1);
        for j in 0..count {
            square(stencil, weight / count as f64, self.first + j, form);
        }
    }
}

/// Adds the square of a sum of neighbouring coefficients, the first of them at `first`, times a weight.
fn square(stencil: &[f64], weight: f64, first: usize, form: &mut Vec<(usize, usize, f64)>) {
    for (b, &by_b) in stencil.iter().enumerate() {
        for (a, &by_a) in stencil[..=b].iter().enumerate() {
            form.push((first + a, first + b, weight * by_a * by_b));
        }
    }
}

/// The functions of the class.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// F_C(X).
    Constant,
    /// F_L(X), factor u.
    Linear,
    /// F_P(w).
    Profile,
    /// F_K(X_K).
    Kinematic,
}

/// The functions of one flank.
#[derive(Clone, Debug)]
pub struct Bases {
    /// Those of the class.
    pub blocks: Vec<Block>,
    scale: RollScale,
    columns: usize,
}

/// Ranges of the arguments over the flank and what the functions reach beyond them, mm.
#[derive(Clone, Copy, Debug)]
pub struct Ranges {
    /// X.
    pub x: [f64; 2],
    /// w.
    pub w: [f64; 2],
    /// X_K.
    pub path: [f64; 2],
    /// Beyond the ends of X and X_K.
    pub beyond: f64,
}

impl Bases {
    /// For a class, with about `intervals` intervals over each range.
    ///
    /// # Errors
    /// `InvalidSpline` for ranges without extent.
    pub fn new(class: FunctionClass, ranges: &Ranges, intervals: usize) -> Result<Self, GeneratingError> {
        let mut blocks = Vec::new();
        let mut first = 0;
        let further = |[low, high]: [f64; 2]| [low - ranges.beyond, high + ranges.beyond];
        let [root, tip] = ranges.w;
        let beyond = BEYOND_PROFILE * (tip - root);
        let profile = [(root - beyond).max(LEAST_ROLL * root), tip + beyond];
        for (used, kind, [low, high], [from, to]) in [
            (class.constant, Kind::Constant, ranges.x, further(ranges.x)),
            (class.linear, Kind::Linear, ranges.x, further(ranges.x)),
            (class.profile, Kind::Profile, ranges.w, profile),
            (class.kinematic, Kind::Kinematic, ranges.path, further(ranges.path)),
        ] {
            if !used {
                continue;
            }
            let count = intervals as f64 * (to - from) / (high - low).max(f64::MIN_POSITIVE);
            let count = count.min(4.0 * intervals as f64).round() as usize;
            let basis = BSplineBasis::uniform([from, to], count, DEGREE, &[])
                .map_err(GeneratingError::InvalidSpline)?;
            let count = basis.count();
            blocks.push(Block { basis, flank: [low, high], first, kind });
            first += count;
        }
        let [low, high] = ranges.w;
        let scale = RollScale { middle: 0.5 * (low + high), half: 0.5 * (high - low) };
        Ok(Self { blocks, scale, columns: first })
    }

    /// Number of coefficients.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// How far two places are apart, in knots of the function for which that is most.
    pub fn apart(&self, a: &Place, b: &Place) -> f64 {
        let of = |block: &Block| (block.argument(a) - block.argument(b)).abs() / block.step();
        self.blocks.iter().map(of).fold(0.0, f64::max)
    }

    /// The factor u of F_L at a length of roll, and its derivative.
    pub fn factor(&self, w: f64) -> (f64, f64) {
        (self.scale.u(w), 1.0 / self.scale.half)
    }

    /// The entries (column, factor) of a place, ascending.
    pub fn row(&self, place: &Place, row: &mut Vec<(usize, f64)>) {
        row.clear();
        for block in &self.blocks {
            let factor = if block.kind == Kind::Linear { self.scale.u(place.w) } else { 1.0 };
            let (first, jets) = block.jets(block.argument(place));
            row.extend(jets.iter().enumerate().map(|(k, [b, ..])| (first + k, b * factor)));
        }
    }

    /// The functions with these coefficients, mm.
    ///
    /// # Errors
    /// `InvalidSpline` for coefficients that are no numbers.
    pub fn functions(&self, x: &[f64]) -> Result<WormFunctions, GeneratingError> {
        let mut functions = WormFunctions {
            constant: None,
            linear: None,
            quadratic: None,
            profile: None,
            kinematic: None,
            scale: self.scale,
        };
        for block in &self.blocks {
            let own = x[block.first..block.first + block.basis.count()].to_vec();
            let spline = BSpline::new(block.basis.clone(), own).map_err(GeneratingError::InvalidSpline)?;
            let place = match block.kind {
                Kind::Constant => &mut functions.constant,
                Kind::Linear => &mut functions.linear,
                Kind::Profile => &mut functions.profile,
                Kind::Kinematic => &mut functions.kinematic,
            };
            *place = Some(spline);
        }
        Ok(functions)
    }
}
