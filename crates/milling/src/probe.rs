//! A cutter seen from a piece of a surface: how near a box of parameters can come to it, and where it is nearest
//! (`docs/mathematics/milling.md#root-and-clearance`).
//!
//! The distance d from a convex part of a cutter is a convex function of the point x, so that it lies above every one of its tangents:
//! d(x) >= d(m) + g (x - m) with a slope |g| <= 1. Over a box with half sides h_a, h_b about m the surface is S(m) + S_a da + S_b db
//! + r with |r| <= [`Surface::off_tangent`], hence
//!
//!     d >= d(m) - |g S_a| h_a - |g S_b| h_b - |r|.
//!
//! A cutter that moves a little to both sides changes d by what g sees of that motion, as if the surface moved instead.
//!
//! Near the nearest point g is perpendicular to the surface, and what a box can hide falls with the square of its size;
//! `docs/mathematics/milling.md` bound d(m) - L_a h_a - L_b h_b falls with the size alone. Of a cutter with a shank the least bound of its
//! parts counts.

use super::{CutterPlace, Patch};
use foundation::geometry::{Cutter, Support, in_tool};
use foundation::numerics::brent;
use nalgebra::{Rotation3, Vector3};
use std::cmp::Ordering;

/// A box of parameters with what it cannot be below, and the nearest of its points that have been looked at. mm.
pub(super) struct Piece {
    pub least: f64,
    pub nearest: f64,
    pub place: [f64; 2],
    pub half: [f64; 2],
    middle: [f64; 2],
    reach: [f64; 2],
}

impl Piece {
    /// How far the surface can be from its middle, mm.
    pub fn radius(&self) -> f64 {
        self.reach[0] + self.reach[1]
    }
}

impl PartialEq for Piece {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Piece {}

impl PartialOrd for Piece {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// The heap yields the piece with the least bound first; ties by place, so that the search is the same every time.
impl Ord for Piece {
    fn cmp(&self, other: &Self) -> Ordering {
        let key = |piece: &Self| (piece.least, piece.middle[0], piece.middle[1]);
        let (a, b) = (key(self), key(other));
        b.0.total_cmp(&a.0).then(b.1.total_cmp(&a.1)).then(b.2.total_cmp(&a.2))
    }
}

/// A cutter at a place, in the coordinates of a patch.
pub(super) struct Probe<'a> {
    pub cutter: &'a Cutter,
    pub tip: Vector3<f64>,
    pub axis: Vector3<f64>,
    pub moves: Moves,
    pub patch: Patch<'a>,
}

/// A motion from a place to both sides, straight at the tip.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Moves {
    /// What it shifts at most, mm.
    shift: Vector3<f64>,
    /// What it turns about the tip at most, rad.
    turn: Vector3<f64>,
    /// How much less it turns to one of the sides, rad.
    uneven: f64,
}

impl Moves {
    /// From the middle of a piece of a block to both ends.
    pub fn between(middle: &CutterPlace, [from, to]: [&CutterPlace; 2]) -> Self {
        let angle = |end: &CutterPlace| middle.axis.cross(&end.axis).norm().atan2(middle.axis.dot(&end.axis));
        let angles = [angle(from), angle(to)];
        let across = from.axis.cross(&to.axis);
        let turn =
            across.try_normalize(0.0).map_or_else(Vector3::zeros, |unit| unit * angles[0].max(angles[1]));
        Self { shift: 0.5 * (to.tip - from.tip), turn, uneven: (angles[0] - angles[1]).abs() }
    }

    /// How far a point within `radius` of one that lies there from the tip moves at most, mm.
    pub fn of(&self, arm: &Vector3<f64>, radius: f64) -> f64 {
        let turns = self.turn.norm();
        self.shift.norm() + if turns > 0.0 { turns * (arm.norm() + radius) } else { 0.0 }
    }

