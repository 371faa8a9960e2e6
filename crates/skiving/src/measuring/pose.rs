//! Poses of the tool in which the beam touches the edge at a track: position and orientation in closed form
//! (`docs/mathematics/skiving.md#tracks-and-poses`).

use super::Beam;
use crate::{MeasuringTrack, SkivingError};
use foundation::geometry::Flank;
use foundation::numerics::wrapped_angle;
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, TAU};

/// How the beam is to lie on the edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PoseKind {
    /// TANGENT: tangential, the tool turned as it stands when it cuts there.
    #[default]
    Tangent,
    /// EXACT, along the flank's helix; where that cannot be reached BEST, the nearest direction within the tangent plane.
    AlongFlank,
}

/// Positions of the tool's axes with the beam on the edge. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuringPose {
    /// A: swivel of the tool.
    pub swivel: f64,
    /// B: turn of the tool.
    pub turn: f64,
    /// X, Y, Z.
    pub position: Vector3<f64>,
    /// eta: angle between the beam and the flank's helix.
    pub off_flank: f64,
    /// l_S: the beam's direction in tool coordinates.
    pub beam_in_tool: Vector3<f64>,
}

/// Below this length across the axis the flank direction tells no turn.
const ALONG_AXIS: f64 = 1e-9;

impl MeasuringPose {
    /// The pose in which the beam touches a track's point across a normal, for a given orientation.
    pub(super) fn laid(
        track: &MeasuringTrack,
        normal: &Vector3<f64>,
        beam: &Beam,
        [swivel, turn]: [f64; 2],
    ) -> Self {
        let to_machine = |v: &Vector3<f64>| swivelled(swivel, &turned(turn, v));
        let (m, n) = (to_machine(&track.contact.point), to_machine(normal));
        let (l, at, radius) = (&beam.direction, &beam.point, beam.radius);
        // The contact lies in the beam's level; the axis of the beam passes it at the radius along the normal.
        let unit = beam.unit();
        let along = radius * n.dot(&beam.level) / unit.dot(&beam.level);
        let position = at + unit * along - m - n * radius;
        let beam_in_tool = turned(-turn, &swivelled(-swivel, &l.normalize()));
        let off_flank = angle_between(&beam_in_tool, &track.contact.flank_direction);
        Self { swivel, turn: wrapped_angle(turn), position, off_flank, beam_in_tool }
    }

    /// The pose with the beam tangential at a track, for a given orientation.
    fn at(track: &MeasuringTrack, beam: &Beam, swivel: f64, turn: f64) -> Self {
        Self::laid(track, &track.contact.normal, beam, [swivel, turn])
    }

    /// A point of the tool at a turn B, in machine coordinates.
    pub fn to_machine(&self, turn: f64, point: &Vector3<f64>) -> Vector3<f64> {
        self.position + swivelled(self.swivel, &turned(turn, point))
    }
}

/// The poses of a track: one tangential; along the flank two where the helix can be reached (the smaller swivel first), one where not.
///
/// # Errors
/// [`SkivingError::PoseNotReachable`], [`SkivingError::DegenerateFlankDirection`] for the track's number.
pub fn measuring_poses(
    track: &MeasuringTrack,
    beam: &Beam,
    kind: PoseKind,
    (flank, number): (Flank, usize),
) -> Result<Vec<MeasuringPose>, SkivingError> {
    match kind {
        PoseKind::Tangent => tangent(track, beam, track.contact.tool_angle + FRAC_PI_2)
            .map(|pose| vec![pose])
            .ok_or_else(|| SkivingError::PoseNotReachable {
                flank,
                track: number,
                reason: "the beam is tilted out of the Y-Z plane by more than the edge's normal leans from it; poses along the flank turn \
                         the tool to it"
                    .into(),
            }),
        PoseKind::AlongFlank => {
            let g = &track.contact.flank_direction;
            if g.x.hypot(g.y) < ALONG_AXIS {
                return Err(SkivingError::DegenerateFlankDirection { flank, track: number });
            }
            Ok(along_flank(track, beam))
        }
    }
}

