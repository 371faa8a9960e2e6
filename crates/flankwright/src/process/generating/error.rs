//! Errors of planning generating grinding (spec 28 section 7).

use crate::contact::ContactError;
use crate::geometry::{Flank, GeometryError};
use crate::modification::{EvaluationError, ModificationError};
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
    /// A dresser is asked for a tool that has none.
    #[error("the tool is not dressed")]
    NotDressed,
    /// A disc dresser moves along a cylinder.
    #[error("a conical worm (cone angle {cone_angle_deg} deg) is not dressed by a disc")]
    ConicalWormNotDressed {
        /// Cone angle of the worm, degrees.
        cone_angle_deg: f64,
    },
    /// The part of the tool's flank that the plan needs lies below its base circle.
    #[error("the tool's flank is needed down to length of roll {w_1:.4} mm on the {flank} flank, below its base circle")]
    ToolBelowBase {
        /// Flank.
        flank: Flank,
        /// Least length of roll needed, mm.
        w_1: f64,
    },
    /// The modification of the tool has no value where the plan needs it.
    #[error("the {flank} flank of the tool has no modification at length of roll {w_1:.4} mm, z = {z_1:.4} mm")]
    ToolUndefined {
        /// Flank.
        flank: Flank,
        /// Length of roll on the tool, mm.
        w_1: f64,
        /// Position on the tool, mm.
        z_1: f64,
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
            Self::NotDressed => "not-dressed",
            Self::ConicalWormNotDressed { .. } => "conical-worm-not-dressed",
            Self::ToolBelowBase { .. } => "worm-below-base",
            Self::ToolUndefined { .. } => "worm-surface-missing",
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
            Self::NotDressed => "set worm.tool = \"dressed\" and describe the [dresser]".into(),
            Self::ConicalWormNotDressed { .. } => {
                "set worm.tool = \"made\" and leave [dresser] out: the plan then gives the flank of the worm".into()
            }
            Self::ToolBelowBase { .. } => {
                "take a tool of larger diameter, fewer threads, or a smaller root form range of the gear".into()
            }
            Self::ToolUndefined { .. } => {
                "let the table of the tool or of the target reach further, or use a kind that continues".into()
            }
            Self::NoFlank => "set grinding.flanks to \"both\", \"left\" or \"right\"".into(),
        }
    }

    /// Whether the input itself is wrong (exit 2) rather than the target out of reach of these bodies (exit 4).
    pub fn is_bad_input(&self) -> bool {
        match self {
            Self::Geometry(_)
            | Self::Modification(_)
            | Self::NoFlank
            | Self::NotDressed
            | Self::ConicalWormNotDressed { .. }
            | Self::ToolUndefined { .. } => true,
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
            Self::DegenerateDirection { .. } => true,
            _ => false,
        }
    }
}
