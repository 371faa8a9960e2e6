//! What can keep a skiving tool from being made, measured or judged (`docs/mathematics/skiving.md#limits`).

use foundation::geometry::{Flank, GeometryError};
use thiserror::Error;

/// Errors of skiving and of measuring its tools. mm, rad inside; degrees in messages.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SkivingError {
    /// A body is impossible.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
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
    /// A length of roll is not above the base circle.
    #[error("the flank begins at length of roll {w} mm: it must lie above the base circle")]
    BelowBaseCircle {
        /// Length of roll, mm.
        w: f64,
    },
    /// Tool and workpiece would not skive.
    #[error("the axes are parallel (crossed-axes angle {:.6} deg)", angle.to_degrees())]
    AxesParallel {
        /// Crossed-axes angle, rad.
        angle: f64,
    },
    /// The sign of the centre distance does not suit the kind of gear.
    #[error("centre distance {value} mm is not usable for {} gear", if *internal { "an internal" } else { "an external" })]
    InvalidCentreDistance {
        /// The centre distance, mm.
        value: f64,
        /// Whether the gear is internal.
        internal: bool,
    },
    /// A modification changes along the tooth.
    #[error("the modification differs along the tooth by {difference:e} mm at w = {w} mm, z = {z} mm")]
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
    NoContact {
        /// Length of roll, mm.
        w: f64,
    },
    /// The place that touches is off the rounding.
    #[error(
        "at length of roll {w:.4} mm the contact lies at {:.3} deg, off the rounding between {:.3} and {:.3} deg",
        angle.to_degrees(), least.to_degrees(), greatest.to_degrees()
    )]
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
    CuttingDirectionAmbiguous {
        /// Length of roll, mm.
        w: f64,
        /// Speed along the rake normal, mm/rad.
        speed: f64,
    },
    /// A turn of the tool hardly moves the flank.
    #[error("at length of roll {w:.4} mm a turn of the tool moves the edge by {lever} mm/rad only")]
    LeverTooSmall {
        /// Length of roll, mm.
        w: f64,
        /// L, mm/rad.
        lever: f64,
    },
    /// No pose lays the beam on the edge as asked for.
    #[error("{flank} flank, track {}: the beam cannot be laid along the edge ({reason})", track + 1)]
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
    DegenerateFlankDirection {
        /// Flank.
        flank: Flank,
        /// Track, from 0.
        track: usize,
    },
    /// An axis would have to leave its range.
    #[error("{flank} flank, track {}: axis {axis} = {value} is outside of {least} to {greatest}", track + 1)]
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
    NoTrigger {
        /// Tooth.
        tooth: usize,
    },
    /// There are not as many signals as teeth.
    #[error("{flank} flank, track {}: {}, the tool has {teeth} teeth", track + 1, signals(*found))]
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
    TooFewTracks {
        /// Tracks.
        tracks: usize,
        /// Degree of the compensation curve.
        degree: usize,
    },
    /// The calibration does not tell its unknowns apart.
    #[error("the calibration is singular: {reason}")]
    CalibrationSingular {
        /// Why.
        reason: &'static str,
    },
}

