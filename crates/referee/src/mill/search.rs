//! The lowest entry of one ray into a cutter that runs along a block, with a proof that no place of the block enters lower.
//!
//! The proof covers the block with stretches. At an anchor (length l, fraction t) the distance D of the ray's point has a tangent
//! plane; the parts are convex and the path of a point in the coordinates of the cutter bends by a known bound B only, so that
//! D >= d + D_l (l' - l) + D_t (t' - t) - B (t' - t)^2 / 2 - W |t' - t| |l' - l| everywhere. Where that is positive for all lengths
//! below the best one, the stretch is free. An anchor inside the cutter lowers the best length instead, and is followed to the bottom
//! of the dip; several dips of one block are found because nothing is left out.

use super::NormalRay;
use super::block::{Block, ON_SURFACE, Pose, Touch};
use super::body::{CutterPart, Part};

/// A ray's best length so far and where it comes from. mm.
#[derive(Clone, Debug)]
pub(super) struct Search<'a> {
    pub ray: &'a NormalRay,
    /// Where the ray begins, below the flank.
    pub lowest: f64,
    /// The lowest entry so far; at first where the stock ends.
    pub best: f64,
    /// Index of the block, part and fraction of the best length.
    pub found: Option<(usize, CutterPart, f64)>,
    /// Whether a place was left without proof.
    pub unsettled: bool,
    /// Evaluations of a distance.
    pub evaluations: u64,
}

/// Length below the best one that is not looked at any more, mm: 1e-7 um.
pub(super) const TOLERANCE: f64 = 1e-10;
/// Evaluations after which a block is given up. A block with a dip takes some thirty; only rays that graze a cutter come near.
const LONGEST_SEARCH: u64 = 20_000;
/// Steps to the bottom of a dip: the cover goes on from there whatever comes out.
const LONGEST_DESCENT: usize = 40;
/// Steps to the least distance along a ray.
const LONGEST_DIP: usize = 60;

/// Where the anchor of a stretch stands.
#[derive(Clone, Copy)]
enum Anchor {
    Middle,
    At(f64),
}

