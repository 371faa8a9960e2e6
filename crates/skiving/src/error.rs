//! What can keep a skiving tool from being made, measured or judged (`docs/mathematics/skiving.md#limits`).

use finding::Finding;
use foundation::geometry::{Flank, GeometryError};
use thiserror::Error;

/// Errors of skiving and of measuring its tools. mm, rad inside; degrees in messages.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum SkivingError {
    /// A body is impossible.
    #[error(transparent)]
    #[finding(transparent, bad_input)]
    Geometry(#[from] GeometryError),
    /// A number that is not finite or outside the range that has a meaning.
    #[error("{field} = {value} is not usable; allowed: {allowed}")]
    #[finding(code = "invalid-number", bad_input)]
    #[way_out("give a value in the allowed range")]
    InvalidNumber {
        /// Name of the quantity.
        field: &'static str,
        /// The offending value.
        value: f64,
        /// Allowed range in words.
        allowed: &'static str,
    },
    /// A length of roll is not above the base circle.
    #[error("the flank begins at length of roll {w} mm: it must lie above the base circle")]
    #[finding(code = "below-base-circle", bad_input)]
    #[way_out("begin the flank above the base circle")]
    BelowBaseCircle {
        /// Length of roll, mm.
        w: f64,
    },
    /// Tool and workpiece would not skive.
    #[error("the axes are parallel (crossed-axes angle {:.6} deg)", angle.to_degrees())]
    #[finding(code = "axes-parallel", bad_input)]
    #[way_out(
        "choose another helix angle of the tool, give the crossed-axes angle, or say that it is a shaping cutter: kinematics = \"shaping\""
    )]
    AxesParallel {
        /// Crossed-axes angle, rad.
        angle: f64,
    },
    /// A shaping cutter whose axis would not be parallel to the workpiece's.
    #[error(
        "a shaping cutter with helix angle {:.6} deg stands at a crossed-axes angle of {:.6} deg to the workpiece", tool.to_degrees(), angle.to_degrees()
    )]
    #[finding(code = "axes-crossed", bad_input)]
    #[way_out(with = format!("give the cutter the helix angle {:.6} deg, or let it skive", needed.to_degrees()))]
    AxesCrossed {
        /// Crossed-axes angle, rad.
        angle: f64,
        /// Helix angle of the cutter, rad.
        tool: f64,
        /// The one that it needs, rad.
        needed: f64,
    },
    /// The sign of the centre distance does not suit the kind of gear.
    #[error("centre distance {value} mm is not usable for {} gear", if *internal { "an internal" } else { "an external" })]
    #[finding(code = "invalid-centre-distance", bad_input)]
    #[way_out("give d > 0 for external and d < 0 for internal gears, or leave it out")]
    InvalidCentreDistance {
        /// The centre distance, mm.
        value: f64,
        /// Whether the gear is internal.
        internal: bool,
    },
    /// A modification changes along the tooth.
    #[error("the modification differs along the tooth by {difference:e} mm at w = {w} mm, z = {z} mm")]
    #[finding(code = "lead-modification-not-supported", bad_input)]
    #[way_out(
        "give modifications of the profile only: those along the tooth are made by the machine's motion"
    )]
    LeadModificationNotSupported {
        /// Length of roll, mm.
        w: f64,
        /// Axial position, mm.
        z: f64,
        /// Difference to the middle of the face, mm.
        difference: f64,
    },
    /// No roll position brings the edge to this place of the flank.
    #[error("no edge on this rake face makes the flank at length of roll {w:.4} mm")]
    #[finding(code = "no-contact")]
    #[way_out("check the rake angle, the tool shift and the range of the flank")]
    NoContact {
        /// Length of roll, mm.
        w: f64,
    },
    /// The place that touches is off the rounding.
    #[error(
        "at length of roll {w:.4} mm the contact lies at {:.3} deg, off the rounding between {:.3} and {:.3} deg",
        angle.to_degrees(), least.to_degrees(), greatest.to_degrees()
    )]
    #[finding(code = "contact-off-rounding")]
    #[way_out("check the chamfers and the clearance angle, or turn the step angle")]
    ContactOffRounding {
        /// Length of roll, mm.
        w: f64,
        /// Angle of the contact on the rounding, rad.
        angle: f64,
        /// Where the rounding begins.
        least: f64,
        /// Where it ends.
        greatest: f64,
    },
    /// The edge is bent more than it is round.
    #[error(
        "at length of roll {w:.4} mm the edge is curved with {curvature_radius:.4} mm, its rounding has {radius} mm"
    )]
    #[finding(code = "rounding-too-large")]
    #[way_out("take a smaller rounding radius")]
    RoundingTooLarge {
        /// Length of roll, mm.
        w: f64,
        /// Radius of the rounding, mm.
        radius: f64,
        /// Radius of curvature of the edge, mm.
        curvature_radius: f64,
    },
    /// The edge does not cut in one direction.
    #[error(
        "at length of roll {w:.4} mm the cutting speed is {speed} mm/rad along the rake normal, elsewhere the other way"
    )]
    #[finding(code = "cutting-direction-ambiguous")]
    #[way_out("choose a larger crossed-axes angle or another rake face")]
    CuttingDirectionAmbiguous {
        /// Length of roll, mm.
        w: f64,
        /// Speed along the rake normal, mm/rad.
        speed: f64,
    },
    /// A turn of the tool hardly moves the flank.
    #[error("at length of roll {w:.4} mm a turn of the tool moves the edge by {lever} mm/rad only")]
    #[finding(code = "lever-too-small")]
    #[way_out("measure this flank at other tracks")]
    LeverTooSmall {
        /// Length of roll, mm.
        w: f64,
        /// L, mm/rad.
        lever: f64,
    },
    /// No pose lays the beam on the edge as asked for.
    #[error("{flank} flank, track {}: the beam cannot be laid along the edge ({reason})", track + 1)]
    #[finding(code = "pose-not-reachable")]
    #[way_out("allow a larger deviation from the flank direction, or tilt the beam")]
    PoseNotReachable {
        /// Flank.
        flank: Flank,
        /// Track, from 0.
        track: usize,
        /// Which condition failed, with its figures.
        reason: String,
    },
    /// The flank direction stands along the tool's axis: every turn of the tool is as good.
    #[error("{flank} flank, track {}: the flank direction stands along the tool's axis", track + 1)]
    #[finding(code = "degenerate-flank-direction")]
    #[way_out("measure with tangent poses")]
    DegenerateFlankDirection {
        /// Flank.
        flank: Flank,
        /// Track, from 0.
        track: usize,
    },
    /// An axis would have to leave its range.
    #[error("{flank} flank, track {}: axis {axis} = {value} is outside of {least} to {greatest}", track + 1)]
    #[finding(code = "axis-limit")]
    #[way_out("move the light barrier, or choose another kind of pose")]
    AxisLimit {
        /// Flank.
        flank: Flank,
        /// Track, from 0.
        track: usize,
        /// Name of the axis.
        axis: char,
        /// Where it would have to stand, mm or deg.
        value: f64,
        /// Least position.
        least: f64,
        /// Greatest position.
        greatest: f64,
    },
    /// Something else of the tool is in the beam.
    #[error(
        "{flank} flank, track {}: the {other} flank of tooth {tooth} comes as near as {gap:.4} mm to the beam", track + 1
    )]
    #[finding(code = "shadowed")]
    #[way_out("take a thinner beam, or another kind of pose")]
    Shadowed {
        /// Flank that is measured.
        flank: Flank,
        /// Track, from 0.
        track: usize,
        /// Flank that comes near.
        other: Flank,
        /// Its tooth, from the measured one.
        tooth: i32,
        /// Gap, mm.
        gap: f64,
    },
    /// The beam meets a place behind the rounding.
    #[error("tooth {tooth}: the beam touches the body at {:.3} deg, the rounding ends at {:.3} and {:.3} deg", angle.to_degrees(), least.to_degrees(), greatest.to_degrees())]
    #[finding(code = "body-touched")]
    #[way_out("lay the beam along the flank direction")]
    BodyTouched {
        /// Tooth.
        tooth: usize,
        /// Angle of the touch, rad.
        angle: f64,
        /// Where the rounding begins.
        least: f64,
        /// Where it ends.
        greatest: f64,
    },
    /// The beam meets the end of the edge.
    #[error(
        "tooth {tooth}: the beam touches the edge at length of roll {w:.4} mm, it goes from {from:.4} to {to:.4} mm"
    )]
    #[finding(code = "edge-end-touched")]
    #[way_out("move the track away from the end of the edge")]
    EdgeEndTouched {
        /// Tooth.
        tooth: usize,
        /// Length of roll, mm.
        w: f64,
        /// Where the edge begins.
        from: f64,
        /// Where it ends.
        to: f64,
    },
    /// The beam does not switch.
    #[error("tooth {tooth} does not switch the beam")]
    #[finding(code = "no-trigger")]
    #[way_out("check the tooth: it may be broken off")]
    NoTrigger {
        /// Tooth.
        tooth: usize,
    },
    /// There are not as many signals as teeth.
    #[error("{flank} flank, track {}: {}, the tool has {teeth} teeth", track + 1, signals(*found))]
    #[finding(code = "trigger-count-mismatch")]
    #[way_out(with = recount(*found))]
    TriggerCountMismatch {
        /// Flank.
        flank: Flank,
        /// Track, from 0.
        track: usize,
        /// Signals of a revolution.
        found: usize,
        /// Teeth.
        teeth: usize,
    },
    /// A signal lies between two teeth.
    #[error(
        "{flank} flank, track {}: the signal at {:.5} deg is {:.5} deg away from the nearest tooth",
        track + 1, angle.to_degrees(), off.to_degrees()
    )]
    #[finding(code = "ambiguous-tooth")]
    #[way_out("check the clocking of the tool and the number of teeth")]
    AmbiguousTooth {
        /// Flank.
        flank: Flank,
        /// Track, from 0.
        track: usize,
        /// Angle of the signal, rad.
        angle: f64,
        /// Distance from the nearest tooth's nominal angle, rad.
        off: f64,
    },
    /// A curve of that degree needs more tracks.
    #[error("a curve of degree {degree} needs more than {tracks} tracks")]
    #[finding(code = "too-few-tracks", bad_input)]
    #[way_out("measure more tracks, or ask for a lower degree")]
    TooFewTracks {
        /// Tracks.
        tracks: usize,
        /// Degree of the compensation curve.
        degree: usize,
    },
    /// The calibration does not tell its unknowns apart.
    #[error("the calibration is singular: {reason}")]
    #[finding(code = "calibration-singular")]
    #[way_out("approach the mandrel at two heights, from both sides in Y")]
    CalibrationSingular {
        /// Why.
        reason: &'static str,
    },
}

fn signals(found: usize) -> String {
    if found == 0 { "there are no readings".into() } else { format!("{found} signals a revolution") }
}

/// What helps where signals are missing or too many.
fn recount(found: usize) -> &'static str {
    if found == 0 {
        "measure this track, or give the job the tracks that were measured"
    } else {
        "check the tool for broken teeth and chips, then measure again"
    }
}
