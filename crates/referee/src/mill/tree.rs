//! A tree over the blocks of one cutter, with a lower bound of its distance from a ray for every branch.
//!
//! A branch is a box of tips around a middle and a cone of axes around a mean axis. A cutter in the middle pose tells how far all
//! others are at least: a shift of the tip changes the distance by the tangent plane at most downwards (the parts are convex), a turn of
//! the axis moves a point by its distance from the tip times the change of the axis.

use super::NormalRay;
use super::block::{Block, Pose};
use super::body::Part;
use nalgebra::Vector3;

#[derive(Clone, Copy, Debug)]
enum Content {
    /// Index of a block.
    Leaf(usize),
    /// Indices of two branches.
    Fork([usize; 2]),
}

#[derive(Clone, Debug)]
struct Node {
    pose: Pose,
    /// Half sizes of the box of tips.
    half: Vector3<f64>,
    /// Farthest tip from the middle.
    radius: f64,
    /// Largest |a - a_mean|.
    spread: f64,
    content: Content,
}

/// The blocks of one cutter.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    pub parts: Vec<Part>,
    nodes: Vec<Node>,
}

/// Branches that wait, with a reused store.
pub(super) type Waiting = Vec<usize>;

/// Where a block lies among others: the middle of its tips, and that of its axes to scale.
fn key(block: &Block) -> [f64; 6] {
    let middle = |[from, to]: [Vector3<f64>; 2], scale: f64| (from + to) * (0.5 * scale);
    let (tip, axis) = (middle(block.tips(), 1.0), middle(block.axes(), LEVER));
    [tip.x, tip.y, tip.z, axis.x, axis.y, axis.z]
}

/// Length that makes a change of axis comparable with one of the tip when branches are parted, mm.
const LEVER: f64 = 5.0;

impl Tree {
    /// A tree over the blocks at these indices, at least one.
    pub fn new(parts: Vec<Part>, blocks: &[Block], mut members: Vec<usize>) -> Self {
        let mut tree = Self { parts, nodes: Vec::with_capacity(2 * members.len()) };
        if !members.is_empty() {
            let keys: Vec<[f64; 6]> = blocks.iter().map(key).collect();
            tree.grow(blocks, &keys, &mut members);
        }
        tree
    }

    fn grow(&mut self, blocks: &[Block], keys: &[[f64; 6]], members: &mut [usize]) -> usize {
        let place = self.nodes.len();
        self.nodes.push(Node::around(blocks, members));
        if members.len() > 1 {
            let mut ends = [[f64::INFINITY, f64::NEG_INFINITY]; 6];
            for &i in members.iter() {
                for ([low, high], value) in ends.iter_mut().zip(keys[i]) {
                    (*low, *high) = (low.min(value), high.max(value));
                }
            }
            let extent = |direction: usize| ends[direction][1] - ends[direction][0];
            let widest = (1..6).fold(0, |best, d| if extent(d) > extent(best) { d } else { best });
            // The index decides between equal places, so that the tree is the same on every machine.
            let order = |&i: &usize, &j: &usize| keys[i][widest].total_cmp(&keys[j][widest]).then(i.cmp(&j));
            let half = members.len() / 2;
            members.select_nth_unstable_by(half, order);
            let (low, high) = members.split_at_mut(half);
            let fork = [self.grow(blocks, keys, low), self.grow(blocks, keys, high)];
            self.nodes[place].content = Content::Fork(fork);
        }
        place
    }

    /// Visits every block whose cutter part may meet the ray between `lowest` and the length that `visit` last returned, nearest
    /// branches first, until a visit returns no length more. Returns the number of bounds that were taken.
    pub fn visit(
        &self,
        part: &Part,
        ray: &NormalRay,
        [lowest, highest]: [f64; 2],
        waiting: &mut Waiting,
        visit: &mut dyn FnMut(usize) -> Option<f64>,
    ) -> u64 {
        waiting.clear();
        let mut best = highest;
        let mut bounds = 1;
        if self.nodes.is_empty() || self.nodes[0].distance(part, ray, [lowest, best]).0 > 0.0 {
            return bounds;
        }
        waiting.push(0);
        while let Some(place) = waiting.pop() {
            match self.nodes[place].content {
                Content::Leaf(block) => match visit(block) {
                    Some(length) => best = length,
                    None => return bounds,
                },
                Content::Fork(fork) => {
                    bounds += 2;
                    let [first, second] = fork.map(|i| self.nodes[i].distance(part, ray, [lowest, best]));
                    let order = if first.1 <= second.1 { [1, 0] } else { [0, 1] };
                    for i in order {
                        if [first, second][i].0 <= 0.0 {
                            waiting.push(fork[i]);
                        }
                    }
                }
            }
        }
        bounds
    }
}

impl Node {
    fn around(blocks: &[Block], members: &[usize]) -> Self {
        let tips = || members.iter().flat_map(|&i| blocks[i].tips());
        let axes = || members.iter().flat_map(|&i| blocks[i].axes());
        let (low, high) = tips().fold(
            (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)),
            |(low, high), tip| (low.inf(&tip), high.sup(&tip)),
        );
        let tip = (low + high) * 0.5;
        let sum: Vector3<f64> = axes().sum();
        let axis = if sum.norm() > 0.0 { sum.normalize() } else { Vector3::z() };
        // Axes between two ends stay in a cone that holds the ends only up to a right angle.
        let inside = axes().all(|a| a.dot(&axis) > 0.0);
        let spread = if inside { axes().map(|a| (a - axis).norm()).fold(0.0, f64::max) } else { 2.0 };
        Self {
            pose: Pose { tip, axis, axis_rate: Vector3::zeros() },
            half: (high - low) * 0.5,
            radius: tips().map(|t| (t - tip).norm()).fold(0.0, f64::max),
            spread,
            content: Content::Leaf(members[0]),
        }
    }

    /// Lower bound of the distance from all poses for all lengths in the range; and the distance from the middle pose at its top.
    fn distance(&self, part: &Part, ray: &NormalRay, [lowest, highest]: [f64; 2]) -> (f64, f64) {
        let top = self.pose.along(part, ray, highest);
        let turn = self.spread * (top.arm.norm() + (highest - lowest) + self.radius);
        let bound = if top.by_length <= 0.0 {
            // Farther below the top: the top is the nearest.
            top.distance - self.radius.min(top.gradient.abs().dot(&self.half))
        } else {
            let bottom = self.pose.along(part, ray, lowest);
            let least = if bottom.by_length >= 0.0 {
                bottom.distance
            } else {
                // Above both tangents: they cross where they are lowest together.
                let fall = bottom.distance - top.distance + (highest - lowest) * top.by_length;
                top.distance - top.by_length * (highest - lowest)
                    + top.by_length * (fall / (top.by_length - bottom.by_length))
            };
            least - self.radius
        };
        (bound - turn, top.distance)
    }
}
