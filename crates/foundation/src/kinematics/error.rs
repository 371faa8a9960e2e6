//! Errors of a motion law or its inverse.

use crate::numerics::SplineError;
use finding::Finding;
use thiserror::Error;

/// Why a motion law or its inverse cannot be built or evaluated.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum LawError {
    /// Too few points for the kind of law.
    #[error("a motion law from {points} points, at least {least} are needed")]
    #[finding(code = "law-too-few-points")]
    #[way_out("give more points")]
    TooFewPoints {
        /// Points given.
        points: usize,
        /// Points needed.
        least: usize,
    },
    /// Lists that belong together differ in length.
    #[error("{found} values for a motion law where {expected} are expected")]
    #[finding(code = "law-length-mismatch")]
    #[way_out("give one value per point")]
    LengthMismatch {
        /// Values expected.
        expected: usize,
        /// Values given.
        found: usize,
    },
    /// A breakpoint does not lie above the one before it.
    #[error("breakpoint {index} of a motion law is not above the one before it")]
    #[finding(code = "law-not-ascending")]
    #[way_out("sort the points and remove duplicates")]
    NotAscending {
        /// Index of the breakpoint.
        index: usize,
    },
    /// A number of the law is not finite.
    #[error("value {index} of a motion law, or a coefficient that follows from it, is not a finite number")]
    #[finding(code = "law-not-finite")]
    #[way_out("give finite numbers of a physical size")]
    NotFinite {
        /// Index of the point or piece.
        index: usize,
    },
    /// Two pieces do not meet.
    #[error("a motion law jumps by {size} at {at}")]
    #[finding(code = "law-jumps")]
    #[way_out("let the pieces meet: an axis cannot jump")]
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
    #[finding(code = "law-rounding-out-of-range")]
    #[way_out("round the corners over a shorter length")]
    RoundingOutOfRange {
        /// Half length of the rounding, mm.
        half_length: f64,
        /// Largest possible, mm.
        largest: f64,
    },
    /// The law has no inverse on the interval.
    #[error("a motion law is not strictly monotone at {at}")]
    #[finding(code = "law-not-monotone")]
    #[way_out("take a law that rises or falls everywhere, with a ratio other than 0 in every part")]
    NotMonotone {
        /// A place where its derivative vanishes or changes sign.
        at: f64,
    },
    /// An argument or a value outside the interval of the law or its inverse.
    #[error("{value} is outside the range {from} .. {to} of a motion law")]
    #[finding(code = "law-outside-range")]
    #[way_out("extend the law over the whole range that is asked for")]
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
    #[finding(code = "law-spline")]
    #[way_out("give at least four ascending points with finite values")]
    Spline(#[from] SplineError),
}
