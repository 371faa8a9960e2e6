//! How far a cutter stays away from a piece of a surface, exactly (spec 50 section 9): boxes of parameters are halved until what
//! they can still hide is below a bound; the best point is then polished.

use crate::geometry::{Cutter, Surface, in_tool};
use crate::numerics::golden_section;
use nalgebra::{Rotation3, Vector3};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// A piece of a surface, turned about the workpiece's axis: a flank of this space or of another one.
#[derive(Clone, Copy, Debug)]
pub struct Patch<'a> {
    /// The surface.
    pub surface: &'a dyn Surface,
    /// Height parameters, ascending.
    pub heights: [f64; 2],
    /// Length parameters, ascending.
    pub lengths: [f64; 2],
    /// Turn about +z, rad.
    pub turn: f64,
}

/// The least distance between a cutter and a patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance {
    /// The distance, mm; < 0 where the cutter is inside.
    pub value: f64,
    /// What it cannot be less than, mm.
    pub lower_bound: f64,
    /// Height and length of the nearest point.
    pub place: [f64; 2],
}

/// What boxes may still hide when the search ends, mm (spec 50 section 9).
pub const HIDDEN: f64 = 1e-3;

/// Evaluations of one golden section while polishing: 0.618^40 of a box of some 1e-2 mm is 5e-11 mm.
const POLISHING: usize = 40;

/// A box of parameters with what it cannot be below.
struct Piece {
    least: f64,
    middle: [f64; 2],
    half: [f64; 2],
    reach: [f64; 2],
}

impl Piece {
    /// How far the surface can be from its middle, mm.
    fn radius(&self) -> f64 {
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
struct Probe<'a> {
    cutter: &'a Cutter,
    tip: Vector3<f64>,
    axis: Vector3<f64>,
    patch: Patch<'a>,
}

impl Probe<'_> {
    fn distance(&self, [height, length]: [f64; 2]) -> f64 {
        let [rho, z] = in_tool(&self.patch.surface.point(height, length), &self.tip, &self.axis);
        self.cutter.distance(rho, z)
    }

    fn piece(&self, middle: [f64; 2], half: [f64; 2]) -> (Piece, f64) {
        let between = |k: usize| [middle[k] - half[k], middle[k] + half[k]];
        let speeds = self.patch.surface.speed_bounds(between(0), between(1));
        let reach = [speeds[0] * half[0], speeds[1] * half[1]];
        let distance = self.distance(middle);
        (Piece { least: distance - reach[0] - reach[1], middle, half, reach }, distance)
    }
}

impl Patch<'_> {
    /// The cutter seen from the patch: turned back instead of the surface forwards.
    fn probe<'a>(&'a self, cutter: &'a Cutter, tip: &Vector3<f64>, axis: &Vector3<f64>) -> Probe<'a> {
        let back = Rotation3::from_axis_angle(&Vector3::z_axis(), -self.turn);
        Probe { cutter, tip: back * tip, axis: back * axis, patch: *self }
    }

    /// The whole patch and its middle's distance.
    fn whole(&self, probe: &Probe) -> (Piece, f64) {
        let middle = [self.heights, self.lengths].map(|[from, to]| 0.5 * (from + to));
        let half = [self.heights, self.lengths].map(|[from, to]| 0.5 * (to - from));
        probe.piece(middle, half)
    }

    /// The least distance of a cutter with its tip and unit axis there.
    pub fn clearance(&self, cutter: &Cutter, tip: &Vector3<f64>, axis: &Vector3<f64>) -> Clearance {
        let probe = self.probe(cutter, tip, axis);
        let (first, distance) = self.whole(&probe);
        let mut best = (distance, first.middle, first.half);
        let mut pieces = BinaryHeap::from([first]);
        let mut bound = f64::NEG_INFINITY;
        while let Some(piece) = pieces.pop() {
            bound = piece.least;
            if piece.least >= best.0 - HIDDEN || piece.radius() < HIDDEN {
                break;
            }
            for (half, distance) in halves(&probe, &piece) {
                if distance < best.0 {
                    best = (distance, half.middle, half.half);
                }
                if half.least < best.0 {
                    pieces.push(half);
                }
            }
        }
        let (value, place) = self.polish(&probe, best.1, best.2, best.0);
        Clearance { value, lower_bound: bound.min(value), place }
    }

    /// Whether the cutter keeps more than `wanted` mm; otherwise a place where it does not, with the distance there. Cheaper than the
    /// clearance itself, because what is far away is seen to be so at once.
    pub fn keeps(
        &self,
        cutter: &Cutter,
        tip: &Vector3<f64>,
        axis: &Vector3<f64>,
        wanted: f64,
    ) -> Result<(), Clearance> {
        let probe = self.probe(cutter, tip, axis);
        let mut pieces = vec![self.whole(&probe).0];
        while let Some(piece) = pieces.pop() {
            if piece.least >= wanted {
                continue;
            }
            let distance = piece.least + piece.radius();
            if distance < wanted || piece.radius() < HIDDEN {
                return Err(Clearance { value: distance, lower_bound: piece.least, place: piece.middle });
            }
            pieces.extend(halves(&probe, &piece).map(|(half, _)| half));
        }
        Ok(())
    }

    /// Something that the clearance is not below, mm: at least half of the way from `wanted` to it, or within `accuracy` of it. Much
    /// cheaper than the clearance where the cutter is far away.
    pub fn lower_bound(
        &self,
        cutter: &Cutter,
        tip: &Vector3<f64>,
        axis: &Vector3<f64>,
        wanted: f64,
        accuracy: f64,
    ) -> f64 {
        let probe = self.probe(cutter, tip, axis);
        let (first, mut best) = self.whole(&probe);
        let mut pieces = BinaryHeap::from([first]);
        while let Some(piece) = pieces.pop() {
            let enough = piece.least >= 0.5 * (wanted + best) || piece.least >= best - accuracy;
            if enough || piece.radius() < HIDDEN {
                return piece.least.min(best);
            }
            for (half, distance) in halves(&probe, &piece) {
                best = best.min(distance);
                pieces.push(half);
            }
        }
        best
    }

    /// The least distance near a place, which the search has found to a thousandth of a millimetre.
    fn polish(&self, probe: &Probe, middle: [f64; 2], half: [f64; 2], least: f64) -> (f64, [f64; 2]) {
        let around = |k: usize, [from, to]: [f64; 2]| {
            let reach = 4.0 * half[k];
            [(middle[k] - reach).max(from), (middle[k] + reach).min(to)]
        };
        let (heights, lengths) = (around(0, self.heights), around(1, self.lengths));
        let length_at = |height: f64| {
            golden_section(lengths[0], lengths[1], POLISHING, |length| probe.distance([height, length]))
        };
        let height = golden_section(heights[0], heights[1], POLISHING, |height| {
            probe.distance([height, length_at(height)])
        });
        let place = [height, length_at(height)];
        let value = probe.distance(place);
        if value < least { (value, place) } else { (least, middle) }
    }
}

/// Both halves across the longer side.
fn halves(probe: &Probe, piece: &Piece) -> [(Piece, f64); 2] {
    let across = usize::from(piece.reach[1] > piece.reach[0]);
    let mut half = piece.half;
    half[across] *= 0.5;
    [-1.0, 1.0].map(|sense| {
        let mut middle = piece.middle;
        middle[across] += sense * half[across];
        probe.piece(middle, half)
    })
}
