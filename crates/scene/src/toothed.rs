//! A body with teeth as it is drawn: its flanks and the radii of its sections. Knows no motion, and no modification: micrometres cannot
//! be seen.

use foundation::geometry::{Flank, Gear};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// A body with teeth outside, between two faces. mm.
#[derive(Clone, Copy, Debug)]
pub struct Toothed<'a> {
    /// Its flanks.
    pub gear: &'a Gear,
    /// Tip radius at z = 0.
    pub tip: f64,
    /// Root radius at z = 0.
    pub root: f64,
    /// Radius at z = 0 at which flanks begin, where that is above the root.
    pub form: f64,
    /// Faces.
    pub faces: [f64; 2],
}

/// Bore of a drawn body as a share of its root radius.
pub const BORE: f64 = 0.45;
/// Least width of a tip or root that is drawn, and least height of a fillet, as shares of the module.
const LEAST_WIDTH: f64 = 0.02;
pub(super) const LEAST_FILLET: f64 = 0.02;

/// Radii of one section.
#[derive(Clone, Copy)]
pub struct Radii {
    /// Tip.
    pub tip: f64,
    /// Where the involute begins.
    pub start: f64,
    /// Root.
    pub root: f64,
}

impl Toothed<'_> {
    /// Polar angle of a flank's point at a radius, from +y towards +x, full turns kept.
    pub fn polar(&self, flank: Flank, radius: f64, z: f64) -> f64 {
        let f = self.gear.flank(flank);
        let w = roll(self.gear, flank, radius);
        f.phi(w, z) - f.s() * f.external_sign * (w / f.base_radius).atan()
    }

    /// Angle of the space at a radius.
    pub(super) fn space(&self, radius: f64, z: f64) -> f64 {
        self.polar(Flank::Left, radius, z) - self.polar(Flank::Right, radius, z)
    }

    /// Radii of the section at z.
    pub fn radii(&self, z: f64) -> Radii {
        let lean = z * self.gear.data().cone_angle.tan();
        let module = self.gear.data().normal_module;
        let (pitch, least) = (TAU / self.gear.tooth_count(), LEAST_WIDTH * module);
        let base = Flank::BOTH.map(|f| self.gear.flank(f).base_radius).into_iter().fold(0.0, f64::max);
        let (mut tip, mut root) = (self.tip - lean, self.root - lean);
        // Teeth or spaces that run together before their end are cut where they have some width left.
        let middle = 0.5 * (tip + root.max(base));
        let wide = |radius: f64| (pitch - self.space(radius, z)) * radius >= least;
        tip = last_good(middle, tip, wide);
        let floor = root.max(base);
        let open = |radius: f64| self.space(radius, z) * radius >= least;
        let reached = last_good(middle, floor, open);
        if reached > floor {
            root = reached;
        }
        let mut start = (self.form - lean).max(root).max(base);
        if start > root && start - root < LEAST_FILLET * module {
            start = root + LEAST_FILLET * module;
        }
        Radii { tip, start, root }
    }
}

pub(super) fn roll(gear: &Gear, flank: Flank, radius: f64) -> f64 {
    gear.flank(flank).length_of_roll(radius).unwrap_or(0.0)
}

/// The place nearest to `to` on the way from `from` at which something still holds; `to` itself where it holds there.
fn last_good(from: f64, to: f64, good: impl Fn(f64) -> bool) -> f64 {
    if good(to) {
        return to;
    }
    let (mut inside, mut outside) = (from, to);
    for _ in 0..40 {
        let middle = 0.5 * (inside + outside);
        if good(middle) { inside = middle } else { outside = middle }
    }
    inside
}

/// A bore in the section at z.
pub fn circle(radius: f64, z: f64, corners: usize) -> Vec<Vector3<f64>> {
    let corner = |k: usize| {
        let (sin, cos) = (TAU * k as f64 / corners as f64).sin_cos();
        Vector3::new(radius * cos, radius * sin, z)
    };
    (0..corners).map(corner).collect()
}
