//! Errors of planning generating grinding (`docs/mathematics/planning.md#limits`).

use super::areas::{FeedInterval, SharedLines};
use contact::ContactError;
use dressing::DressingError;
use finding::Finding;
use foundation::geometry::{Flank, GeometryError};
use foundation::kinematics::LawError;
use foundation::modification::{EvaluationError, ModificationError};
use foundation::numerics::SplineError;
use std::borrow::Cow;
use thiserror::Error;

/// What can go wrong while planning. Lengths mm.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum GeneratingError {
    /// A body is impossible.
    #[error(transparent)]
    #[finding(transparent, bad_input)]
    Geometry(#[from] GeometryError),
    /// A modification is impossible.
    #[error(transparent)]
    #[finding(transparent, bad_input)]
    Modification(#[from] ModificationError),
    /// Worm and workpiece do not touch as they should.
    #[error(transparent)]
    #[finding(transparent, bad_input = contact_is_bad_input(_0))]
    Contact(#[from] ContactError),
    /// Dresser and worm do not touch as they should.
    #[error(transparent)]
    #[finding(transparent, bad_input = dressing_is_bad_input(_0))]
    Dressing(#[from] DressingError),
    /// A stroke of dressing cannot be made.
    #[error("stroke {number} of the dressing: {error}")]
    #[finding(transparent = error, bad_input = dressing_is_bad_input(error))]
    #[way_out(with = beside_stroke(error))]
    Stroke {
        /// Which, from 1.
        number: usize,
        /// Why.
        error: DressingError,
    },
    /// The worm is too narrow for the modified area.
    #[error(
        "the plan needs {needed:.2} mm of worm width, the worm has {width:.2} mm (diagonal ratio {ratio:.4})"
    )]
    #[finding(code = "worm-too-short")]
    #[way_out(
        "take a wider worm, a diagonal ratio of smaller magnitude, or put the profile crowning into the diagonal"
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
    #[error(
        "{} by {value:.4} {unit}; planning takes at most {limit:.4} {unit} on its own",
        correction_in_words(axis)
    )]
    #[finding(code = "axis-limit")]
    #[way_out(
        "that limit is one of planning, not of the machine: grinding.axis_limits.{} sets another, and a number as diagonal_ratio is not bound by it; or reduce the amount, or take a worm with more threads",
        limit_key(axis)
    )]
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
    #[finding(code = "degenerate-direction", bad_input)]
    #[way_out("choose another diagonal ratio")]
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
    #[finding(code = "envelope-broken")]
    #[way_out("reduce the amount or choose another diagonal_ratio")]
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
    #[finding(code = "model-error")]
    #[way_out("choose another diagonal_ratio or widen the tolerance")]
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
    #[finding(code = "no-flank", bad_input)]
    #[way_out("set grinding.flanks to \"both\", \"left\" or \"right\"")]
    NoFlank,
    /// The dresser cuts into the flank across the thread space while it dresses one.
    #[error("the dresser cuts into the {} flank while it dresses the {flank} one: {}", flank.other(), lands(*land, *largest))]
    #[finding(code = "counter-flank-cut")]
    #[way_out(with = narrower_land(*largest))]
    CounterFlankCut {
        /// Flank that is dressed.
        flank: Flank,
        /// Width of the tip land, mm; `None` where none is given.
        land: Option<f64>,
        /// Widest land that clears the other flank, mm; `None` where none does.
        largest: Option<f64>,
    },
    /// The root of the gear shall be a cylinder, but one place of the worm grinds all of it.
    #[error(
        "at diagonal ratio {ratio} the tip of the worm cannot follow the centre distance: the root of the gear is no cylinder"
    )]
    #[finding(code = "root-needs-shift")]
    #[way_out("choose a diagonal ratio other than 0 and constant, or dressing.gear_root.along = \"follows\"")]
    RootNeedsShift {
        /// Diagonal ratio, or its value in the middle of the feed.
        ratio: f64,
    },
    /// The edge of the worm undercuts the flank.
    #[error("the worm's edge undercuts the {flank} flank: its root fillet at z = {z:.3} mm has a notch")]
    #[finding(code = "root-notched")]
    #[way_out("give a smaller corner radius, a larger root diameter, or a larger form diameter of the gear")]
    RootNotched {
        /// Flank concerned.
        flank: Flank,
        /// Axial position on the gear, mm.
        z: f64,
    },
    /// The root fillet begins above the root form diameter.
    #[error(
        "the root fillet of the {flank} flank begins at diameter {ground:.4} mm, above the root form diameter {form} mm"
    )]
    #[finding(code = "root-reaches-flank")]
    #[way_out("give a smaller corner radius, a larger root diameter, or a larger form diameter of the gear")]
    RootReachesFlank {
        /// Flank concerned.
        flank: Flank,
        /// Diameter at which it begins, mm.
        ground: f64,
        /// Root form diameter of the gear, mm.
        form: f64,
    },
    /// The root fillet is sharper than wanted.
    #[error(
        "the root fillet of the {flank} flank has a radius of {least:.4} mm at its sharpest, less than {wanted} mm"
    )]
    #[finding(code = "root-too-sharp")]
    #[way_out("give a larger corner radius, or accept a sharper fillet")]
    RootTooSharp {
        /// Flank concerned.
        flank: Flank,
        /// Least radius of curvature, mm.
        least: f64,
        /// Least one wanted, mm.
        wanted: f64,
    },
    /// The referee's rays do not end on the planned root fillet.
    #[error(
        "the simulation does not confirm the root fillet of the {flank} flank at z = {z:.3} mm: {}",
        difference.map_or_else(|| "nothing is cut there".to_owned(), |d| format!("it differs by {:.3} um", d * 1e3))
    )]
    #[finding(code = "root-not-confirmed")]
    #[way_out("give another corner radius, or leave dressing.gear_root out")]
    RootNotConfirmed {
        /// Flank concerned.
        flank: Flank,
        /// Axial position on the gear, mm.
        z: f64,
        /// What is left over the planned fillet, mm; `None` where nothing is cut.
        difference: Option<f64>,
    },
    /// A dresser is asked for a tool that has none.
    #[error("the tool is not dressed")]
    #[finding(code = "not-dressed", bad_input)]
    #[way_out("set worm.tool = \"dressed\" and describe the [dresser]")]
    NotDressed,
    /// The profile that a dresser of a conical worm needs depends on the worm's width.
    #[error(
        "the dresser of a conical worm (cone angle {cone_angle_deg} deg) serves the rolls of its whole width, which is not given"
    )]
    #[finding(code = "conical-worm-without-width", bad_input)]
    #[way_out("give the usable width of the worm as worm.width, in mm")]
    ConicalWormWithoutWidth {
        /// Cone angle of the worm, degrees.
        cone_angle_deg: f64,
    },
    /// The part of the tool's flank that the plan needs lies below its base circle.
    #[error(
        "the tool's flank is needed down to length of roll {w_1:.4} mm on the {flank} flank, below its base circle"
    )]
    #[finding(code = "worm-below-base")]
    #[way_out("take a tool of larger diameter, fewer threads, or a smaller root form range of the gear")]
    ToolBelowBase {
        /// Flank.
        flank: Flank,
        /// Least length of roll needed, mm.
        w_1: f64,
    },
    /// The modification of the tool has no value where the plan needs it.
    #[error(
        "the {flank} flank of the tool has no modification at length of roll {w_1:.4} mm, z = {z_1:.4} mm"
    )]
    #[finding(code = "worm-surface-missing", bad_input)]
    #[way_out("let the table of the tool or of the target reach further, or use a kind that continues")]
    ToolUndefined {
        /// Flank.
        flank: Flank,
        /// Length of roll on the tool, mm.
        w_1: f64,
        /// Position on the tool, mm.
        z_1: f64,
    },
    /// A motion law or its inverse cannot be built or asked there.
    #[error(transparent)]
    #[finding(transparent, bad_input)]
    Law(LawError),
    /// A number that has no sense here.
    #[error("{field} = {value}; allowed: {allowed}")]
    #[finding(code = "invalid-number", bad_input)]
    #[way_out("give a value inside the allowed range")]
    InvalidNumber {
        /// Quantity.
        field: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// The dressed lines run along the contact path of the worm.
    #[error("worm lines at {direction_deg:.4} deg run along the contact path of the {flank} worm flank")]
    #[finding(code = "worm-direction-degenerate", bad_input)]
    #[way_out("dress the worm along other lines, for example in its axial plane")]
    WormDirectionDegenerate {
        /// Flank.
        flank: Flank,
        /// rho_1, degree.
        direction_deg: f64,
    },
    /// A wanted curve does not reach over the whole flank.
    #[error(
        "the wanted curve gives the tool shift of the {flank} flank for feeds {:.3} .. {:.3} mm, the flank needs {:.3} .. {:.3} mm",
        covered[0], covered[1], needed[0], needed[1]
    )]
    #[finding(code = "range-not-covered", bad_input)]
    #[way_out("continue the curve further beyond the ends of the profile")]
    RangeNotCovered {
        /// Flank.
        flank: Flank,
        /// Feeds that the curve gives a shift for, mm.
        covered: [f64; 2],
        /// Feeds at the corners of the field, mm.
        needed: [f64; 2],
    },
    /// A wanted curve touches a contact path.
    #[error(
        "the wanted curve on the {flank} flank runs along the contact path or turns against it at w = {w:.4} mm"
    )]
    #[finding(code = "curve-not-a-function", bad_input)]
    #[way_out("take a curve that crosses the contact paths everywhere in the same sense")]
    CurveNotAFunction {
        /// Flank.
        flank: Flank,
        /// Length of roll, mm.
        w: f64,
    },
    /// A region is no polygon on its flank.
    #[error("region {region} on the {flank} flank: {reason}")]
    #[finding(code = "invalid-region", bad_input)]
    #[way_out("give at least three corners on the evaluated flank")]
    InvalidRegion {
        /// Index of the region.
        region: usize,
        /// Flank.
        flank: Flank,
        /// What is wrong.
        reason: &'static str,
    },
    /// Two regions with different diagonal ratios are ground at the same feed.
    #[error(
        "the {} region ground at feeds {:.3} .. {:.3} mm asks for diagonal ratio {:.4}, the {} region at {:.3} .. {:.3} mm for {:.4}",
        first.flank, first.feed[0], first.feed[1], first.ratio, second.flank, second.feed[0], second.feed[1], second.ratio
    )]
    #[finding(code = "areas-overlap")]
    #[way_out("shorten the regions, let them demand the same diagonal ratio, or grind the flanks one by one")]
    AreasOverlap {
        /// The region with the lower feeds.
        first: FeedInterval,
        /// The other.
        second: FeedInterval,
    },
    /// Lines of the worm that carry a modification touch the flank outside their region too.
    #[error(
        "{} worm line ranges of modified regions are used twice; largest: {:.3} mm of the {} flank at feeds {:.3} .. {:.3} mm",
        shared.len(), largest.overlap, largest.flank, largest.segment[0], largest.segment[1]
    )]
    #[finding(code = "worm-lines-shared")]
    #[way_out("let the diagonal ratio keep its sign over the whole feed, free areas included")]
    WormLinesShared {
        /// The largest overlap.
        largest: SharedLines,
        /// All of them.
        shared: Vec<SharedLines>,
    },
    /// All threads are left out.
    #[error("no thread of {threads} is active")]
    #[finding(code = "no-active-thread", bad_input)]
    #[way_out("keep at least one thread")]
    NoActiveThread {
        /// Threads of the worm.
        threads: usize,
    },
    /// No diagonal ratio lets one swivelling dresser serve both flanks.
    #[error(
        "no diagonal ratio gives both flanks the same swivel of the dresser (numerator {numerator:.3e}, denominator {denominator:.3e})"
    )]
    #[finding(code = "no-common-swivel")]
    #[way_out("dress the flanks one by one or change the modification of one of them")]
    NoCommonSwivel {
        /// D of K = D/N.
        numerator: f64,
        /// N of K = D/N.
        denominator: f64,
    },
    /// A target has no finite value somewhere.
    #[error("the target has no finite amount at w = {w} mm, z = {z} mm")]
    #[finding(code = "amount-not-finite", bad_input)]
    #[way_out("give finite amounts on the whole evaluation field")]
    AmountNotFinite {
        /// Length of roll.
        w: f64,
        /// Face position.
        z: f64,
    },
    /// A tolerance by which deviations are weighed is no positive number.
    #[error("the tolerance {value} mm at w = {w} mm, z = {z} mm is no positive number")]
    #[finding(code = "tolerance-not-positive", bad_input)]
    #[way_out("give tolerances above 0 mm at every point")]
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
    #[finding(code = "too-few-points", bad_input)]
    #[way_out("give more points, or take fewer functions or fewer intervals")]
    TooFewPoints {
        /// Points given.
        points: usize,
        /// Points needed.
        needed: usize,
    },
    /// All samples lie on one line of a coordinate.
    #[error("all points have the same {coordinate} = {value} mm: nothing can be fitted along it")]
    #[finding(code = "no-extent", bad_input)]
    #[way_out("spread the points over the flank, or leave out the functions of that coordinate")]
    NoExtent {
        /// Coordinate.
        coordinate: &'static str,
        /// Its value.
        value: f64,
    },
    /// The lines of a diagonal ratio have no coordinate somewhere.
    #[error("the dressed lines or contact paths have no finite coordinate at w = {w} mm, z = {z} mm")]
    #[finding(code = "coordinate-not-finite", bad_input)]
    #[way_out("let the ratio law cover the whole flank")]
    CoordinateNotFinite {
        /// Length of roll.
        w: f64,
        /// Face position.
        z: f64,
    },
    /// The lines on the workpiece run along the contact paths, or along the profile (diagonal ratio 0).
    #[error(
        "lines of direction tan(rho_2) = {t} cannot be distinguished from the contact paths, tan(rho_K) = {t_k}"
    )]
    #[finding(code = "degenerate-direction", bad_input)]
    #[way_out("choose another direction, or the functions P and K alone for diagonal ratio 0")]
    DirectionAlongPath {
        /// tan(rho_2).
        t: f64,
        /// tan(rho_K).
        t_k: f64,
    },
    /// The splines of a decomposition are impossible.
    #[error("splines of the decomposition: {0}")]
    #[finding(code = "invalid-spline", bad_input)]
    #[way_out("take at least one interval, degree 1 and finite kinks")]
    InvalidSpline(SplineError),
    /// A range of diagonal ratios or directions is impossible.
    #[error("a scan of {count} values from {least} to {most} is impossible")]
    #[finding(code = "invalid-scan", bad_input)]
    #[way_out("give a range above 0 with its lower end first, finite values and at least two of them")]
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
    #[finding(code = "fit-not-solved")]
    #[way_out("let tolerances differ by fewer orders of magnitude, or take fewer intervals")]
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

