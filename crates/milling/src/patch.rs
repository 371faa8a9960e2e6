//! A piece of a surface that a cutter may come near to, and its distance from a cutter.

use foundation::geometry::Surface;

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
    /// The distance, mm; < 0 where the cutter is inside (there to [`HIDDEN`]: the distance has edges).
    pub value: f64,
    /// What it cannot be less than, mm.
    pub lower_bound: f64,
    /// Height and length of the nearest point.
    pub place: [f64; 2],
}

/// What boxes may still hide when the search ends, mm (`docs/mathematics/milling.md#root-and-clearance`).
pub const HIDDEN: f64 = 1e-3;
