//! Which of several solutions a machine takes: within its travel, nearest to where it stands, full turns kept
//! (`docs/mathematics/programs.md#from-bodies-to-axes`).

use super::{Joint, Machine, MachineError, Positions, Role, Station};
use std::f64::consts::{PI, TAU};

/// One way to take up a pose.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Positions of the axes, angles in (-180, 180] degrees.
    pub at: Positions,
    /// Numbers of the axes that stand beyond their travel.
    pub beyond: Vec<usize>,
}

/// Millimetres that count as 1 rad where changes of axes are compared.
const LENGTH: f64 = 100.0;

impl Machine {
    /// The same positions, each with the axes that stand beyond their travel. An axis with less than a turn of travel is
    /// looked for in every turn.
    ///
    /// # Errors
    /// As [`Machine::station`].
    pub fn judged(&self, station: Station, found: Vec<Positions>) -> Result<Vec<Solution>, MachineError> {
        let axes = self.axes_at(station)?;
        Ok(found
            .into_iter()
            .map(|mut at| {
                for &axis in &axes {
                    at[axis] = self.within_travel(axis, at[axis]);
                }
                let beyond = axes.iter().copied().filter(|&k| !self.axes()[k].admits(at[k])).collect();
                Solution { at, beyond }
            })
            .collect())
    }

    /// A rotary axis in the turn in which its travel is, if there is one.
    fn within_travel(&self, axis: usize, value: f64) -> f64 {
        let described = &self.axes()[axis];
        match (described.joint, described.travel) {
            (Joint::Rotary, Some([from, to])) if !described.admits(value) => {
                let middle = 0.5 * (from + to);
                let turned = value - TAU * ((value - middle) / TAU).round();
                if described.admits(turned) { turned } else { value }
            }
            _ => value,
        }
    }

    /// The solution to begin a stroke with: within travel, the smallest tilt, then the smallest swivel.
    ///
    /// # Errors
    /// [`MachineError::AxisLimit`] of the solution that comes nearest.
    pub fn first<'s>(&self, solutions: &'s [Solution]) -> Result<&'s Solution, MachineError> {
        let size =
            |solution: &Solution, role: Role| self.role(role).map_or(0.0, |axis| solution.at[axis].abs());
        let better = |a: &&Solution, b: &&Solution| {
            let by = |role: Role| size(a, role).total_cmp(&size(b, role));
            by(Role::Tilt).then_with(|| by(Role::Swivel))
        };
        match solutions.iter().filter(|solution| solution.beyond.is_empty()).min_by(better) {
            Some(best) => Ok(best),
            None => Err(self.limit_of(solutions)),
        }
    }

    /// The error of the solution that stands least beyond the travel, where all do.
    pub fn limit_of(&self, solutions: &[Solution]) -> MachineError {
        let scaled = |axis: usize, excess: f64| match self.joint(axis) {
            Joint::Rotary => excess,
            Joint::Linear => excess / LENGTH,
        };
        let worst = |solution: &Solution| {
            let excess = |&axis: &usize| (axis, -self.axes()[axis].margin(solution.at[axis]));
            solution.beyond.iter().map(excess).max_by(|a, b| scaled(a.0, a.1).total_cmp(&scaled(b.0, b.1)))
        };
        let nearest = solutions
            .iter()
            .filter_map(|solution| worst(solution).map(|(axis, excess)| (solution, axis, excess)))
            .min_by(|a, b| scaled(a.1, a.2).total_cmp(&scaled(b.1, b.2)));
        nearest
            .and_then(|(solution, axis, _)| self.axes()[axis].beyond(solution.at[axis]))
            .unwrap_or(MachineError::NoSolution { starts: 0, residual: f64::INFINITY })
    }
}

/// Half a turn, where two values are as near, is taken as -180 degrees; closer than this (rad) counts as half a turn.
const HALF_TURN: f64 = 1e-9;

fn nearest_zero(angle: f64) -> f64 {
    let turned = angle - TAU * (angle / TAU).round();
    if turned > PI - HALF_TURN { turned - TAU } else { turned }
}

/// Follows a stroke: the branch stays, endless axes keep their full turns.
#[derive(Clone, Debug)]
pub struct Follower<'m> {
    machine: &'m Machine,
    station: Station,
    /// Senses of the bodies in their spindles: tool, counterpart.
    senses: [f64; 2],
    last: Option<(Positions, [f64; 2])>,
}

impl<'m> Follower<'m> {
    /// At rest before the first position of a stroke; `senses` are those of the mounts of tool and counterpart.
    pub fn new(machine: &'m Machine, station: Station, senses: [f64; 2]) -> Self {
        Self { machine, station, senses, last: None }
    }

    /// Where the tool's axis stands now, rad: what [`Machine::dressing`] may be given as wanted.
    pub fn worm(&self) -> Option<f64> {
        let worm = self.machine.role(Role::Worm)?;
        self.last.map(|(at, _)| at[worm])
    }

    /// Takes the next position among all solutions of its pose; `angles` are the bodies' own (tool, counterpart), rad, full
    /// turns kept.
    ///
    /// # Errors
    /// [`MachineError::AxisLimit`].
    pub fn next(&mut self, found: Vec<Positions>, angles: [f64; 2]) -> Result<Positions, MachineError> {
        let machine = self.machine;
        let solutions = machine.judged(self.station, found)?;
        let counterpart = match self.station {
            Station::Work => Role::Work,
            Station::Dresser => Role::Dresser,
        };
        let bodies = [machine.role(Role::Worm), machine.role(counterpart)];
        let Some((last, before)) = self.last else {
            let mut at = machine.first(&solutions)?.at;
            for axis in bodies.into_iter().flatten().filter(|&axis| machine.axes()[axis].travel.is_none()) {
                at[axis] = nearest_zero(at[axis]);
            }
            self.last = Some((at, angles));
            return Ok(at);
        };
        let axes = machine.axes_at(self.station)?;
        let change = |solution: &&Solution| {
            let limited = axes.iter().filter(|&&axis| machine.axes()[axis].travel.is_some());
            let apart = limited.map(|&axis| {
                let apart = (solution.at[axis] - last[axis]).abs();
                if machine.joint(axis) == Joint::Linear { apart / LENGTH } else { apart }
            });
            apart.fold(0.0, f64::max)
        };
        let within = solutions.iter().filter(|solution| solution.beyond.is_empty());
        let Some(nearest) = within.min_by(|a, b| change(a).total_cmp(&change(b))) else {
            return Err(machine.limit_of(&solutions));
        };
        let mut at = nearest.at;
        for (k, axis) in bodies.into_iter().enumerate() {
            let Some(axis) = axis.filter(|&axis| machine.axes()[axis].travel.is_none()) else { continue };
            let expected = last[axis] + self.senses[k] * (angles[k] - before[k]);
            at[axis] -= TAU * ((at[axis] - expected) / TAU).round();
        }
        self.last = Some((at, angles));
        Ok(at)
    }
}
