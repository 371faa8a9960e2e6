//! Contact line of dresser and worm and its mean direction rho (`docs/mathematics/dressing.md#the-contact-line`).

use super::{DressedProfile, DresserTool, DressingError};
use foundation::geometry::Flank;
use foundation::kinematics::DressingCorrection;

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

/// Equidistant points of the fit; every calculation must use the same number, because the diagonal ratio follows from the
/// direction (`docs/mathematics/planning.md` reference numbers: 21).
const SAMPLES: usize = 21;

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
                profile.at_roll(w).map(|p| (p.w, p.b))
            })
            .collect::<Result<Vec<_>, _>>()?;
        Ok(Self::through(&points))
    }

    /// Least-squares line through points (w, b) of a contact line, mm; at least two different w.
    pub fn through(points: &[(f64, f64)]) -> Self {
        let n = points.len() as f64;
        let (mean_w, mean_b) =
            (points.iter().map(|p| p.0).sum::<f64>() / n, points.iter().map(|p| p.1).sum::<f64>() / n);
        let slope = points.iter().map(|p| (p.0 - mean_w) * (p.1 - mean_b)).sum::<f64>()
            / points.iter().map(|p| (p.0 - mean_w).powi(2)).sum::<f64>();
        let rho = (-slope).atan();
        let (sin, cos) = rho.sin_cos();
        let across = points.iter().map(|p| (p.0 - mean_w) * sin + p.1 * cos);
        let (low, high) = across.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        Self { rho, coordinate: (mean_b - slope * mean_w) * cos, straightness: high - low }
    }
}
