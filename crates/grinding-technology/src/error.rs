//! What can be wrong with stock, strokes and limits, each with its data, a stable code and a way out.

use contact::ContactError;
use finding::Finding;
use foundation::geometry::{Flank, GeometryError};
use thiserror::Error;

/// Errors of the technology. Lengths mm, amounts um where a name says so.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum TechnologyError {
    /// A body is impossible by itself.
    #[error(transparent)]
    #[finding(transparent)]
    Geometry(#[from] GeometryError),
    /// Worm and workpiece do not meet.
    #[error(transparent)]
    #[finding(transparent)]
    Contact(#[from] ContactError),
    /// A cone.
    #[error(
        "stock and removal are worked out for cylindrical worms and workpieces; here the {body} is conical"
    )]
    #[finding(code = "cylindrical-only")]
    #[way_out("leave out [stock] and [technology] for this job")]
    CylindricalOnly {
        /// "worm" or "workpiece".
        body: &'static str,
    },
    /// An input outside what it may be.
    #[error("{field} = {value} is not allowed; allowed: {allowed}")]
    #[finding(code = "bad-input")]
    #[way_out("give a value in the allowed range")]
    OutOfRange {
        /// Name of the input.
        field: String,
        /// Its value.
        value: f64,
        /// What is allowed.
        allowed: String,
    },
    /// A stroke leaves more than the one before, or the last one leaves something.
    #[error(
        "stroke {stroke} leaves {left_um} um on the {flank} flank after {before_um} um: each leaves as much as the one before or less, and the last one 0"
    )]
    #[finding(code = "stroke-order")]
    #[way_out("order the strokes from roughing to finishing; the last one leaves 0 um")]
    StrokeOrder {
        /// Number of the stroke, from 1.
        stroke: usize,
        /// Flank concerned.
        flank: Flank,
        /// What it leaves.
        left_um: f64,
        /// What the one before left.
        before_um: f64,
    },
    /// No cycle within the limits.
    #[error(
        "no cycle within the limits: {limit} allows a feed of {feed} mm per revolution, below the least feed {least} mm; {needed} would do"
    )]
    #[finding(code = "no-feasible-plan")]
    #[way_out("raise the limit named, allow smaller feeds or more roughing strokes")]
    NoFeasiblePlan {
        /// The limit that binds.
        limit: &'static str,
        /// Largest feed under it, mm per revolution.
        feed: f64,
        /// Least feed.
        least: f64,
        /// Value of the limit that would do.
        needed: f64,
    },
}

/// Checks that a number is above 0.
pub(crate) fn positive(field: &str, value: f64) -> Result<f64, TechnologyError> {
    in_range(field, value, value > 0.0, "> 0")
}

/// Checks a number that has to be finite and `good`.
pub(crate) fn in_range(field: &str, value: f64, good: bool, allowed: &str) -> Result<f64, TechnologyError> {
    if value.is_finite() && good {
        return Ok(value);
    }
    Err(TechnologyError::OutOfRange { field: field.into(), value, allowed: allowed.into() })
}
