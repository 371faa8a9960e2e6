//! Bodies beside the flanks that every cutter keeps away from, whether or not anything of them is milled: root body or hub, blades with
//! their back sides, the ring of an internal gear.

use super::{HIDDEN, Obstacle, Patch};
use foundation::geometry::Surface;
use std::sync::Arc;

/// What a wall belongs to: what has to be kept from it follows from that.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WallKind {
    /// The body that the teeth or blades stand on. Fillet and bottom come down to it.
    Base,
    /// Blades beside the passage, seen from it.
    Blade,
    /// Backs of blades, whose material lies where their normals point to.
    Back,
    /// Teeth and ends of an internal gear away from the space, which tool, holder and spindle have to stay clear of.
    Ring,
}

/// A piece of a body's surface.
#[derive(Clone, Debug)]
pub struct Wall {
    /// What it is, for messages.
    pub name: &'static str,
    /// What it belongs to.
    pub kind: WallKind,
    /// The surface.
    pub surface: Arc<dyn Surface>,
    /// Height parameters, ascending.
    pub heights: [f64; 2],
    /// Length parameters, ascending.
    pub lengths: [f64; 2],
    /// Turn about +z, rad.
    pub turn: f64,
}

/// How far a pass that comes down to the root body may be found inside of it, mm: the drawn root is a section in the column plane, and
/// what is swept differs from it by micrometres where the tooth is not straight (`docs/mathematics/milling.md#root-and-clearance`).
pub(super) const DOWN_TO: f64 = 0.01;

/// What a height that a body limits keeps beyond what is wanted, mm: a search that follows the path hides as much at its end, and once
/// more between two places.
pub(super) const SPARE: f64 = 2.0 * HIDDEN;

/// What straight blocks between two places may come nearer than the places themselves, mm; of a smaller distance a half.
const BETWEEN: f64 = 0.01;

/// What is asked of a path that was laid with `safety` mm at its places.
pub(super) fn along_blocks(safety: f64) -> f64 {
    safety - BETWEEN.min(0.5 * safety)
}

impl Wall {
    /// Its surface.
    pub fn patch(&self) -> Patch<'_> {
        Patch { surface: &*self.surface, heights: self.heights, lengths: self.lengths, turn: self.turn }
    }

    /// The wall as something that a cutter keeps away from.
    pub fn obstacle(&self, wanted: f64) -> Obstacle<'_> {
        Obstacle { name: self.name, patch: self.patch(), wanted, between: true }
    }
}
