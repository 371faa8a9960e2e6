//! The path of all axes along a course in straight blocks, few enough for the control and near enough to the course on the flank
//! (`docs/mathematics/programs.md#what-rounding-adds`).

use super::drive::Drive;
use super::{Course, MotionError, Waypoint};
use machine::{Machine, Positions};

/// Ends of straight blocks.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisPath {
    /// Places and positions in driving order.
    pub nodes: Vec<(Waypoint, Positions)>,
    /// Largest deviation of the blocks from the course, seen on the flank, mm.
    pub deviation: f64,
}

/// Most blocks of a path (`docs/mathematics/programs.md#limits`).
const MOST_PIECES: usize = 1 << 20;
/// Most pieces into which a block is divided in one step.
const MOST_AT_ONCE: f64 = 256.0;
/// A block of less than this share of 1 mm cannot be divided further.
const LEAST_BLOCK: f64 = 1e-6;

fn nothing_left(a: &Waypoint, b: &Waypoint) -> bool {
    (a.v - b.v).abs().max((a.lift - b.lift).abs()) < LEAST_BLOCK
}

/// Where a block is compared with the course.
const CHECKS: [f64; 3] = [0.25, 0.5, 0.75];

fn between(a: &Waypoint, b: &Waypoint, u: f64) -> Waypoint {
    let mix = |x: f64, y: f64| x + u * (y - x);
    Waypoint { v: mix(a.v, b.v), lift: mix(a.lift, b.lift), lead: mix(a.lead, b.lead) }
}

/// Positions on a straight block.
pub(super) fn straight(machine: &Machine, a: &Positions, b: &Positions, u: f64) -> Positions {
    let mut at = Positions::default();
    for k in 0..machine.axes().len() {
        at[k] = a[k] + u * (b[k] - a[k]);
    }
    at
}

/// Largest deviation of a straight block from the course, mm; infinite where it leaves the course altogether.
pub(super) fn chord_deviation(
    machine: &Machine,
    course: &Course,
    [a, b]: [&(Waypoint, Positions); 2],
) -> f64 {
    let off = |u: f64| {
        let pose = machine.pose(course.station(), &straight(machine, &a.1, &b.1, u)).ok()?;
        course.off(&pose, &between(&a.0, &b.0, u))
    };
    CHECKS.into_iter().map(|u| off(u).unwrap_or(f64::INFINITY)).fold(0.0, f64::max)
}

impl AxisPath {
    /// Straight blocks from one place to the next, each divided until it is within `tolerance` (mm) of the course.
    ///
    /// # Errors
    /// [`MotionError::Machine`], [`MotionError::ToleranceNotReached`].
    pub(super) fn new(
        machine: &Machine,
        course: &Course,
        (stroke, swivel): (&str, f64),
        places: &[Waypoint],
        tolerance: f64,
    ) -> Result<Self, MotionError> {
        let mut drive = Drive::new(machine, course, stroke, swivel);
        let Some((first, rest)) = places.split_first() else {
            return Ok(Self { nodes: Vec::new(), deviation: 0.0 });
        };
        let mut nodes = vec![(*first, drive.stand(first)?)];
        let mut deviation: f64 = 0.0;
        for end in rest {
            let mut ahead = vec![*end];
            while let Some(&target) = ahead.last() {
                let mut probe = drive.clone();
                let reached = (target, probe.stand(&target)?);
                let begun = nodes[nodes.len() - 1];
                let off = chord_deviation(machine, course, [&begun, &reached]);
                if off <= tolerance {
                    deviation = deviation.max(off);
                    nodes.push(reached);
                    drive = probe;
                    ahead.pop();
                } else if nodes.len() + ahead.len() > MOST_PIECES || nothing_left(&begun.0, &target) {
                    return Err(MotionError::ToleranceNotReached {
                        stroke: stroke.to_owned(),
                        pieces: nodes.len() + ahead.len(),
                        deviation_um: off * 1e3,
                        tolerance_um: tolerance * 1e3,
                    });
                } else {
                    // A chord misses a smooth curve by the square of its length.
                    let pieces = (off / tolerance).sqrt().ceil().clamp(2.0, MOST_AT_ONCE) as usize;
                    let places =
                        (1..pieces).rev().map(|k| between(&begun.0, &target, k as f64 / pieces as f64));
                    ahead.extend(places);
                }
            }
        }
        Ok(Self { nodes, deviation })
    }

    /// The same path with the endless axes begun in the turns nearest to where they stand.
    pub(super) fn turned_to(mut self, machine: &Machine, now: &Positions) -> Self {
        use std::f64::consts::TAU;
        let Some(first) = self.nodes.first().map(|node| node.1) else { return self };
        for (k, axis) in machine.axes().iter().enumerate() {
            if axis.travel.is_none() {
                let by = TAU * ((now[k] - first[k]) / TAU).round();
                self.nodes.iter_mut().for_each(|(_, at)| at[k] += by);
            }
        }
        self
    }

    /// How far an axis moves between its extremes, mm or rad.
    pub fn range(&self, axis: usize) -> f64 {
        let [low, high] = foundation::numerics::extremes(self.nodes.iter().map(|(_, at)| at[axis]));
        high - low
    }
}
