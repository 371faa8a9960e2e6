//! Errors of a body: one variant per meaning, each with its data, a stable code and a way out.

use super::Flank;
use finding::Finding;
use thiserror::Error;

/// Errors of `docs/mathematics/involute-gears.md` and of the surfaces of this room. Lengths mm, angles deg in messages.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum GeometryError {
    /// A number that is not finite or outside the range that has a meaning.
    #[error("{field} = {value} is not usable; allowed: {allowed}")]
    #[finding(code = "invalid-number")]
    #[way_out("give a value inside the allowed range")]
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
    #[finding(code = "invalid-geometry")]
    #[way_out("check this value against the drawing")]
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
    #[finding(code = "internal-conical-unsupported")]
    #[way_out("use an external gear or cone angle 0")]
    InternalConicalUnsupported {
        /// Number of teeth, negative.
        teeth: i32,
        /// Cone angle in degrees.
        cone_angle_deg: f64,
    },
    /// A steep cone against a large helix: tan(alpha_t) <= 0.
    #[error("the transverse pressure angle of the {flank} flank is not positive (tan alpha_t = {tangent})")]
    #[finding(code = "pressure-angle-not-positive")]
    #[way_out("reduce the cone angle or the helix angle, or raise the normal pressure angle of this flank")]
    PressureAngleNotPositive {
        /// Flank concerned.
        flank: Flank,
        /// tan(alpha_tF).
        tangent: f64,
    },
    /// A length of roll was asked for at a radius below the base circle.
    #[error("radius {radius} mm lies below the base circle of the {flank} flank (r_b = {base_radius} mm)")]
    #[finding(code = "radius-below-base-circle")]
    #[way_out("raise the diameter above the base circle diameter")]
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
    #[finding(code = "diameters-inconsistent")]
    #[way_out("check the order root < form < tip (internal: reversed)")]
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
    #[finding(code = "undercut")]
    #[way_out("raise the profile shift or shorten the rack addendum")]
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
    #[finding(code = "tooth-pointed")]
    #[way_out("reduce the tip diameter or the profile shift")]
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
    #[finding(code = "span-undefined")]
    #[way_out("give the thickness over balls instead")]
    SpanUndefined {
        /// Why.
        reason: &'static str,
    },
    /// No straight roll lies in the space.
    #[error("a size over rolls is undefined: {reason}")]
    #[finding(code = "rolls-undefined")]
    #[way_out("measure over balls instead")]
    RollsUndefined {
        /// Why.
        reason: &'static str,
    },
    /// The measuring ball sinks below the base circle.
    #[error("the ball of {ball} mm is too small for the tooth space")]
    #[finding(code = "ball-too-small")]
    #[way_out("use a larger ball")]
    BallTooSmall {
        /// Ball diameter, mm.
        ball: f64,
    },
    /// The measuring ball does not enter the space of the internal gear.
    #[error("the ball of {ball} mm is too large for the tooth space")]
    #[finding(code = "ball-too-large")]
    #[way_out("use a smaller ball")]
    BallTooLarge {
        /// Ball diameter, mm.
        ball: f64,
    },
    /// Ball or caliper touches outside the usable flank.
    #[error("contact at length of roll {w} mm is off the usable {flank} flank [{w_from}, {w_to}] mm")]
    #[finding(code = "contact-off-flank")]
    #[way_out("choose another ball diameter or number of spanned teeth")]
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
    #[finding(code = "no-rack")]
    #[way_out("choose a smaller pressure angle or a pitch radius above the base circle")]
    NoRack {
        /// What was asked for.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// Only cylindrical gears have other racks.
    #[error("a conical gear has its own rack only")]
    #[finding(code = "cylindrical-only")]
    #[way_out("leave the worm's pressure angle out so that the gear's own rack is used")]
    CylindricalOnly,
    /// Normal base pitches of worm and gear differ.
    #[error("worm and gear do not mesh on the {flank} flank: normal base pitch {worm} mm against {gear} mm")]
    #[finding(code = "not-mating")]
    #[way_out("match m_n cos(alpha_n) of worm and gear")]
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
    #[finding(code = "worm-too-small")]
    #[way_out("use a larger worm diameter or fewer threads")]
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
    #[finding(code = "below-base-cone")]
    #[way_out("raise the form angle above the base cone")]
    BelowBaseCone {
        /// Angle asked for, deg.
        angle_deg: f64,
        /// Angle of the base cone, deg.
        base_angle_deg: f64,
    },
    /// A flank line that does not cover the face.
    #[error("the flank line has no direction {distance} mm from the apex, only from {from} to {to} mm")]
    #[finding(code = "flank-line-out-of-reach")]
    #[way_out("use a larger cutter radius, a smaller spiral angle or a smaller face width")]
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
    #[finding(code = "bevel-tooth-pointed")]
    #[way_out("reduce the addendum or the pressure angle")]
    BevelToothPointed {
        /// Half of the tooth's angle at the tip cone, deg, <= 0.
        half_angle_deg: f64,
    },
    /// An octoid flank below its regular branch.
    #[error(
        "the octoid flank is undercut at the polar angle {angle_deg} deg: undercut begins below {begins_deg} deg"
    )]
    #[finding(code = "octoid-undercut")]
    #[way_out("raise the form angle, or use more teeth or a larger pressure angle")]
    OctoidUndercut {
        /// Angle asked for, deg.
        angle_deg: f64,
        /// Where the regular branch ends, deg.
        begins_deg: f64,
    },
    /// A grid of points that is too small for cubic splines.
    #[error("a grid of {rows} x {columns} points; at least 4 x 4 are needed")]
    #[finding(code = "grid-size")]
    #[way_out("give at least four rows of four points")]
    GridSize {
        /// Rows given.
        rows: usize,
        /// Points of the shortest row.
        columns: usize,
    },
    /// Rows of different lengths.
    #[error("row {row} of the grid has {found} points, the first has {expected}")]
    #[finding(code = "grid-ragged")]
    #[way_out("give every row the same number of points")]
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
    #[finding(code = "grid-not-finite")]
    #[way_out("correct the point")]
    GridNotFinite {
        /// Row, from 0.
        row: usize,
        /// Place in the row, from 0.
        column: usize,
    },
    /// Two neighbours of a grid at one place.
    #[error("point {column} of row {row} of the grid coincides with a neighbour before it")]
    #[finding(code = "grid-duplicate")]
    #[way_out("leave double points out, or the row that has no extent")]
    GridDuplicate {
        /// Row, from 0.
        row: usize,
        /// Place in the row, from 0.
        column: usize,
    },
    /// A grid whose surface has no tangent plane at a point, or turns over there.
    #[error("the surface through the grid has no clear side at point {column} of row {row}")]
    #[finding(code = "grid-folded")]
    #[way_out("check the order of the points along rows and columns")]
    GridFolded {
        /// Row, from 0.
        row: usize,
        /// Place in the row, from 0.
        column: usize,
    },
}
