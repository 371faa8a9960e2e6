//! Errors of a modification, and where it has no value.

use finding::Finding;
use thiserror::Error;

/// A description that can't become a modification. Lengths in mm, amounts in um as in the file.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum ModificationError {
    /// A key is missing, unknown or its value outside the allowed range.
    #[error("{kind}: {key} is {value}, allowed: {allowed}")]
    #[finding(code = "invalid-modification")]
    #[way_out("Correct {key}; allowed is: {allowed}.")]
    InvalidModification {
        /// Kind of the modification, or "evaluation field".
        kind: String,
        /// The offending key.
        key: String,
        /// Its value as written.
        value: String,
        /// The allowed range or choices.
        allowed: String,
    },
    /// A number is not finite or so large that it can only be a slip.
    #[error("{kind}: {key} is {value}, allowed: finite numbers up to {limit:e} in magnitude")]
    #[finding(code = "invalid-number")]
    #[way_out("Check the unit and the decimal point of {key} (amounts are in um, lengths in mm).")]
    InvalidNumber {
        /// Kind of the modification, or "evaluation field".
        kind: String,
        /// The offending key.
        key: String,
        /// Its value.
        value: f64,
        /// Largest allowed magnitude.
        limit: f64,
    },
    /// There is no modification of this name.
    #[error("kind is {kind:?}, allowed: {allowed}")]
    #[finding(code = "unknown-modification")]
    #[way_out("Write kind = {nearest:?} if that is meant.")]
    UnknownModification {
        /// The name given.
        kind: String,
        /// The known name that is spelled most alike.
        nearest: String,
        /// All known names.
        allowed: String,
    },
    /// A circular crowning higher than a half circle over its length.
    #[error(
        "{kind}: amount_um is {amount_um}, allowed: at most {limit_um} um in magnitude (half the length)"
    )]
    #[finding(code = "arc-too-deep")]
    #[way_out("Use a smaller amount, or the parabola: kind = {:?}.", kind.trim_end_matches("_arc"))]
    ArcTooDeep {
        /// Kind of the modification.
        kind: String,
        /// The transverse amount asked for, um.
        amount_um: f64,
        /// Half the length of the field, um.
        limit_um: f64,
    },
    /// Too few points for the surface wanted.
    #[error("{kind}: points holds {count} points, allowed: {needed} or more, spread over both directions")]
    #[finding(code = "too-few-points")]
    #[way_out("Give at least {needed} points spread over both directions, or use method = \"linear\".")]
    TooFewPoints {
        /// Kind of the modification.
        kind: String,
        /// Number of distinct points given.
        count: usize,
        /// Number needed.
        needed: usize,
    },
    /// All points lie on one straight line.
    #[error("{kind}: points holds {count} points on one line, allowed: points that span an area")]
    #[finding(code = "collinear-points")]
    #[way_out("Add points beside the line, so that the cloud spans an area.")]
    CollinearPoints {
        /// Kind of the modification.
        kind: String,
        /// Number of points given.
        count: usize,
    },
    /// A grid or cloud refers to a file that can't be had.
    #[error("{kind}: file is {file:?}, allowed: a readable file ({reason})")]
    #[finding(code = "file-unavailable")]
    #[way_out("Put {file:?} where the job file expects it, or write the numbers into the job file.")]
    FileUnavailable {
        /// Kind of the modification.
        kind: String,
        /// The file's name as written.
        file: String,
        /// Why it can't be had.
        reason: String,
    },
    /// The modification has no value at a point where one is needed.
    #[error(transparent)]
    #[finding(transparent)]
    Evaluation(#[from] EvaluationError),
}

/// A point at which a modification has no value. Small, because it travels through the innermost loops.
#[derive(Clone, Copy, Debug, PartialEq, Error, Finding)]
pub enum EvaluationError {
    /// The point lies outside the convex hull of a point cloud.
    #[error("the point w = {w} mm, z = {z} mm is outside the point cloud, allowed: points within its hull")]
    #[finding(code = "outside-point-cloud")]
    #[way_out("Extend the cloud beyond the evaluation field, or narrow the field to what was measured.")]
    OutsidePointCloud {
        /// Length of roll, mm.
        w: f64,
        /// Face position as the cloud sees it, mm.
        z: f64,
    },
    /// The point lies where the circle of an arc-shaped crowning has ended.
    #[error(
        "the point w = {w} mm, z = {z} mm is {distance} mm from the middle of an arc, allowed: at most its radius {radius} mm"
    )]
    #[finding(code = "beyond-arc")]
    #[way_out("Use the parabolic crowning, which continues without end.")]
    BeyondArc {
        /// Length of roll, mm.
        w: f64,
        /// Face position, mm.
        z: f64,
        /// Distance from the apex, mm.
        distance: f64,
        /// Radius of the arc, mm.
        radius: f64,
    },
    /// The value or a derivative is larger than a number can hold, or the point itself is not finite.
    #[error(
        "the modification at w = {w} mm, z = {z} mm is not a finite number, allowed: points near the evaluation field"
    )]
    #[finding(code = "amount-not-finite")]
    #[way_out("Evaluate nearer to the evaluation field or lower the polynomial's degree.")]
    NotFinite {
        /// Length of roll, mm.
        w: f64,
        /// Face position, mm.
        z: f64,
    },
}
