//! A planned space: its flanks, the layers that clear it, and the operations in their order.

use super::RoughingLayer;
use super::flank_plan::FlankPlan;
use super::operation_kind::OperationKind;
use super::path::CutterPath;

/// Paths of one cutter in the order of cutting.
#[derive(Clone, Debug)]
pub struct Operation {
    /// What it does.
    pub kind: OperationKind,
    /// Its paths.
    pub paths: Vec<CutterPath>,
}

/// A space from blank to finished.
#[derive(Clone, Debug)]
pub struct MillingPlan {
    /// The flanks.
    pub flanks: Vec<FlankPlan>,
    /// The layers that clear the space.
    pub layers: Vec<RoughingLayer>,
    /// Everything in its order.
    pub operations: Vec<Operation>,
}
