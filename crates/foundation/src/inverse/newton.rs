//! Damped Newton iteration with the natural monotonicity test, for N equations in N unknowns.
//!
//! The test compares Newton steps, not residuals, so rows of very different size (micrometres beside millimetres) need no
//! weights (`docs/mathematics/dressing.md#conditions`).

use nalgebra::{Const, DimMin, SMatrix, SVector};

/// How long and how far to iterate. Unknowns are taken as scaled by the caller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NewtonOptions {
    /// Converged when a full step is shorter than this.
    pub step_tolerance: f64,
    /// A stalled iteration with steps below this counts as converged (rounding).
    pub stall_tolerance: f64,
    /// Longest first step.
    pub longest_step: f64,
    /// Smallest damping factor tried.
    pub least_damping: f64,
    /// Most iterations.
    pub iterations: usize,
}

impl Default for NewtonOptions {
    fn default() -> Self {
        Self {
            step_tolerance: 1e-10,
            stall_tolerance: 1e-7,
            longest_step: 5.0,
            least_damping: 1e-4,
            iterations: 60,
        }
    }
}

/// How an iteration went.
#[derive(Clone, Debug, PartialEq)]
pub struct NewtonReport<const N: usize> {
    /// The root.
    pub x: SVector<f64, N>,
    /// Length of the last full step.
    pub last_step: f64,
    /// Iterations used.
    pub iterations: usize,
}

/// Why an iteration ended without a root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NewtonError {
    /// The equations cannot be evaluated at the start.
    NoStart,
    /// The Jacobian at the start is singular: least over largest singular value.
    Singular {
        /// sigma_min/sigma_max.
        ratio: f64,
    },
    /// No damping factor passes the monotonicity test, or the iterations are used up.
    Stuck {
        /// Length of the last full step.
        last_step: f64,
    },
}

/// Residual and Jacobian of N equations in N unknowns.
pub type Linearised<const N: usize> = (SVector<f64, N>, SMatrix<f64, N, N>);

/// Solves R(x) = 0 from `x`; `equations` returns residual and Jacobian, or `None` outside their domain.
///
/// # Errors
/// [`NewtonError`].
pub fn newton<const N: usize>(
    mut x: SVector<f64, N>,
    options: &NewtonOptions,
    mut equations: impl FnMut(&SVector<f64, N>) -> Option<Linearised<N>>,
) -> Result<NewtonReport<N>, NewtonError>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let (mut residual, mut jacobian) = equations(&x).ok_or(NewtonError::NoStart)?;
    let mut last_step = f64::INFINITY;
    for iteration in 0..options.iterations {
        let lu = jacobian.lu();
        let step = match lu.solve(&residual) {
            Some(step) if step.iter().all(|s| s.is_finite()) => -step,
            _ if iteration == 0 => return Err(NewtonError::Singular { ratio: singular_ratio(&jacobian) }),
            _ => return Err(NewtonError::Stuck { last_step }),
        };
        let length = step.norm();
        if iteration == 0 && length > 1e6 * options.longest_step {
            let ratio = singular_ratio(&jacobian);
            if ratio < 1e-13 {
                return Err(NewtonError::Singular { ratio });
            }
        }
        if length < options.step_tolerance {
            return Ok(NewtonReport { x: x + step, last_step: length, iterations: iteration + 1 });
        }
        let mut damping = f64::min(1.0, options.longest_step / length);
        let accepted = loop {
            let trial = x + step * damping;
            if let Some((r, j)) = equations(&trial) {
                let simplified = lu.solve(&r).map_or(f64::INFINITY, |s| s.norm());
                if simplified <= (1.0 - damping / 4.0) * length {
                    break Some((trial, r, j));
                }
            }
            damping *= 0.5;
            if damping < options.least_damping {
                break None;
            }
        };
        last_step = length;
        match accepted {
            Some((trial, r, j)) => (x, residual, jacobian) = (trial, r, j),
            None if length < options.stall_tolerance => {
                return Ok(NewtonReport { x, last_step: length, iterations: iteration + 1 });
            }
            None => return Err(NewtonError::Stuck { last_step }),
        }
    }
    if last_step < options.stall_tolerance {
        return Ok(NewtonReport { x, last_step, iterations: options.iterations });
    }
    Err(NewtonError::Stuck { last_step })
}

fn singular_ratio<const N: usize>(jacobian: &SMatrix<f64, N, N>) -> f64
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let values = nalgebra::DMatrix::from_fn(N, N, |i, j| jacobian[(i, j)]).singular_values();
    if values.max() > 0.0 { values.min() / values.max() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Vector2};

    #[test]
    fn badly_scaled_rows_converge() {
        let report = newton(Vector2::new(3.0, -2.0), &NewtonOptions::default(), |x| {
            Some((
                Vector2::new(1e-6 * (x[0] * x[0] - 2.0), 1e4 * (x[0] * x[1] - 1.0)),
                Matrix2::new(2e-6 * x[0], 0.0, 1e4 * x[1], 1e4 * x[0]),
            ))
        })
        .unwrap();
        assert!((report.x[0] - 2f64.sqrt()).abs() < 1e-12 && (report.x[1] - 0.5f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn no_root_and_singular_start_are_told_apart() {
        let no_root = |x: &Vector2<f64>| {
            Some((Vector2::new(x[0] * x[0] + 1.0, x[1]), Matrix2::new(2.0 * x[0], 0.0, 0.0, 1.0)))
        };
        let stuck = newton(Vector2::new(1.0, 0.0), &NewtonOptions::default(), no_root);
        assert!(matches!(stuck, Err(NewtonError::Stuck { .. })), "{stuck:?}");
        let singular = newton(Vector2::new(0.0, 0.0), &NewtonOptions::default(), |_| {
            Some((Vector2::new(1.0, 1.0), Matrix2::zeros()))
        });
        assert!(matches!(singular, Err(NewtonError::Singular { .. })));
    }
}
