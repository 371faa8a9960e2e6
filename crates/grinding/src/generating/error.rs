//! Errors of planning generating grinding (`docs/mathematics/planning.md#limits`).

use super::areas::{FeedInterval, SharedLines};
use crate::dressing::DressingError;
use contact::ContactError;
use foundation::geometry::{Flank, GeometryError};
use foundation::kinematics::LawError;
use foundation::modification::{EvaluationError, ModificationError};
use foundation::numerics::SplineError;
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
    /// A stroke of dressing cannot be made.
    #[error("stroke {number} of the dressing: {error}")]
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
        "{} by {value:.4} {unit} ({axis}); planning takes at most {limit:.4} {unit} on its own",
        correction_in_words(axis)
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
    /// The dresser cuts into the flank across the thread space while it dresses one.
    #[error("the dresser cuts into the {} flank while it dresses the {flank} one: {}", flank.other(), lands(*land, *largest))]
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
    RootNeedsShift {
        /// Diagonal ratio, or its value in the middle of the feed.
        ratio: f64,
    },
    /// The edge of the worm undercuts the flank.
    #[error("the worm's edge undercuts the {flank} flank: its root fillet at z = {z:.3} mm has a notch")]
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
    NotDressed,
    /// The profile that a dresser of a conical worm needs depends on the worm's width.
    #[error(
        "the dresser of a conical worm (cone angle {cone_angle_deg} deg) serves the rolls of its whole width, which is not given"
    )]
    ConicalWormWithoutWidth {
        /// Cone angle of the worm, degrees.
        cone_angle_deg: f64,
    },
    /// The part of the tool's flank that the plan needs lies below its base circle.
    #[error(
        "the tool's flank is needed down to length of roll {w_1:.4} mm on the {flank} flank, below its base circle"
    )]
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
    Law(LawError),
    /// A number that has no sense here.
    #[error("{field} = {value}; allowed: {allowed}")]
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
    CurveNotAFunction {
        /// Flank.
        flank: Flank,
        /// Length of roll, mm.
        w: f64,
    },
    /// A region is no polygon on its flank.
    #[error("region {region} on the {flank} flank: {reason}")]
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
    WormLinesShared {
        /// The largest overlap.
        largest: SharedLines,
        /// All of them.
        shared: Vec<SharedLines>,
    },
    /// All threads are left out.
    #[error("no thread of {threads} is active")]
    NoActiveThread {
        /// Threads of the worm.
        threads: usize,
    },
    /// No diagonal ratio lets one swivelling dresser serve both flanks.
    #[error(
        "no diagonal ratio gives both flanks the same swivel of the dresser (numerator {numerator:.3e}, denominator {denominator:.3e})"
    )]
    NoCommonSwivel {
        /// D of K = D/N.
        numerator: f64,
        /// N of K = D/N.
        denominator: f64,
    },
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
    #[error(
        "lines of direction tan(rho_2) = {t} cannot be distinguished from the contact paths, tan(rho_K) = {t_k}"
    )]
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

