//! Contact line of dresser and worm and its mean direction rho (spec 30 section 6).

use super::{DressedProfile, DresserTool, DressingError};
use crate::geometry::Flank;
use crate::kinematics::DressingCorrection;

/// Least-squares line through the contact line over the used profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactLine {
    /// rho, rad: tan(rho) = -db/dw.
    pub rho: f64,
    /// X = b_0 cos(rho), mm.
    pub coordinate: f64,
    /// Peak to peak of w sin(rho) + b cos(rho), mm.
    pub straightness: f64,
}

/// Equidistant points of the fit; the direction of a line that is straight to a micrometre does not need more, and every
/// calculation must use the same number, because the diagonal ratio follows from the direction.
const SAMPLES: usize = 7;

impl ContactLine {
    /// Fits the contact line of `flank` at correction `dk` over the used range.
    ///
    /// # Errors
    /// As [`DressedProfile::at_roll`].
    pub fn fit(tool: &DresserTool, flank: Flank, dk: DressingCorrection) -> Result<Self, DressingError> {
        let range = tool.flanks[flank].range;
        let profile = DressedProfile::new(tool, flank, dk);
        let points = (0..SAMPLES)
            .map(|i| {
                let w = range.w_nf + range.length() * i as f64 / (SAMPLES - 1) as f64;
                profile.at_roll(w).map(|p| (p.w - range.middle(), p.b))
            })
            .collect::<Result<Vec<_>, _>>()?;
        let n = points.len() as f64;
        let (mean_x, mean_b) =
            (points.iter().map(|p| p.0).sum::<f64>() / n, points.iter().map(|p| p.1).sum::<f64>() / n);
        let slope = points.iter().map(|p| (p.0 - mean_x) * (p.1 - mean_b)).sum::<f64>()
            / points.iter().map(|p| (p.0 - mean_x).powi(2)).sum::<f64>();
        let rho = (-slope).atan();
        let (sin, cos) = rho.sin_cos();
        let along: Vec<f64> = points.iter().map(|p| p.0 * sin + p.1 * cos).collect();
        let (low, high) =
            along.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &x| (l.min(x), h.max(x)));
        let b_0 = mean_b - slope * (mean_x + range.middle());
        Ok(Self { rho, coordinate: b_0 * cos, straightness: high - low })
    }
}