impl Search<'_> {
    /// Whether the cutter already reaches the ray's begin: no lower entry can be found.
    pub fn too_deep(&self) -> bool {
        self.found.is_some() && self.best <= self.lowest
    }

    /// Lowers the best length to the lowest entry of this block, if that is lower by more than the tolerance.
    pub fn block(&mut self, index: usize, block: &Block, part: &Part, waiting: &mut Vec<Stretch>) {
        let end = self.evaluations + LONGEST_SEARCH;
        waiting.clear();
        waiting.push(Stretch { from: 0.0, to: 1.0, anchor: Anchor::Middle, middle_next: false });
        while let Some(stretch) = waiting.pop() {
            if self.evaluations > end {
                self.unsettled = true;
                return;
            }
            let Stretch { from, to, .. } = stretch;
            let t = match stretch.anchor {
                Anchor::Middle => 0.5 * (from + to),
                Anchor::At(t) => t.clamp(from, to),
            };
            let pose = block.pose(t);
            let touch = self.touch(block, part, &pose, self.best);
            let free = if touch.distance < -ON_SURFACE {
                None
            } else if touch.by_length <= 0.0 {
                Some(self.free_below(block, &touch))
            } else {
                self.free_across(block, part, &pose)
            };
            match free {
                None => {
                    let before = self.best;
                    let start = if touch.by_length < 0.0 { self.best } else { self.lowest };
                    self.enter(index, block, part, t, start);
                    if self.best >= before {
                        // Rounding only: the entry is the best length.
                        self.unsettled = true;
                        return;
                    }
                    let bottom = self.descend(index, block, part, t);
                    if self.too_deep() {
                        return;
                    }
                    // The rest of the block was free below a higher length: it stays so.
                    let anchor = Anchor::At(bottom);
                    waiting.push(Stretch { from, to, anchor, middle_next: false });
                }
                Some([below, above]) => {
                    let dip = estimate(part, &touch);
                    let sides = [
                        (from, t - below, touch.by_fraction > 0.0),
                        (t + above, to, touch.by_fraction < 0.0),
                    ];
                    for (side, (low, high, falls)) in sides.into_iter().enumerate() {
                        if low >= high {
                            continue;
                        }
                        let inner = if side == 0 { high } else { low };
                        let slow = high - low > 0.5 * (to - from);
                        let anchor = if slow && stretch.middle_next {
                            Anchor::Middle
                        } else if falls {
                            Anchor::At((t - dip).clamp(low, high))
                        } else {
                            Anchor::At(inner)
                        };
                        waiting.push(Stretch {
                            from: low,
                            to: high,
                            anchor,
                            middle_next: !stretch.middle_next,
                        });
                    }
                }
            }
        }
    }

    fn touch(&mut self, block: &Block, part: &Part, pose: &Pose, length: f64) -> Touch {
        self.evaluations += 1;
        block.touch(part, self.ray, length, pose)
    }

    /// Takes the entry at fraction t if it is the lowest so far.
    fn enter(&mut self, index: usize, block: &Block, part: &Part, t: f64, start: f64) {
        let (entry, evaluations) = block.pose(t).entry(part, self.ray, [self.lowest, self.best], start);
        self.evaluations += evaluations;
        if let Some(length) = entry.filter(|&length| length < self.best) {
            self.best = length;
            self.found = Some((index, part.name, t));
        }
    }

    /// Follows the entry from fraction t, where it is the best length, to the bottom of its dip; returns where that is.
    fn descend(&mut self, index: usize, block: &Block, part: &Part, start: f64) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        let (mut low_seen, mut high_seen) = (false, false);
        let (mut t, mut bottom) = (start, start);
        let mut last: Option<(f64, f64)> = None;
        for _ in 0..LONGEST_DESCENT {
            let pose = block.pose(t);
            let mut touch = self.touch(block, part, &pose, self.best);
            if touch.distance < -ON_SURFACE {
                let from = if touch.by_length < 0.0 { self.best } else { self.lowest };
                self.enter(index, block, part, t, from);
                bottom = t;
                if self.too_deep() {
                    break;
                }
                touch = self.touch(block, part, &pose, self.best);
            }
            let slope = touch.by_fraction;
            if slope > 0.0 {
                (high, high_seen) = (t, true);
            } else {
                (low, low_seen) = (t, true);
            }
            let curvature = last.map(|(at, was)| (slope - was) / (t - at)).filter(|c| *c > 0.0);
            let step = curvature.map_or_else(|| -estimate(part, &touch), |c| -slope / c);
            last = Some((t, slope));
            let next = t + step;
            let next = if next <= low {
                if low_seen { 0.5 * (low + high) } else { low }
            } else if next >= high {
                if high_seen { 0.5 * (low + high) } else { high }
            } else {
                next
            };
            if next == t || (slope * (next - t)).abs() <= ON_SURFACE * touch.by_length.abs().min(1.0) {
                break;
            }
            t = next;
        }
        bottom
    }

    /// How far the stretch around an anchor at the best length is free, down and up the block, where the distance falls along the ray.
    fn free_below(&self, block: &Block, touch: &Touch) -> [f64; 2] {
        let depth = self.best - self.lowest;
        let lever = touch.lever + depth + block.way;
        let (speed, bend) = (block.speed(lever), block.bend(lever));
        let distance = touch.distance.max(0.0);
        let steepness = -touch.by_length;
        // Half of the steepness pays for the turn of the ray seen from the cutter, the other half for the tolerance.
        let room = distance + 0.5 * steepness * TOLERANCE;
        let turned = if block.turn == 0.0 { f64::INFINITY } else { 0.5 * steepness / block.turn };
        [-touch.by_fraction, touch.by_fraction].map(|slope| {
            let plane = reach(room, slope, bend).min(turned);
            let blunt = reach(distance, slope - block.turn * depth, bend);
            plane.max(blunt).max((distance + ON_SURFACE) / speed)
        })
    }

    /// The same where the distance grows along the ray at the best length: the cutter may be entered and left below it. `None` if it is.
    fn free_across(&mut self, block: &Block, part: &Part, pose: &Pose) -> Option<[f64; 2]> {
        let depth = self.best - self.lowest;
        let (mut low, mut high) = (self.lowest, self.best);
        let mut length = low;
        let mut free = [0.0, 0.0];
        for _ in 0..LONGEST_DIP {
            let at = self.touch(block, part, pose, length);
            if at.distance <= 0.0 {
                return None;
            }
            // How much the tangent falls towards the far end of the ray.
            let fall = at.by_length * (length - if at.by_length > 0.0 { self.lowest } else { self.best });
            let room = (at.distance - fall).max(0.0);
            let lever = at.lever + depth + block.way;
            let (speed, bend) = (block.speed(lever), block.bend(lever));
            free = [-at.by_fraction, at.by_fraction].map(|slope| {
                let plane = reach(room, slope - block.turn * depth, bend);
                plane.max((room + ON_SURFACE) / speed)
            });
            if room > 0.75 * at.distance {
                break;
            }
            if at.by_length > 0.0 {
                high = length;
            } else {
                low = length;
            }
            length = 0.5 * (low + high);
        }
        Some(free)
    }
}

/// A stretch of a block that is not yet known to be free.
#[derive(Clone, Copy)]
pub(super) struct Stretch {
    from: f64,
    to: f64,
    anchor: Anchor,
    /// Whether the next anchor stands in the middle if this one frees little.
    middle_next: bool,
}

/// The largest x >= 0 with room + slope x - bend x^2 / 2 >= 0, for room >= 0; infinite if there is none.
fn reach(room: f64, slope: f64, bend: f64) -> f64 {
    let root = (slope * slope + 2.0 * bend * room).sqrt();
    if slope > 0.0 {
        // Without a bend the division gives infinity.
        (slope + root) / bend
    } else if root > slope {
        2.0 * room / (root - slope)
    } else {
        f64::INFINITY
    }
}

/// How far before the touch the bottom of the dip may be, as a fraction of the block: a circle of the cutter's radius is rolled off.
fn estimate(part: &Part, touch: &Touch) -> f64 {
    if touch.by_fraction == 0.0 { 0.0 } else { touch.by_fraction * part.radius / touch.slide_squared }
}
