//! What can keep a flank from being milled (`docs/mathematics/milling.md#limits`).

use super::flank::{Along, LimitBody};
use super::milled_side::MilledSide;
use super::obstacle::Collision;
use super::operation_kind::OperationKind;
use super::touch_fault::TouchFault;
use finding::Finding;
use foundation::geometry::GeometryError;
use thiserror::Error;

/// Errors of milling. mm, rad inside; degrees in messages.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum MillingError {
    /// A body is impossible.
    #[error(transparent)]
    #[finding(transparent)]
    Geometry(#[from] GeometryError),
    /// A guide curve leaves its base body or has no direction.
    #[error("at u = {u} the guide curve leaves the base body (t.N = {sine:e}, allowed 1e-9)")]
    #[finding(code = "lead-off-base")]
    #[way_out("give a guide curve that lies on the base body")]
    LeadOffBase {
        /// Parameter of the curve.
        u: f64,
        /// t.N there.
        sine: f64,
    },
    /// A column plane does not meet the flank.
    #[error(
        "the column plane at u = {u} does not meet the flank at height {height} (looked for near length {start})"
    )]
    #[finding(code = "column-no-section")]
    #[way_out("shorten the overrun or the skew of the column planes")]
    ColumnNoSection {
        /// Parameter of the guide curve.
        u: f64,
        /// Height parameter.
        height: f64,
        /// Where the search began.
        start: f64,
    },
    /// A column is not ended by a body.
    #[error("the column at u = {u} does not reach {body:?}")]
    #[finding(code = "column-no-limit")]
    #[way_out("check the bodies that end the flank at root and tip")]
    ColumnNoLimit {
        /// Parameter of the guide curve.
        u: f64,
        /// The body.
        body: LimitBody,
    },
    /// A column or path of one half of a double-helical gear runs into the other half.
    #[error("length {length} lies beyond the middle of the gear at {kink}")]
    #[finding(code = "column-kink")]
    #[way_out("mill each half alone and end its columns before the middle of the gear")]
    ColumnKink {
        /// Length reached, mm.
        length: f64,
        /// Where the halves meet, mm.
        kink: f64,
        /// What both are counted along.
        along: Along,
    },
    /// No column plane holds a point of the face's end.
    #[error("no column plane holds the flank's point at height {height}, length {length}")]
    #[finding(code = "range-not-found")]
    #[way_out("check the guide curve: its planes must cross the ends of the face")]
    RangeNotFound {
        /// Height parameter.
        height: f64,
        /// Length parameter.
        length: f64,
    },
    /// Rows cannot be spaced because the weight along the column is not smooth.
    #[error("rows cannot be spaced on the column at u = {u}: the weight is known to {tail:e} only")]
    #[finding(code = "spacing-not-smooth")]
    #[way_out(
        "space the rows by equal arcs, or with a relief in the profile by equal steps of the height (row_spacing = \"parameter\")"
    )]
    SpacingNotSmooth {
        /// Parameter of the guide curve.
        u: f64,
        /// What the series misses, relative.
        tail: f64,
    },
    /// No axis in the column plane has the angle that the cutter's cone needs.
    #[error(
        "at u = {u} no axis in the column plane suits a half angle of {:.4} deg: the normal leaves the plane by {:.4} deg",
        half_angle.to_degrees(), out_of_plane.to_degrees()
    )]
    #[finding(code = "axis-none")]
    #[way_out("take a cutter with a smaller half angle, or planes set askew")]
    AxisNone {
        /// Parameter of the guide curve.
        u: f64,
        /// Half angle of the cutter, rad.
        half_angle: f64,
        /// Angle of the normal out of the plane, rad.
        out_of_plane: f64,
    },
    /// The wanted contact is not on the cutter.
    #[error("at u = {u} the contact is not on the cutter: {fault}")]
    #[finding(code = "tool")]
    #[way_out("change the tilt or the contact height, or take a cutter that is rounded there")]
    ContactOffTool {
        /// Parameter of the guide curve.
        u: f64,
        /// Why.
        fault: TouchFault,
    },
    /// The cutter digs into the flank around its contact.
    #[error("the cutter digs into the flank at ({:.3}, {:.3}, {:.3}) mm: least curvature of the gap {least:.6} 1/mm", point[0], point[1], point[2])]
    #[finding(code = "gouge-local")]
    #[way_out("take a ball, a torus or a barrel whose profile is more curved than the flank is hollow")]
    GougeLocal {
        /// The contact, mm.
        point: [f64; 3],
        /// Least eigenvalue, 1/mm.
        least: f64,
    },
    /// Limits of the density that contradict themselves.
    #[error("{name} = {value} mm is not usable; allowed: {allowed}")]
    #[finding(code = "density-input")]
    #[way_out("give limits > 0 mm, the lower ones not above the upper ones")]
    DensityInput {
        /// Name of the limit.
        name: &'static str,
        /// Its value, mm.
        value: f64,
        /// Allowed range in words.
        allowed: &'static str,
    },
    /// More rows or columns than a program can have.
    #[error("the limits ask for {needed:.0} {lines}, at most {} are possible", super::size::MOST_LINES)]
    #[finding(code = "density-size")]
    #[way_out("allow larger distances, scallops or chords")]
    DensitySize {
        /// What is counted.
        lines: &'static str,
        /// How many are needed.
        needed: f64,
    },
    /// The corner of the tool is too large for the given depth.
    #[error(
        "at u = {u} the corner radius {corner_radius} mm is too large for the depth of the root: the straight piece would be {straight:.4} mm"
    )]
    #[finding(code = "root-corner")]
    #[way_out("take a smaller corner radius or a deeper root")]
    RootCorner {
        /// Parameter of the guide curve.
        u: f64,
        /// h_b, mm.
        straight: f64,
        /// r_c, mm.
        corner_radius: f64,
    },
    /// The fillets of both flanks overlap.
    #[error(
        "at u = {u} the fillets of both flanks overlap by {overlap:.4} mm each with the corner radius {corner_radius} mm"
    )]
    #[finding(code = "root-overlap")]
    #[way_out("take a smaller corner radius or a shallower root")]
    RootOverlap {
        /// Parameter of the guide curve.
        u: f64,
        /// How far the lowest point lies beyond the middle, mm.
        overlap: f64,
        /// r_c, mm.
        corner_radius: f64,
    },
    /// The bottom pass does not fit.
    #[error(
        "at u = {u} no bottom pass fits: half width {half_width:.4} mm, tool radius {radius} mm, lean of the axis {:.4} deg",
        lean.to_degrees()
    )]
    #[finding(code = "root-bottom")]
    #[way_out("take a thinner tool for the bottom")]
    RootBottom {
        /// Parameter of the guide curve.
        u: f64,
        /// Half of the distance of the fillets' lowest points, mm.
        half_width: f64,
        /// R_2, mm.
        radius: f64,
        /// nu, rad.
        lean: f64,
    },
    /// The cutting edge is too short for the root pass.
    #[error(
        "at u = {u} the root pass needs {needed:.4} mm of cutting edge, the tool has {cutting_length} mm"
    )]
    #[finding(code = "tool-short")]
    #[way_out("take a tool with a longer cutting edge")]
    ToolShort {
        /// Parameter of the guide curve.
        u: f64,
        /// h_b + r_c, mm.
        needed: f64,
        /// l_c, mm.
        cutting_length: f64,
    },
    /// The tool comes too near to something that it must not touch.
    #[error(
        "row {row}, column {column}: the tool keeps {clearance:.4} mm from the {from}, wanted are {wanted:.3} mm"
    )]
    #[finding(code = "tool-gap")]
    #[way_out(
        "take a thinner tool, less tilt or a smaller contact height, or begin the active flank higher above the root or hub"
    )]
    ToolGap {
        /// Row, from 0 at the root.
        row: usize,
        /// Column, from 0.
        column: usize,
        /// What it comes near to.
        from: &'static str,
        /// Clearance, mm; < 0 inside.
        clearance: f64,
        /// Clearance wanted, mm.
        wanted: f64,
    },
    /// An approach on an arc does not fit into the gap.
    #[error(
        "an approach from {aside:.4} mm beside the row does not fit: the cutter is free to move {room:.4} mm before it comes too near to the opposite flank"
    )]
    #[finding(code = "approach")]
    #[way_out(
        "take a smaller radius or angle or a shorter straight piece, or let the tool come in beside the face"
    )]
    Approach {
        /// How far beside the row it begins, mm.
        aside: f64,
        /// Clearance to the opposite flank without what is to be kept from it, mm.
        room: f64,
    },
    /// The axis of the cutter does not lead out of the workpiece.
    #[error(
        "the cutter cannot be drawn back along its axis ({:.4}, {:.4}, {:.4}) from ({:.3}, {:.3}, {:.3}) mm",
        axis[0], axis[1], axis[2], tip[0], tip[1], tip[2]
    )]
    #[finding(code = "no-retraction")]
    #[way_out("give a clearance body that the tool's axis crosses")]
    NoRetraction {
        /// Tip, mm.
        tip: [f64; 3],
        /// Axis.
        axis: [f64; 3],
    },
    /// The spindle does not fit into an internal gear.
    #[error(
        "{side} flank, row {row}, column {column}: from its tip the tool is free for {free:.3} mm up to the teeth on the other side, \
         tool and holder need {needed:.3} mm"
    )]
    #[finding(code = "internal-access")]
    #[way_out("lean the axis out of the gear by a lead angle, or take a shorter tool and holder")]
    InternalAccess {
        /// The flank.
        side: MilledSide,
        /// Row, 0 at the root.
        row: usize,
        /// Column of the path.
        column: usize,
        /// Free length along the axis, mm.
        free: f64,
        /// Length of tool and holder, mm.
        needed: f64,
    },
    /// Tool, holder or spindle come too near to the ring of an internal gear.
    #[error(
        "{side} flank, row {row}, column {column}: tool, holder or spindle keep {clearance:.3} mm from the {from}, wanted are {wanted} mm"
    )]
    #[finding(code = "internal-access")]
    #[way_out(
        "lean the axis out of the gear by a lead angle, take a longer and thinner tool, or give the true `machine.spindle_diameter`"
    )]
    RingMet {
        /// The flank.
        side: MilledSide,
        /// Row, 0 at the root.
        row: usize,
        /// Column of the path.
        column: usize,
        /// What they come near to.
        from: &'static str,
        /// A distance that is too small, mm; < 0 inside.
        clearance: f64,
        /// What they should keep, mm.
        wanted: f64,
    },
    /// No guide curve has the wanted row in its column planes.
    #[error(
        "no guide curve with a radius of {from:.2} to {to:.2} mm has the normals of that row in its column planes"
    )]
    #[finding(code = "no-such-lead")]
    #[way_out(
        "choose another row, or leave `lead_through_row` out: on spur gears all normals lie in the planes"
    )]
    NoSuchLead {
        /// Least radius looked at, mm.
        from: f64,
        /// Greatest radius looked at, mm.
        to: f64,
    },
    /// The normal of a point does not meet the cutter that runs beside it.
    #[error("the normal at ({:.3}, {:.3}, {:.3}) mm does not meet the cutter of the next row", point[0], point[1], point[2])]
    #[finding(code = "not-met")]
    #[way_out("lay the rows closer")]
    NotMet {
        /// The point, mm.
        point: [f64; 3],
    },
    /// On its way the tool comes too near to something.
    #[error("{kind}, path {path}: after place {} the tool keeps {:.4} mm from the {}, wanted are {} mm", collision.block, collision.clearance.value, collision.name, collision.wanted)]
    #[finding(code = "tool-gap")]
    #[way_out(
        "take a thinner tool, less tilt or a smaller contact height, or begin the active flank higher above the root or hub"
    )]
    Collides {
        /// The operation.
        kind: OperationKind,
        /// Number of its path, from 0.
        path: usize,
        /// Where and what.
        collision: Box<Collision>,
    },
    /// The root needs a cylindrical tool with a corner.
    #[error("the root is milled with a cylindrical tool (end mill, torus or ball)")]
    #[finding(code = "root-tool")]
    #[way_out("leave out `milling.root`, or mill with an end mill")]
    RootTool,
    /// The roughing cutter is too thick for the space.
    #[error(
        "the roughing cutter finds no room between the flanks from {top:.3} mm down to {bottom:.3} mm above the guide curve"
    )]
    #[finding(code = "roughing-nowhere")]
    #[way_out("take a thinner cutter or a smaller allowance")]
    RoughingNowhere {
        /// Height of the first layer, mm.
        top: f64,
        /// Height of the last layer, mm.
        bottom: f64,
    },
    /// No contact height suits a row.
    #[error("row {row} allows no contact height: from {least:.4} to {greatest:.4} mm above the tip")]
    #[finding(code = "wear-window")]
    #[way_out("take a thinner tool or one with a smaller corner radius")]
    WearWindow {
        /// Row, from 0 at the root.
        row: usize,
        /// Least height, mm.
        least: f64,
        /// Greatest height, mm.
        greatest: f64,
    },
    /// The list of contact heights is of another length than the rows.
    #[error("{given} contact heights are given for {rows} rows")]
    #[finding(code = "height-count")]
    #[way_out("give one contact height for each row, the root's first")]
    HeightCount {
        /// Heights given.
        given: usize,
        /// Number of rows.
        rows: usize,
    },
    /// A contact height of the caller's is not possible.
    #[error("row {row}: the contact height {height} mm is outside of {least:.4} to {greatest:.4} mm")]
    #[finding(code = "height-outside")]
    #[way_out("give a height inside the row's window, or the rule `ramp`")]
    HeightOutside {
        /// Row, from 0 at the root.
        row: usize,
        /// The height, mm.
        height: f64,
        /// Least height, mm.
        least: f64,
        /// Greatest height, mm.
        greatest: f64,
    },
}
