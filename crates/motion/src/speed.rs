//! How fast a path may be driven: speed, acceleration and jerk of every axis (`docs/mathematics/programs.md`, issue of the time law). Knows
//! no block of a control.

use super::path::AxisPath;
use super::s_curve::SCurve;
use machine::Machine;

/// What slows a path down.
#[derive(Clone, Debug, PartialEq)]
pub struct Braked {
    /// Name of the axis.
    pub axis: String,
    /// "velocity", "acceleration" or "jerk".
    pub limit: &'static str,
    /// Speed driven over the speed wanted, below 1.
    pub share: f64,
}

/// Speed and ramps along a path, in path lengths (mm of the parameter, or whatever `lengths` counts).
#[derive(Clone, Debug, PartialEq)]
pub struct PathLimits {
    /// Speed driven.
    pub speed: f64,
    /// Greatest acceleration along the path.
    pub acceleration: f64,
    /// Greatest jerk along the path.
    pub jerk: f64,
    /// What makes the speed less than wanted, if anything.
    pub braked: Option<Braked>,
}

impl PathLimits {
    /// The greatest speed up to `wanted` that no axis forbids; `lengths` are the path lengths of the nodes, ascending.
    ///
    /// In the middle of a block the axes run at its slope; from one middle to the next the speed has to change by the difference.
    pub fn new(machine: &Machine, path: &AxisPath, lengths: &[f64], wanted: f64) -> Self {
        let mut speed = wanted;
        let mut braked = None;
        let (mut acceleration, mut jerk) = (f64::INFINITY, f64::INFINITY);
        let nodes = &path.nodes;
        let middles: Vec<f64> = lengths.windows(2).map(|s| 0.5 * (s[0] + s[1])).collect();
        for (k, axis) in machine.axes().iter().enumerate() {
            let slopes: Vec<f64> = nodes
                .windows(2)
                .zip(lengths.windows(2))
                .map(|(n, s)| (n[1].1[k] - n[0].1[k]) / (s[1] - s[0]))
                .collect();
            let rate = |values: &[f64], at: &[f64]| -> Vec<f64> {
                values.windows(2).zip(at.windows(2)).map(|(f, x)| (f[1] - f[0]) / (x[1] - x[0])).collect()
            };
            let bends = rate(&slopes, &middles);
            let ends: Vec<f64> = middles.windows(2).map(|m| 0.5 * (m[0] + m[1])).collect();
            let largest = |values: &[f64]| values.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            let slope = largest(&slopes);
            let limits = axis.limits;
            let mut slow = |limit: Option<f64>, size: f64, root: f64, name: &'static str| {
                let Some(limit) = limit.filter(|_| size > 0.0) else { return };
                let most = (limit / size).powf(1.0 / root);
                if most < speed {
                    speed = most;
                    braked = Some(Braked { axis: axis.name.clone(), limit: name, share: most / wanted });
                }
            };
            slow(limits.velocity, slope, 1.0, "velocity");
            slow(limits.acceleration, largest(&bends), 2.0, "acceleration");
            slow(limits.jerk, largest(&rate(&bends, &ends)), 3.0, "jerk");
            if slope > 0.0 {
                acceleration = acceleration.min(limits.acceleration.map_or(f64::INFINITY, |a| a / slope));
                jerk = jerk.min(limits.jerk.map_or(f64::INFINITY, |j| j / slope));
            }
        }
        Self { speed, acceleration, jerk, braked }
    }

    /// The move over a length at this speed, from rest to rest.
    pub fn curve(&self, length: f64) -> SCurve {
        SCurve::new(length, self.speed, self.acceleration, self.jerk)
    }

    /// Length on which the speed is reached.
    pub fn run_in(&self) -> f64 {
        // Far longer than any ramp, so that the speed is reached.
        self.curve(f64::from(1 << 30)).ramp_length()
    }
}