impl SkivingError {
    /// Stable code.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Geometry(error) => error.code(),
            Self::InvalidNumber { .. } => "invalid-number",
            Self::BelowBaseCircle { .. } => "below-base-circle",
            Self::AxesParallel { .. } => "axes-parallel",
            Self::InvalidCentreDistance { .. } => "invalid-centre-distance",
            Self::LeadModificationNotSupported { .. } => "lead-modification-not-supported",
            Self::NoContact { .. } => "no-contact",
            Self::ContactOffRounding { .. } => "contact-off-rounding",
            Self::RoundingTooLarge { .. } => "rounding-too-large",
            Self::CuttingDirectionAmbiguous { .. } => "cutting-direction-ambiguous",
            Self::LeverTooSmall { .. } => "lever-too-small",
            Self::PoseNotReachable { .. } => "pose-not-reachable",
            Self::DegenerateFlankDirection { .. } => "degenerate-flank-direction",
            Self::AxisLimit { .. } => "axis-limit",
            Self::Shadowed { .. } => "shadowed",
            Self::BodyTouched { .. } => "body-touched",
            Self::EdgeEndTouched { .. } => "edge-end-touched",
            Self::NoTrigger { .. } => "no-trigger",
            Self::TriggerCountMismatch { .. } => "trigger-count-mismatch",
            Self::AmbiguousTooth { .. } => "ambiguous-tooth",
            Self::TooFewTracks { .. } => "too-few-tracks",
            Self::CalibrationSingular { .. } => "calibration-singular",
        }
    }

    /// What helps, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self {
            Self::Geometry(error) => error.way_out(),
            Self::InvalidNumber { .. } => "give a value in the allowed range",
            Self::BelowBaseCircle { .. } => "begin the flank above the base circle",
            Self::AxesParallel { .. } => {
                "choose another helix angle of the tool, or give the crossed-axes angle"
            }
            Self::InvalidCentreDistance { .. } => {
                "give d > 0 for external and d < 0 for internal gears, or leave it out"
            }
            Self::LeadModificationNotSupported { .. } => {
                "give modifications of the profile only: those along the tooth are made by the machine's motion"
            }
            Self::NoContact { .. } => "check the rake angle, the tool shift and the range of the flank",
            Self::ContactOffRounding { .. } => {
                "check the chamfers and the clearance angle, or turn the step angle"
            }
            Self::RoundingTooLarge { .. } => "take a smaller rounding radius",
            Self::CuttingDirectionAmbiguous { .. } => {
                "choose a larger crossed-axes angle or another rake face"
            }
            Self::LeverTooSmall { .. } => "measure this flank at other tracks",
            Self::PoseNotReachable { .. } => {
                "allow a larger deviation from the flank direction, or tilt the beam"
            }
            Self::DegenerateFlankDirection { .. } => "measure with tangent poses",
            Self::AxisLimit { .. } => "move the light barrier, or choose another kind of pose",
            Self::Shadowed { .. } => "take a thinner beam, or another kind of pose",
            Self::BodyTouched { .. } => "lay the beam along the flank direction",
            Self::EdgeEndTouched { .. } => "move the track away from the end of the edge",
            Self::NoTrigger { .. } => "check the tooth: it may be broken off",
            Self::TriggerCountMismatch { found: 0, .. } => {
                "measure this track, or give the job the tracks that were measured"
            }
            Self::TriggerCountMismatch { .. } => {
                "check the tool for broken teeth and chips, then measure again"
            }
            Self::AmbiguousTooth { .. } => "check the clocking of the tool and the number of teeth",
            Self::TooFewTracks { .. } => "measure more tracks, or ask for a lower degree",
            Self::CalibrationSingular { .. } => "approach the mandrel at two heights, from both sides in Y",
        }
    }

    /// Whether the input is wrong, as opposed to bodies or measurements that do not go together.
    pub fn is_bad_input(&self) -> bool {
        match self {
            Self::Geometry(_)
            | Self::InvalidNumber { .. }
            | Self::BelowBaseCircle { .. }
            | Self::AxesParallel { .. }
            | Self::InvalidCentreDistance { .. }
            | Self::LeadModificationNotSupported { .. }
            | Self::TooFewTracks { .. } => true,
            Self::NoContact { .. }
            | Self::ContactOffRounding { .. }
            | Self::RoundingTooLarge { .. }
            | Self::CuttingDirectionAmbiguous { .. }
            | Self::LeverTooSmall { .. }
            | Self::PoseNotReachable { .. }
            | Self::DegenerateFlankDirection { .. }
            | Self::AxisLimit { .. }
            | Self::Shadowed { .. }
            | Self::BodyTouched { .. }
            | Self::EdgeEndTouched { .. }
            | Self::NoTrigger { .. }
            | Self::TriggerCountMismatch { .. }
            | Self::AmbiguousTooth { .. }
            | Self::CalibrationSingular { .. } => false,
        }
    }
}

fn signals(found: usize) -> String {
    if found == 0 { "there are no readings".into() } else { format!("{found} signals a revolution") }
}
