//! Conditions along the worm: the four rows over the worm position and over where the dresser touches, as functions or as data whose
//! numbers change over the width (`docs/mathematics/dressing.md#conditions`). Knows no solver.

use crate::{Condition, DresserTool};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::extremes;
use std::f64::consts::FRAC_1_SQRT_2;
use std::ops::Add;

/// Four conditions at every worm position.
pub trait ConditionsAlong {
    /// The conditions at worm position v (mm). `b` holds for each row that is a pitch point the worm z (mm) of the place that it
    /// stands on, as far as it is known; for the other rows it says nothing.
    fn at(&self, v: f64, b: &[f64; 4]) -> [Condition; 4];
}

impl<F: Fn(f64, &[f64; 4]) -> [Condition; 4]> ConditionsAlong for F {
    fn at(&self, v: f64, b: &[f64; 4]) -> [Condition; 4] {
        self(v, b)
    }
}

/// Coefficients that a law over the width may have.
pub const MOST_COEFFICIENTS: usize = 6;

/// A number that changes over the width of the worm in use: c_0 + c_1 q + c_2 q^2 + .., q from -1 at its lower end to 1 at its upper one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WidthLaw([f64; MOST_COEFFICIENTS]);

impl WidthLaw {
    /// The same everywhere.
    pub const fn constant(value: f64) -> Self {
        let mut coefficients = [0.0; MOST_COEFFICIENTS];
        coefficients[0] = value;
        Self(coefficients)
    }

    /// From its coefficients; those that are not given are 0. `None` for more than [`MOST_COEFFICIENTS`] of them.
    pub fn new(given: &[f64]) -> Option<Self> {
        let mut coefficients = [0.0; MOST_COEFFICIENTS];
        coefficients.get_mut(..given.len())?.copy_from_slice(given);
        Some(Self(coefficients))
    }

    /// The value at q.
    pub fn value(&self, q: f64) -> f64 {
        self.0.iter().rev().fold(0.0, |sum, c| sum * q + c)
    }

    /// Its coefficients up to the last that is not 0, at least the first.
    pub fn coefficients(&self) -> &[f64] {
        let count = self.0.iter().rposition(|c| *c != 0.0).map_or(1, |last| last + 1);
        &self.0[..count]
    }

    /// Whether it is the same everywhere.
    pub fn is_constant(&self) -> bool {
        self.0[1..].iter().all(|c| *c == 0.0)
    }

    /// The law times a number.
    pub fn times(self, factor: f64) -> Self {
        Self(self.0.map(|c| c * factor))
    }

    /// Least and largest value between q = -reach and reach.
    pub fn extremes(&self, reach: f64) -> [f64; 2] {
        extremes((0..=PLACES).map(|k| self.value(reach * (2.0 * k as f64 / PLACES as f64 - 1.0))))
    }
}

/// Intervals at whose ends the extremes of a law are looked for.
const PLACES: usize = 100;

impl Add for WidthLaw {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

/// One row along the worm. Shares count over the used profile, 0 at w_NfS and 1 at w_NaS.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RowAlong {
    /// Pitch point: what is wanted at this share of the worm's profile is met exactly.
    Point {
        /// Flank; `None`: the one that is dressed.
        flank: Option<Flank>,
        /// Share of the worm's profile.
        at: WidthLaw,
    },
    /// Radius map: this share of the dresser's profile dresses that share of the worm's.
    Map {
        /// Flank; `None`: the one that is dressed.
        flank: Option<Flank>,
        /// Share of the profile that the dresser was designed for.
        dresser: WidthLaw,
        /// Share of the worm's profile.
        at: WidthLaw,
    },
    /// Relative stretch of the profile P (`docs/mathematics/dressing.md#conditions`), positive = longer.
    Stretch {
        /// Flank; `None`: the one that is dressed.
        flank: Option<Flank>,
        /// P, a share.
        stretch: WidthLaw,
    },
    /// Head height: where the head profile touches at this distance along the worm, the tip is higher than wanted by so much.
    Head {
        /// Parameter of the head profile: distance from where the dresser stands, mm.
        position: f64,
        /// What the tip is to stand above its wanted radius, mm.
        above: WidthLaw,
    },
    /// A correction that is given.
    Fixed {
        /// Component of DK.
        j: usize,
        /// Its value, rad or mm.
        x: WidthLaw,
    },
}

impl RowAlong {
    /// The usual rows of one flank: both ends and the middle of the profile, and the dresser's circle made for the upper end stays there.
    pub const fn three_points_with_map() -> [Self; 4] {
        [Self::point(0.0), Self::point(0.5), Self::point(1.0), Self::map_of_upper_end()]
    }

