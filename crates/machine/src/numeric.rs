//! Inverse kinematics of chains without a closed form: damped Newton with the exact Jacobian from a net of starts
//! (`docs/mathematics/programs.md#from-bodies-to-axes`). What it finds are solutions; that it finds all of them is probable, not proven.

use super::inverse::{check_pose, within_turn};
use super::{Bed, Joint, Machine, MachineError, Positions, Station, StationSpindle, ToolSpindle};
use foundation::inverse::{NewtonOptions, newton};
use foundation::kinematics::Pose;
use nalgebra::{Matrix3, Rotation3, SMatrix, SVector, Vector3};
use std::f64::consts::{PI, TAU};

/// Length that counts as 1 rad, mm.
const LENGTH: f64 = 100.0;
/// Starts of every rotary axis over one turn.
const STARTS: usize = 4;
/// Solutions closer than this in every axis (rad, and mm/100) are one.
const SAME: f64 = 1e-7;
/// Residual of a solution: rad, and mm/100.
const SOLVED: f64 = 1e-11;

impl Machine {
    /// All solutions that the iteration finds with some axes fixed.
    pub(super) fn iterate(
        &self,
        station: Station,
        pose: &Pose<ToolSpindle, StationSpindle>,
        fixed: &[(usize, f64)],
    ) -> Result<Vec<Positions>, MachineError> {
        check_pose(pose)?;
        let axes = self.axes_at(station)?;
        let free: Vec<usize> = axes.into_iter().filter(|k| fixed.iter().all(|(axis, _)| axis != k)).collect();
        let Ok(free) = <[usize; 6]>::try_from(free.as_slice()) else {
            return Err(MachineError::NotDetermined {
                free: free.len(),
                determined: 6,
                axes: self.names(&free),
            });
        };
        let mut start = Positions::default();
        fixed.iter().for_each(|&(axis, value)| start[axis] = value);
        let rotary: Vec<usize> =
            free.iter().copied().filter(|&axis| self.joint(axis) == Joint::Rotary).collect();
        let starts = STARTS.pow(rotary.len() as u32);
        let mut found: Vec<Positions> = Vec::new();
        let mut least = f64::INFINITY;
        for number in 0..starts {
            let mut at = start;
            let mut rest = number;
            for &axis in &rotary {
                // Off the multiples of a right angle, where wrists tend to be singular.
                at[axis] = -PI + TAU * ((rest % STARTS) as f64 + 0.37) / STARTS as f64;
                rest /= STARTS;
            }
            let (solution, residual) = self.refine(station, pose, &free, at)?;
            least = least.min(residual);
            let same = |other: &Positions| {
                free.iter().all(|&axis| match self.joint(axis) {
                    Joint::Rotary => within_turn(other[axis] - solution[axis]).abs() < SAME,
                    Joint::Linear => (other[axis] - solution[axis]).abs() < SAME * LENGTH,
                })
            };
            if residual < SOLVED && !found.iter().any(same) {
                found.push(solution);
            }
        }
        if found.is_empty() { Err(MachineError::NoSolution { starts, residual: least }) } else { Ok(found) }
    }

    /// The solution that the iteration reaches from a start, and its residual (rad, and mm/100).
    fn refine(
        &self,
        station: Station,
        pose: &Pose<ToolSpindle, StationSpindle>,
        free: &[usize; 6],
        start: Positions,
    ) -> Result<(Positions, f64), MachineError> {
        self.station(station)?;
        let unit = free.map(|axis| match self.joint(axis) {
            Joint::Rotary => 1.0,
            Joint::Linear => LENGTH,
        });
        let placed = |x: &SVector<f64, 6>| {
            let mut at = start;
            for (k, &axis) in free.iter().enumerate() {
                at[axis] = x[k] * unit[k];
            }
            at
        };
        let x = SVector::<f64, 6>::from_fn(|k, _| start[free[k]] / unit[k]);
        let options = NewtonOptions {
            step_tolerance: 1e-13,
            stall_tolerance: 1e-11,
            longest_step: 1.0,
            ..NewtonOptions::default()
        };
        let equations = |x: &SVector<f64, 6>| self.equations(station, pose, free, &unit, &placed(x)).ok();
        let x = newton(x, &options, equations).map_or(x, |report| report.x);
        let mut at = placed(&x);
        for &axis in free.iter().filter(|&&axis| self.joint(axis) == Joint::Rotary) {
            at[axis] = within_turn(at[axis]);
        }
        let residual = self.equations(station, pose, free, &unit, &at)?.0.norm();
        Ok((at, residual))
    }

