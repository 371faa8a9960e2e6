//! The splines of one flank at one diagonal ratio: F_C(X), F_L(X) u, F_P(w), F_K(X_K), and the row that a place has in them.

use super::super::GeneratingError;
use super::super::least_squares::{Arguments, FunctionClass, RollScale, WormFunctions};
use foundation::numerics::{BSpline, BSplineBasis};

/// Cubic splines.
const DEGREE: usize = 3;

/// A place at which the functions are asked: their arguments and the length of roll that F_L is multiplied by, mm.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Length of roll.
    pub w: f64,
    /// X, w, X_K.
    pub at: Arguments,
}

/// One function: its B-splines and where its coefficients stand.
#[derive(Clone, Debug)]
pub struct Block {
    /// The B-splines.
    pub basis: BSplineBasis,
    /// Column of the first coefficient.
    pub first: usize,
    /// What it is.
    pub kind: Kind,
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
        let share_of_roll = 0.08 * (ranges.w[1] - ranges.w[0]);
        for (used, kind, [low, high], beyond) in [
            (class.constant, Kind::Constant, ranges.x, ranges.beyond),
            (class.linear, Kind::Linear, ranges.x, ranges.beyond),
            (class.profile, Kind::Profile, ranges.w, share_of_roll),
            (class.kinematic, Kind::Kinematic, ranges.path, ranges.beyond),
        ] {
            if !used {
                continue;
            }
            let count = intervals as f64 * (1.0 + 2.0 * beyond / (high - low).max(f64::MIN_POSITIVE));
            let count = count.min(4.0 * intervals as f64).round() as usize;
            let basis = BSplineBasis::uniform([low - beyond, high + beyond], count, DEGREE, &[])
                .map_err(GeneratingError::InvalidSpline)?;
            let count = basis.count();
            blocks.push(Block { basis, first, kind });
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

    /// The entries (column, factor) of a place, ascending.
    pub fn row(&self, place: &Place, row: &mut Vec<(usize, f64)>) {
        row.clear();
        let mut values = [0.0; DEGREE + 1];
        for block in &self.blocks {
            let (argument, factor) = match block.kind {
                Kind::Constant => (place.at.x, 1.0),
                Kind::Linear => (place.at.x, self.scale.u(place.w)),
                Kind::Profile => (place.at.profile, 1.0),
                Kind::Kinematic => (place.at.path, 1.0),
            };
            // Beyond its range a function is what it is at the end: cubics would run away.
            let [low, high] = block.basis.interval();
            let first = block.first + block.basis.values(argument.clamp(low, high), &mut values);
            row.extend(values.iter().enumerate().map(|(k, b)| (first + k, b * factor)));
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
