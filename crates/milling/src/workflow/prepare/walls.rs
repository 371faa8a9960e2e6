//! The bodies beside the flanks of a job: root cylinder, root cone or hub, and the ring of an internal gear.

use crate::job::{MilledRoot, RootBottom};
use crate::{Wall, WallKind};
use foundation::geometry::{BevelGear, Frustum};
use std::f64::consts::PI;
use std::sync::Arc;

/// How far the drawn root lies below the root body, mm, above which the guide curve stands by `lead` mm; 0 where it does not.
pub(super) fn below_root_body(root: Option<&MilledRoot>, lead: f64) -> f64 {
    match root.map(MilledRoot::depth) {
        Some(RootBottom::Height(height)) => (-height - lead).max(0.0),
        Some(RootBottom::Straight(_)) | None => 0.0,
    }
}

/// A frustum between two azimuths.
fn frustum(name: &'static str, kind: WallKind, surface: Frustum, azimuths: [f64; 2]) -> Wall {
    Wall { name, kind, surface: Arc::new(surface), heights: azimuths, lengths: [0.0, 1.0], turn: 0.0 }
}

/// A body inside of its teeth or blades, around the whole circumference.
fn around(name: &'static str, [radii, positions]: [[f64; 2]; 2]) -> Wall {
    let surface = Frustum { radii, positions, turns: [0.0; 2], outward: 1.0 };
    frustum(name, WallKind::Base, surface, [-PI, PI])
}

/// The cylinder that the teeth of an internal gear stand on, about the space at +y, whose middle turns with the teeth: by `turns` at both
/// ends. What lies across the bore belongs to the [`ring`].
pub(super) fn root_in_ring(radius: f64, ends: [f64; 2], turns: [f64; 2], pitch: f64) -> Wall {
    let surface = Frustum { radii: [radius; 2], positions: ends, turns, outward: -1.0 };
    frustum("root body", WallKind::Base, surface, [-pitch, pitch])
}

/// The root cone of a bevel gear between two distances from the apex, so many mm below the drawn one.
pub(super) fn root_cone(gear: &BevelGear, face: [f64; 2], below: f64) -> Wall {
    let (sin, cos) = gear.root_angle().sin_cos();
    let [radii, positions] = [face.map(|r| r * sin - below * cos), face.map(|r| r * cos + below * sin)];
    around("root body", [radii, positions])
}

/// The body of revolution that teeth stand on, by its ends as (radius, position).
pub(super) fn root_body(ends: [[f64; 2]; 2]) -> Wall {
    around("root body", [[ends[0][0], ends[1][0]], [ends[0][1], ends[1][1]]])
}

/// The hub between the ends of its blades.
pub(super) fn hub(radii: [f64; 2], ends: [f64; 2]) -> Wall {
    around("hub", [radii, ends])
}

/// Teeth and ends of an internal gear away from the space about +y, whose middle turns with the teeth: by `turns` at both ends.
pub(super) fn ring([tip, rim]: [f64; 2], ends: [f64; 2], turns: [f64; 2], pitch: f64) -> Vec<Wall> {
    let wall = |name, surface| frustum(name, WallKind::Ring, surface, [pitch, 2.0 * PI - pitch]);
    let bore = Frustum { radii: [tip; 2], positions: ends, turns, outward: -1.0 };
    let end =
        |k: usize| Frustum { radii: [tip, rim], positions: [ends[k]; 2], turns: [turns[k]; 2], outward: 1.0 };
    vec![wall("teeth of the ring", bore), wall("end of the ring", end(0)), wall("end of the ring", end(1))]
}
