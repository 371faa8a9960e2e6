//! Angles without their full turns.

use std::f64::consts::TAU;

/// The angle brought into -pi..pi, rad.
pub fn wrapped_angle(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