    /// Rotation vector and distance by which the station's spindle misses the pose, in M, and their rates with the free axes.
    fn equations(
        &self,
        station: Station,
        pose: &Pose<ToolSpindle, StationSpindle>,
        free: &[usize; 6],
        unit: &[f64; 6],
        at: &Positions,
    ) -> Result<(SVector<f64, 6>, SMatrix<f64, 6, 6>), MachineError> {
        let other = self.station(station)?;
        let wanted = self.limb::<ToolSpindle>(self.tool(), at).then(pose);
        let here: Pose<Bed, StationSpindle> = self.limb(other, at);
        let phi = rotation_vector(&(wanted.rotation() * here.rotation().transpose()));
        let gap = (wanted.translation() - here.translation()) / LENGTH;
        let residual = SVector::<f64, 6>::from_column_slice(&[phi.x, phi.y, phi.z, gap.x, gap.y, gap.z]);
        let rates = [rate_of_rotation_vector(&phi), rate_of_rotation_vector(&-phi)];
        let mut jacobian = SMatrix::<f64, 6, 6>::zeros();
        let limbs = [(self.tool(), wanted.translation(), 1.0), (other, here.translation(), -1.0)];
        for ((limb, origin, sense), rate) in limbs.into_iter().zip(rates) {
            for axis in self.standing(limb, at) {
                let Some(k) = free.iter().position(|&number| number == axis.axis) else { continue };
                let (turning, sliding) = match self.joint(axis.axis) {
                    Joint::Linear => (Vector3::zeros(), axis.direction),
                    Joint::Rotary => (rate * axis.direction, axis.direction.cross(&(origin - axis.point))),
                };
                let column = [turning, sliding / LENGTH].map(|part| part * (sense * unit[k]));
                jacobian.fixed_view_mut::<3, 1>(0, k).copy_from(&column[0]);
                jacobian.fixed_view_mut::<3, 1>(3, k).copy_from(&column[1]);
            }
        }
        Ok((residual, jacobian))
    }
}

/// Axis times angle of a rotation, exact also for the smallest angles.
fn rotation_vector(r: &Matrix3<f64>) -> Vector3<f64> {
    let sine = Vector3::new(r[(2, 1)] - r[(1, 2)], r[(0, 2)] - r[(2, 0)], r[(1, 0)] - r[(0, 1)]) * 0.5;
    let size = sine.norm();
    let angle = size.atan2(0.5 * (r.trace() - 1.0));
    if size > SMALL {
        sine * (angle / size)
    } else if angle < 1.0 {
        sine
    } else {
        // Half a turn: its axis stands in the symmetric part.
        Rotation3::from_matrix_unchecked(*r).scaled_axis()
    }
}

/// Sine below which angle and sine are the same, or the angle is half a turn.
const SMALL: f64 = 1e-8;

/// How the rotation vector of R grows when R is turned further from the left: the inverse of the left Jacobian.
fn rate_of_rotation_vector(phi: &Vector3<f64>) -> Matrix3<f64> {
    let angle = phi.norm();
    let cross = phi.cross_matrix();
    // 1/t^2 - (1 + cos t)/(2 t sin t), with its series where it cancels.
    let factor = if angle < 1e-3 {
        1.0 / 12.0 + angle * angle / 720.0
    } else {
        1.0 / (angle * angle) - (1.0 + angle.cos()) / (2.0 * angle * angle.sin())
    };
    Matrix3::identity() - cross * 0.5 + cross * cross * factor
}
