//! Which tooth switched. A tool is clamped at any angle, but its teeth stand evenly: the light of all tracks tells the angle up to whole
//! pitches, and the tooth that then stands nearest to its nominal angle is tooth 0, or the one that the user names.

use crate::SkivingError;
use foundation::geometry::Flank;
use foundation::numerics::wrapped_angle;
use std::f64::consts::TAU;

/// How far from its place among the others a switch may lie, in pitches: beyond it might belong to a neighbour.
const FARTHEST: f64 = 0.3;

/// How far the tool is turned against the nominal angles of its teeth, rad: between half a pitch to both sides of `near`. `turns` are
/// the angles less that of tooth 0 on the same track.
pub(super) fn clamped_at(turns: impl Iterator<Item = f64>, teeth: usize, near: f64) -> f64 {
    // The mean direction on a circle of one pitch.
    let (sin, cos) = turns.fold((0.0, 0.0), |(sin, cos), turn| {
        let (s, c) = (teeth as f64 * (turn - near)).sin_cos();
        (sin + s, cos + c)
    });
    near + f64::atan2(sin, cos) / teeth as f64
}

/// Angles away from the nominal ones, dF of every tooth, for the readings of one revolution; `None` for a tooth that did not switch.
/// The tool stands turned by `clamped`, rad.
///
/// # Errors
/// [`SkivingError::TriggerCountMismatch`] for more switches than teeth or for less than half of them,
/// [`SkivingError::AmbiguousTooth`] for one between two teeth and for two of the same.
pub(super) fn assigned(
    angles: &[f64],
    (pose_turn, clamped): (f64, f64),
    teeth: usize,
    (flank, track): (Flank, usize),
) -> Result<Vec<Option<f64>>, SkivingError> {
    if angles.len() > teeth || 2 * angles.len() < teeth {
        return Err(SkivingError::TriggerCountMismatch { flank, track, found: angles.len(), teeth });
    }
    let pitch = TAU / teeth as f64;
    let mut of_tooth = vec![None; teeth];
    for &angle in angles {
        let number = ((pose_turn + clamped - angle) / pitch).round();
        let off = wrapped_angle(angle - clamped - (pose_turn - number * pitch));
        let tooth = number.rem_euclid(teeth as f64) as usize % teeth;
        if off.abs() > FARTHEST * pitch || of_tooth[tooth].is_some() {
            return Err(SkivingError::AmbiguousTooth { flank, track, angle, off });
        }
        of_tooth[tooth] = Some(clamped + off);
    }
    Ok(of_tooth)
}
