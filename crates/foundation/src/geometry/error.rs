//! Errors of a body: one variant per meaning, each with its data, a stable code and a way out.

use super::Flank;
use thiserror::Error;

/// Errors of `docs/mathematics/involute-gears.md` and of the surfaces of this room. Lengths mm, angles deg in messages.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum GeometryError {
    /// A number that is not finite or outside the range that has a meaning.
    #[error("{field} = {value} is not usable; allowed: {allowed}")]
    InvalidNumber {
        /// Name of the quantity.
        field: &'static str,
        /// The offending value.
        value: f64,
        /// Allowed range in words.
        allowed: &'static str,
    },
    /// Values that are fine one by one but make no body together.
    #[error("{what} = {value} makes no body; allowed: {allowed}")]
    InvalidGeometry {
        /// The condition that failed.
        what: String,
        /// The offending value.
        value: f64,
        /// Allowed range in words.
        allowed: String,
    },
    /// z < 0 together with a cone angle.
    #[error("an internal gear ({teeth} teeth) with cone angle {cone_angle_deg} deg is not supported")]
    InternalConicalUnsupported {
        /// Number of teeth, negative.
        teeth: i32,
        /// Cone angle in degrees.
        cone_angle_deg: f64,
    },
    /// A steep cone against a large helix: tan(alpha_t) <= 0.
    #[error("the transverse pressure angle of the {flank} flank is not positive (tan alpha_t = {tangent})")]
    PressureAngleNotPositive {
        /// Flank concerned.
        flank: Flank,
        /// tan(alpha_tF).
        tangent: f64,
    },
    /// A length of roll was asked for at a radius below the base circle.
    #[error("radius {radius} mm lies below the base circle of the {flank} flank (r_b = {base_radius} mm)")]
    RadiusBelowBaseCircle {
        /// Flank concerned.
        flank: Flank,
        /// Radius asked for, mm.
        radius: f64,
        /// Base radius, mm.
        base_radius: f64,
    },
    /// Tip, form and root diameters in the wrong order.
    #[error("{inner} = {inner_value} mm must be smaller than {outer} = {outer_value} mm")]
    DiametersInconsistent {
        /// Name of the diameter that must be smaller.
        inner: &'static str,
        /// Its value, mm.
        inner_value: f64,
        /// Name of the diameter that must be larger.
        outer: &'static str,
        /// Its value, mm.
        outer_value: f64,
    },
    /// The straight rack flank reaches below the base circle.
    #[error("the {flank} flank is undercut at z = {z} mm (rack starts at length of roll {w_start} mm)")]
    Undercut {
        /// Flank concerned.
        flank: Flank,
        /// Position along the face width, mm.
        z: f64,
        /// Length of roll at which the rack would start, mm (< 0).
        w_start: f64,
    },
    /// No tooth thickness is left at the tip.
    #[error("the tooth is pointed: thickness {thickness} mm at radius {radius} mm, z = {z} mm")]
    ToothPointed {
        /// Radius, mm.
        radius: f64,
        /// Position along the face width, mm.
        z: f64,
        /// Transverse tooth thickness there, mm.
        thickness: f64,
    },
    /// Parallel measuring faces have no stationary reading on this gear.
    #[error("span measurement is undefined: {reason}")]
    SpanUndefined {
        /// Why.
        reason: &'static str,
    },
    /// The measuring ball sinks below the base circle.
    #[error("the ball of {ball} mm is too small for the tooth space")]
    BallTooSmall {
        /// Ball diameter, mm.
        ball: f64,
    },
    /// The measuring ball does not enter the space of the internal gear.
    #[error("the ball of {ball} mm is too large for the tooth space")]
    BallTooLarge {
        /// Ball diameter, mm.
        ball: f64,
    },
    /// Ball or caliper touches outside the usable flank.
    #[error("contact at length of roll {w} mm is off the usable {flank} flank [{w_from}, {w_to}] mm")]
    ContactOffFlank {
        /// Flank concerned.
        flank: Flank,
        /// Length of roll of the contact, mm.
        w: f64,
        /// Usable from, mm.
        w_from: f64,
        /// Usable to, mm.
        w_to: f64,
    },
    /// No other rack of the asked kind generates this gear.
    #[error("no rack with {field} = {value} generates this gear")]
    NoRack {
        /// What was asked for.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// Only cylindrical gears have other racks.
    #[error("a conical gear has its own rack only")]
    CylindricalOnly,
    /// Normal base pitches of worm and gear differ.
    #[error("worm and gear do not mesh on the {flank} flank: normal base pitch {worm} mm against {gear} mm")]
    NotMating {
        /// Flank concerned.
        flank: Flank,
        /// Worm's normal base pitch, mm.
        worm: f64,
        /// Gear's normal base pitch, mm.
        gear: f64,
    },
    /// The worm's pitch diameter is too small for its threads.
    #[error(
        "a worm of {threads} threads and module {module} mm needs more than {least} mm pitch diameter, not {diameter} mm"
    )]
    WormTooSmall {
        /// Threads.
        threads: i32,
        /// Normal module, mm.
        module: f64,
        /// Least pitch diameter, mm.
        least: f64,
        /// Pitch diameter asked for, mm.
        diameter: f64,
    },
    /// A polar angle below the base cone of a bevel gear, or beyond the plane through its apex.
    #[error("the polar angle {angle_deg} deg is off the bevel flank, which begins at {base_angle_deg} deg")]
    BelowBaseCone {
        /// Angle asked for, deg.
        angle_deg: f64,
        /// Angle of the base cone, deg.
        base_angle_deg: f64,
    },
    /// A flank line that does not cover the face.
    #[error("the flank line has no direction {distance} mm from the apex, only from {from} to {to} mm")]
    FlankLineOutOfReach {
        /// Distance of the end of the face from the apex, mm.
        distance: f64,
        /// Where the line begins, mm.
        from: f64,
        /// Where it ends, mm.
        to: f64,
    },
    /// No tooth thickness is left at the tip cone.
    #[error(
        "the bevel tooth is pointed: half an angle of {half_angle_deg} deg is left of it at the tip cone"
    )]
    BevelToothPointed {
        /// Half of the tooth's angle at the tip cone, deg, <= 0.
        half_angle_deg: f64,
    },
    /// An octoid flank below its regular branch.
    #[error(
        "the octoid flank is undercut at the polar angle {angle_deg} deg: undercut begins below {begins_deg} deg"
    )]
    OctoidUndercut {
        /// Angle asked for, deg.
        angle_deg: f64,
        /// Where the regular branch ends, deg.
        begins_deg: f64,
    },
    /// A grid of points that is too small for cubic splines.
    #[error("a grid of {rows} x {columns} points; at least 4 x 4 are needed")]
    GridSize {
        /// Rows given.
        rows: usize,
        /// Points of the shortest row.
        columns: usize,
    },
    /// Rows of different lengths.
    #[error("row {row} of the grid has {found} points, the first has {expected}")]
    GridRagged {
        /// Row, from 0.
        row: usize,
        /// Points of the first row.
        expected: usize,
        /// Points of this row.
        found: usize,
    },
    /// A point of a grid that is not finite.
    #[error("point {column} of row {row} of the grid is not finite")]
    GridNotFinite {
        /// Row, from 0.
        row: usize,
        /// Place in the row, from 0.
        column: usize,
    },
    /// Two neighbours of a grid at one place.
    #[error("point {column} of row {row} of the grid coincides with a neighbour before it")]
    GridDuplicate {
        /// Row, from 0.
        row: usize,
        /// Place in the row, from 0.
        column: usize,
    },
    /// A grid whose surface has no tangent plane at a point, or turns over there.
    #[error("the surface through the grid has no clear side at point {column} of row {row}")]
    GridFolded {
        /// Row, from 0.
        row: usize,
        /// Place in the row, from 0.
        column: usize,
    },
}

