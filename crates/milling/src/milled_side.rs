//! A flank of the workpiece as plans, results and messages name it.

use foundation::geometry::Flank;

/// A half of a double-helical gear, cylindrical or bevel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Half {
    /// Towards +z.
    Upper,
    /// Towards -z.
    Lower,
    /// Of a bevel gear, towards the heel.
    Heel,
    /// Of a bevel gear, towards the toe.
    Toe,
}

impl Half {
    /// +1 on the side to which lengths of the teeth ascend, else -1.
    pub const fn sign(self) -> f64 {
        match self {
            Self::Upper | Self::Heel => 1.0,
            Self::Lower | Self::Toe => -1.0,
        }
    }
}

/// A flank of the workpiece's spaces, as plans and results name it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MilledSide {
    /// The side of the space.
    pub flank: Flank,
    /// The half that it belongs to, of a double-helical gear.
    pub half: Option<Half>,
}

impl MilledSide {
    /// Its name in documents.
    pub const fn name(self) -> &'static str {
        match (self.half, self.flank) {
            (None, flank) => flank.name(),
            (Some(Half::Upper), Flank::Left) => "upper-left",
            (Some(Half::Upper), Flank::Right) => "upper-right",
            (Some(Half::Lower), Flank::Left) => "lower-left",
            (Some(Half::Lower), Flank::Right) => "lower-right",
            (Some(Half::Heel), Flank::Left) => "heel-left",
            (Some(Half::Heel), Flank::Right) => "heel-right",
            (Some(Half::Toe), Flank::Left) => "toe-left",
            (Some(Half::Toe), Flank::Right) => "toe-right",
        }
    }
}

impl std::fmt::Display for MilledSide {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(self.name())
    }
}
