//! What an operation does, and its place in the order of cutting.

use super::milled_side::MilledSide;

/// What an operation does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OperationKind {
    /// Clears the space.
    Roughing,
    /// Finishes the rows of a flank.
    Flank(MilledSide),
    /// Goes on below a flank with the fillet.
    Fillet(MilledSide),
    /// Joins both fillets.
    Bottom,
}

impl OperationKind {
    /// Place of the operation in the order of cutting.
    pub(super) const fn stage(self) -> usize {
        match self {
            Self::Roughing => 0,
            Self::Flank(_) => 1,
            Self::Fillet(_) => 2,
            Self::Bottom => 3,
        }
    }
}

impl std::fmt::Display for OperationKind {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Roughing => f.write_str("roughing"),
            Self::Flank(side) => write!(f, "{side} flank"),
            Self::Fillet(side) => write!(f, "fillet of the {side} flank"),
            Self::Bottom => f.write_str("bottom"),
        }
    }
}
