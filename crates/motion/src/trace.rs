//! Positions, speeds and accelerations of all axes over time, for charts and figures.

use super::path::AxisPath;
use super::s_curve::SCurve;
use machine::{Machine, Positions};

/// All axes at an instant: mm or rad, per s, per s^2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceRow {
    /// Time, s.
    pub t: f64,
    /// Positions.
    pub at: Positions,
    /// Speeds.
    pub velocity: Positions,
    /// Accelerations.
    pub acceleration: Positions,
}

/// A program over time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AxisTrace {
    /// Instants in ascending order.
    pub rows: Vec<TraceRow>,
}

/// Instants of a rapid move, and of either ramp of a path.
const RAMP_ROWS: usize = 24;
/// Most instants of the part of a path at constant speed.
const MOST_ROWS: usize = 400;
/// Instants of either ramp and of what lies between them, where a path is one of thousands.
const SKETCH_ROWS: [usize; 2] = [2, 2];

impl AxisTrace {
    /// Time of the last row, s.
    pub fn duration(&self) -> f64 {
        self.rows.last().map_or(0.0, |row| row.t)
    }

    /// Way of an axis over the whole program, mm or rad.
    pub fn way(&self, axis: usize) -> f64 {
        self.rows.windows(2).map(|pair| (pair[1].at[axis] - pair[0].at[axis]).abs()).sum()
    }

    /// Each axis moves on its own as fast as it may; an axis without limits jumps.
    /// All axes stand for a time, s.
    pub(super) fn stand(&mut self, time: f64) {
        if let Some(&last) = self.rows.last() {
            let at = last.at;
            let still = |t: f64| TraceRow {
                t,
                at,
                velocity: Positions::default(),
                acceleration: Positions::default(),
            };
            self.rows.extend([still(last.t), still(last.t + time)]);
        }
    }

    pub(super) fn rapid(&mut self, machine: &Machine, from: &Positions, to: &Positions) {
        let begun = self.duration();
        let curves: Vec<SCurve> = machine
            .axes()
            .iter()
            .enumerate()
            .map(|(k, axis)| {
                let limit = |x: Option<f64>| x.unwrap_or(f64::INFINITY);
                let [v, a, j] = [axis.limits.velocity, axis.limits.acceleration, axis.limits.jerk].map(limit);
                SCurve::new(to[k] - from[k], v, a, j)
            })
            .collect();
        let time = curves.iter().map(SCurve::duration).fold(0.0, f64::max);
        for row in 0..=2 * RAMP_ROWS {
            let t = time * row as f64 / (2 * RAMP_ROWS) as f64;
            let mut now = TraceRow {
                t: begun + t,
                at: *from,
                velocity: Positions::default(),
                acceleration: Positions::default(),
            };
            for (k, curve) in curves.iter().enumerate() {
                let sense = (to[k] - from[k]).signum();
                let [way, speed, acceleration] = curve.at(t);
                now.at[k] = from[k] + sense * way;
                now.velocity[k] = sense * speed;
                now.acceleration[k] = sense * acceleration;
            }
            self.rows.push(now);
        }
    }

    /// All axes follow a path; `lengths` are the path lengths of its nodes, which `curve` covers.
    pub(super) fn path(&mut self, machine: &Machine, path: &AxisPath, lengths: &[f64], curve: &SCurve) {
        let inner = (4 * path.nodes.len()).clamp(16, MOST_ROWS);
        self.rows_of(machine, (path, lengths, curve), [RAMP_ROWS, inner]);
    }

    /// The same in few instants, for one path of thousands.
    pub(super) fn sketch(&mut self, machine: &Machine, path: &AxisPath, lengths: &[f64], curve: &SCurve) {
        self.rows_of(machine, (path, lengths, curve), SKETCH_ROWS);
    }

    /// Instants of either ramp and of the part between them.
    fn rows_of(
        &mut self,
        machine: &Machine,
        (path, lengths, curve): (&AxisPath, &[f64], &SCurve),
        [ramp_rows, inner]: [usize; 2],
    ) {
        let begun = self.duration();
        let total = curve.duration();
        let ramp = if curve.speed > 0.0 {
            0.5 * (total - (curve.length - 2.0 * curve.ramp_length()) / curve.speed)
        } else {
            0.5 * total
        };
        // A path too short to reach its speed is all ramps; what rounding leaves between them must not run backwards.
        let ramp = ramp.clamp(0.0, 0.5 * total);
        let steady = (total - 2.0 * ramp).max(0.0);
        let up = (0..=ramp_rows).map(|k| ramp * k as f64 / ramp_rows as f64);
        let along = (1..inner).map(|k| ramp + steady * k as f64 / inner as f64);
        let down = (0..=ramp_rows).map(|k| total - ramp + ramp * k as f64 / ramp_rows as f64);
        let mut last = 0.0f64;
        for t in up.chain(along).chain(down) {
            last = t.max(last).min(total);
            let t = last;
            let [way, speed, acceleration] = curve.at(t);
            let s = lengths.first().copied().unwrap_or(0.0) + way;
            let mut now = TraceRow {
                t: begun + t,
                at: Positions::default(),
                velocity: Positions::default(),
                acceleration: Positions::default(),
            };
            for k in 0..machine.axes().len() {
                let [value, slope, bend] = rounded(path, lengths, k, s);
                now.at[k] = value;
                now.velocity[k] = slope * speed;
                now.acceleration[k] = slope * acceleration + bend * speed * speed;
            }
            self.rows.push(now);
        }
    }
}

/// Value, slope and bend of an axis over the path length, its corners rounded from the middle of one block to that of the next.
fn rounded(path: &AxisPath, lengths: &[f64], axis: usize, s: f64) -> [f64; 3] {
    let nodes = &path.nodes;
    let last = nodes.len().saturating_sub(2);
    let block = lengths.partition_point(|&end| end <= s).saturating_sub(1).min(last);
    let Some(pair) = nodes.get(block..block + 2) else {
        return [nodes.first().map_or(0.0, |node| node.1[axis]), 0.0, 0.0];
    };
    let slope_of = |k: usize| (nodes[k + 1].1[axis] - nodes[k].1[axis]) / (lengths[k + 1] - lengths[k]);
    let middle_of = |k: usize| 0.5 * (lengths[k] + lengths[k + 1]);
    let value = pair[0].1[axis] + slope_of(block) * (s - lengths[block]);
    let (before, after) = if s < middle_of(block) {
        (block.checked_sub(1), Some(block))
    } else {
        (Some(block), (block < last).then_some(block + 1))
    };
    match (before, after) {
        (Some(a), Some(b)) if a != b => {
            let bend = (slope_of(b) - slope_of(a)) / (middle_of(b) - middle_of(a));
            [value, slope_of(a) + bend * (s - middle_of(a)), bend]
        }
        _ => [value, slope_of(block), 0.0],
    }
}
