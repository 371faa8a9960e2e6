//! Why a ray of a milled flank has no length.

use super::body::CutterPart;

/// Why a ray has no length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unmilled {
    /// No cutter meets it between its begin in the material and the end of the stock.
    NotReached,
    /// A cutter already covers its begin: the gouge is deeper than was looked for.
    TooDeep {
        /// Index of the path.
        path: usize,
        /// Index of the block in it.
        block: usize,
        /// How far the cutter was along that block, 0 to 1; the first such place that was found.
        fraction: f64,
        /// The part of the cutter.
        part: CutterPart,
    },
    /// A cutter grazes it so closely that rounding decides whether it is met.
    NotSettled,
}

impl Unmilled {
    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::NotReached => "extend the paths over the whole flank, or allow more stock",
            Self::TooDeep { .. } => "look for the gouge there, or begin the rays deeper in the material",
            Self::NotSettled => "turn or shift the ray slightly: it only grazes the cutter",
        }
    }
}

impl std::fmt::Display for Unmilled {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::NotReached => f.write_str("no cutter meets it within the stock"),
            Self::TooDeep { path, block, .. } => {
                write!(f, "block {block} of path {path} gouges deeper than the ray begins")
            }
            Self::NotSettled => f.write_str("it only grazes a cutter"),
        }
    }
}
