//! What a cutter must keep away from, and where it does not.

use super::patch::{Clearance, Patch};

/// A surface that a cutter must keep away from.
#[derive(Clone, Copy, Debug)]
pub struct Obstacle<'a> {
    /// What it is, for messages.
    pub name: &'static str,
    /// The surface.
    pub patch: Patch<'a>,
    /// What the cutter has to keep, mm; < 0 allows it to go in by that.
    pub wanted: f64,
    /// Whether blocks between places are followed. Along the flank that the cutter touches they cannot be: there it keeps nothing, and
    /// what the blocks leave is a matter of micrometres, which the referee's rays tell.
    pub between: bool,
}

/// Where a cutter comes too near.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Collision {
    /// Number of the place on the path after which it happens.
    pub block: usize,
    /// Share of the block that begins there.
    pub share: f64,
    /// What it comes near to.
    pub name: &'static str,
    /// Distance there and the nearest point.
    pub clearance: Clearance,
    /// What it should keep, mm.
    pub wanted: f64,
}
