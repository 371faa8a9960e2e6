//! Errors of contact (`docs/mathematics/generating-contact.md`), each with its data, a stable code and a way out.

use foundation::geometry::{Flank, GeometryError};
use thiserror::Error;

/// det J / det J_0 below which the envelope counts as folding. A search that ends above it has failed for another reason.
pub const FOLD_BEGINS: f64 = 0.3;

/// What can go wrong between worm and workpiece. Lengths mm.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ContactError {
    /// A body is impossible by itself.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// Internal gears cannot be ground by a worm here.
    #[error("an internal gear ({teeth} teeth) cannot be ground by a worm")]
    InternalUnsupported {
        /// Number of teeth.
        teeth: i32,
    },
    /// The axes are parallel.
    #[error("the axes of worm and workpiece are parallel (crossed-axes angle {angle_deg} deg)")]
    AxesParallel {
        /// gamma in degrees.
        angle_deg: f64,
    },
    /// No direction is normal to both flanks.
    #[error(
        "worm and workpiece have no common normal on the {flank} flank at crossed-axes angle {angle_deg} deg"
    )]
    NoCommonNormal {
        /// Flank concerned.
        flank: Flank,
        /// gamma in degrees.
        angle_deg: f64,
    },
    /// With a conical body both flanks need the same rack.
    #[error("the flanks mesh on different racks (helix angles {left_deg} and {right_deg} deg)")]
    RacksNotCongruent {
        /// beta_w1 of the left flank, degrees.
        left_deg: f64,
        /// beta_w1 of the right flank, degrees.
        right_deg: f64,
    },
    /// The contact would lie below a base circle.
    #[error(
        "the contact for length of roll {w_2} mm needs length of roll {w_1} mm on the worm, below its base circle"
    )]
    ContactBelowBase {
        /// Length of roll on the workpiece.
        w_2: f64,
        /// Length of roll on the worm.
        w_1: f64,
    },
    /// The evaluation range of the workpiece would need a worm flank below its base circle.
    #[error("the range needs length of roll {w_1} mm on the worm, below its base circle")]
    WormBelowBase {
        /// Smallest length of roll needed on the worm.
        w_1: f64,
    },
    /// The direction of a modification runs along the contact path.
    #[error(
        "direction {direction_deg} deg runs along the contact path: the worm has no line of its own for it"
    )]
    DirectionIsContactPath {
        /// Direction rho, degrees.
        direction_deg: f64,
    },
    /// The direction is that of the profile: the diagonal ratio is not determined.
    #[error(
        "direction {direction_deg} deg is a profile direction: the diagonal ratio is not determined by it"
    )]
    DirectionIsProfile {
        /// Direction rho, degrees.
        direction_deg: f64,
    },
    /// The wanted direction needs an infinite diagonal ratio.
    #[error("direction {direction_deg} deg needs an infinite diagonal ratio")]
    DiagonalRatioInfinite {
        /// Direction rho_2, degrees.
        direction_deg: f64,
    },
    /// The feed does not move the contact over the flank.
    #[error("at diagonal ratio {ratio} the feed does not move the contact over the flank")]
    FeedDoesNotMoveContact {
        /// Diagonal ratio.
        ratio: f64,
    },
    /// The tool envelope folds: no flank is left at this point.
    #[error(
        "the envelope of the worm folds on the {flank} flank at length of roll {w:.4} mm, z = {z:.4} mm (determinant ratio {ratio:.3}): the worm would gouge the flank there"
    )]
    Undercut {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll.
        w: f64,
        /// Axial position.
        z: f64,
        /// det J / det J_0 reached.
        ratio: f64,
    },
    /// The search for the contact ends although the envelope is far from a fold.
    #[error(
        "the contact that grinds the {flank} flank at length of roll {w:.4} mm, z = {z:.4} mm was not found: the search does not settle, although the envelope is far from folding there (determinant ratio {ratio:.3}, a fold begins below {FOLD_BEGINS})"
    )]
    NotSettled {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll.
        w: f64,
        /// Axial position.
        z: f64,
        /// det J / det J_0 where the search ended.
        ratio: f64,
    },
    /// The unmodified contact does not exist at this point.
    #[error("no contact of worm and workpiece at length of roll {w:.4} mm, z = {z:.4} mm")]
    NoStart {
        /// Length of roll.
        w: f64,
        /// Axial position.
        z: f64,
    },
    /// The tool surface does not reach as far as the contact needs.
    #[error(
        "the contact leaves the part of the worm's flank that is made, at its parameters ({p:.4}, {q:.4})"
    )]
    WormSurfaceMissing {
        /// First surface parameter.
        p: f64,
        /// Second surface parameter.
        q: f64,
    },
    /// The tool surface has a point and a normal but no finite derivatives.
    #[error("the worm surface has no curvature at its parameters ({p:.4}, {q:.4}): an edge or a kink")]
    NotSmooth {
        /// First surface parameter.
        p: f64,
        /// Second surface parameter.
        q: f64,
    },
    /// The edge of the worm cannot be that round.
    #[error("a corner radius of {radius} mm does not fit on the worm: below {most:.4} mm it would")]
    CornerTooLarge {
        /// Radius wanted, mm.
        radius: f64,
        /// Distance of tip and base cylinder of the worm, mm.
        most: f64,
    },
    /// The edge of the worm leaves no envelope in the tooth space.
    #[error("the edge of the worm on its {flank} flank leaves no root fillet at z = {z:.4} mm")]
    NoRootFillet {
        /// Flank concerned.
        flank: Flank,
        /// Axial position on the gear.
        z: f64,
    },
    /// Two gears that are rolled against each other never face each other with these flanks.
    #[error("the {flank} flanks of both gears never come together")]
    FlanksDoNotMesh {
        /// Flank concerned.
        flank: Flank,
    },
    /// A number that is not usable.
    #[error("{field} = {value} is not usable; allowed: {allowed}")]
    InvalidNumber {
        /// Name of the quantity.
        field: &'static str,
        /// Its value.
        value: f64,
        /// Allowed range in words.
        allowed: &'static str,
    },
}

