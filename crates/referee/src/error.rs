//! Errors of the referee: unusable input, rays that were not cut, minima that were not found.

use super::mill::Unmilled;
use finding::Finding;
use foundation::geometry::Flank;
use foundation::numerics::SplineError;
use thiserror::Error;

/// The two stages of the referee.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Dresser against worm.
    Dressing,
    /// Worm against workpiece.
    Grinding,
}

impl std::fmt::Display for Stage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Dressing => "dressing",
            Self::Grinding => "grinding",
        })
    }
}

/// Why a ray has no length: the tool did not finish it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Uncut {
    /// No pose of the whole stroke brings the tool within the stock of the ray.
    NotReached,
    /// The tool is still approaching where the stroke ends.
    StrokeTooShort,
    /// The contact wanders off the tool's surface before the ray is finished.
    ToolMissing,
    /// The threads that are left out are the only ones that meet this tooth space.
    NoActiveThread,
    /// The search for the shortest length did not settle: an edge of the tool decides it (undercut), or a kink.
    NotConverged,
}

impl Uncut {
    /// What the user can do about it, in one sentence.
    pub fn way_out(self) -> &'static str {
        match self {
            Self::NotReached => "check centre distance and phase, or allow more stock",
            Self::StrokeTooShort => "take smaller amounts, or a longer stroke where it is given",
            Self::ToolMissing => {
                "take a tool with more profile or width there, or evaluate less of the flank"
            }
            Self::NoActiveThread => "index the workpiece between strokes or leave more threads on the worm",
            Self::NotConverged => {
                "reduce the tool's tip diameter if it undercuts there, or round the kinks of the modification"
            }
        }
    }
}

impl std::fmt::Display for Uncut {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::NotReached => "no pose of the stroke brings the tool near it",
            Self::StrokeTooShort => "the stroke ends before the tool has passed it",
            Self::ToolMissing => "the contact leaves the surface of the tool",
            Self::NoActiveThread => "no active thread meets this tooth space in any stroke",
            Self::NotConverged => "the search for the shortest length did not settle",
        })
    }
}

