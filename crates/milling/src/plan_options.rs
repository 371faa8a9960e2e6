//! What a space is milled with and how.

use super::finish::Bottom;
use super::lines::{Lines, SpacingLaw};
use super::milled_side::{Half, MilledSide};
use super::operation_kind::OperationKind;
use super::path::{RowOrder, Traverse};
use super::root_pass::RootDepth;
use super::{HeightRule, LeadArc, Orientation};
use foundation::geometry::{Cutter, Flank};

/// What a space is milled with and how.
#[derive(Clone, Debug)]
pub struct PlanOptions {
    /// The cutter of the flanks.
    pub cutter: Cutter,
    /// The cutter of the bottom; the flanks' own without.
    pub bottom_cutter: Option<Cutter>,
    /// The cutter that clears the space; the flanks' own without.
    pub roughing_cutter: Option<Cutter>,
    /// Rows and columns.
    pub lines: Lines,
    /// Law of the rows.
    pub spacing: SpacingLaw,
    /// Tilt and lead angle; the tilt is that of the first row.
    pub orientation: Orientation,
    /// Tilt of the last row, rad, where rows lean differently.
    pub tilt_at_tip: Option<f64>,
    /// Contact heights.
    pub heights: HeightRule,
    /// How far the path goes on beyond the face, mm.
    pub overrun: f64,
    /// What the cutter keeps from everything that it does not mill, mm.
    pub safety: f64,
    /// Senses of the rows.
    pub traverse: Traverse,
    /// Order of the rows.
    pub order: RowOrder,
    /// Root: its depth, and whether the bottom between the fillets is milled as well.
    pub root: Option<(RootDepth, bool)>,
    /// The finished bottom, which rows keep away from by the safety distance, where the job draws one.
    pub bottom: Option<Bottom>,
    /// Clearing: allowance, greatest depth of a layer and greatest distance of passes, mm.
    pub roughing: Option<[f64; 3]>,
    /// How the cutter comes to rows, and how it leaves them.
    pub leads: [Option<LeadArc>; 2],
    /// The flanks that are milled.
    pub sides: Vec<Flank>,
}

impl PlanOptions {
    /// The cutter of an operation.
    pub fn cutter_of(&self, kind: OperationKind) -> &Cutter {
        let own = match kind {
            OperationKind::Roughing => &self.roughing_cutter,
            OperationKind::Bottom => &self.bottom_cutter,
            OperationKind::Flank(_) | OperationKind::Fillet(_) => &None,
        };
        own.as_ref().unwrap_or(&self.cutter)
    }

    /// How the axis is turned on a flank: halves are mirror images of each other, and so is the axis that is turned about the normal.
    pub(super) fn orientation_on(&self, side: MilledSide) -> Orientation {
        let sense = side.half.map_or(1.0, Half::sign);
        Orientation { lead_angle: sense * self.orientation.lead_angle, ..self.orientation }
    }
}