    /// What a distance with this slope changes at most by the motion, at all points within `radius` of one that lies there from the tip.
    /// The axis turns by an angle that is not quite in proportion to the shift, and a point leaves its tangent: both are of second order.
    fn changes(&self, gradient: &Vector3<f64>, arm: &Vector3<f64>, radius: f64) -> f64 {
        let level = gradient.dot(&(self.shift + self.turn.cross(arm))).abs();
        let angle = self.turn.norm();
        if angle == 0.0 {
            return level;
        }
        let shift = self.shift.norm();
        let aside = self.uneven + angle * angle * (0.5 + angle);
        let sharp = level + angle * (radius + shift) + aside * (arm.norm() + radius + shift);
        sharp.min(self.of(arm, radius))
    }
}

impl Probe<'_> {
    /// The same on its way, of a patch that is turned by so much.
    pub fn moving(self, moves: &Moves, turn: f64) -> Self {
        let back = Rotation3::from_axis_angle(&Vector3::z_axis(), -turn);
        Self { moves: Moves { shift: back * moves.shift, turn: back * moves.turn, ..*moves }, ..self }
    }

    fn distance(&self, [height, length]: [f64; 2]) -> f64 {
        let [rho, z] = in_tool(&self.patch.surface.point(height, length), &self.tip, &self.axis);
        self.cutter.distance(rho, z)
    }

    /// Distances of the cutter's convex parts from the surface at a place, each with its slopes over height and length.
    fn supports(&self, place: [f64; 2]) -> impl Iterator<Item = (f64, [f64; 2])> {
        self.moving_supports(place, 0.0).map(|(distance, slopes, _)| (distance, slopes))
    }

    /// The same with what the motion changes at most in the place and around it by a radius: there and all around.
    fn moving_supports(
        &self,
        [height, length]: [f64; 2],
        radius: f64,
    ) -> impl Iterator<Item = (f64, [f64; 2], [f64; 2])> {
        let jet = self.patch.surface.jet(height, length);
        let [rho, z] = in_tool(&jet.point, &self.tip, &self.axis);
        // On the axis any radial direction will do, because no distance falls with the radius: none is the simplest.
        let outwards = (jet.point - self.tip - self.axis * z) / if rho > 0.0 { rho } else { 1.0 };
        let (axis, arm, moves) = (self.axis, jet.point - self.tip, self.moves);
        self.cutter.supports(rho, z).map(move |Support { distance, slope }| {
            let gradient = outwards * slope[0] + axis * slope[1];
            let slopes = [gradient.dot(&jet.by_height), gradient.dot(&jet.by_length)];
            (distance, slopes, [0.0, radius].map(|radius| moves.changes(&gradient, &arm, radius)))
        })
    }

    /// The slopes of the part that is nearest at a place.
    fn slopes(&self, place: [f64; 2]) -> [f64; 2] {
        let nearer = |a: (f64, [f64; 2]), b: (f64, [f64; 2])| if b.0 < a.0 { b } else { a };
        self.supports(place).reduce(nearer).map_or([f64::NAN; 2], |(_, slopes)| slopes)
    }

    /// The whole patch.
    pub fn whole(&self) -> Piece {
        let Patch { heights, lengths, .. } = self.patch;
        let middle = [heights, lengths].map(|[from, to]| 0.5 * (from + to));
        let half = [heights, lengths].map(|[from, to]| 0.5 * (to - from));
        self.piece(middle, half, f64::INFINITY)
    }

    /// A box. Its bound is made no better where it is seen to be `enough` at once.
    fn piece(&self, middle: [f64; 2], half: [f64; 2], enough: f64) -> Piece {
        let [heights, lengths] = [0, 1].map(|k| [middle[k] - half[k], middle[k] + half[k]]);
        let speeds = self.patch.surface.speed_bounds(heights, lengths);
        let reach = [speeds[0] * half[0], speeds[1] * half[1]];
        let point = self.patch.surface.point(middle[0], middle[1]);
        let [rho, z] = in_tool(&point, &self.tip, &self.axis);
        let (distance, arm) = (self.cutter.distance(rho, z), point - self.tip);
        let least = distance - reach[0] - reach[1] - self.moves.of(&arm, reach[0] + reach[1]);
        let mut piece = Piece { least, nearest: distance, place: middle, half, middle, reach };
        if least < enough {
            self.sharpen(&mut piece, [heights, lengths]);
        }
        piece
    }

    /// The bound by tangents, and the corner at which they are least.
    fn sharpen(&self, piece: &mut Piece, [heights, lengths]: [[f64; 2]; 2]) {
        let off = self.patch.surface.off_tangent(heights, lengths);
        let (half, radius) = (piece.half, piece.radius());
        let mut least = f64::INFINITY;
        let mut downwards = [0.0; 2];
        for (distance, slopes, [here, around]) in self.moving_supports(piece.middle, radius) {
            let falls = slopes[0].abs() * half[0] + slopes[1].abs() * half[1] + off;
            let bound = distance - radius.min(falls) - around;
            piece.nearest = piece.nearest.min(distance - here);
            if bound < least {
                least = bound;
                downwards = slopes.map(|slope| -slope.signum());
            }
        }
        piece.least = piece.least.max(least);
        let corner = [0, 1].map(|k| piece.middle[k] + downwards[k] * half[k]);
        let distance = self.distance(corner);
        if distance < piece.nearest {
            (piece.nearest, piece.place) = (distance, corner);
        }
    }

    /// Both halves across the longer side; by shares of the patch where a side has no bounded length yet.
    pub fn halves(&self, piece: &Piece, enough: f64) -> [Piece; 2] {
        let share = |k: usize, [from, to]: [f64; 2]| piece.half[k] / (to - from);
        let sides = if piece.radius().is_finite() {
            piece.reach
        } else {
            [share(0, self.patch.heights), share(1, self.patch.lengths)]
        };
        let across = usize::from(sides[1] > sides[0]);
        let mut half = piece.half;
        half[across] *= 0.5;
        [-1.0, 1.0].map(|sense| {
            let mut middle = piece.middle;
            middle[across] += sense * half[across];
            self.piece(middle, half, enough)
        })
    }

    /// The least distance near a place and where it is: along the length for every height, then over the height, each where the slope
    /// changes its sign or at an end. Outside of the cutter's parts the distance has no edges, so that this is exact.
    pub fn polish(&self, mut place: [f64; 2], half: [f64; 2]) -> (f64, [f64; 2]) {
        let limits = [self.patch.heights, self.patch.lengths];
        let mut reach = half.map(|half| AROUND * half);
        loop {
            let around = [0, 1]
                .map(|k| [(place[k] - reach[k]).max(limits[k][0]), (place[k] + reach[k]).min(limits[k][1])]);
            let length_at = |height: f64| lowest(around[1], |length| self.slopes([height, length])[1]);
            // Where the length is the best one, the distance changes with the height as if the length stood still.
            let height = lowest(around[0], |height| self.slopes([height, length_at(height)])[0]);
            place = [height, length_at(height)];
            // It goes on where the valley leads out of what was looked at.
            let leads_out =
                |k: usize| (0..2).any(|end| place[k] == around[k][end] && around[k][end] != limits[k][end]);
            if !leads_out(0) && !leads_out(1) {
                return (self.distance(place), place);
            }
            reach = reach.map(|reach| 2.0 * reach);
        }
    }
}

/// How far around the nearest point that was looked at the polished one is looked for at first, in half sides of its box.
const AROUND: f64 = 2.0;

/// Share of an interval to which a place is polished: the distance is level there, and changes by the square of it.
const POLISHED: f64 = 1e-7;

/// Where a function of one variable with this slope is lowest, if it has one valley.
fn lowest(range: [f64; 2], slope: impl Fn(f64) -> f64) -> f64 {
    let [from, to] = range;
    let ends = range.map(&slope);
    if ends[0] >= 0.0 {
        return from;
    }
    if ends[1] <= 0.0 {
        return to;
    }
    brent(range, ends, POLISHED * (to - from), |x| Some(slope(x))).unwrap_or(0.5 * (from + to))
}
