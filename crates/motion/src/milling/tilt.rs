//! A mount that keeps a path away from the pole: the workpiece tilted by as little as it takes
//! (`docs/mathematics/milling.md#positions-of-five-axes`, strategy `mount`).

use super::pole::least_angle;
use super::{CutterPlace, MillingSetup};
use crate::MotionError;
use foundation::kinematics::{Direction, Pose, Workpiece};
use machine::StationSpindle;
use nalgebra::{Rotation3, Unit, Vector3};
use std::f64::consts::TAU;

/// A mount with the workpiece tilted about its origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltedMount {
    /// The clamping of the tilted workpiece.
    pub clamping: Pose<StationSpindle, Workpiece>,
    /// Axis of the tilt on the work spindle.
    pub axis: Direction<StationSpindle>,
    /// Its angle, rad.
    pub angle: f64,
    /// Least angle between the path and the pole, rad.
    pub least: f64,
}

/// Directions in which tilts are tried.
const DIRECTIONS: usize = 72;
/// Tilts tried in one direction over the distance wanted.
const STEPS: f64 = 4.0;
/// Halvings of the last step.
const HALVINGS: usize = 30;

/// The mount with the least tilt up to `greatest` (rad), among 72 directions, that keeps paths at least `clearance` (rad) away
/// from the pole. Whether the axes reach the paths then is decided by [`choose`](super::choose).
///
/// # Errors
/// [`MotionError::NoTilt`]; [`MotionError::InvalidNumber`]; [`MotionError::Place`] for numbers that are not usable.
pub fn tilt_mount(
    setup: &MillingSetup,
    paths: &[&[CutterPlace]],
    clearance: f64,
    greatest: f64,
) -> Result<TiltedMount, MotionError> {
    for places in paths {
        CutterPlace::check(places)?;
    }
    let in_range = |x: f64| x > 0.0 && x < std::f64::consts::FRAC_PI_2;
    for (field, value) in [("pole_cap_deg", clearance), ("greatest tilt", greatest)] {
        if !in_range(value) {
            let value = value.to_degrees();
            return Err(MotionError::InvalidNumber { field, value, allowed: "above 0, below 90 deg" });
        }
    }
    let pole = setup.pole().xyz;
    let across = across(&pole);
    let other = pole.cross(&across);
    // Where the pole has to stand on the workpiece.
    let moved = |direction: usize, tilt: f64| -> Vector3<f64> {
        let (sin, cos) = (TAU * direction as f64 / DIRECTIONS as f64).sin_cos();
        pole * tilt.cos() + (across * cos + other * sin) * tilt.sin()
    };
    let least = |pole: &Vector3<f64>| {
        let alone = paths.iter().copied().flatten().map(|place| [place, place]);
        let blocks = paths.iter().flat_map(|places| places.windows(2)).map(|pair| [&pair[0], &pair[1]]);
        alone
            .chain(blocks)
            .map(|pair| least_angle(pole, pair.map(|place| &place.axis.xyz)))
            .fold(std::f64::consts::FRAC_PI_2, f64::min)
    };
    let tilts = (0..).map(|k| f64::from(k) * clearance / STEPS).take_while(|&tilt| tilt <= greatest);
    let found = tilts.into_iter().find_map(|tilt| {
        let clear = (0..DIRECTIONS).filter(|&k| least(&moved(k, tilt)) >= clearance);
        let ends =
            clear.map(|k| (k, shortened(tilt, clearance / STEPS, |t| least(&moved(k, t)) >= clearance)));
        ends.min_by(|a, b| a.1.total_cmp(&b.1))
    });
    let Some((direction, angle)) = found else {
        let (greatest_deg, clearance_deg) = (greatest.to_degrees(), clearance.to_degrees());
        return Err(MotionError::NoTilt { greatest_deg, clearance_deg });
    };
    let new_pole = moved(direction, angle);
    // The workpiece turns the other way, so that the machine's pole comes to stand there.
    let clamping = setup.clamping();
    let axis = (clamping.rotation() * new_pole.cross(&pole)).try_normalize(f64::MIN_POSITIVE);
    let axis = axis.unwrap_or_else(|| clamping.rotation() * across);
    let turn = *Rotation3::from_axis_angle(&Unit::new_unchecked(axis), angle).matrix();
    let tilted = Pose::rigid(turn * clamping.rotation(), *clamping.translation());
    Ok(TiltedMount {
        clamping: tilted,
        axis: Direction::from_vector(axis),
        angle,
        least: least(&setup.clamped(tilted).pole().xyz),
    })
}

/// A unit vector across another.
fn across(k: &Vector3<f64>) -> Vector3<f64> {
    let mut e = Vector3::zeros();
    e[k.iamin()] = 1.0;
    (e - k * k.dot(&e)).normalize()
}

/// The least tilt of the last step that is still clear.
fn shortened(tilt: f64, step: f64, clear: impl Fn(f64) -> bool) -> f64 {
    let (mut short, mut enough) = ((tilt - step).max(0.0), tilt);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (short + enough);
        if clear(middle) { enough = middle } else { short = middle }
    }
    enough
}