/// Whether the contact lacks because of the input, not of the target.
fn contact_is_bad_input(error: &ContactError) -> bool {
    !matches!(
        error,
        ContactError::Undercut { .. }
            | ContactError::NotSettled { .. }
            | ContactError::WormSurfaceMissing { .. }
            | ContactError::NoStart { .. }
            | ContactError::NoRootFillet { .. }
            | ContactError::ContactBelowBase { .. }
    )
}

/// Whether dressing fails because of the input, not of the target.
fn dressing_is_bad_input(error: &DressingError) -> bool {
    matches!(
        error,
        DressingError::Geometry(_)
            | DressingError::InvalidNumber { .. }
            | DressingError::ConditionCount { .. }
    )
}

/// What helps a stroke: what its section is can be changed where the whole profile could not.
fn beside_stroke(error: &DressingError) -> Cow<'static, str> {
    match error {
        DressingError::NoZero { .. } | DressingError::NoContact { .. } | DressingError::OutOfDresser { .. } => {
            "bend its section less, hollow ones above all, divide it, or dress it with an area nearer to its place on the dresser"
                .into()
        }
        _ => error.way_out(),
    }
}

/// What helps where the dresser cuts the other flank.
fn narrower_land(largest: Option<f64>) -> Cow<'static, str> {
    match largest {
        Some(largest) => format!(
            "take a dresser with a tip land of at most {largest:.3} mm, or leave more of the profile to the dresser"
        )
        .into(),
        None => {
            "let the dresser carry more of the profile, leave out threads of the worm, or take a worm with a wider space"
                .into()
        }
    }
}

/// The given tip land beside the widest possible one.
fn lands(land: Option<f64>, largest: Option<f64>) -> String {
    match (land, largest) {
        (Some(land), Some(largest)) => format!("its tip land is {land} mm wide, allowed are {largest:.4} mm"),
        (_, Some(largest)) => format!("its tip land may be {largest:.4} mm wide"),
        (_, None) => "even without a tip land".into(),
    }
}

/// Key of a job under `grinding.axis_limits` for the limit of an axis.
fn limit_key(axis: &str) -> &'static str {
    match axis {
        "d_phi_S" => "d_phi_S_deg",
        "d_gamma" => "d_gamma_deg",
        "d_d" => "d_d_mm",
        "d_v_yA" => "d_v_yA_mm",
        _ => "delta_d_mm",
    }
}

/// What a correcting axis would have to do, for the beginning of a sentence.
fn correction_in_words(axis: &str) -> &'static str {
    match axis {
        "d_phi_S" => "dressing would have to turn the worm",
        "d_gamma" => "dressing would have to swivel the dresser",
        "d_d" => "dressing would have to move the dresser radially",
        "d_v_yA" => "dressing would have to offset the dresser tangentially",
        _ => "grinding would have to change the centre distance",
    }
}
