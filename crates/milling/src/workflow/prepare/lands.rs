//! The tops of the teeth beside a space: what shank and holder of a cutter keep away from.

use crate::{Land, SpaceFlank};
use foundation::geometry::Frustum;
use foundation::numerics::extremes;
use std::f64::consts::TAU;

/// The lands of both teeth beside the space: frusta between the ends of pieces of the face, from the tip edge of one flank to that
/// of the other flank of the next space. `place` gives radius, position and turn of the teeth at a length.
pub(super) fn lands(
    flanks: &[SpaceFlank],
    spaces: usize,
    ends: &[f64],
    place: impl Fn(f64) -> [f64; 3],
    outward: f64,
) -> Vec<Land> {
    let azimuth = |flank: &SpaceFlank, length: f64| {
        let [_, tip] = flank.active.height_span();
        let point = flank.active.surface.point(tip, length);
        point.x.atan2(point.y) - place(length)[2]
    };
    let mut lands = Vec::new();
    for pair in ends.windows(2) {
        let at = [place(pair[0]), place(pair[1])];
        let of = |k: usize| [at[0][k], at[1][k]];
        let surface = Frustum { radii: of(0), positions: of(1), turns: of(2), outward };
        let middle = 0.5 * (pair[0] + pair[1]);
        let within = |angle: f64| angle - TAU * (angle / TAU).round();
        let edges = [&flanks[0], &flanks[1]].map(|flank| within(azimuth(flank, middle)));
        let [low, high] = extremes(edges);
        let pitch = TAU / spaces as f64;
        let [above, below] = if edges[0] > edges[1] { [0, 1] } else { [1, 0] };
        lands.push(Land { surface, azimuths: [high, low + pitch], side: flanks[above].side });
        lands.push(Land { surface, azimuths: [high - pitch, low], side: flanks[below].side });
    }
    lands
}