    /// A pitch point on the flank that is dressed.
    pub const fn point(share: f64) -> Self {
        Self::Point { flank: None, at: WidthLaw::constant(share) }
    }

    /// What was designed for the upper end of the profile dresses it.
    pub const fn map_of_upper_end() -> Self {
        Self::Map { flank: None, dresser: WidthLaw::constant(1.0), at: WidthLaw::constant(1.0) }
    }

    /// A correction that stays 0.
    pub const fn fixed(j: usize) -> Self {
        Self::Fixed { j, x: WidthLaw::constant(0.0) }
    }

    /// The usual rows of both flanks at once: two pitch points on each, where a parabola that deviates alike at the ends and in the middle
    /// of the profile is zero. What the two rows leave is a parabola nearly, and so it is shared out.
    pub fn two_points_on_each_flank() -> [Self; 4] {
        let reach = 0.5 * FRAC_1_SQRT_2;
        let point = |flank: Flank, at: f64| Self::Point { flank: Some(flank), at: WidthLaw::constant(at) };
        let [low, high] = [0.5 - reach, 0.5 + reach];
        let (left, right) = (Flank::Left, Flank::Right);
        [point(left, low), point(left, high), point(right, low), point(right, high)]
    }

    /// Whether a worm that is wanted as the dresser leaves it without corrections meets the row.
    pub fn is_met_uncorrected(&self) -> bool {
        let none = WidthLaw::constant(0.0);
        match *self {
            Self::Point { .. } => true,
            Self::Map { dresser, at, .. } => dresser == at,
            Self::Stretch { stretch, .. } => stretch == none,
            Self::Head { above, .. } => above == none,
            Self::Fixed { x, .. } => x == none,
        }
    }

    /// Whether its numbers change over the width.
    pub fn varies(&self) -> bool {
        match *self {
            Self::Point { at, .. } => !at.is_constant(),
            Self::Map { dresser, at, .. } => !(dresser.is_constant() && at.is_constant()),
            Self::Stretch { stretch: law, .. }
            | Self::Head { above: law, .. }
            | Self::Fixed { x: law, .. } => !law.is_constant(),
        }
    }

    /// The miss that counts as one with the weight 1, in the unit of the row's residual (mm or rad): 1 um of a point or of the head, 1 % of
    /// the used profile's `length` (mm) of a map or a stretch, 0.01 degrees or 0.01 mm of a correction.
    pub fn unit(&self, length: f64) -> f64 {
        match *self {
            Self::Point { .. } | Self::Head { .. } => 1e-3,
            Self::Map { .. } | Self::Stretch { .. } => 0.01 * length,
            Self::Fixed { j: 0 | 1, .. } => 0.01_f64.to_radians(),
            Self::Fixed { .. } => 0.01,
        }
    }

    /// The flank on which a row stands that names one.
    pub fn names(&self) -> Option<Flank> {
        match *self {
            Self::Point { flank, .. } | Self::Map { flank, .. } | Self::Stretch { flank, .. } => flank,
            Self::Head { .. } | Self::Fixed { .. } => None,
        }
    }
}

/// Most rows of a set.
pub const MOST_ROWS: usize = 12;

/// Rows along the worm: four that are met exactly, or more, of which some are met as nearly as their weights ask.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowSet {
    rows: [RowAlong; MOST_ROWS],
    weights: [Option<f64>; MOST_ROWS],
    count: usize,
}

impl RowSet {
    /// Four rows, each met exactly.
    pub fn exact(rows: [RowAlong; 4]) -> Self {
        let mut all = [RowAlong::fixed(0); MOST_ROWS];
        all[..4].copy_from_slice(&rows);
        Self { rows: all, weights: [None; MOST_ROWS], count: 4 }
    }

    /// Rows, those with a weight met as nearly as it asks ([`RowAlong::unit`]). `None` for more than [`MOST_ROWS`] and for rows without any
    /// weight that are not four.
    pub fn weighed(given: &[(RowAlong, Option<f64>)]) -> Option<Self> {
        let exact = given.iter().all(|(_, weight)| weight.is_none());
        if given.len() > MOST_ROWS || (exact && given.len() != 4) {
            return None;
        }
        let mut set = Self { count: given.len(), ..Self::exact([RowAlong::fixed(0); 4]) };
        for (k, (row, weight)) in given.iter().enumerate() {
            (set.rows[k], set.weights[k]) = (*row, *weight);
        }
        Some(set)
    }

    /// The rows.
    pub fn rows(&self) -> &[RowAlong] {
        &self.rows[..self.count]
    }

    /// The weight of each row; `None`: it is met exactly.
    pub fn weights(&self) -> &[Option<f64>] {
        &self.weights[..self.count]
    }

    /// Whether some rows are met as nearly as their weights ask.
    pub fn is_weighed(&self) -> bool {
        self.weights().iter().any(Option::is_some)
    }
}

