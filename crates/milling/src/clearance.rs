//! How far a cutter stays away from a piece of a surface, exactly (`docs/mathematics/milling.md#root-and-clearance`): boxes of parameters
//! are halved until what they can still hide is below a bound; the best point is then polished.

use super::patch::{Clearance, HIDDEN, Patch};
use super::probe::{Moves, Probe};
use foundation::geometry::Cutter;
use nalgebra::{Rotation3, Vector3};
use std::collections::BinaryHeap;

impl Patch<'_> {
    /// The cutter seen from the patch: turned back instead of the surface forwards.
    fn probe<'a>(&'a self, cutter: &'a Cutter, tip: &Vector3<f64>, axis: &Vector3<f64>) -> Probe<'a> {
        let back = Rotation3::from_axis_angle(&Vector3::z_axis(), -self.turn);
        Probe { cutter, tip: back * tip, axis: back * axis, moves: Moves::default(), patch: *self }
    }

    /// The least distance of a cutter with its tip and unit axis there.
    pub fn clearance(&self, cutter: &Cutter, tip: &Vector3<f64>, axis: &Vector3<f64>) -> Clearance {
        let probe = self.probe(cutter, tip, axis);
        let first = probe.whole();
        let (mut value, mut place, mut half) = (first.nearest, first.place, first.half);
        let mut pieces = BinaryHeap::from([first]);
        let mut bound = f64::NEG_INFINITY;
        while let Some(piece) = pieces.pop() {
            bound = piece.least;
            if bound >= value - HIDDEN {
                break;
            }
            for part in probe.halves(&piece, value) {
                if part.nearest < value {
                    (value, place, half) = (part.nearest, part.place, part.half);
                }
                if part.least < value {
                    pieces.push(part);
                }
            }
        }
        let (polished, at) = probe.polish(place, half);
        if polished < value {
            (value, place) = (polished, at);
        }
        Clearance { value, lower_bound: bound.min(value), place }
    }

    /// A point of it, mm.
    pub fn point(&self, [height, length]: [f64; 2]) -> Vector3<f64> {
        Rotation3::from_axis_angle(&Vector3::z_axis(), self.turn) * self.surface.point(height, length)
    }

    /// Whether the cutter keeps more than `wanted` mm; otherwise a place where it does not, or not for certain, with the distance
    /// there. Cheaper than the clearance itself, because what is far away is seen to be so at once.
    pub fn keeps(
        &self,
        cutter: &Cutter,
        tip: &Vector3<f64>,
        axis: &Vector3<f64>,
        wanted: f64,
    ) -> Result<(), Clearance> {
        self.keeps_moving(cutter, (tip, axis), &Moves::default(), wanted)
    }

    /// The same wherever the cutter moves to from there. The distance reported is then what is certain.
    pub(super) fn keeps_moving(
        &self,
        cutter: &Cutter,
        (tip, axis): (&Vector3<f64>, &Vector3<f64>),
        moves: &Moves,
        wanted: f64,
    ) -> Result<(), Clearance> {
        let probe = self.probe(cutter, tip, axis).moving(moves, self.turn);
        let mut pieces = vec![probe.whole()];
        while let Some(piece) = pieces.pop() {
            if piece.least >= wanted {
                continue;
            }
            let hides = (piece.nearest - piece.least).min(piece.radius());
            if piece.nearest < wanted || hides < HIDDEN {
                return Err(Clearance { value: piece.nearest, lower_bound: piece.least, place: piece.place });
            }
            pieces.extend(probe.halves(&piece, wanted));
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
        let first = probe.whole();
        let mut best = first.nearest;
        let mut pieces = BinaryHeap::from([first]);
        while let Some(piece) = pieces.pop() {
            let enough = piece.least >= 0.5 * (wanted + best) || piece.least >= best - accuracy;
            if enough || piece.radius() < HIDDEN {
                return piece.least.min(best);
            }
            for part in probe.halves(&piece, best) {
                best = best.min(part.nearest);
                pieces.push(part);
            }
        }
        best
    }
}