impl ContactError {
    /// Stable kebab-case code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Geometry(e) => e.code(),
            Self::InternalUnsupported { .. } => "internal-unsupported",
            Self::AxesParallel { .. } => "axes-parallel",
            Self::NoCommonNormal { .. } => "no-common-normal",
            Self::RacksNotCongruent { .. } => "racks-not-congruent",
            Self::ContactBelowBase { .. } => "contact-below-base",
            Self::WormBelowBase { .. } => "worm-below-base",
            Self::DirectionIsContactPath { .. } => "direction-is-contact-path",
            Self::DirectionIsProfile { .. } => "direction-is-profile",
            Self::DiagonalRatioInfinite { .. } => "diagonal-ratio-infinite",
            Self::FeedDoesNotMoveContact { .. } => "feed-does-not-move-contact",
            Self::Undercut { .. } => "undercut",
            Self::NotSettled { .. } => "contact-not-found",
            Self::NoStart { .. } => "no-start",
            Self::WormSurfaceMissing { .. } => "worm-surface-missing",
            Self::NotSmooth { .. } => "not-smooth",
            Self::CornerTooLarge { .. } => "corner-radius-too-large",
            Self::NoRootFillet { .. } => "no-root-fillet",
            Self::FlanksDoNotMesh { .. } => "flanks-do-not-mesh",
            Self::InvalidNumber { .. } => "invalid-number",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::Geometry(e) => e.way_out(),
            Self::InternalUnsupported { .. } => {
                "worm grinding is for external gears; for a ring gear see the process \"five-axis-milling\""
            }
            Self::AxesParallel { .. } | Self::NoCommonNormal { .. } => {
                "change the worm's helix (threads, diameter, hand)"
            }
            Self::RacksNotCongruent { .. } => {
                "grind the flanks one by one or use the design crossed-axes angle"
            }
            Self::ContactBelowBase { .. } | Self::WormBelowBase { .. } | Self::NoStart { .. } => {
                "raise the form diameter of the gear or use a larger worm"
            }
            Self::DirectionIsContactPath { .. } => {
                "let the grinding motion make this part of the modification"
            }
            Self::DirectionIsProfile { .. } => "let the dresser profile make this part of the modification",
            Self::DiagonalRatioInfinite { .. } | Self::FeedDoesNotMoveContact { .. } => {
                "choose another direction or ratio"
            }
            Self::Undercut { .. } => "reduce the amount of the modification, or spread it over a longer way",
            Self::NotSettled { .. } => {
                "round the kinks of reliefs, or take smaller amounts; that the flank cannot be made is not shown"
            }
            Self::WormSurfaceMissing { .. } => {
                "reduce the amount of the modification; how far the worm is dressed is a limit of the planner"
            }
            Self::NotSmooth { .. } => {
                "round the modification's kink with a transition or split the field there"
            }
            Self::CornerTooLarge { .. } | Self::NoRootFillet { .. } => {
                "give a smaller corner radius, or a larger root diameter of the gear"
            }
            Self::FlanksDoNotMesh { .. } => "compare teeth, cone angles and shaft angle of both gears",
            Self::InvalidNumber { .. } => "give a value inside the allowed range",
        }
    }
}
