//! Errors of planning generating grinding (spec 28 section 7).

use crate::contact::ContactError;
use crate::geometry::{Flank, GeometryError};
use crate::modification::{EvaluationError, ModificationError};
use crate::numerics::SplineError;
use crate::process::dressing::DressingError;
use thiserror::Error;

/// What can go wrong while planning. Lengths mm.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum GeneratingError {
    /// A body is impossible.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// A modification is impossible.
    #[error(transparent)]
    Modification(#[from] ModificationError),
    /// Worm and workpiece do not touch as they should.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// Dresser and worm do not touch as they should.
    #[error(transparent)]
    Dressing(#[from] DressingError),
    /// The worm is too narrow for the modified area.
    #[error(
        "the plan needs {needed:.2} mm of worm width, the worm has {width:.2} mm (diagonal ratio {ratio:.4})"
    )]
    WormTooShort {
        /// Width needed, run-in and run-out included.
        needed: f64,
        /// Width there is.
        width: f64,
        /// Diagonal ratio.
        ratio: f64,
    },
    /// A dressing or grinding axis leaves its range.
    #[error("axis {axis} needs {value:.4} {unit}, its limit is {limit:.4} {unit}")]
    AxisLimit {
        /// Axis.
        axis: &'static str,
        /// Value needed.
        value: f64,
        /// Limit.
        limit: f64,
        /// Unit of both.
        unit: &'static str,
    },
    /// The direction of the worm lines runs along the contact path.
    #[error(
        "diagonal ratio {ratio} leaves no line on the {flank} worm flank that could carry the modification"
    )]
    DegenerateDirection {
        /// Flank.
        flank: Flank,
        /// Diagonal ratio.
        ratio: f64,
    },
    /// The envelope of the plan folds too nearly.
    #[error(
        "the envelope of the {flank} flank nearly folds (determinant ratio {ratio:.3}, allowed from {limit})"
    )]
    EnvelopeBroken {
        /// Flank.
        flank: Flank,
        /// Least determinant ratio.
        ratio: f64,
        /// Least allowed.
        limit: f64,
    },
    /// The class of modifications cannot make the target within its tolerance even on an ideal worm.
    #[error(
        "diagonal ratio {ratio:.4} misses the target by {error_um:.3} um on an ideal worm; allowed: {allowed_um:.3} um"
    )]
    ModelError {
        /// Diagonal ratio.
        ratio: f64,
        /// Largest error, um.
        error_um: f64,
        /// Allowed, um.
        allowed_um: f64,
    },
    /// No flank is to be ground.
    #[error("no flank is to be ground")]
    NoFlank,
    /// A target has no finite value somewhere.
    #[error("the target has no finite amount at w = {w} mm, z = {z} mm")]
    AmountNotFinite {
        /// Length of roll.
        w: f64,
        /// Face position.
        z: f64,
    },
    /// A tolerance by which deviations are weighed is no positive number.
    #[error("the tolerance {value} mm at w = {w} mm, z = {z} mm is no positive number")]
    ToleranceNotPositive {
        /// Length of roll.
        w: f64,
        /// Face position.
        z: f64,
        /// Tolerance given, mm.
        value: f64,
    },
    /// Fewer samples than functions to be found.
    #[error("{points} points do not determine a decomposition, at least {needed} are needed")]
    TooFewPoints {
        /// Points given.
        points: usize,
        /// Points needed.
        needed: usize,
    },
    /// All samples lie on one line of a coordinate.
    #[error("all points have the same {coordinate} = {value} mm: nothing can be fitted along it")]
    NoExtent {
        /// Coordinate.
        coordinate: &'static str,
        /// Its value.
        value: f64,
    },
    /// The lines of a diagonal ratio have no coordinate somewhere.
    #[error("the dressed lines or contact paths have no finite coordinate at w = {w} mm, z = {z} mm")]
    CoordinateNotFinite {
        /// Length of roll.
        w: f64,
        /// Face position.
        z: f64,
    },
    /// The lines on the workpiece run along the contact paths, or along the profile (diagonal ratio 0).
    #[error("lines of direction tan(rho_2) = {t} cannot be told from the contact paths, tan(rho_K) = {t_k}")]
    DirectionAlongPath {
        /// tan(rho_2).
        t: f64,
        /// tan(rho_K).
        t_k: f64,
    },
    /// The splines of a decomposition are impossible.
    #[error("splines of the decomposition: {0}")]
    InvalidSpline(SplineError),
    /// A range of diagonal ratios or directions is impossible.
    #[error("a scan of {count} values from {least} to {most} is impossible")]
    InvalidScan {
        /// Lower end.
        least: f64,
        /// Upper end.
        most: f64,
        /// Number of values.
        count: usize,
    },
    /// A fit did not converge.
    #[error("a fit of {coefficients} coefficients did not converge")]
    FitNotSolved {
        /// Coefficients.
        coefficients: usize,
    },
}

