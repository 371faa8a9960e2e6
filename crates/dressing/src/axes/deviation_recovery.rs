//! Deviations of the dressing axes found from what was measured on the worm, with their uncertainty
//! (`docs/mathematics/dressing.md#axes-and-their-deviations`): from profiles dressed at rest, or from points of flanks that a motion dressed.
//! Knows no distribution of the deviations. `recover_deviation`, from profiles at rest, no command reaches: `verify` recomputes references with it.

use crate::axes::deviation::{AXIS_NAMES, check_correction, check_rolls, sum};
use crate::{ConditionSolver, DressedProfile, DressedWorm, DresserTool, DressingError};
use foundation::geometry::Flank;
use foundation::inverse::{GaussNewton, gauss_newton};
use foundation::kinematics::DressingCorrection;
use foundation::numerics::Chebyshev;
use nalgebra::{DMatrix, DVector};

/// A measured profile of one flank of the worm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement<'a> {
    /// Flank of the worm.
    pub flank: Flank,
    /// The correction DK at which it was meant to be dressed; profiles at different known DK tell more.
    pub dk: DressingCorrection,
    /// Lengths of roll, mm.
    pub w: &'a [f64],
    /// Measured normal modification there, mm; positive = material left.
    pub f: &'a [f64],
}

/// What is known beforehand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recovery {
    /// Standard deviation of a measured value, mm.
    pub noise: f64,
    /// Components of the deviation that are held at a value, rad or mm.
    pub held: [Option<f64>; 4],
}

/// Deviations and how well they are known.
#[derive(Clone, Debug, PartialEq)]
pub struct RecoveredDeviation {
    /// Deviation of the axes from the corrections of the measurements, rad, rad, mm, mm.
    pub deviation: DressingCorrection,
    /// Standard deviation of each component from the given noise and the derivatives at the known corrections; 0 for a held one.
    pub standard_deviation: DressingCorrection,
    /// Singular values of these derivatives in the scaled unknowns (see [`ConditionSolver::scale`]), mm, descending.
    pub singular_values: Vec<f64>,
    /// Root mean square of what the deviations do not explain, mm.
    pub residual_rms: f64,
}

/// A component is not determined where its standard deviation exceeds one scaled unknown (1 mm at the worm's pitch circle, 1/20 rad, 1 mm,
/// 5 mm): more than any machine deviates by.
const LARGEST_DEVIATION: f64 = 1.0;
/// Singular values below this share of the largest are rounding errors of the derivatives.
const CUT: f64 = 1e-12;

/// Deviations that explain the measurements best: least squares over all measured points, exact model.
///
/// # Errors
/// [`DressingError::InvalidNumber`] for measurements that are absent, uneven or not finite, noise that is not above 0, and if all components
/// are held; [`DressingError::NotIdentifiable`] where the measurements do not tell the components apart, as on one flank alone; those of
/// [`DressedProfile::at_roll`] at the corrections given; [`DressingError::NotConverged`].
pub fn recover_deviation(
    tool: &DresserTool,
    reference_radius: f64,
    measurements: &[Measurement<'_>],
    known: &Recovery,
) -> Result<RecoveredDeviation, DressingError> {
    check(measurements, known)?;
    let count: usize = measurements.iter().map(|m| m.w.len()).sum();
    recover(tool, reference_radius, known, |off| {
        let mut rows = Rows::with_capacity(count);
        for m in measurements {
            let profile = DressedProfile::new(tool, m.flank, sum(&m.dk, off));
            rows.extend(profile.at_rolls(m.w)?.iter().zip(m.f).map(|(at, f)| (at.f - f, at.df_dk)));
        }
        Ok(rows)
    })
}

/// Points of a worm flank that were measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredFlank<'a> {
    /// Flank of the worm.
    pub flank: Flank,
    /// DK over v with which it was meant to be dressed.
    pub corrections: &'a [Chebyshev; 4],
    /// Length of roll, worm z and measured normal modification of each point, mm; positive = material left.
    pub points: &'a [[f64; 3]],
}

