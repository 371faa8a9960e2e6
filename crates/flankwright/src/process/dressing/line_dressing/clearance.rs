//! How much room the disc has in the thread space: its rounded tip and its sides against both flanks, by the closed distance
//! to an involute flank (spec 29 section 1). Knows one position, no line.

use super::{TipDisc, Touch};
use crate::geometry::InvoluteFlank;
use crate::numerics::golden_section;
use nalgebra::Vector3;
use std::f64::consts::PI;

/// The thread space in which the disc works.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ThreadSpace {
    /// The flank that is dressed.
    pub own: InvoluteFlank,
    /// The flank on the other side of the space.
    pub counter: InvoluteFlank,
    /// Radius up to which the thread has flanks, mm.
    pub tip_radius: f64,
}

/// Room of the disc in one position, mm; negative where it cuts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Room {
    /// Least distance to the counter flank.
    pub counter: f64,
    /// Least distance of the tip to the flank that is dressed, its modification included: 0 at the contact.
    pub own: f64,
    /// Smallest radius of the worm that the rim reaches.
    pub deepest: f64,
}

/// The disc is looked at over this angle to both sides of the direction to the worm axis, rad: beyond it, it is out of the
/// thread space of any worm that it can dress.
const HALF_ANGLE: f64 = 1.2;
/// Positions of the scan and steps of the search round the best.
const SCAN: usize = 81;
const STEPS: usize = 40;
/// Circles of each side, from the tip rounding inwards, as shares of the depth of the thread.
const SIDE_CIRCLES: [f64; 3] = [0.0, 0.5, 1.0];

/// Room of the disc at `touch`; `modification` is f_n1 of the dressed flank at (w, z), mm.
pub(super) fn room(
    disc: &TipDisc,
    touch: &Touch,
    space: &ThreadSpace,
    modification: &dyn Fn(f64, f64) -> f64,
) -> Room {
    let deepest = touch.position.centre_distance - disc.outside_radius();
    let depth = space.tip_radius - deepest;
    let r_t = disc.tip_radius();
    // Radius and axial position of a circle of the disc, and radius of the body round it.
    let tip = [disc.centre_radius(), 0.0, r_t];
    let sides = SIDE_CIRCLES.into_iter().flat_map(|share| {
        let radius = disc.centre_radius() - share * depth;
        [[radius, r_t, 0.0], [radius, -r_t, 0.0]]
    });
    let circles: Vec<[f64; 3]> = std::iter::once(tip).chain(sides).filter(|c| c[0] > 0.0).collect();
    let least_of = |circles: &[[f64; 3]], flank: &InvoluteFlank, added: &dyn Fn(f64, f64) -> f64| {
        let distances = circles.iter().map(|circle| least(touch, *circle, flank, space.tip_radius, added));
        distances.fold(f64::INFINITY, f64::min)
    };
    Room {
        counter: least_of(&circles, &space.counter, &|_, _| 0.0),
        // Where the side would touch the dressed flank, the rounding next to it does too.
        own: least_of(&circles[..1], &space.own, modification),
        deepest,
    }
}

/// Distance of a point in the thread space from a flank, mm: > 0 outside the material; infinite where there is no flank.
fn distance(flank: &InvoluteFlank, x: &Vector3<f64>, modification: &dyn Fn(f64, f64) -> f64) -> f64 {
    let at = flank.deviation(x);
    // The nearest thread may be the next one: across the space a distance counts from this side.
    let base_pitch = 2.0 * PI * flank.base_radius * flank.base_helix_angle.cos() / flank.teeth;
    let f = if at.f_n < -0.25 * base_pitch { at.f_n + base_pitch } else { at.f_n };
    if f.is_nan() { f64::INFINITY } else { f - modification(at.w, at.z) }
}

/// Least distance of the body round one circle of the disc from a flank.
fn least(
    touch: &Touch,
    [radius, z, body]: [f64; 3],
    flank: &InvoluteFlank,
    tip_radius: f64,
    modification: &dyn Fn(f64, f64) -> f64,
) -> f64 {
    // Radial directions of the disc: towards the worm axis, and across.
    let to_axis = Vector3::new(-touch.centre.x, -touch.centre.y, 0.0);
    let towards = (to_axis - touch.axis * to_axis.dot(&touch.axis)).normalize();
    let across = touch.axis.cross(&towards);
    let at = |psi: f64| {
        let radial = towards * psi.cos() + across * psi.sin();
        let x = touch.centre + radial * radius + touch.axis * z;
        if x.x.hypot(x.y) > tip_radius + body {
            return f64::INFINITY;
        }
        distance(flank, &x, modification) - body
    };
    let step = 2.0 * HALF_ANGLE / (SCAN - 1) as f64;
    let values: Vec<f64> = (0..SCAN).map(|k| at(-HALF_ANGLE + step * k as f64)).collect();
    let best = (0..SCAN).min_by(|&a, &b| values[a].total_cmp(&values[b])).unwrap_or(0);
    let middle = -HALF_ANGLE + step * best as f64;
    let psi = golden_section(middle - step, middle + step, STEPS, at);
    values[best].min(at(psi))
}