impl From<EvaluationError> for GeneratingError {
    fn from(error: EvaluationError) -> Self {
        Self::Modification(ModificationError::Evaluation(error))
    }
}

impl GeneratingError {
    /// Stable kebab-case code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Geometry(e) => e.code(),
            Self::Modification(e) => e.code(),
            Self::Contact(e) => e.code(),
            Self::Dressing(e) => e.code(),
            Self::WormTooShort { .. } => "worm-too-short",
            Self::AxisLimit { .. } => "axis-limit",
            Self::DegenerateDirection { .. } => "degenerate-direction",
            Self::EnvelopeBroken { .. } => "envelope-broken",
            Self::ModelError { .. } => "model-error",
            Self::NoFlank => "no-flank",
            Self::AmountNotFinite { .. } => "amount-not-finite",
            Self::ToleranceNotPositive { .. } => "tolerance-not-positive",
            Self::TooFewPoints { .. } => "too-few-points",
            Self::NoExtent { .. } => "no-extent",
            Self::CoordinateNotFinite { .. } => "coordinate-not-finite",
            Self::DirectionAlongPath { .. } => "degenerate-direction",
            Self::InvalidSpline(_) => "invalid-spline",
            Self::InvalidScan { .. } => "invalid-scan",
            Self::FitNotSolved { .. } => "fit-not-solved",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> String {
        match self {
            Self::Geometry(e) => e.way_out().to_string(),
            Self::Modification(e) => e.way_out().to_string(),
            Self::Contact(e) => e.way_out().to_string(),
            Self::Dressing(e) => e.way_out().to_string(),
            Self::WormTooShort { .. } => {
                "take a wider worm, a diagonal ratio of smaller magnitude, or put the profile crowning into the diagonal"
                    .into()
            }
            Self::AxisLimit { .. } => {
                "reduce the amount, choose another diagonal ratio, a worm with more threads, or the dresser for the profile crowning"
                    .into()
            }
            Self::DegenerateDirection { .. } => "choose another diagonal ratio".into(),
            Self::EnvelopeBroken { .. } => "reduce the amount or choose another diagonal ratio".into(),
            Self::ModelError { .. } => "choose another diagonal ratio or widen the tolerance".into(),
            Self::NoFlank => "set grinding.flanks to \"both\", \"left\" or \"right\"".into(),
            Self::AmountNotFinite { .. } => "give finite amounts on the whole evaluation field".into(),
            Self::ToleranceNotPositive { .. } => "give tolerances above 0 mm at every point".into(),
            Self::TooFewPoints { .. } => "give more points, or take fewer functions or fewer intervals".into(),
            Self::NoExtent { .. } => "spread the points over the flank, or leave out the functions of that coordinate".into(),
            Self::CoordinateNotFinite { .. } => "let the ratio law cover the whole flank".into(),
            Self::DirectionAlongPath { .. } => {
                "choose another direction, or the functions P and K alone for diagonal ratio 0".into()
            }
            Self::InvalidSpline(_) => "take at least one interval, degree 1 and finite kinks".into(),
            Self::InvalidScan { .. } => {
                "give a range above 0 with its lower end first, finite values and at least two of them".into()
            }
            Self::FitNotSolved { .. } => {
                "let tolerances differ by fewer orders of magnitude, or take fewer intervals".into()
            }
        }
    }

    /// Whether the input itself is wrong (exit 2) rather than the target out of reach of these bodies (exit 4).
    pub fn is_bad_input(&self) -> bool {
        match self {
            Self::Geometry(_) | Self::Modification(_) | Self::NoFlank => true,
            Self::Contact(e) => !matches!(
                e,
                ContactError::Undercut { .. }
                    | ContactError::WormSurfaceMissing { .. }
                    | ContactError::NoStart { .. }
                    | ContactError::ContactBelowBase { .. }
            ),
            Self::Dressing(e) => matches!(
                e,
                DressingError::Geometry(_)
                    | DressingError::InvalidNumber { .. }
                    | DressingError::ConditionCount { .. }
            ),
            Self::DegenerateDirection { .. }
            | Self::AmountNotFinite { .. }
            | Self::ToleranceNotPositive { .. }
            | Self::TooFewPoints { .. }
            | Self::NoExtent { .. }
            | Self::CoordinateNotFinite { .. }
            | Self::DirectionAlongPath { .. }
            | Self::InvalidSpline(_)
            | Self::InvalidScan { .. } => true,
            _ => false,
        }
    }
}
