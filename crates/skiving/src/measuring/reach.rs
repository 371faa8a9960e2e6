//! Whether the machine gets into a pose and the beam passes everything else there: limits of the axes, the lean against the flank, the
//! shadow of other flanks (`docs/mathematics/skiving.md#tracks-and-poses`).

use super::{
    Beam, MeasuringPose, OTHER_FLANK_GAP, PoseKind, measuring_poses, nearest_clamped, nearest_other_flank,
    own_edge_gap,
};
use crate::{MeasuringTrack, SkivingError, VirtualEdge};
use foundation::geometry::{Flank, Sides};

/// What a machine and a user allow. mm, rad; [least, greatest].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseLimits {
    /// A.
    pub swivel: [f64; 2],
    /// X, Y, Z.
    pub position: [[f64; 2]; 3],
    /// Greatest angle eta between beam and flank direction.
    pub off_flank: f64,
    /// Depth of the clearance faces that may shade the beam.
    pub body_depth: f64,
}

impl Default for PoseLimits {
    /// Axes without ends, 15 deg and 5 mm of `docs/mathematics/skiving.md#tracks-and-poses`.
    fn default() -> Self {
        let all = [f64::NEG_INFINITY, f64::INFINITY];
        Self { swivel: all, position: [all; 3], off_flank: 15f64.to_radians(), body_depth: 5.0 }
    }
}

/// How far the own edge may reach into the beam: the touch itself, and numbers.
const OWN_EDGE: f64 = -1e-6;

/// The first pose of a track that the machine reaches, that lies on the flank closely enough and in which nothing else shades the beam.
/// Where the swivel would have to go beyond its range it stays at the end of it and the tool turns.
///
/// # Errors
/// [`SkivingError::AxisLimit`], [`SkivingError::PoseNotReachable`], [`SkivingError::Shadowed`] of the pose that came farthest; those of
/// [`measuring_poses`].
pub fn reached_pose(
    edges: &Sides<VirtualEdge>,
    track: &MeasuringTrack,
    beam: &Beam,
    kind: PoseKind,
    limits: &PoseLimits,
    (flank, number): (Flank, usize),
) -> Result<MeasuringPose, SkivingError> {
    let mut refused = None;
    for pose in measuring_poses(track, beam, kind, (flank, number))? {
        let [least, greatest] = limits.swivel;
        let clamped = pose.swivel.clamp(least, greatest);
        let held = (clamped != pose.swivel).then(|| nearest_clamped(track, beam, clamped)).flatten();
        for candidate in [Some(pose), held].into_iter().flatten() {
            match check_pose(edges, track, &candidate, beam, limits, (flank, number)) {
                Ok(()) => return Ok(candidate),
                Err(error) => refused = Some(error),
            }
        }
    }
    Err(refused.unwrap_or_else(|| SkivingError::PoseNotReachable {
        flank,
        track: number,
        reason: "no pose lays the beam on the edge".into(),
    }))
}

/// Whether a pose lies within the limits, and the beam or stylus touches nothing but the place that it is laid on.
///
/// # Errors
/// [`SkivingError::AxisLimit`], [`SkivingError::PoseNotReachable`], [`SkivingError::Shadowed`], [`SkivingError::BodyTouched`].
pub fn check_pose(
    edges: &Sides<VirtualEdge>,
    at: &MeasuringTrack,
    pose: &MeasuringPose,
    beam: &Beam,
    limits: &PoseLimits,
    (flank, track): (Flank, usize),
) -> Result<(), SkivingError> {
    let degrees = limits.swivel.map(f64::to_degrees);
    let [x, y, z] = pose.position.into();
    let [at_x, at_y, at_z] = limits.position;
    let axes = [('A', pose.swivel.to_degrees(), degrees), ('X', x, at_x), ('Y', y, at_y), ('Z', z, at_z)];
    for (axis, value, [least, greatest]) in axes {
        if !(least..=greatest).contains(&value) {
            return Err(SkivingError::AxisLimit { flank, track, axis, value, least, greatest });
        }
    }
    if pose.off_flank > limits.off_flank {
        let [found, most] = [pose.off_flank, limits.off_flank].map(f64::to_degrees);
        let reason = format!("{found:.2} deg off the flank direction, {most:.2} deg are allowed");
        return Err(SkivingError::PoseNotReachable { flank, track, reason });
    }
    let nearest = nearest_other_flank(edges, flank, pose, beam, limits.body_depth);
    if nearest.gap < OTHER_FLANK_GAP {
        let (other, tooth, gap) = (nearest.flank, nearest.tooth, nearest.gap);
        return Err(SkivingError::Shadowed { flank, track, other, tooth, gap });
    }
    // The own edge is touched at one place, which the rounding has; everything else of it must stay away
    // (`docs/mathematics/skiving.md#tracks-and-poses`).
    if own_edge_gap(&edges[flank], pose, beam, limits.body_depth) < OWN_EDGE {
        let (angle, [least, greatest]) = (at.section.contact_angle, at.section.range);
        return Err(SkivingError::BodyTouched { tooth: 0, angle, least, greatest });
    }
    Ok(())
}