/// F_i,k: the turn at which tooth k of the ideal tool switches, rad.
pub fn nominal_angle(pose: &MeasuringPose, tooth: usize, teeth: usize) -> f64 {
    pose.turn - TAU * tooth as f64 / teeth as f64
}

/// TANGENT: the turn given, the swivel that brings the normal across the beam.
pub(super) fn tangent(track: &MeasuringTrack, beam: &Beam, turn: f64) -> Option<MeasuringPose> {
    let n = turned(turn, &track.contact.normal);
    let l = &beam.direction;
    let (a, b) = (l.y * n.y + l.z * n.z, l.z * n.y - l.y * n.z);
    let cosine = -l.x * n.x / a.hypot(b);
    if cosine.is_nan() || cosine.abs() > 1.0 {
        return None;
    }
    let (middle, half) = (b.atan2(a), cosine.acos());
    nearest(track, beam, [middle + half, middle - half].map(|swivel| (swivel, turn)))
}

/// CLAMPED: the swivel given, the turn that brings the normal across the beam. `None` where no turn does.
pub fn nearest_clamped(track: &MeasuringTrack, beam: &Beam, swivel: f64) -> Option<MeasuringPose> {
    let n = &track.contact.normal;
    let l = swivelled(-swivel, &beam.direction);
    let (p, q) = (l.x * n.x + l.y * n.y, l.y * n.x - l.x * n.y);
    let cosine = -l.z * n.z / p.hypot(q);
    if cosine.is_nan() || cosine.abs() > 1.0 {
        return None;
    }
    let (middle, half) = (q.atan2(p), cosine.acos());
    nearest(track, beam, [middle + half, middle - half].map(|turn| (swivel, turn)))
}

/// Of two orientations the one nearer to the flank's helix.
fn nearest(track: &MeasuringTrack, beam: &Beam, of: [(f64, f64); 2]) -> Option<MeasuringPose> {
    let poses = of.map(|(swivel, turn)| MeasuringPose::at(track, beam, wrapped_angle(swivel), turn));
    poses.into_iter().min_by(|a, b| a.off_flank.total_cmp(&b.off_flank))
}

/// EXACT, or BEST where the flank leans less from the tool's axis than the beam out of the Y-Z plane.
fn along_flank(track: &MeasuringTrack, beam: &Beam) -> Vec<MeasuringPose> {
    let (g, n) = (&track.contact.flank_direction, &track.contact.normal);
    let l = beam.unit();
    let across = l.y.hypot(l.z);
    let lean = l.y.atan2(l.z);
    if g.z.abs() <= across {
        let reach = (g.z / across).acos();
        let mut poses = [1.0, -1.0].map(|sense| {
            let angle = sense * reach;
            let turn = (across * angle.sin()).atan2(l.x) - g.y.atan2(g.x);
            MeasuringPose::at(track, beam, wrapped_angle(angle - lean), turn)
        });
        if poses[1].swivel.abs() < poses[0].swivel.abs() {
            poses.swap(0, 1);
        }
        return poses.to_vec();
    }
    let second = n.cross(g);
    let length = g.z.hypot(second.z);
    let (middle, half) = (second.z.atan2(g.z), (across / length).acos());
    let eta = [middle + half, middle - half].into_iter().min_by(|a, b| a.abs().total_cmp(&b.abs()));
    let (sin, cos) = eta.unwrap_or(middle).sin_cos();
    let wanted = g * cos + second * sin;
    let turn = 0f64.atan2(l.x) - wanted.y.atan2(wanted.x);
    vec![MeasuringPose::at(track, beam, -lean, turn)]
}

/// Rz(angle) v.
pub(crate) fn turned(angle: f64, v: &Vector3<f64>) -> Vector3<f64> {
    let (sin, cos) = angle.sin_cos();
    Vector3::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z)
}

/// Rx(angle) v.
pub(super) fn swivelled(angle: f64, v: &Vector3<f64>) -> Vector3<f64> {
    let (sin, cos) = angle.sin_cos();
    Vector3::new(v.x, cos * v.y - sin * v.z, sin * v.y + cos * v.z)
}

/// Angle between two unit directions, exact for small ones.
fn angle_between(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    a.cross(b).norm().atan2(a.dot(b))
}
