//! What is known of a program where it is checked.

use super::{AxisWord, MAXIMUM_AXES, TipControl};
use std::collections::BTreeMap;

/// How far the tip control is.
#[derive(Clone, Copy, Default)]
pub(super) struct TipState {
    pub(super) on: Option<TipControl>,
    /// Whether a tool was called, and whether with a length offset.
    pub(super) tool: bool,
    pub(super) offset: bool,
    /// Whether the control adds a length to axis values.
    pub(super) lengthened: bool,
    /// Whether something said where the axis points, and how fast the tip is.
    pub(super) oriented: bool,
    pub(super) paced: bool,
}

/// Spindles that can be numbered.
pub(super) const SPINDLES: usize = 8;

/// How far the gear of an axis is.
pub(super) enum GearPlace {
    Absent,
    Defined(Vec<usize>),
    On(Vec<usize>),
}

/// What the blocks so far have said.
pub(super) struct State<'a> {
    pub(super) axes: &'a [AxisWord],
    /// Bit mask of the axes whose place is known.
    pub(super) known: u16,
    pub(super) gears: [GearPlace; MAXIMUM_AXES],
    /// Follower and leader of each table.
    pub(super) tables: BTreeMap<u32, [usize; 2]>,
    pub(super) speeds: [f64; SPINDLES],
    /// Bit mask of the outputs that are switched with the next motion.
    pub(super) switched: u16,
    pub(super) tip: TipState,
    /// Bit mask of the places that a probe has kept.
    pub(super) probed: u16,
    pub(super) block: usize,
}
