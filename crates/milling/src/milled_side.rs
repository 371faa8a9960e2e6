//! A flank of the workpiece as plans, results and messages name it.

use foundation::geometry::Flank;

/// A half of a double-helical gear.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Half {
    /// Towards +z.
    Upper,
    /// Towards -z.
    Lower,
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
        }
    }
}

impl std::fmt::Display for MilledSide {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(self.name())
    }
}
