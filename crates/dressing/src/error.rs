//! Errors of dressing (`docs/mathematics/dressing.md#limits-of-a-correction`).

use super::PathReason;
use contact::ContactError;
use finding::Finding;
use foundation::geometry::{Flank, GeometryError};
use foundation::kinematics::MachineError;
use thiserror::Error;

/// What can go wrong between dresser and worm. Lengths mm.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum DressingError {
    /// A body is impossible by itself.
    #[error(transparent)]
    #[finding(transparent)]
    Geometry(#[from] GeometryError),
    /// Worm and gear do not stand together.
    #[error(transparent)]
    #[finding(transparent)]
    Contact(#[from] ContactError),
    /// The machine cannot take up the poses of a dressing motion.
    #[error(transparent)]
    #[finding(transparent)]
    Machine(#[from] MachineError),
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
    /// The involute flank has no conjugate dresser in the design range.
    #[error("the {flank} flank has no conjugate dresser at length of roll {w:.4} mm")]
    #[finding(code = "no-conjugate")]
    #[way_out("use a larger worm, fewer threads or a smaller dresser")]
    NoConjugate {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll.
        w: f64,
    },
    /// A circle of the dresser touches nothing.
    #[error("the dresser circle at profile parameter {t:.4} mm does not touch the {flank} flank of the worm")]
    #[finding(code = "no-contact")]
    #[way_out("reduce the modification made by the dressing motion, or let the dresser's profile make it")]
    NoContact {
        /// Flank concerned.
        flank: Flank,
        /// Profile parameter.
        t: f64,
    },
    /// The contact leaves the dresser's profile.
    #[error(
        "length of roll {w:.4} mm of the {flank} worm flank needs dresser profile outside [{from:.3}, {to:.3}] mm"
    )]
    #[finding(code = "out-of-dresser")]
    #[way_out("reduce the modification made by the dressing motion, or let the dresser's profile make it")]
    OutOfDresser {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll on the worm.
        w: f64,
        /// Profile from.
        from: f64,
        /// Profile to.
        to: f64,
    },
    /// Pitch points and additional conditions must be four, and differ.
    #[error(
        "{count} conditions were given for the four dressing corrections; needed: exactly 4 different ones"
    )]
    #[finding(code = "condition-count")]
    #[way_out("give four different conditions: pitch points, map rows, head rows or fixed axes")]
    ConditionCount {
        /// How many there were.
        count: usize,
    },
    /// The conditions do not determine the corrections.
    #[error("the conditions do not determine the corrections (singular value ratio {ratio:.1e})")]
    #[finding(code = "singular")]
    #[way_out("replace one pitch point by a radius-map row or a fixed axis")]
    Singular {
        /// sigma_4/sigma_1.
        ratio: f64,
    },
    /// No corrections fulfil the conditions.
    #[error("no dressing correction fulfils the conditions on the {flank} flank at v_zS = {v:.3} mm; reached {:.1} percent ({reason})", fraction * 100.0)]
    #[finding(code = "no-zero")]
    #[way_out(with = reason.way_out())]
    NoZero {
        /// Flank concerned.
        flank: Flank,
        /// Worm position.
        v: f64,
        /// Reached share of the target, 0..1.
        fraction: f64,
        /// Why it went no further.
        reason: PathReason,
    },
    /// Conditions that leave corrections open.
    #[error("{rows} conditions determine only {rank} of the four dressing corrections")]
    #[finding(code = "underdetermined")]
    #[way_out(
        "add pitch points, map rows or points of the other flank, fix an axis, or ask for the shortest correction"
    )]
    Underdetermined {
        /// Conditions given.
        rows: usize,
        /// How many corrections they determine at most.
        rank: usize,
    },
    /// One correction for both flanks of a conical worm, whose leads differ.
    #[error("the flanks of a conical worm have different leads and are not dressed by one motion")]
    #[finding(code = "two-flanks-of-cone")]
    #[way_out("dress one flank after the other: dressing.flanks = \"one\"")]
    TwoFlanksOfCone,
    /// No profile angle of the bracket fits the dresser without stretch.
    #[error(
        "no profile angle from {from:.3} to {to:.3} deg fits the dresser to the {flank} flank without stretch (P from {:.5} to \
         {:.5})", stretch[0], stretch[1]
    )]
    #[finding(code = "no-zero")]
    #[way_out(
        "widen the bracket, or take a worm whose diameter is nearer to the one the dresser was designed for"
    )]
    NoAngleWithoutStretch {
        /// Flank concerned.
        flank: Flank,
        /// Bracket from, degrees.
        from: f64,
        /// Bracket to, degrees.
        to: f64,
        /// P at both ends.
        stretch: [f64; 2],
    },
    /// No cone angle near fits the dresser to both flanks without stretch.
    #[error(
        "no cone angle fits the dresser to both flanks without stretch: at {cone:.3} deg P is {:.5} and {:.5}", stretch[0], stretch[1]
    )]
    #[finding(code = "no-zero")]
    #[way_out(
        "take a worm whose diameter is nearer to the one the dresser was designed for, or dress each flank by a dresser of its own"
    )]
    NoConeWithoutStretch {
        /// Cone angle where the search ended, degrees.
        cone: f64,
        /// P of the left and the right flank there.
        stretch: [f64; 2],
    },
    /// The dresser's profiles do not have its outside radius.
    #[error(
        "the dresser's {flank} profile has no circle of the tip radius {radius:.4} mm; it reaches from {from:.4} to {to:.4} mm"
    )]
    #[finding(code = "tip-outside-profile")]
    #[way_out(
        "give a tip radius that the profile reaches, or continue the profile further beyond the used range"
    )]
    TipOutsideProfile {
        /// Flank concerned.
        flank: Flank,
        /// Tip radius.
        radius: f64,
        /// Smallest radius that a tip can have there.
        from: f64,
        /// Largest radius of the profile.
        to: f64,
    },
    /// The flanks of the dresser cross below its tip.
    #[error(
        "the dresser's profiles cross below the tip radius {radius:.4} mm and overlap there by {overlap:.4} mm"
    )]
    #[finding(code = "pointed-tip")]
    #[way_out("give a smaller tip radius, or design the dresser for a wider thread space")]
    PointedTip {
        /// Tip radius.
        radius: f64,
        /// Overlap of the profiles at the tip.
        overlap: f64,
    },
    /// A tip land that the dresser cannot have.
    #[error(
        "a tip land of {land} mm is not possible; the dresser's profiles leave 0 to {full:.4} mm between them"
    )]
    #[finding(code = "tip-land")]
    #[way_out("give a tip land within that range; a wider one needs a smaller tip radius")]
    TipLand {
        /// Tip land asked for.
        land: f64,
        /// The full one.
        full: f64,
    },
    /// Dressing in several strokes leaves stock between, below or above them.
    #[error(
        "stock stays on the {flank} worm flank from length of roll {from:.4} to {to:.4} mm{}: {}",
        b.map_or_else(String::new, |b| format!(" at worm z {b:.3} mm")),
        beside_gap(*beside)
    )]
    #[finding(code = "gap")]
    #[way_out("add a stroke, let the strokes overlap more, or use a larger active area of the dresser")]
    Gap {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll from.
        from: f64,
        /// Length of roll to.
        to: f64,
        /// Numbers (from 0) of the strokes before and behind the gap.
        beside: [Option<usize>; 2],
        /// Worm z; absent where the strokes are the same along the worm.
        b: Option<f64>,
    },
    /// Deviations of the axes that a measurement does not tell apart.
    #[error(
        "the measurement does not determine {component} (standard deviation {} from the given noise; singular values {})",
        with_unit(component, *standard_deviation),
        singular_values.iter().map(|s| format!("{s:.1e}")).collect::<Vec<_>>().join(", ")
    )]
    #[finding(code = "not-identifiable")]
    #[way_out(
        "measure both flanks, hold one component at a known value, or add measurements at known changes of the corrections"
    )]
    NotIdentifiable {
        /// Name of the correction that is determined worst.
        component: &'static str,
        /// Its standard deviation, rad or mm; infinite where it is free.
        standard_deviation: f64,
        /// Singular values of the derivatives in the scaled unknowns of the conditions, mm, descending.
        singular_values: Vec<f64>,
    },
    /// An iteration that does not settle.
    #[error("{what}: the iteration does not settle (last step {last:.1e})")]
    #[finding(code = "not-converged")]
    #[way_out("begin with smaller amounts, or change them less over the width of the worm")]
    NotConverged {
        /// What was sought.
        what: &'static str,
        /// Size of the last step, in scaled unknowns or mm.
        last: f64,
    },
    /// A disc in point contact is not round enough for a hollow of the worm.
    #[error(
        "the {flank} worm flank is hollower at w = {w:.3} mm, z = {z:.3} mm than the dresser's tip radius {tip_radius} mm allows; there at most {largest:.4} mm"
    )]
    #[finding(code = "tip-radius-too-large")]
    #[way_out("take a smaller tip radius, or spread the modification over a longer way")]
    TipRadiusTooLarge {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll.
        w: f64,
        /// Axial position.
        z: f64,
        /// Tip radius r_T.
        tip_radius: f64,
        /// Largest tip radius that touches in a point only.
        largest: f64,
    },
    /// A disc in point contact cuts where it must not.
    #[error(
        "dressing the {flank} worm flank at w = {w:.3} mm, z = {z:.3} mm, the disc cuts {depth:.4} mm into the {with} flank"
    )]
    #[finding(code = "disc-collides")]
    #[way_out("take a smaller tip radius or a smaller disc")]
    DiscCollides {
        /// Flank that is dressed.
        flank: Flank,
        /// Length of roll of the contact.
        w: f64,
        /// Axial position of the contact.
        z: f64,
        /// Flank that is cut.
        with: Flank,
        /// Depth.
        depth: f64,
    },
    /// A disc in point contact cannot stand so that it touches a point.
    #[error("the disc cannot touch the {flank} worm flank at w = {w:.3} mm, z = {z:.3} mm")]
    #[finding(code = "disc-touches-not")]
    #[way_out("let the crossing angle follow the thread, or take a larger profile angle")]
    DiscTouchesNot {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll.
        w: f64,
        /// Axial position.
        z: f64,
    },
    /// The wanted worm surface has no value where a line passes.
    #[error(
        "the modification of the {flank} worm flank has no value at w = {w:.3} mm, z = {z:.3} mm, where a dressing line passes"
    )]
    #[finding(code = "worm-surface-undefined")]
    #[way_out("let the modification reach beyond the area that is dressed")]
    SurfaceUndefined {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll.
        w: f64,
        /// Axial position.
        z: f64,
    },
    /// The wanted worm surface is too rough for a smooth motion along a line.
    #[error(
        "the {flank} worm flank bends too sharply along the dressing line through w = {w:.3} mm, z = {z:.3} mm"
    )]
    #[finding(code = "dressing-line-too-rough")]
    #[way_out("round off kinks of the modification, or lay the lines along them")]
    LineTooRough {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll of the line's middle.
        w: f64,
        /// Axial position of the line's middle.
        z: f64,
    },
    /// Crossing angle 0 in the K chart.
    #[error("at crossing angle 0 the dressing corrections are not unique")]
    #[finding(code = "pole-of-chart")]
    #[way_out("use the tilt chart or a crossing angle other than 0")]
    PoleOfChart,
}

impl DressingError {
    /// The same error with the worm position at which it came about.
    pub(super) fn at_position(self, v: f64) -> Self {
        match self {
            Self::NoZero { flank, fraction, reason, .. } => Self::NoZero { flank, v, fraction, reason },
            other => other,
        }
    }
}

/// Where a gap lies among the strokes, which are counted from 1 here.
fn beside_gap(beside: [Option<usize>; 2]) -> String {
    match beside {
        [Some(a), Some(b)] => format!("strokes {} and {} do not overlap", a + 1, b + 1),
        [Some(a), None] => format!("stroke {} ends before it", a + 1),
        [None, Some(b)] => format!("stroke {} begins behind it", b + 1),
        [None, None] => "no stroke reaches it".into(),
    }
}

/// A component of DK in the units of files.
fn with_unit(component: &str, value: f64) -> String {
    if component == "d_phi_S" || component == "d_gamma" {
        format!("{:.3e} deg", value.to_degrees())
    } else {
        format!("{value:.3e} mm")
    }
}
