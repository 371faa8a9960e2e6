//! What kind of workpiece a job mills.

use crate::job::MilledBody;

/// Kind of a workpiece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorkpieceKind {
    /// A cylindrical gear.
    Cylindrical,
    /// A bevel gear.
    Bevel,
    /// Blades on a hub.
    Bladed,
    /// A gear by points.
    Gridded,
}

impl WorkpieceKind {
    pub(super) fn of_body(body: &MilledBody<'_>) -> Self {
        match body {
            MilledBody::Gear(_) => Self::Cylindrical,
            MilledBody::Bevel(_) => Self::Bevel,
            MilledBody::Blade(_) => Self::Bladed,
            MilledBody::Grid(_) => Self::Gridded,
        }
    }

    /// Units of the height and the length parameter of its flanks.
    pub const fn units(self) -> [&'static str; 2] {
        match self {
            Self::Cylindrical => ["mm", "mm"],
            Self::Bevel => ["rad", "mm"],
            Self::Bladed | Self::Gridded => ["1", "1"],
        }
    }
}
