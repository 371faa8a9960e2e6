//! The usual way, for comparison: the beam parallel to the tool's axis in every pose. It touches the silhouette instead of the contact
//! point (`docs/mathematics/skiving.md#limits`).

use super::{Barrier, Beam, MeasuringPose, RealTool, nominal_angle};
use crate::{MeasuringTrack, SkivingError, VirtualEdge};
use foundation::numerics::wrapped_angle;
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// What the usual way finds at a track of a tooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConventionalReading {
    /// Deviation that it reports, mm.
    pub deviation: f64,
    /// Angle of the touch on the rounding, rad.
    pub angle: f64,
    /// Where the rounding ends there, rad.
    pub end: f64,
}

/// The pose of the usual way: tool upright, turned as it cuts at the track, the beam beside the contact point.
pub fn conventional_pose(track: &MeasuringTrack, beam: &Beam) -> MeasuringPose {
    MeasuringPose::laid(track, &level(track), beam, [0.0, track.contact.tool_angle + FRAC_PI_2])
}

/// What it reports of a tooth, for an upright beam.
///
/// # Errors
/// [`SkivingError::InvalidNumber`] for a tilted beam; [`SkivingError::BodyTouched`] where the silhouette is not on the rounding, so that
/// wear cannot be seen; [`SkivingError::NoTrigger`].
pub fn conventional_reading(
    edge: &VirtualEdge,
    tool: &RealTool,
    track: &MeasuringTrack,
    beam: &Beam,
    tooth: usize,
) -> Result<ConventionalReading, SkivingError> {
    if beam.direction.xy().norm() != 0.0 {
        let (field, value) = ("beam.tilt", beam.direction.xy().norm().atan().to_degrees());
        return Err(SkivingError::InvalidNumber {
            field,
            value,
            allowed: "0: the usual way has an upright beam",
        });
    }
    let pose = conventional_pose(track, beam);
    let barrier = Barrier { beam, pose: &pose };
    let nominal = nominal_angle(&pose, tooth, tool.teeth());
    let touch = barrier.anywhere(edge, tool, tooth, beam.radius, [track.contact.w, nominal])?;
    let [least, greatest] = edge.section(touch.w).range;
    if !(least..=greatest).contains(&touch.angle) {
        return Err(SkivingError::BodyTouched { tooth, angle: touch.angle, least, greatest });
    }
    let n = level(track);
    let lever = track.contact.point.x * n.y - track.contact.point.y * n.x;
    Ok(ConventionalReading {
        deviation: -lever * wrapped_angle(touch.turn - nominal),
        angle: touch.angle,
        end: greatest,
    })
}

/// The normal without its part along the tool's axis.
fn level(track: &MeasuringTrack) -> Vector3<f64> {
    let n = &track.contact.normal;
    Vector3::new(n.x, n.y, 0.0).normalize()
}