impl GeometryError {
    /// Stable kebab-case code (`README.md#references-exit-status`).
    pub fn code(&self) -> &'static str {
        match self {
            Self::InvalidNumber { .. } => "invalid-number",
            Self::InvalidGeometry { .. } => "invalid-geometry",
            Self::InternalConicalUnsupported { .. } => "internal-conical-unsupported",
            Self::PressureAngleNotPositive { .. } => "pressure-angle-not-positive",
            Self::RadiusBelowBaseCircle { .. } => "radius-below-base-circle",
            Self::DiametersInconsistent { .. } => "diameters-inconsistent",
            Self::Undercut { .. } => "undercut",
            Self::ToothPointed { .. } => "tooth-pointed",
            Self::SpanUndefined { .. } => "span-undefined",
            Self::BallTooSmall { .. } => "ball-too-small",
            Self::BallTooLarge { .. } => "ball-too-large",
            Self::ContactOffFlank { .. } => "contact-off-flank",
            Self::NoRack { .. } => "no-rack",
            Self::CylindricalOnly => "cylindrical-only",
            Self::NotMating { .. } => "not-mating",
            Self::WormTooSmall { .. } => "worm-too-small",
            Self::BelowBaseCone { .. } => "below-base-cone",
            Self::FlankLineOutOfReach { .. } => "flank-line-out-of-reach",
            Self::BevelToothPointed { .. } => "bevel-tooth-pointed",
            Self::OctoidUndercut { .. } => "octoid-undercut",
            Self::GridSize { .. } => "grid-size",
            Self::GridRagged { .. } => "grid-ragged",
            Self::GridNotFinite { .. } => "grid-not-finite",
            Self::GridDuplicate { .. } => "grid-duplicate",
            Self::GridFolded { .. } => "grid-folded",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::InvalidNumber { .. } => "give a value inside the allowed range",
            Self::InvalidGeometry { .. } => "check this value against the drawing",
            Self::InternalConicalUnsupported { .. } => "use an external gear or cone angle 0",
            Self::PressureAngleNotPositive { .. } => {
                "reduce the cone angle or the helix angle, or raise the normal pressure angle of this flank"
            }
            Self::RadiusBelowBaseCircle { .. } => "raise the diameter above the base circle diameter",
            Self::DiametersInconsistent { .. } => "check the order root < form < tip (internal: reversed)",
            Self::Undercut { .. } => "raise the profile shift or shorten the rack addendum",
            Self::ToothPointed { .. } => "reduce the tip diameter or the profile shift",
            Self::SpanUndefined { .. } => "give the thickness over balls instead",
            Self::BallTooSmall { .. } => "use a larger ball",
            Self::BallTooLarge { .. } => "use a smaller ball",
            Self::ContactOffFlank { .. } => "choose another ball diameter or number of spanned teeth",
            Self::NoRack { .. } => "choose a smaller pressure angle or a pitch radius above the base circle",
            Self::CylindricalOnly => {
                "leave the worm's pressure angle out so that the gear's own rack is used"
            }
            Self::NotMating { .. } => "match m_n cos(alpha_n) of worm and gear",
            Self::WormTooSmall { .. } => "use a larger worm diameter or fewer threads",
            Self::BelowBaseCone { .. } => "raise the form angle above the base cone",
            Self::FlankLineOutOfReach { .. } => {
                "use a larger cutter radius, a smaller spiral angle or a smaller face width"
            }
            Self::BevelToothPointed { .. } => "reduce the addendum or the pressure angle",
            Self::OctoidUndercut { .. } => {
                "raise the form angle, or use more teeth or a larger pressure angle"
            }
            Self::GridSize { .. } => "give at least four rows of four points",
            Self::GridRagged { .. } => "give every row the same number of points",
            Self::GridNotFinite { .. } => "correct the point",
            Self::GridDuplicate { .. } => "leave double points out, or the row that has no extent",
            Self::GridFolded { .. } => "check the order of the points along rows and columns",
        }
    }
}
