//! Errors of a motion law or its inverse.

use crate::numerics::SplineError;
use thiserror::Error;

/// Why a motion law or its inverse cannot be built or evaluated.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum LawError {
    /// Too few points for the kind of law.
    #[error("a motion law from {points} points, at least {least} are needed")]
    TooFewPoints {
        /// Points given.
        points: usize,
        /// Points needed.
        least: usize,
    },
    /// Lists that belong together differ in length.
    #[error("{found} values for a motion law where {expected} are expected")]
    LengthMismatch {
        /// Values expected.
        expected: usize,
        /// Values given.
        found: usize,
    },
    /// A breakpoint does not lie above the one before it.
    #[error("breakpoint {index} of a motion law is not above the one before it")]
    NotAscending {
        /// Index of the breakpoint.
        index: usize,
    },
    /// A number of the law is not finite.
    #[error("value {index} of a motion law, or a coefficient that follows from it, is not a finite number")]
    NotFinite {
        /// Index of the point or piece.
        index: usize,
    },
    /// Two pieces do not meet.
    #[error("a motion law jumps by {size} at {at}")]
    Jump {
        /// Breakpoint.
        at: f64,
        /// Size of the jump.
        size: f64,
    },
    /// The roundings of neighbouring corners would overlap, or there is nothing to round over.
    #[error(
        "corners of a motion law rounded over +-{half_length} mm; allowed: above 0, at most {largest} mm"
    )]
    RoundingOutOfRange {
        /// Half length of the rounding, mm.
        half_length: f64,
        /// Largest possible, mm.
        largest: f64,
    },
    /// The law has no inverse on the interval.
    #[error("a motion law is not strictly monotone at {at}")]
    NotMonotone {
        /// A place where its derivative vanishes or changes sign.
        at: f64,
    },
    /// An argument or a value outside the interval of the law or its inverse.
    #[error("{value} is outside the range {from} .. {to} of a motion law")]
    OutsideRange {
        /// The argument or value.
        value: f64,
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
    },
    /// A spline through the points is not possible.
    #[error(transparent)]
    Spline(#[from] SplineError),
}

impl LawError {
    /// Stable kebab-case code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::TooFewPoints { .. } => "law-too-few-points",
            Self::LengthMismatch { .. } => "law-length-mismatch",
            Self::NotAscending { .. } => "law-not-ascending",
            Self::NotFinite { .. } => "law-not-finite",
            Self::Jump { .. } => "law-jumps",
            Self::RoundingOutOfRange { .. } => "law-rounding-out-of-range",
            Self::NotMonotone { .. } => "law-not-monotone",
            Self::OutsideRange { .. } => "law-outside-range",
            Self::Spline(_) => "law-spline",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::TooFewPoints { .. } => "give more points",
            Self::LengthMismatch { .. } => "give one value per point",
            Self::NotAscending { .. } => "sort the points and remove duplicates",
            Self::NotFinite { .. } => "give finite numbers of a physical size",
            Self::Jump { .. } => "let the pieces meet: an axis cannot jump",
            Self::RoundingOutOfRange { .. } => "round the corners over a shorter length",
            Self::NotMonotone { .. } => {
                "take a law that rises or falls everywhere, with a ratio other than 0 in every part"
            }
            Self::OutsideRange { .. } => "extend the law over the whole range that is asked for",
            Self::Spline(_) => "give at least four ascending points with finite values",
        }
    }
}