/// Errors of the referee. Lengths mm.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum RemovalError {
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
    /// The abscissae of a ray grid are empty, not finite or not ascending.
    #[error("ray grid: {axis}[{index}] = {value} mm; allowed: finite, ascending, lengths of roll above 0")]
    #[finding(code = "invalid-ray-grid")]
    #[way_out("give ascending finite abscissae with lengths of roll above 0")]
    InvalidGrid {
        /// `"w"` or `"z"`.
        axis: &'static str,
        /// Index of the offending abscissa.
        index: usize,
        /// Its value; NaN when the axis is empty.
        value: f64,
    },
    /// Left works on left, right on right.
    #[error("the {worm} flank of the worm cannot grind the {work} flank of the workpiece")]
    #[finding(code = "flanks-differ")]
    #[way_out("pair left with left and right with right")]
    FlanksDiffer {
        /// Flank of the worm.
        worm: Flank,
        /// Flank of the workpiece.
        work: Flank,
    },
    /// Internal bodies have no place in the chain.
    #[error("the {stage} stage of the referee handles external bodies only")]
    #[finding(code = "internal-unsupported")]
    #[way_out("use an external gear and worm")]
    InternalUnsupported {
        /// Stage concerned.
        stage: Stage,
    },
    /// Every thread is left out.
    #[error("no thread of the {threads} cuts")]
    #[finding(code = "no-active-thread")]
    #[way_out("leave at least one thread on the worm")]
    NoActiveThread {
        /// Threads of the worm.
        threads: i64,
    },
    /// The dresser's meridian is no function of the radius.
    #[error("the dresser profile turns back at profile parameter {t:.4} mm (radius {r:.4} mm)")]
    #[finding(code = "dresser-profile-folds")]
    #[way_out("shorten the dresser profile or reduce its modification")]
    ProfileFolds {
        /// Profile parameter.
        t: f64,
        /// Radius there.
        r: f64,
    },
    /// Rays without a length where a whole flank is wanted.
    #[error(
        "simulation of {stage}: {count} rays were not finished, first at length of roll {w:.4} mm, z = {z:.4} mm: {reason}"
    )]
    #[finding(code = "ray-uncut")]
    #[way_out(with = reason.way_out())]
    RayUncut {
        /// Stage concerned.
        stage: Stage,
        /// Length of roll of the first one.
        w: f64,
        /// Axial position of the first one.
        z: f64,
        /// Why.
        reason: Uncut,
        /// How many there are.
        count: usize,
    },
    /// A row of rays does not show where the contact path crosses it.
    #[error(
        "no contact seen at length of roll {w:.4} mm with feeds z_V1 = {shift:.4} mm, z_V2 = {feed:.4} mm: {reason}"
    )]
    #[finding(code = "contact-not-seen")]
    #[way_out("widen the face or the worm's area, or choose lengths of roll that the worm can grind")]
    ContactNotSeen {
        /// Length of roll of the row.
        w: f64,
        /// Tool shift.
        shift: f64,
        /// Feed.
        feed: f64,
        /// Why.
        reason: &'static str,
    },
    /// Rows and feeds do not determine the relations.
    #[error("{contacts} contacts do not determine the relations of these bodies")]
    #[finding(code = "too-few-contacts")]
    #[way_out("give at least two lengths of roll, and different feeds for every conical body")]
    TooFewContacts {
        /// Contacts seen.
        contacts: usize,
    },
    /// No path, or one without a place.
    #[error("milling path {path} has no place of the cutter")]
    #[finding(code = "empty-milling-path")]
    #[way_out("give every milling path at least one place of its cutter")]
    EmptyPath {
        /// Index of the path; 0 also when there is none at all.
        path: usize,
    },
    /// A path names a cutter that is not there.
    #[error("milling path {path} names cutter {cutter}; there are {cutters}")]
    #[finding(code = "unknown-cutter")]
    #[way_out("name one of the cutters by its index from 0")]
    UnknownCutter {
        /// Index of the path.
        path: usize,
        /// Index of the cutter that it names.
        cutter: usize,
        /// How many cutters there are.
        cutters: usize,
    },
    /// A place of a cutter that is no number, or whose axis is no unit vector.
    #[error("milling path {path}, place {place}: {field} = {value} is not usable")]
    #[finding(code = "invalid-cutter-place")]
    #[way_out("give a finite tip and an axis of length 1 within 1e-6")]
    InvalidCutterPlace {
        /// Index of the path.
        path: usize,
        /// Index of the place in it.
        place: usize,
        /// `"tip coordinate"` or `"length of the axis"`.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// Between two places the axis turns by half a turn: nothing says which way.
    #[error("milling path {path}: from place {block} to the next one the axis turns back onto itself")]
    #[finding(code = "axis-turns-back")]
    #[way_out("put a place between the two, or part the path there")]
    AxisTurnsBack {
        /// Index of the path.
        path: usize,
        /// Index of the block.
        block: usize,
    },
    /// A ray that is no number, or whose direction is no unit vector.
    #[error("ray {index}: {field} = {value} is not usable")]
    #[finding(code = "invalid-ray")]
    #[way_out("give a finite point and a normal of length 1 within 1e-6")]
    InvalidRay {
        /// Index of the ray.
        index: usize,
        /// `"point coordinate"` or `"length of the normal"`.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// Rays of a milled flank without a length where all are wanted.
    #[error("milling: {count} rays have no length, first ray {index}: {reason}")]
    #[finding(code = "ray-not-milled")]
    #[way_out(with = reason.way_out())]
    RayNotMilled {
        /// Index of the first one.
        index: usize,
        /// Why.
        reason: Unmilled,
        /// How many there are.
        count: usize,
    },
    /// The rays make no interpolating surface.
    #[error("the rays of the worm make no smooth surface: {0}")]
    #[finding(code = "no-worm-surface")]
    #[way_out("use at least four lengths of roll and four axial positions")]
    Surface(#[from] SplineError),
}

/// Tests a number that must be finite and positive.
pub(super) fn positive(field: &'static str, value: f64) -> Result<(), RemovalError> {
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(RemovalError::InvalidNumber { field, value, allowed: "> 0 and finite" })
    }
}

/// Tests a range: finite and not empty.
pub(super) fn range(field: &'static str, [from, to]: [f64; 2]) -> Result<(), RemovalError> {
    if !from.is_finite() {
        return Err(RemovalError::InvalidNumber { field, value: from, allowed: "two finite ends" });
    }
    if to.is_finite() && to > from {
        Ok(())
    } else {
        Err(RemovalError::InvalidNumber { field, value: to, allowed: "finite and above the other end" })
    }
}
