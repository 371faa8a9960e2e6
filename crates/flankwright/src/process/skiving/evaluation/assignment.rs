//! Which tooth switched: the one whose nominal angle is nearest.

use crate::geometry::Flank;
use crate::numerics::wrapped_angle;
use crate::process::skiving::SkivingError;
use std::f64::consts::{PI, TAU};

/// Angles away from the nominal ones, dF of every tooth, for the readings of one revolution.
///
/// # Errors
/// [`SkivingError::TriggerCountMismatch`], [`SkivingError::AmbiguousTooth`].
pub(super) fn assigned(
    angles: &[f64],
    pose_turn: f64,
    teeth: usize,
    (flank, track): (Flank, usize),
) -> Result<Vec<f64>, SkivingError> {
    if angles.len() != teeth {
        return Err(SkivingError::TriggerCountMismatch { flank, track, found: angles.len(), teeth });
    }
    let pitch = TAU / teeth as f64;
    let mut of_tooth = vec![None; teeth];
    for &angle in angles {
        let number = ((pose_turn - angle) / pitch).round();
        let off = wrapped_angle(angle - (pose_turn - number * pitch));
        let tooth = number.rem_euclid(teeth as f64) as usize % teeth;
        if off.abs() > PI / (2.0 * teeth as f64) || of_tooth[tooth].is_some() {
            return Err(SkivingError::AmbiguousTooth { flank, track, angle, off });
        }
        of_tooth[tooth] = Some(off);
    }
    // As many readings as teeth, no tooth twice: none is without.
    Ok(of_tooth.into_iter().flatten().collect())
}