/// The given tip land beside the widest possible one.
fn lands(land: Option<f64>, largest: Option<f64>) -> String {
    match (land, largest) {
        (Some(land), Some(largest)) => format!("its tip land is {land} mm wide, allowed are {largest:.4} mm"),
        (_, Some(largest)) => format!("its tip land may be {largest:.4} mm wide"),
        (_, None) => "even without a tip land".into(),
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
            Self::Stroke { error, .. } => error.code(),
            Self::WormTooShort { .. } => "worm-too-short",
            Self::AxisLimit { .. } => "axis-limit",
            Self::DegenerateDirection { .. } => "degenerate-direction",
            Self::EnvelopeBroken { .. } => "envelope-broken",
            Self::ModelError { .. } => "model-error",
            Self::NoFlank => "no-flank",
            Self::CounterFlankCut { .. } => "counter-flank-cut",
            Self::RootNeedsShift { .. } => "root-needs-shift",
            Self::RootNotched { .. } => "root-notched",
            Self::RootReachesFlank { .. } => "root-reaches-flank",
            Self::RootTooSharp { .. } => "root-too-sharp",
            Self::RootNotConfirmed { .. } => "root-not-confirmed",
            Self::NotDressed => "not-dressed",
            Self::ConicalWormWithoutWidth { .. } => "conical-worm-without-width",
            Self::ToolBelowBase { .. } => "worm-below-base",
            Self::ToolUndefined { .. } => "worm-surface-missing",
            Self::Law(e) => e.code(),
            Self::InvalidNumber { .. } => "invalid-number",
            Self::WormDirectionDegenerate { .. } => "worm-direction-degenerate",
            Self::RangeNotCovered { .. } => "range-not-covered",
            Self::CurveNotAFunction { .. } => "curve-not-a-function",
            Self::InvalidRegion { .. } => "invalid-region",
            Self::AreasOverlap { .. } => "areas-overlap",
            Self::WormLinesShared { .. } => "worm-lines-shared",
            Self::NoActiveThread { .. } => "no-active-thread",
            Self::NoCommonSwivel { .. } => "no-common-swivel",
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
            Self::Stroke {
                error:
                    DressingError::NoZero { .. }
                    | DressingError::NoContact { .. }
                    | DressingError::OutOfDresser { .. },
                ..
            } => {
                "bend its section less, hollow ones above all, divide it, or dress it with an area nearer to its place on the dresser"
                    .into()
            }
            Self::Stroke { error, .. } => error.way_out().to_string(),
            Self::WormTooShort { .. } => {
                "take a wider worm, a diagonal ratio of smaller magnitude, or put the profile crowning into the diagonal"
                    .into()
            }
            Self::AxisLimit { .. } => {
                "that limit is a default of planning, not one of the machine, and no key changes it: a number as diagonal_ratio is not bound by it; or reduce the amount, or take a worm with more threads"
                    .into()
            }
            Self::DegenerateDirection { .. } => "choose another diagonal ratio".into(),
            Self::EnvelopeBroken { .. } => "reduce the amount or choose another diagonal_ratio".into(),
            Self::ModelError { .. } => "choose another diagonal_ratio or widen the tolerance".into(),
            Self::CounterFlankCut { largest: Some(largest), .. } => {
                format!("take a dresser with a tip land of at most {largest:.3} mm, or leave more of the profile to the dresser")
            }
            Self::CounterFlankCut { .. } => {
                "let the dresser carry more of the profile, leave out threads of the worm, or take a worm with a wider space".into()
            }
            Self::RootNeedsShift { .. } => {
                "choose a diagonal ratio other than 0 and constant, or dressing.gear_root.along = \"follows\"".into()
            }
            Self::RootNotched { .. } | Self::RootReachesFlank { .. } => {
                "give a smaller corner radius, a larger root diameter, or a larger form diameter of the gear".into()
            }
            Self::RootTooSharp { .. } => "give a larger corner radius, or accept a sharper fillet".into(),
            Self::RootNotConfirmed { .. } => {
                "give another corner radius, or leave dressing.gear_root out".into()
            }
            Self::NotDressed => "set worm.tool = \"dressed\" and describe the [dresser]".into(),
            Self::ConicalWormWithoutWidth { .. } => "give the usable width of the worm as worm.width, in mm".into(),
            Self::ToolBelowBase { .. } => {
                "take a tool of larger diameter, fewer threads, or a smaller root form range of the gear".into()
            }
            Self::ToolUndefined { .. } => {
                "let the table of the tool or of the target reach further, or use a kind that continues".into()
            }
            Self::Law(e) => e.way_out().into(),
            Self::InvalidNumber { .. } => "give a value inside the allowed range".into(),
            Self::WormDirectionDegenerate { .. } => {
                "dress the worm along other lines, for example in its axial plane".into()
            }
            Self::RangeNotCovered { .. } => "continue the curve further beyond the ends of the profile".into(),
            Self::CurveNotAFunction { .. } => {
                "take a curve that crosses the contact paths everywhere in the same sense".into()
            }
            Self::InvalidRegion { .. } => "give at least three corners on the evaluated flank".into(),
            Self::AreasOverlap { .. } => {
                "shorten the regions, let them demand the same diagonal ratio, or grind the flanks one by one"
                    .into()
            }
            Self::WormLinesShared { .. } => {
                "let the diagonal ratio keep its sign over the whole feed, free areas included".into()
            }
            Self::NoActiveThread { .. } => "keep at least one thread".into(),
            Self::NoCommonSwivel { .. } => {
                "dress the flanks one by one or change the modification of one of them".into()
            }
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
            Self::Geometry(_)
            | Self::Modification(_)
            | Self::NoFlank
            | Self::NotDressed
            | Self::ConicalWormWithoutWidth { .. }
            | Self::ToolUndefined { .. } => true,
            Self::Contact(e) => !matches!(
                e,
                ContactError::Undercut { .. }
                    | ContactError::NotSettled { .. }
                    | ContactError::WormSurfaceMissing { .. }
                    | ContactError::NoStart { .. }
                    | ContactError::NoRootFillet { .. }
                    | ContactError::ContactBelowBase { .. }
            ),
            Self::Dressing(e) | Self::Stroke { error: e, .. } => matches!(
                e,
                DressingError::Geometry(_)
                    | DressingError::InvalidNumber { .. }
                    | DressingError::ConditionCount { .. }
            ),
            Self::DegenerateDirection { .. }
            | Self::Law(_)
            | Self::InvalidNumber { .. }
            | Self::WormDirectionDegenerate { .. }
            | Self::RangeNotCovered { .. }
            | Self::CurveNotAFunction { .. }
            | Self::InvalidRegion { .. }
            | Self::NoActiveThread { .. }
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
