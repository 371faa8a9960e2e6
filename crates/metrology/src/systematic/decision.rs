//! Whether the mean of a characteristic over the teeth is worth a correction.

use super::{FirstHarmonic, SystematicError, TeethVariance};
use foundation::numerics::{student_quantile, student_two_sided};

/// What the test is judged by, in the unit of the values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SystematicOptions {
    /// Tolerance of the characteristic, > 0.
    pub tolerance: f64,
    /// Standard uncertainty of the calibration, >= 0.
    pub calibration: f64,
    /// Share of the tolerance below which nothing is corrected.
    pub dead_band: f64,
    /// Level of all tests, 0 to 1.
    pub level: f64,
}

impl SystematicOptions {
    /// Dead band 0.1, level 0.95.
    pub fn new(tolerance: f64, calibration: f64) -> Self {
        Self { tolerance, calibration, dead_band: 0.1, level: 0.95 }
    }
}

/// What follows for the process.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decision {
    /// Systematic and large enough: correct it.
    Correct,
    /// Smaller than the dead band.
    BelowDeadBand,
    /// Not distinguished from the scatter of teeth and the calibration.
    NotSystematic,
    /// What there is comes from the clamping; nothing systematic stays without it.
    FirstHarmonic,
}

impl Decision {
    /// Stable name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Correct => "correct",
            Self::BelowDeadBand => "below-dead-band",
            Self::NotSystematic => "not-systematic",
            Self::FirstHarmonic => "first-harmonic",
        }
    }
}

/// The test of one characteristic.
#[derive(Clone, Debug, PartialEq)]
pub struct SystematicTest {
    /// Variance between and within teeth.
    pub variance: TeethVariance,
    /// First harmonic of the rotation, with at least five teeth and their angles.
    pub harmonic: Option<FirstHarmonic>,
    /// Whether the harmonic is real and taken out: a fault of the clamping to be reported.
    pub harmonic_removed: bool,
    /// What all teeth share: the mean, without the harmonic where that is taken out.
    pub common: f64,
    /// Its standard uncertainty without the calibration.
    pub uncertainty: f64,
    /// Degrees of freedom of the uncertainty.
    pub freedom: f64,
    /// common/uncertainty.
    pub t: f64,
    /// Probability of so large a |t| by chance.
    pub p: f64,
    /// Two-sided quantile of t at the level.
    pub t_quantile: f64,
    /// |common| above this is corrected.
    pub limit: f64,
    /// What follows.
    pub decision: Decision,
    /// Share of the common part to apply where one is cautious, 0 to 1.
    pub share: f64,
}

/// Tests readings `[tooth][repeat]` of one characteristic; `angles` of the teeth in rad, where known.
///
/// # Errors
/// Those of [`TeethVariance::new`]; [`SystematicError::OtherShape`] for angles of other teeth; [`SystematicError::InvalidNumber`] for options
/// outside their ranges.
pub fn systematic_test(
    readings: &[Vec<f64>],
    angles: Option<&[f64]>,
    options: &SystematicOptions,
) -> Result<SystematicTest, SystematicError> {
    check(readings.len(), angles, options)?;
    let variance = TeethVariance::new(readings)?;
    let teeth = variance.teeth.len() as f64;
    let harmonic = angles.and_then(|angles| FirstHarmonic::new(&variance.teeth, angles));
    let removed = harmonic.filter(|h| h.p < 1.0 - options.level);
    let (common, uncertainty, freedom) = match removed {
        Some(h) => (h.mean, h.uncertainty, teeth - 3.0),
        None => (variance.mean, variance.uncertainty(), teeth - 1.0),
    };
    let t = if common == 0.0 { 0.0 } else { common / uncertainty };
    let t_quantile = student_quantile(options.level, freedom);
    let spread = uncertainty.hypot(options.calibration);
    let dead = options.dead_band * options.tolerance;
    let limit = dead.max(t_quantile * spread);
    let decision = if common.abs() > limit {
        Decision::Correct
    } else if common.abs() > t_quantile * spread {
        Decision::BelowDeadBand
    } else if removed.is_some() {
        Decision::FirstHarmonic
    } else {
        Decision::NotSystematic
    };
    let share = if common == 0.0 { 0.0 } else { (1.0 - (spread / common).powi(2)).max(0.0) };
    Ok(SystematicTest {
        variance,
        harmonic,
        harmonic_removed: removed.is_some(),
        common,
        uncertainty,
        freedom,
        t,
        p: student_two_sided(t, freedom),
        t_quantile,
        limit,
        decision,
        share,
    })
}

fn check(teeth: usize, angles: Option<&[f64]>, options: &SystematicOptions) -> Result<(), SystematicError> {
    if let Some(angles) = angles {
        if angles.len() != teeth {
            let (name, found) = ("angles of teeth", angles.len());
            return Err(SystematicError::OtherShape { name, found, wanted: teeth });
        }
        if let Some(&value) = angles.iter().find(|a| !a.is_finite()) {
            let (name, allowed) = ("angle of a tooth", "finite numbers");
            return Err(SystematicError::InvalidNumber { name, value, allowed });
        }
    }
    let SystematicOptions { tolerance, calibration, dead_band, level } = *options;
    let numbers = [
        ("tolerance", tolerance, tolerance > 0.0, "finite numbers above 0"),
        ("calibration uncertainty", calibration, calibration >= 0.0, "finite numbers from 0"),
        ("dead band", dead_band, (0.0..=1.0).contains(&dead_band), "0 to 1"),
        ("level", level, level > 0.0 && level < 1.0, "numbers between 0 and 1"),
    ];
    match numbers.into_iter().find(|(_, value, good, _)| !(*good && value.is_finite())) {
        None => Ok(()),
        Some((name, value, _, allowed)) => Err(SystematicError::InvalidNumber { name, value, allowed }),
    }
}
