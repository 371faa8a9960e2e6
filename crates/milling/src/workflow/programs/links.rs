//! The way of the cutter from one path to the next, outside of the body that holds the workpiece: around the workpiece's axis in
//! steps, so that no chord dips into the body (`docs/mathematics/milling.md#positions-of-five-axes`).

use super::safe_room::SafeRoom;
use foundation::kinematics::{Direction, Point};
use motion::milling::CutterPlace as Place;
use nalgebra::{Rotation3, Vector3};
use std::f64::consts::{PI, TAU};

/// Largest turn of a straight piece about the workpiece's axis, and of the cutter's axis on it: 10 degrees, rad.
const STEP: f64 = PI / 18.0;
/// cos(STEP / 2): what a chord of that angle leaves of the distance from the axis.
pub(super) const DIP: f64 = 0.996_194_698_091_745_5;
/// Additional ways along the axis that are tried before a link is given up, mm.
const LIFTS: [f64; 9] = [0.0, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0];
/// Pieces are divided further by these numbers.
const FINER: [usize; 2] = [1, 4];
/// Places looked at on a straight piece.
pub(super) const SAMPLES: usize = 16;
/// A cutter that touches the body within this is outside: rounding, mm.
const TOUCH: f64 = 1e-9;

/// A way that may be tried: places from the one that the cutter leaves (included) to the one that it comes to. With a lift the first
/// and the last piece run along the cutter's axis.
#[derive(Clone, Debug)]
pub(super) struct LinkWay {
    pub places: Vec<Place>,
    pub lifted: bool,
}

/// A place farther along its own axis.
pub(super) fn lifted(place: &Place, way: f64) -> Place {
    let tip = Point::from_vector(place.tip.xyz + place.axis.xyz * way);
    Place { contact: tip, tip, axis: place.axis }
}

/// Ways between two places outside, the shortest first.
pub(super) fn ways<'p>(from: &'p Place, to: &'p Place) -> impl Iterator<Item = LinkWay> + 'p {
    LIFTS.into_iter().flat_map(move |lift| FINER.into_iter().map(move |finer| way(from, to, lift, finer)))
}

/// Pairs of lifted places, for a way that turns the axes back.
pub(super) fn lifted_pairs(from: &Place, to: &Place) -> impl Iterator<Item = [Place; 2]> {
    let (from, to) = (*from, *to);
    LIFTS.into_iter().map(move |lift| [lifted(&from, lift), lifted(&to, lift)])
}

fn way(from: &Place, to: &Place, lift: f64, finer: usize) -> LinkWay {
    let around = around(&lifted(from, lift), &lifted(to, lift), finer);
    if lift == 0.0 {
        return LinkWay { places: around, lifted: false };
    }
    let places = [*from].into_iter().chain(around).chain([*to]).collect();
    LinkWay { places, lifted: true }
}

/// Both places and those between, on a way around the workpiece's axis.
fn around(from: &Place, to: &Place, finer: usize) -> Vec<Place> {
    let angle = |tip: &Vector3<f64>| tip.y.atan2(tip.x);
    let (begin, end) = (angle(&from.tip.xyz), angle(&to.tip.xyz));
    let turn = (end - begin) - TAU * ((end - begin) / TAU).round();
    let back = |by: f64, x: &Vector3<f64>| Rotation3::from_axis_angle(&Vector3::z_axis(), -by) * x;
    // Seen from a frame that goes around with the tip.
    let (first, last) = (back(begin, &from.axis.xyz), back(end, &to.axis.xyz));
    let tilt = first.cross(&last).norm().atan2(first.dot(&last));
    let pieces = (turn.abs().max(tilt) / STEP).ceil().max(1.0) as usize * finer;
    let between = |k: usize| {
        let u = k as f64 / pieces as f64;
        let at = begin + turn * u;
        let mix = |a: f64, b: f64| a + (b - a) * u;
        let rho = mix(from.tip.xyz.xy().norm(), to.tip.xyz.xy().norm());
        let tip = Vector3::new(rho * at.cos(), rho * at.sin(), mix(from.tip.xyz.z, to.tip.xyz.z));
        let axis = (first + (last - first) * u).try_normalize(f64::MIN_POSITIVE).unwrap_or(last);
        let tip = Point::from_vector(tip);
        Place { contact: tip, tip, axis: Direction::from_vector(back(-at, &axis)) }
    };
    let inner = (1..pieces).map(between);
    [*from].into_iter().chain(inner).chain([*to]).collect()
}

/// Whether the cutter stays outside at a place.
pub(super) fn is_outside(room: &SafeRoom, tip: &Vector3<f64>, axis: &Vector3<f64>) -> bool {
    room.clearance(tip, axis, 1.0) >= -TOUCH
}

/// Whether the cutter stays outside on the straight way of tip and axis.
pub(super) fn straight_is_outside(room: &SafeRoom, from: &Place, to: &Place) -> bool {
    (0..=SAMPLES).all(|k| {
        let at = from.towards(to, k as f64 / SAMPLES as f64);
        is_outside(room, &at.tip.xyz, &at.axis.xyz)
    })
}
