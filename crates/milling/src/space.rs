//! A space to be milled: its flanks, what stands around it, and the frames along its bottom. A double-helical gear has two of them,
//! one for each half.

use super::milled_side::{Half, MilledSide};
use super::{ActiveFlank, Along, HIDDEN, LeadCurve, Obstacle, Patch, Wall, WallKind};
use foundation::geometry::{Flank, Frustum};
use std::sync::Arc;

/// One flank of a space.
#[derive(Clone, Debug)]
pub struct SpaceFlank {
    /// Which.
    pub side: Flank,
    /// Its surface and limits.
    pub active: ActiveFlank,
}

/// A piece of the land on top of a tooth or blade: a frustum between two azimuths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Land {
    /// The surface.
    pub surface: Frustum,
    /// From and to, rad.
    pub azimuths: [f64; 2],
    /// The flank of the space whose tip edge it begins at.
    pub side: Flank,
}

/// A tooth space, the half of one, or the passage beside a blade.
#[derive(Clone, Debug)]
pub struct Space {
    /// The flanks that are milled.
    pub flanks: Vec<SpaceFlank>,
    /// The middle of the bottom.
    pub lead: Arc<dyn LeadCurve>,
    /// Turn from one space to the next, rad.
    pub pitch: f64,
    /// Tops of the teeth beside the space, and of those beside its other half.
    pub lands: Vec<Land>,
    /// Flanks of the other half of a double-helical gear.
    pub other_half: Vec<SpaceFlank>,
    /// Bodies beside the flanks: root body or hub, other blades, the ring of an internal gear.
    pub walls: Vec<Wall>,
}

/// How deep the search on the flank that the cutter touches may find it: what curvature and blocks do there is less and judged by
/// rays; what digs in elsewhere is more. mm.
const OWN_FLANK: f64 = 0.05;

/// What a path that ends where it comes too near to the other half may be found short of it when it is checked: the search hides that
/// much at its end, and once more between two places. mm.
const SEARCHED: f64 = 2.0 * HIDDEN;

impl SpaceFlank {
    /// Its name among all flanks of the workpiece.
    pub fn side(&self) -> MilledSide {
        let half = self.active.kink.map(|kink| match (kink.along, kink.side > 0.0) {
            (Along::Axis, true) => Half::Upper,
            (Along::Axis, false) => Half::Lower,
            (Along::Rays, true) => Half::Heel,
            (Along::Rays, false) => Half::Toe,
        });
        MilledSide { flank: self.side, half }
    }

    /// The flank within its face as something to keep away from, turned about the axis.
    pub fn patch(&self, turn: f64) -> Patch<'_> {
        let [a, b] = self.active.height_span();
        Patch {
            surface: &*self.active.surface,
            heights: [a.min(b), a.max(b)],
            lengths: self.active.face,
            turn,
        }
    }
}

impl Space {
    /// The flank opposite to one.
    pub fn opposite(&self, side: Flank) -> Option<&SpaceFlank> {
        self.flanks.iter().find(|flank| flank.side != side)
    }

    /// Walls of a kind, to keep `wanted` mm from.
    pub fn walls(&self, kind: WallKind, wanted: f64) -> impl Iterator<Item = Obstacle<'_>> {
        self.walls.iter().filter(move |wall| wall.kind == kind).map(move |wall| wall.obstacle(wanted))
    }

    /// All that a cutter on one flank (or on none) must keep away from by `safety` mm, beside the walls.
    pub fn obstacles(&self, on: Option<Flank>, safety: f64) -> Vec<Obstacle<'_>> {
        let keep = |name, patch| Obstacle { name, patch, wanted: safety, between: true };
        let mut all = Vec::new();
        for flank in &self.flanks {
            if on == Some(flank.side) {
                let (patch, wanted) = (flank.patch(0.0), -OWN_FLANK);
                all.push(Obstacle { name: "own flank", patch, wanted, between: false });
            } else {
                all.push(keep("opposite flank", flank.patch(0.0)));
            }
            for turn in [self.pitch, -self.pitch] {
                all.push(keep("neighbouring tooth", flank.patch(turn)));
            }
        }
        for land in &self.lands {
            let patch =
                Patch { surface: &land.surface, heights: land.azimuths, lengths: [0.0, 1.0], turn: 0.0 };
            // The last row touches the edge that flank and land share, in the middle of a double-helical gear that of both halves.
            if on == Some(land.side) {
                all.push(Obstacle { name: "tip of a tooth", patch, wanted: -OWN_FLANK, between: false });
            } else {
                all.push(keep("tip of a tooth", patch));
            }
        }
        let beyond = self.beyond_middle(on, safety).into_iter();
        all.extend(beyond.map(|obstacle| Obstacle { wanted: obstacle.wanted - SEARCHED, ..obstacle }));
        all
    }

    /// Flanks of the other half. A cutter on one flank may come to where it touches the same flank there, or nothing would be left of
    /// a corner that opens outwards; from the others it keeps away by `safety` mm.
    pub fn beyond_middle(&self, on: Option<Flank>, safety: f64) -> Vec<Obstacle<'_>> {
        let mut all = Vec::new();
        for flank in &self.other_half {
            for turn in [0.0, self.pitch, -self.pitch] {
                let wanted = if on == Some(flank.side) && turn == 0.0 { 0.0 } else { safety };
                let name = "other half of the teeth";
                all.push(Obstacle { name, patch: flank.patch(turn), wanted, between: true });
            }
        }
        all
    }
}
