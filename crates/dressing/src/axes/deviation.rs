//! What given deviations of the dressing axes do to the dressed profile, exactly and to first order
//! (`docs/mathematics/dressing.md#axes-and-their-deviations`). Knows no distribution of the deviations and no measurement.

use crate::{DressedProfile, DresserTool, DressingError};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;

/// Names of the components of DK and of its deviations.
pub const AXIS_NAMES: [&str; 4] = ["d_phi_S", "d_gamma", "d_d", "d_v_yA"];

/// Change of a profile by deviations of the axes. Lists run over the lengths of roll. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Influence {
    /// Lengths of roll.
    pub w: Vec<f64>,
    /// f(K + dK) - f(K), exact.
    pub exact: Vec<f64>,
    /// df/dK_j dK_j per component; their sum is the exact change to first order.
    pub first_order: [Vec<f64>; 4],
}

/// Change of the profile of `flank` over lengths of roll `w` (mm) when the axes deviate by `deviation` from the correction `dk`
/// (rad, rad, mm, mm).
///
/// # Errors
/// [`DressingError::InvalidNumber`] without lengths of roll and for numbers that are not finite; those of
/// [`DressedProfile::at_roll`].
pub fn influence(
    tool: &DresserTool,
    flank: Flank,
    dk: DressingCorrection,
    deviation: DressingCorrection,
    w: &[f64],
) -> Result<Influence, DressingError> {
    check_correction("dressing correction", &dk)?;
    check_correction("deviation of an axis", &deviation)?;
    check_rolls(w)?;
    let ideal = DressedProfile::new(tool, flank, dk).at_rolls(w)?;
    let real = DressedProfile::new(tool, flank, sum(&dk, &deviation)).at_rolls(w)?;
    Ok(Influence {
        w: w.to_vec(),
        exact: real.iter().zip(&ideal).map(|(real, ideal)| real.f - ideal.f).collect(),
        first_order: std::array::from_fn(|j| ideal.iter().map(|at| at.df_dk[j] * deviation[j]).collect()),
    })
}

pub(crate) fn sum(a: &DressingCorrection, b: &DressingCorrection) -> DressingCorrection {
    std::array::from_fn(|j| a[j] + b[j])
}

/// # Errors
/// [`DressingError::InvalidNumber`] for a component that is not finite.
pub(crate) fn check_correction(field: &'static str, dk: &DressingCorrection) -> Result<(), DressingError> {
    match dk.iter().find(|x| !x.is_finite()) {
        None => Ok(()),
        Some(&value) => Err(DressingError::InvalidNumber { field, value, allowed: "finite numbers" }),
    }
}

/// # Errors
/// [`DressingError::InvalidNumber`] for an empty list and for numbers that are no lengths of roll.
pub(crate) fn check_rolls(w: &[f64]) -> Result<(), DressingError> {
    let invalid = |field, value, allowed| Err(DressingError::InvalidNumber { field, value, allowed });
    if w.is_empty() {
        return invalid("number of lengths of roll", 0.0, "at least 1");
    }
    match w.iter().find(|w| !(w.is_finite() && **w > 0.0)) {
        None => Ok(()),
        Some(&value) => invalid("length of roll", value, "finite numbers above 0"),
    }
}
