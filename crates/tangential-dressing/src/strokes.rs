//! How far the axes go and which part of the worm is used (`docs/mathematics/tangential-dressing.md#how-it-is-verified`: the dresser must
//! cover more than the tool shifts).

use super::forward::{FlankPoint, TangentialFlank};
use contact::ToolSurface;

/// Ranges of one flank's motions. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TangentialStrokes {
    /// x_D at which the evaluated flank is dressed.
    pub positions: [f64; 2],
    /// x_D of the dressing stroke: the same with a run-in and run-out, so that what is used is finished.
    pub dressing: [f64; 2],
    /// z_V2 of the grinding stroke.
    pub feed: [f64; 2],
    /// Lengths of roll of the worm that are used.
    pub worm_rolls: [f64; 2],
    /// Axial positions on the worm that are used.
    pub worm_faces: [f64; 2],
    /// Largest distance of the dressed worm flank from the unmodified one at its contacts.
    pub worm_modification: f64,
}

/// The used part of the worm is taken larger by this much in roll and along the axis, for what lies beside a contact.
const MARGINS: [f64; 2] = [0.1, 1.5];
/// Run-in and run-out of both strokes, mm.
const RUN_IN: f64 = 2.0;

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
}

fn wider([from, to]: [f64; 2], by: f64) -> [f64; 2] {
    [from - by, to + by]
}

impl TangentialFlank<'_> {
    /// The ranges that ground points of the flank need.
    pub fn strokes(&self, points: &[FlankPoint]) -> TangentialStrokes {
        let surface = self.surface();
        let feet: Vec<(f64, f64, f64, f64)> = points
            .iter()
            .filter_map(|p| {
                let dressed = surface.touch(p.height, p.position)?;
                let axial = p.position + surface.laws.axial.value(p.position);
                let (point, _) = dressed.contact.on_worm(surface.worm_angle(p.position), axial);
                let foot = self.worm().deviation(&point);
                // Where the dresser stands against the place that it would dress without corrections.
                Some((foot.w, foot.z, p.position - surface.start(foot.w, foot.z).1, foot.f_n))
            })
            .collect();
        let [first, last] = surface.profile.rolls();
        let [low, high] = wider(range(feet.iter().map(|f| f.0)), MARGINS[0]);
        let worm_rolls = [low.max(first), high.min(last)];
        let worm_faces = wider(range(feet.iter().map(|f| f.1)), MARGINS[1]);
        let [back, ahead] = range(feet.iter().map(|f| f.2));
        let corners = worm_rolls.into_iter().flat_map(|w| worm_faces.map(|z| surface.start(w, z).1));
        let [from, to] = range(corners);
        TangentialStrokes {
            positions: range(points.iter().map(|p| p.position)),
            dressing: [from + back - RUN_IN, to + ahead + RUN_IN],
            feed: wider(range(points.iter().map(|p| -p.feed)), RUN_IN),
            worm_rolls,
            worm_faces,
            worm_modification: feet.iter().map(|f| f.3.abs()).fold(0.0, f64::max),
        }
    }
}