/// Deviations, the same all along the worm, that explain points of flanks which a motion dressed: least squares over all points, exact
/// envelope. `by_form` compares each flank about its mean, where the thickness of the threads is not known; nothing tells the worm's angle then.
///
/// # Errors
/// As [`recover_deviation`]; [`DressingError::OutOfDresser`] for a point that the motion does not dress.
pub fn recover_from_points(
    tool: &DresserTool,
    reference_radius: f64,
    flanks: &[MeasuredFlank<'_>],
    known: &Recovery,
    by_form: bool,
) -> Result<RecoveredDeviation, DressingError> {
    check_known(flanks.len(), known)?;
    for value in flanks.iter().flat_map(|flank| flank.points.iter().flatten()) {
        if !value.is_finite() {
            let (field, value, allowed) = ("measured point of the worm", *value, "finite numbers");
            return Err(DressingError::InvalidNumber { field, value, allowed });
        }
    }
    recover(tool, reference_radius, known, |off| {
        let mut rows = Rows::new();
        for of in flanks {
            let moved = std::array::from_fn(|j| of.corrections[j].raised(off[j]));
            let worm = DressedWorm::new(tool, of.flank, &moved);
            let row = |&[w, z, f]: &[f64; 3]| {
                let range = worm.range();
                let beyond =
                    DressingError::OutOfDresser { flank: of.flank, w, from: range.w_nf, to: range.w_na };
                let (made, _, v) = worm.modification(w, z).ok_or(beyond)?;
                // Derivatives of the profile at rest there: what the motion adds to them is of second order.
                let dk = std::array::from_fn(|j| moved[j].value(v));
                let at = DressedProfile::new(tool, of.flank, dk).at_roll(w)?;
                Ok((made - f, at.df_dk))
            };
            let mut flank = of.points.iter().map(row).collect::<Result<Rows, DressingError>>()?;
            if by_form {
                about_mean(&mut flank);
            }
            rows.extend(flank);
        }
        Ok(rows)
    })
}

/// Residuals with their derivatives by d_phi_S, d_gamma, d_d, d_v_yA.
type Rows = Vec<(f64, [f64; 4])>;

/// Rows less their mean.
fn about_mean(rows: &mut Rows) {
    let count = rows.len().max(1) as f64;
    let mean = rows.iter().map(|row| row.0).sum::<f64>() / count;
    let slopes: [f64; 4] = std::array::from_fn(|j| rows.iter().map(|row| row.1[j]).sum::<f64>() / count);
    for (residual, derivatives) in rows {
        *residual -= mean;
        for j in 0..4 {
            derivatives[j] -= slopes[j];
        }
    }
}

/// Least squares over rows of a model of the deviations.
fn recover(
    tool: &DresserTool,
    reference_radius: f64,
    known: &Recovery,
    model: impl Fn(&DressingCorrection) -> Result<Rows, DressingError>,
) -> Result<RecoveredDeviation, DressingError> {
    let scale = ConditionSolver::new(tool, reference_radius).scale();
    let free: Vec<usize> = (0..4).filter(|&j| known.held[j].is_none()).collect();
    let deviation = |x: &DVector<f64>| -> DressingCorrection {
        let mut at = known.held.map(|held| held.unwrap_or(0.0));
        for (k, &j) in free.iter().enumerate() {
            at[j] = x[k] * scale[j];
        }
        at
    };
    let rows = |x: &DVector<f64>| -> Result<(DVector<f64>, DMatrix<f64>), DressingError> {
        let rows = model(&deviation(x))?;
        let residual = DVector::from_fn(rows.len(), |i, _| rows[i].0);
        let jacobian = DMatrix::from_fn(rows.len(), free.len(), |i, k| rows[i].1[free[k]] * scale[free[k]]);
        Ok((residual, jacobian))
    };
    let start = DVector::zeros(free.len());
    // The derivatives of section 14 are those at the known corrections. A problem without a solution is refused before the iteration
    // runs away along its free direction.
    let uncertainty = Uncertainty::of(&rows(&start)?.1, known.noise, &free, &scale)?;
    let options = GaussNewton { cut: CUT, ..GaussNewton::default() };
    let what = "deviations of the axes";
    let found = gauss_newton(start, None, &options, |x| rows(x).ok())
        .ok_or(DressingError::NotConverged { what, last: options.longest_step })?;
    let (residual, jacobian) = rows(&found.x)?;
    if !found.converged {
        let last = (jacobian.transpose() * &residual).norm();
        return Err(DressingError::NotConverged { what, last });
    }
    Ok(RecoveredDeviation {
        deviation: deviation(&found.x),
        standard_deviation: uncertainty.standard_deviation,
        singular_values: uncertainty.singular_values,
        residual_rms: (residual.norm_squared() / residual.len().max(1) as f64).sqrt(),
    })
}

/// What the derivatives say of the accuracy.
struct Uncertainty {
    standard_deviation: DressingCorrection,
    singular_values: Vec<f64>,
}

impl Uncertainty {
    /// Standard deviations: roots of the diagonal of noise^2 (J^T J)^-1.
    fn of(
        jacobian: &DMatrix<f64>,
        noise: f64,
        free: &[usize],
        scale: &DressingCorrection,
    ) -> Result<Self, DressingError> {
        // A square matrix has as many singular values as unknowns even where there are fewer rows.
        let unknowns = free.len();
        let square = if jacobian.nrows() < unknowns {
            jacobian.clone().resize_vertically(unknowns, 0.0)
        } else {
            jacobian.clone()
        };
        let svd = square.svd(false, true);
        let largest = svd.singular_values.max();
        let mut scaled = vec![0.0_f64; unknowns];
        if let Some(directions) = &svd.v_t {
            for (sigma, direction) in svd.singular_values.iter().zip(directions.row_iter()) {
                for (k, part) in direction.iter().enumerate() {
                    // A direction without any part of a component leaves it alone, even where it is free itself.
                    if part.abs() > CUT {
                        scaled[k] += (noise * part / sigma.max(f64::MIN_POSITIVE)).powi(2);
                    }
                    if *sigma <= CUT * largest && part.abs() > CUT {
                        scaled[k] = f64::INFINITY;
                    }
                }
            }
        }
        let mut singular_values: Vec<f64> = svd.singular_values.iter().copied().collect();
        singular_values.sort_by(|a, b| b.total_cmp(a));
        let worst = (0..unknowns).max_by(|&a, &b| scaled[a].total_cmp(&scaled[b]));
        if let Some(k) = worst.filter(|&k| scaled[k].sqrt() > LARGEST_DEVIATION || scaled[k].is_nan()) {
            return Err(DressingError::NotIdentifiable {
                component: AXIS_NAMES[free[k]],
                standard_deviation: scaled[k].sqrt() * scale[free[k]],
                singular_values,
            });
        }
        let mut standard_deviation = [0.0; 4];
        for (k, &j) in free.iter().enumerate() {
            standard_deviation[j] = scaled[k].sqrt() * scale[j];
        }
        Ok(Self { standard_deviation, singular_values })
    }
}

fn check(measurements: &[Measurement<'_>], known: &Recovery) -> Result<(), DressingError> {
    let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
    check_known(measurements.len(), known)?;
    for m in measurements {
        check_correction("correction of a measured profile", &m.dk)?;
        check_rolls(m.w)?;
        if m.f.len() != m.w.len() {
            return invalid("number of measured values", m.f.len() as f64, "one for each length of roll");
        }
        if let Some(&value) = m.f.iter().find(|f| !f.is_finite()) {
            return invalid("measured modification", value, "finite numbers");
        }
    }
    Ok(())
}

fn check_known(count: usize, known: &Recovery) -> Result<(), DressingError> {
    let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
    if count == 0 {
        return invalid("number of measured profiles", 0.0, "at least 1");
    }
    if !(known.noise.is_finite() && known.noise > 0.0) {
        return invalid("standard deviation of a measured value", known.noise, "finite numbers above 0");
    }
    if known.held.iter().all(Option::is_some) {
        return invalid("number of held components", 4.0, "at most 3");
    }
    if let Some(value) = known.held.into_iter().flatten().find(|x| !x.is_finite()) {
        return invalid("held component", value, "finite numbers");
    }
    Ok(())
}
