//! The corrections with which a dresser leaves a parabola on a worm that it may not have been designed for, and what comes out
//! without them (`docs/mathematics/dressing.md`). Knows no limit of axes or bodies.

use crate::{
    Condition, ConditionSolver, DressedProfile, DresserTool, DressingError, PathReason, WormSeat, stretch,
    three_points_with_map,
};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;

/// A flank dressed to a parabola through the pitch points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileFit {
    /// DK against the nominal kinematics of the worm.
    pub dk: DressingCorrection,
    /// Relative stretch P_FS.
    pub stretch: f64,
}

/// Steps in which the amount grows from 0 (`docs/mathematics/dressing.md`).
const STEPS: usize = 8;

/// The rows of the three-point method for f = `middle` (mm) in the middle of the used range and 0 at both ends.
fn rows(tool: &DresserTool, flank: Flank, middle: f64) -> [Condition; 4] {
    three_points_with_map(&tool.flanks[flank], [0.0, middle, 0.0])
}

/// Corrections at which the worm gets f = `middle` in the middle of its used profile and 0 at both ends, mm normal; the amount
/// grows in 8 steps from the solution without one, which is sought from `start`.
///
/// # Errors
/// Those of [`ConditionSolver::solve`]; [`DressingError::NoZero`] with the share of the amount that was reached.
pub fn fit_profile(
    tool: &DresserTool,
    flank: Flank,
    reference_radius: f64,
    middle: f64,
    start: &DressingCorrection,
) -> Result<ProfileFit, DressingError> {
    let solver = ConditionSolver::new(tool, reference_radius);
    let mut dk = solver.solve(&rows(tool, flank, 0.0), start)?;
    if middle != 0.0 {
        for k in 1..=STEPS {
            let share = k as f64 / STEPS as f64;
            dk = solver.solve(&rows(tool, flank, middle * share), &dk).map_err(|e| match e {
                // The share of this step becomes one of the whole amount.
                DressingError::NoZero { flank, v, fraction, reason } => {
                    let fraction = share - (1.0 - fraction) / STEPS as f64;
                    DressingError::NoZero { flank, v, fraction, reason }
                }
                other => other,
            })?;
        }
    }
    Ok(ProfileFit { dk, stretch: stretch(tool, flank, dk)? })
}

/// The same straight from the corrections `start` of a neighbour: another diameter, another amount.
///
/// # Errors
/// Those of [`ConditionSolver::solve`].
pub fn refit_profile(
    tool: &DresserTool,
    flank: Flank,
    reference_radius: f64,
    middle: f64,
    start: &DressingCorrection,
) -> Result<ProfileFit, DressingError> {
    let solver = ConditionSolver::new(tool, reference_radius);
    let dk = solver.solve(&rows(tool, flank, middle), start)?;
    Ok(ProfileFit { dk, stretch: stretch(tool, flank, dk)? })
}

/// What a dresser leaves on a worm without crossing and offset corrections: only distance and phase are set so that both ends
/// of the used profile are met. The corrections and f in the middle, mm normal.
///
/// # Errors
/// Those of [`ConditionSolver::solve`].
pub fn uncorrected_profile(
    tool: &DresserTool,
    flank: Flank,
    reference_radius: f64,
) -> Result<(DressingCorrection, f64), DressingError> {
    let [first, _, last, _] = rows(tool, flank, 0.0);
    let fixed = |j| Condition::Fixed { j, x: 0.0 };
    let solver = ConditionSolver::new(tool, reference_radius);
    let dk = solver.solve(&[first, last, fixed(1), fixed(3)], &[0.0; 4])?;
    let middle = tool.flanks[flank].range.middle();
    Ok((dk, DressedProfile::new(tool, flank, dk).at_roll(middle)?.f))
}

/// Largest distance of the dressed profile from the parabola that [`fit_profile`] asks for, mm normal, and the dresser radii
/// that dress it (smallest, largest), mm.
///
/// # Errors
/// As [`DressedProfile::at_roll`].
pub fn profile_error(
    tool: &DresserTool,
    flank: Flank,
    dk: DressingCorrection,
    middle: f64,
) -> Result<(f64, [f64; 2]), DressingError> {
    const POINTS: usize = 17;
    let range = tool.flanks[flank].range;
    let profile = DressedProfile::new(tool, flank, dk);
    let (mut error, mut radii) = (0.0_f64, [f64::INFINITY, f64::NEG_INFINITY]);
    for k in 0..POINTS {
        let x = 2.0 * k as f64 / (POINTS - 1) as f64 - 1.0;
        let at = profile.at_roll(range.middle() + 0.5 * range.length() * x)?;
        error = error.max((at.f - middle * (1.0 - x * x)).abs());
        radii = [radii[0].min(at.r_a), radii[1].max(at.r_a)];
    }
    Ok((error, radii))
}

/// Shortest step along a path of worms, as a share of it.
const LEAST_STEP: f64 = 1e-3;

/// [`fit_profile`] on the worm at the end of a path that begins at a worm which the dresser fits well (share 0): along the path
/// in steps as small as it takes.
///
/// # Errors
/// Those of the worms of the path; [`DressingError::NoZero`] with the share of the path that was reached.
pub fn fit_profile_on_path(
    dresser: &DresserTool,
    flank: Flank,
    path: &dyn Fn(f64) -> Result<WormSeat, DressingError>,
    middle: f64,
) -> Result<ProfileFit, DressingError> {
    let (mut reached, mut step, mut dk) = (0.0, 0.25, [0.0; 4]);
    let mut reason = PathReason::GivenUp;
    while step >= LEAST_STEP {
        let next = f64::min(reached + step, 1.0);
        let seat = path(next)?;
        let here = dresser.on_worm(&seat)?;
        match refit_profile(&here, flank, seat.reference_radius(), 0.0, &dk) {
            Ok(fit) => {
                (reached, dk) = (next, fit.dk);
                if reached >= 1.0 {
                    return fit_profile(&here, flank, seat.reference_radius(), middle, &dk);
                }
                step *= 1.5;
            }
            Err(refusal) => {
                if let DressingError::NoZero { reason: why, .. } = refusal {
                    reason = why;
                }
                step *= 0.5;
            }
        }
    }
    Err(DressingError::NoZero { flank, v: 0.0, fraction: reached, reason })
}

/// [`fit_profile`] directly, and where that fails by [`fit_profile_on_path`].
///
/// # Errors
/// Those of the worms of the path; else the refusal of the direct way.
pub fn fit_profile_along(
    dresser: &DresserTool,
    flank: Flank,
    path: &dyn Fn(f64) -> Result<WormSeat, DressingError>,
    middle: f64,
) -> Result<ProfileFit, DressingError> {
    let seat = path(1.0)?;
    let tool = dresser.on_worm(&seat)?;
    fit_profile(&tool, flank, seat.reference_radius(), middle, &[0.0; 4])
        .or_else(|refusal| fit_profile_on_path(dresser, flank, path, middle).map_err(|_| refusal))
}
