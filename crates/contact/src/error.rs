//! Errors of contact (`docs/mathematics/generating-contact.md`), each with its data, a stable code and a way out.

use finding::Finding;
use foundation::geometry::{Flank, GeometryError};
use thiserror::Error;

/// det J / det J_0 below which the envelope counts as folding. A search that ends above it has failed for another reason.
pub const FOLD_BEGINS: f64 = 0.3;

/// What can go wrong between worm and workpiece. Lengths mm.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum ContactError {
    /// A body is impossible by itself.
    #[error(transparent)]
    #[finding(transparent)]
    Geometry(#[from] GeometryError),
    /// Internal gears cannot be ground by a worm here.
    #[error("an internal gear ({teeth} teeth) cannot be ground by a worm")]
    #[finding(code = "internal-unsupported")]
    #[way_out("worm grinding is for external gears; for a ring gear see the process \"five-axis-milling\"")]
    InternalUnsupported {
        /// Number of teeth.
        teeth: i32,
    },
    /// The axes are parallel.
    #[error("the axes of worm and workpiece are parallel (crossed-axes angle {angle_deg} deg)")]
    #[finding(code = "axes-parallel")]
    #[way_out("change the worm's helix (threads, diameter, hand)")]
    AxesParallel {
        /// gamma in degrees.
        angle_deg: f64,
    },
    /// No direction is normal to both flanks.
    #[error(
        "worm and workpiece have no common normal on the {flank} flank at crossed-axes angle {angle_deg} deg"
    )]
    #[finding(code = "no-common-normal")]
    #[way_out("change the worm's helix (threads, diameter, hand)")]
    NoCommonNormal {
        /// Flank concerned.
        flank: Flank,
        /// gamma in degrees.
        angle_deg: f64,
    },
    /// With a conical body both flanks need the same rack.
    #[error("the flanks mesh on different racks (helix angles {left_deg} and {right_deg} deg)")]
    #[finding(code = "racks-not-congruent")]
    #[way_out("grind the flanks one by one or use the design crossed-axes angle")]
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
    #[finding(code = "contact-below-base")]
    #[way_out("raise the form diameter of the gear or use a larger worm")]
    ContactBelowBase {
        /// Length of roll on the workpiece.
        w_2: f64,
        /// Length of roll on the worm.
        w_1: f64,
    },
    /// The evaluation range of the workpiece would need a worm flank below its base circle.
    #[error("the range needs length of roll {w_1} mm on the worm, below its base circle")]
    #[finding(code = "worm-below-base")]
    #[way_out("raise the form diameter of the gear or use a larger worm")]
    WormBelowBase {
        /// Smallest length of roll needed on the worm.
        w_1: f64,
    },
    /// The direction of a modification runs along the contact path.
    #[error(
        "direction {direction_deg} deg runs along the contact path: the worm has no line of its own for it"
    )]
    #[finding(code = "direction-is-contact-path")]
    #[way_out("let the grinding motion make this part of the modification")]
    DirectionIsContactPath {
        /// Direction rho, degrees.
        direction_deg: f64,
    },
    /// The direction is that of the profile: the diagonal ratio is not determined.
    #[error(
        "direction {direction_deg} deg is a profile direction: the diagonal ratio is not determined by it"
    )]
    #[finding(code = "direction-is-profile")]
    #[way_out("let the dresser profile make this part of the modification")]
    DirectionIsProfile {
        /// Direction rho, degrees.
        direction_deg: f64,
    },
    /// The wanted direction needs an infinite diagonal ratio.
    #[error("direction {direction_deg} deg needs an infinite diagonal ratio")]
    #[finding(code = "diagonal-ratio-infinite")]
    #[way_out("choose another direction or ratio")]
    DiagonalRatioInfinite {
        /// Direction rho_2, degrees.
        direction_deg: f64,
    },
    /// The feed does not move the contact over the flank.
    #[error("at diagonal ratio {ratio} the feed does not move the contact over the flank")]
    #[finding(code = "feed-does-not-move-contact")]
    #[way_out("choose another direction or ratio")]
    FeedDoesNotMoveContact {
        /// Diagonal ratio.
        ratio: f64,
    },
    /// The tool envelope folds: no flank is left at this point.
    #[error(
        "the envelope of the worm folds on the {flank} flank at length of roll {w:.4} mm, z = {z:.4} mm (determinant ratio {ratio:.3}): the worm would gouge the flank there"
    )]
    #[finding(code = "undercut")]
    #[way_out("reduce the amount of the modification, or spread it over a longer way")]
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
    #[finding(code = "contact-not-found")]
    #[way_out(
        "round the kinks of reliefs, or take smaller amounts; that the flank cannot be made is not shown"
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
    #[finding(code = "no-start")]
    #[way_out("raise the form diameter of the gear or use a larger worm")]
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
    #[finding(code = "worm-surface-missing")]
    #[way_out("reduce the amount of the modification; how far the worm is dressed is a limit of the planner")]
    WormSurfaceMissing {
        /// First surface parameter.
        p: f64,
        /// Second surface parameter.
        q: f64,
    },
    /// The tool surface has a point and a normal but no finite derivatives.
    #[error("the worm surface has no curvature at its parameters ({p:.4}, {q:.4}): an edge or a kink")]
    #[finding(code = "not-smooth")]
    #[way_out("round the modification's kink with a transition or split the field there")]
    NotSmooth {
        /// First surface parameter.
        p: f64,
        /// Second surface parameter.
        q: f64,
    },
    /// The edge of the worm cannot be that round.
    #[error("a corner radius of {radius} mm does not fit on the worm: below {most:.4} mm it would")]
    #[finding(code = "corner-radius-too-large")]
    #[way_out("give a smaller corner radius, or a larger root diameter of the gear")]
    CornerTooLarge {
        /// Radius wanted, mm.
        radius: f64,
        /// Distance of tip and base cylinder of the worm, mm.
        most: f64,
    },
    /// The edge of the worm leaves no envelope in the tooth space.
    #[error("the edge of the worm on its {flank} flank leaves no root fillet at z = {z:.4} mm")]
    #[finding(code = "no-root-fillet")]
    #[way_out("give a smaller corner radius, or a larger root diameter of the gear")]
    NoRootFillet {
        /// Flank concerned.
        flank: Flank,
        /// Axial position on the gear.
        z: f64,
    },
    /// Two gears that are rolled against each other never face each other with these flanks.
    #[error("the {flank} flanks of both gears never come together")]
    #[finding(code = "flanks-do-not-mesh")]
    #[way_out("compare teeth, cone angles and shaft angle of both gears")]
    FlanksDoNotMesh {
        /// Flank concerned.
        flank: Flank,
    },
    /// A number that is not usable.
    #[error("{field} = {value} is not usable; allowed: {allowed}")]
    #[finding(code = "invalid-number")]
    #[way_out("give a value inside the allowed range")]
    InvalidNumber {
        /// Name of the quantity.
        field: &'static str,
        /// Its value.
        value: f64,
        /// Allowed range in words.
        allowed: &'static str,
    },
}
