//! How much room the disc has in the thread space: its rounded tip and its sides against both flanks, by the closed distance
//! to an involute flank (`docs/mathematics/dressing.md#conditions`). Knows one position, no line.

use super::{TipDisc, Touch};
use foundation::geometry::InvoluteFlank;
use foundation::numerics::golden_section;
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
    /// Least distance to the opposite flank.
    pub counter: f64,
    /// Least distance of the tip to the flank that is dressed, its modification included: 0 at the contact.
    pub own: f64,
    /// Smallest radius of the worm that the rim reaches.
    pub deepest: f64,
}

/// The disc is looked at over this angle to both sides of the contact, rad: beyond it, it is out of the thread space of any worm
/// that it can dress.
const HALF_ANGLE: f64 = 1.4;
/// Positions of the scan to each side and steps of the search round the best. Between two of them a distance changes by less than
/// half a pitch of the threads.
const SCAN: usize = 80;
const STEPS: usize = 40;
/// Circles of each side, from the tip rounding inwards, as shares of the depth of the thread.
const SIDE_CIRCLES: [f64; 3] = [0.0, 0.5, 1.0];

/// A circle of the disc: radius, axial position, and radius of the body round it.
type Circle = [f64; 3];

/// Room of the disc at `touch`, whose contact is at `contact`; `modification` is f_n1 of the dressed flank at (w, z), mm.
pub(super) fn room(
    disc: &TipDisc,
    touch: &Touch,
    contact: &Vector3<f64>,
    space: &ThreadSpace,
    modification: &dyn Fn(f64, f64) -> f64,
) -> Room {
    let deepest = touch.position.centre_distance - disc.outside_radius();
    let depth = space.tip_radius - deepest;
    let r_t = disc.tip_radius();
    let tip: Circle = [disc.centre_radius(), 0.0, r_t];
    let side = |z: f64| {
        SIDE_CIRCLES
            .map(|share| [disc.centre_radius() - share * depth, z, 0.0])
            .into_iter()
            .filter(|c| c[0] > 0.0)
    };
    let plain = |_: f64, _: f64| 0.0;
    // Where the side would touch the dressed flank, the rounding next to it does too.
    let own = Wall { flank: &space.own, tip_radius: space.tip_radius, modification };
    let counter = Wall { flank: &space.counter, tip_radius: space.tip_radius, modification: &plain };
    // The contact lies in the space, so that the opposite flank is in front of it.
    let across = counter.flank.deviation(contact).f_n;
    let across = if across < 0.0 { across + counter.pitch() } else { across };
    let walls = [side(r_t).collect(), side(-r_t).collect(), vec![tip]];
    Room {
        counter: walls
            .iter()
            .map(|chain: &Vec<Circle>| counter.least(touch, chain, across))
            .fold(f64::INFINITY, f64::min),
        own: own.least(touch, &[tip], r_t),
        deepest,
    }
}

/// A flank of the thread space as something to stay clear of.
struct Wall<'a> {
    flank: &'a InvoluteFlank,
    tip_radius: f64,
    modification: &'a dyn Fn(f64, f64) -> f64,
}

impl Wall<'_> {
    /// Distance of two threads along the normal, mm.
    fn pitch(&self) -> f64 {
        2.0 * PI * self.flank.base_radius * self.flank.base_helix_angle.cos() / self.flank.teeth
    }

    /// Distance of a point from this very flank, mm: the closed distance is that of the nearest thread, so whole pitches are
    /// added until it is next to `near`, the distance of a point less than half a pitch away.
    fn distance(&self, x: &Vector3<f64>, near: f64) -> Option<f64> {
        let at = self.flank.deviation(x);
        let f = at.f_n + self.pitch() * ((near - at.f_n) / self.pitch()).round();
        f.is_finite().then(|| f - (self.modification)(at.w, at.z))
    }

    /// Least distance of the bodies round a chain of circles, each next to the one before it; `near` is the distance of a point
    /// next to the first.
    fn least(&self, touch: &Touch, circles: &[Circle], near: f64) -> f64 {
        let radial = touch.around.cross(&touch.axis);
        let mut least = f64::INFINITY;
        let mut near = near;
        for &[radius, z, body] in circles {
            let point = |psi: f64| {
                touch.centre + (radial * psi.cos() + touch.around * psi.sin()) * radius + touch.axis * z
            };
            let exists = |x: &Vector3<f64>| x.x.hypot(x.y) <= self.tip_radius + body;
            near = self.distance(&point(0.0), near).unwrap_or(near);
            let mut best = (f64::INFINITY, 0.0, near);
            for way in [1.0, -1.0] {
                let mut before = near;
                for k in 0..=SCAN {
                    let psi = way * HALF_ANGLE * k as f64 / SCAN as f64;
                    let x = point(psi);
                    let Some(f) = self.distance(&x, before) else { break };
                    before = f;
                    if exists(&x) && f < best.0 {
                        best = (f, psi, f);
                    }
                }
            }
            let step = HALF_ANGLE / SCAN as f64;
            let at = |psi: f64| {
                let x = point(psi);
                self.distance(&x, best.2).filter(|_| exists(&x)).unwrap_or(f64::INFINITY)
            };
            let psi = golden_section(best.1 - step, best.1 + step, STEPS, at);
            least = least.min(best.0.min(at(psi)) - body);
        }
        least
    }
}
