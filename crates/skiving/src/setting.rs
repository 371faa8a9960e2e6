//! The setting of the machine: what a change of it does to the flank, and which change answers a measured tool
//! (`docs/mathematics/skiving.md#correction-of-the-setting`).

use super::{ContactPlace, SkivingError};
use foundation::kinematics::SkivingMotion;
use foundation::numerics::root_mean_square;
use nalgebra::{DMatrix, DVector, Vector3};

/// A quantity that is set at the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Setting {
    /// d, mm, with its sign: at an internal gear a negative change makes |d| larger.
    CentreDistance,
    /// gamma, rad.
    CrossedAxesAngle,
    /// z_V1, mm.
    ToolShift,
    /// phi_1: the tool turned against its coupling, rad.
    ToolAngle,
}

/// How far each setting may be changed, mm and rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SettingLimits {
    /// [d, gamma, z_V1, phi_1].
    pub of: [f64; 4],
}

/// A change of the setting and what it leaves.
#[derive(Clone, Debug, PartialEq)]
pub struct SettingFit {
    /// Change of [d, gamma, z_V1, phi_1]; 0 of what is held. mm, rad.
    pub change: [f64; 4],
    /// Which of them ended at their limits.
    pub limited: Vec<Setting>,
    /// f_2 after the change, in the order of the rows, mm.
    pub residual: Vec<f64>,
    /// Root mean square of f_2 before and after, mm.
    pub rms: [f64; 2],
    /// Singular values of the scaled matrix of all free settings, descending.
    pub singular_values: Vec<f64>,
}

/// Singular values of the scaled matrix below which a direction is left alone (`docs/mathematics/skiving.md#correction-of-the-setting`).
const SMALLEST: f64 = 1e-3;

impl Default for SettingLimits {
    /// Those of `docs/mathematics/skiving.md#correction-of-the-setting`.
    fn default() -> Self {
        let degree = 1f64.to_radians();
        Self { of: [0.05, 0.1 * degree, 0.5, 0.1 * degree] }
    }
}

impl Setting {
    /// All, in the order of [`setting_sensitivity`].
    pub const ALL: [Self; 4] =
        [Self::CentreDistance, Self::CrossedAxesAngle, Self::ToolShift, Self::ToolAngle];
    /// Those that a measurement tells apart: a tool shift is a turn of a helical tool, and nothing to a spur one.
    pub const USUAL: [Self; 3] = [Self::CentreDistance, Self::CrossedAxesAngle, Self::ToolAngle];
}

/// Change of f_2 per unit of [d, gamma, z_V1, phi_1]: mm/mm and mm/rad.
pub fn setting_sensitivity(motion: &SkivingMotion, place: &ContactPlace) -> [f64; 4] {
    let (n, q) = (&place.work_normal, &place.engagement);
    let axis = motion.tool_axis();
    let from_tool = q + Vector3::y() * motion.centre_distance;
    [-n.y, -n.dot(&Vector3::y().cross(q)), n.dot(&axis), n.dot(&axis.cross(&from_tool))]
}

/// The change of the free settings that makes the flank's deviations least, within its limits: what wants to go farthest beyond its
/// limit is set to it, the others are sought again.
///
/// # Errors
/// [`SkivingError::InvalidNumber`] for deviations that are not finite or limits that are not positive.
pub fn fit_setting(
    rows: &[[f64; 4]],
    deviations: &[f64],
    free: &[Setting],
    limits: &SettingLimits,
) -> Result<SettingFit, SkivingError> {
    let bad = |field, value, allowed| Err(SkivingError::InvalidNumber { field, value, allowed });
    if let Some(&value) = deviations.iter().find(|f| !f.is_finite()) {
        return bad("deviation", value, "finite numbers");
    }
    if let Some(&value) = limits.of.iter().find(|x| !(x.is_finite() && **x > 0.0)) {
        return bad("setting_limit", value, "> 0");
    }
    let mut change = [0.0; 4];
    let mut open: Vec<usize> = free.iter().map(|setting| *setting as usize).collect();
    let mut limited = Vec::new();
    let mut singular_values = Vec::new();
    let left = |change: &[f64; 4]| -> Vec<f64> {
        let moved = |row: &[f64; 4]| row.iter().zip(change).map(|(s, x)| s * x).sum::<f64>();
        rows.iter().zip(deviations).map(|(row, f)| f + moved(row)).collect()
    };
    while !open.is_empty() {
        for &k in &open {
            change[k] = 0.0;
        }
        let (step, values) = least_squares(rows, &left(&change), &open);
        if singular_values.is_empty() {
            singular_values = values;
        }
        for (&k, x) in open.iter().zip(step.iter()) {
            change[k] = *x;
        }
        let excess = |k: usize| change[k].abs() / limits.of[k];
        let Some(worst) = open.iter().copied().max_by(|&a, &b| excess(a).total_cmp(&excess(b))) else {
            break;
        };
        if excess(worst) <= 1.0 {
            break;
        }
        change[worst] = limits.of[worst].copysign(change[worst]);
        open.retain(|&k| k != worst);
        limited.push(Setting::ALL[worst]);
    }
    let residual = left(&change);
    let rms = [deviations, &residual].map(root_mean_square);
    Ok(SettingFit { change, limited, residual, rms, singular_values })
}

/// The x that makes |f + S x| least, with columns of length one and without directions that hardly act.
fn least_squares(rows: &[[f64; 4]], deviations: &[f64], open: &[usize]) -> (DVector<f64>, Vec<f64>) {
    let matrix = DMatrix::from_fn(rows.len(), open.len(), |i, j| rows[i][open[j]]);
    let scale = DVector::from_fn(open.len(), |j, _| {
        let norm = matrix.column(j).norm();
        if norm > 0.0 { 1.0 / norm } else { 0.0 }
    });
    let svd = (matrix * DMatrix::from_diagonal(&scale)).svd(true, true);
    let mut values: Vec<f64> = svd.singular_values.iter().copied().collect();
    values.sort_by(|a, b| b.total_cmp(a));
    let right = -DVector::from_column_slice(deviations);
    let solved = svd.solve(&right, SMALLEST).unwrap_or_else(|_| DVector::zeros(open.len()));
    (solved.component_mul(&scale), values)
}
