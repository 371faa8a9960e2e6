//! Measured lines and fields of one flank of one tooth.

use serde::{Deserialize, Serialize};

use super::undefined;
use foundation::geometry::Flank;

/// What a trace runs along.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum TraceKind {
    /// From root to tip at one height z.
    Profile,
    /// Along the face width at one length of roll w.
    Helix,
}

impl TraceKind {
    /// `profile` or `helix`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Profile => "profile",
            Self::Helix => "helix",
        }
    }
}

/// What the values of a trace are measured from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Zero {
    /// From anywhere: traces of different lines have different zeros.
    Free,
    /// From the nominal flank.
    Absolute,
}

/// One measured line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trace {
    /// Along profile or face width.
    pub kind: TraceKind,
    /// Number of the tooth as the machine counts.
    pub tooth: u32,
    /// The flank.
    pub flank: Flank,
    /// Mark of the line: empty for the middle one, `u` and `o` lower and upper profile, `f` and `k` inner and outer helix.
    pub tag: String,
    /// Where the line lies: z of a profile from the middle of the face width, length of roll w of a helix, mm.
    pub position_mm: f64,
    /// Places of the samples, ascending: length of roll w of a profile, z of a helix, mm.
    pub abscissa_mm: Vec<f64>,
    /// Deviations, um, f > 0 material; NaN = undefined.
    #[serde(with = "undefined")]
    pub f_um: Vec<f64>,
    /// What the values are measured from.
    pub zero: Zero,
}

/// A measured field of one flank.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Topography {
    /// Number of the tooth as the machine counts.
    pub tooth: u32,
    /// The flank.
    pub flank: Flank,
    /// Points [w mm, z mm].
    pub points_mm: Vec<[f64; 2]>,
    /// Deviations at the points, um, f > 0 material; NaN = undefined.
    #[serde(with = "undefined")]
    pub f_um: Vec<f64>,
}
