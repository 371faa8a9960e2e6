//! What a driven motion says of each operation.

use crate::OperationKind;
use motion::milling::{RowSmoothness, SectionFeed};
use std::collections::BTreeMap;

/// Largest deviations that straight blocks of the axes leave from the planned path.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StraightKept {
    /// Of the tip, mm.
    pub tip: f64,
    /// Of the axis, rad.
    pub axis: f64,
}

/// One path of the first space.
#[derive(Clone, Debug, PartialEq)]
pub struct RowFigures {
    /// Path of the operation, from 0; a path that is cut in pieces has one entry for each.
    pub path: usize,
    /// How smoothly the rotary axes run.
    pub smoothness: RowSmoothness,
}

/// One operation.
#[derive(Clone, Debug, PartialEq)]
pub struct OperationFigures {
    /// What it does.
    pub kind: OperationKind,
    /// Number of the tool.
    pub tool: u32,
    /// Time of cuts and plunges, s.
    pub cutting: f64,
    /// Time of all other blocks, s.
    pub rapid: f64,
    /// Blocks.
    pub blocks: usize,
    /// What determines the time of how many cuts: "feed" or the name of an axis.
    pub limits: BTreeMap<String, usize>,
    /// Travel of both rotary axes over all blocks, links included, rad; the axis next to the workpiece first.
    pub rotary_travel: [f64; 2],
    /// Rows of the first space.
    pub rows: Vec<RowFigures>,
    /// Parts of paths of the first space near the pole: path and feed there, mm/min.
    pub passages: Vec<(usize, SectionFeed)>,
    /// Places of the first space at which an axis is held near the pole, and by how much the cutter's axis is off there at most, rad.
    pub held: (usize, f64),
    /// Links on which an axis is turned back or changes its solution.
    pub rewinds: usize,
}

impl OperationFigures {
    /// Time of all its blocks, s.
    pub fn seconds(&self) -> f64 {
        self.cutting + self.rapid
    }
}

impl StraightKept {
    /// The larger of both.
    pub(super) fn larger(self, other: Self) -> Self {
        Self { tip: self.tip.max(other.tip), axis: self.axis.max(other.axis) }
    }
}