/// The place of a pitch point on the worm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PitchPlace {
    /// Flank.
    pub flank: Flank,
    /// Length of roll, mm.
    pub w: f64,
    /// Worm z, mm.
    pub b: f64,
}

/// The wanted f_n (mm) at the pitch points among the rows; what it gives for other rows is not used.
pub type WishAlong<'a> = &'a dyn Fn(&[Option<PitchPlace>]) -> Vec<f64>;

/// Rows of data on a dresser, with what they want.
#[derive(Clone, Copy)]
pub struct RowsAlong<'a> {
    /// The dresser.
    pub tool: &'a DresserTool,
    /// The flank that is dressed where a row names none.
    pub flank: Flank,
    /// The rows.
    pub rows: RowSet,
    /// Worm z in use, from and to, mm: where q is -1 and 1.
    pub used: Sides<[f64; 2]>,
    /// What the pitch points want.
    pub wanted: WishAlong<'a>,
    /// Wanted tip radius over the worm's z, mm.
    pub tip: &'a dyn Fn(f64) -> f64,
}

impl RowsAlong<'_> {
    fn q(&self, flank: Flank, z: f64) -> f64 {
        let [from, to] = self.used[flank];
        (2.0 * z - from - to) / (to - from)
    }

    /// Length of roll at a share of the worm's profile.
    fn roll(&self, flank: Flank, share: f64) -> f64 {
        let range = &self.tool.flanks[flank].range;
        range.w_nf * (1.0 - share) + range.w_na * share
    }

    /// Parameter of the dresser's profile at a share of what it was designed for.
    fn parameter(&self, flank: Flank, share: f64) -> f64 {
        let designed = &self.tool.flanks[flank].designed;
        designed.w_nf * (1.0 - share) + designed.w_na * share
    }

    /// The flank of the row's place, or the one that is dressed.
    fn flank_of(&self, row: &RowAlong) -> Flank {
        row.names().unwrap_or(self.flank)
    }

    /// What turns the residual of each row (mm or rad) into mm of modification; `None` for one that is met exactly.
    pub(crate) fn weights(&self) -> Vec<Option<f64>> {
        let of = |(row, weight): (&RowAlong, &Option<f64>)| {
            let length = self.tool.flanks[self.flank_of(row)].range.length();
            weight.map(|weight| weight * 1e-3 / row.unit(length))
        };
        self.rows.rows().iter().zip(self.rows.weights()).map(of).collect()
    }

    /// The conditions at worm position v (mm); `b` as [`ConditionsAlong::at`] has it, one for each row.
    pub fn conditions(&self, v: f64, b: &[f64]) -> Vec<Condition> {
        let rows = self.rows.rows();
        let place = |(row, &b): (&RowAlong, &f64)| match *row {
            RowAlong::Point { flank, at } => {
                let flank = flank.unwrap_or(self.flank);
                let w = self.roll(flank, at.value(self.q(flank, b)));
                Some(PitchPlace { flank, w, b })
            }
            _ => None,
        };
        let places: Vec<Option<PitchPlace>> = rows.iter().zip(b).map(place).collect();
        let wanted = (self.wanted)(&places);
        // Rows without a place of their own go by where the dresser stands.
        let here = |flank: Flank| {
            let dresser = &self.tool.flanks[flank];
            self.q(flank, dresser.line.value(dresser.range.middle()) - v)
        };
        let condition = |(i, row): (usize, &RowAlong)| match *row {
            RowAlong::Point { flank, .. } => {
                let w = places[i].map_or(f64::NAN, |place| place.w);
                let f = wanted.get(i).copied().unwrap_or(f64::NAN);
                Condition::Point { flank: flank.unwrap_or(self.flank), w, f }
            }
            RowAlong::Map { flank, dresser, at } => {
                let flank = flank.unwrap_or(self.flank);
                let q = here(flank);
                let (t, w) = (self.parameter(flank, dresser.value(q)), self.roll(flank, at.value(q)));
                Condition::Map { flank, t, w }
            }
            RowAlong::Stretch { flank, stretch } => {
                let flank = flank.unwrap_or(self.flank);
                // Longer by P: the circle made for the lower end dresses what lies below it.
                let w = self.roll(flank, -stretch.value(here(flank)));
                Condition::Map { flank, t: self.parameter(flank, 0.0), w }
            }
            RowAlong::Head { position, above } => {
                let z = position - v;
                Condition::Head { t: position, r: (self.tip)(z) + above.value(self.q(self.flank, z)) }
            }
            RowAlong::Fixed { j, x } => Condition::Fixed { j, x: x.value(here(self.flank)) },
        };
        rows.iter().enumerate().map(condition).collect()
    }
}
