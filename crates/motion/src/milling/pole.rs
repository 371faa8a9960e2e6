//! Where a path comes near the pole, the direction at which the first rotary axis does not move the cutter's axis
//! (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::{CutterPlace, MillingSetup};
use crate::MotionError;
use nalgebra::Vector3;

/// theta_cap where none is given: 2 degrees.
pub const DEFAULT_CAP: f64 = std::f64::consts::PI / 90.0;

/// A part of a path that comes near the pole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolePassage {
    /// Number (from 0) of the first place of it; the pole may be nearest between two places that are both farther away.
    pub from: usize,
    /// Number of its last place.
    pub to: usize,
    /// Least angle to the pole at its places and between them, rad.
    pub least: f64,
}

/// Angle (rad) from the line of the pole, 0 .. pi/2.
fn angle(pole: &Vector3<f64>, axis: &Vector3<f64>) -> f64 {
    pole.cross(axis).norm().atan2(pole.dot(axis).abs())
}

/// Least angle between a line and the directions on the shortest way from one direction to another, rad.
pub(super) fn least_angle(pole: &Vector3<f64>, [a, b]: [&Vector3<f64>; 2]) -> f64 {
    let ends = angle(pole, a).min(angle(pole, b));
    let Some(across) = a.cross(b).try_normalize(f64::MIN_POSITIVE) else { return ends };
    let foot = pole - across * across.dot(pole);
    let on_the_way = |x: &Vector3<f64>| a.cross(x).dot(&across) >= 0.0 && x.cross(b).dot(&across) >= 0.0;
    if on_the_way(&foot) || on_the_way(&-foot) {
        // The line leaves the plane of the way by this angle.
        ends.min(across.dot(pole).abs().min(1.0).asin())
    } else {
        ends
    }
}

/// All parts of a path that come within `cap` (rad) of the pole, blocks between places included.
///
/// # Errors
/// [`MotionError::Place`] for numbers that are not usable.
pub fn pole_passages(
    setup: &MillingSetup,
    places: &[CutterPlace],
    cap: f64,
) -> Result<Vec<PolePassage>, MotionError> {
    CutterPlace::check(places)?;
    let pole = setup.pole().xyz;
    let mut passages: Vec<PolePassage> = Vec::new();
    let mut near = |from: usize, to: usize, least: f64| {
        if least > cap {
            return;
        }
        match passages.last_mut() {
            Some(last) if last.to >= from => {
                last.to = to;
                last.least = last.least.min(least);
            }
            _ => passages.push(PolePassage { from, to, least }),
        }
    };
    for (k, place) in places.iter().enumerate() {
        let here = angle(&pole, &place.axis.xyz);
        near(k, k, here);
        if let Some(next) = places.get(k + 1) {
            let there = angle(&pole, &next.axis.xyz);
            let least = least_angle(&pole, [&place.axis.xyz, &next.axis.xyz]);
            // A block whose nearest place is one of its ends adds nothing to that place.
            if least < here.min(there) || here.max(there) <= cap {
                near(k, k + 1, least);
            }
        }
    }
    Ok(passages)
}
