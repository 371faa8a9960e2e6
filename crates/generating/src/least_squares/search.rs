//! The direction of the dressed lines that meets the samples of one flank or, with one diagonal ratio, of both best
//! (`docs/mathematics/planning.md#producibility`). Asks [`FlankLines`] for directions only.

use super::super::{FlankLines, GeneratingError};
use super::fit::fit_coefficients;
use super::scan::least;
use super::{
    ArgumentKinks, Arguments, Candidates, DiagonalCoordinates, FitQuality, FitSettings, FlankCoordinates,
    Samples, SplineDecomposition, Tried,
};
use foundation::geometry::Sides;

/// Two exact ratios closer than this are one (`docs/mathematics/planning.md#producibility`).
const SAME_RATIO: f64 = 1e-9;

/// What a search makes small.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Objective {
    /// sqrt(rms_l^2 + rms_r^2), mm.
    #[default]
    Rms,
    /// The largest |f - fit|/tolerance of the flanks.
    ToleranceRatio,
}

impl Objective {
    /// Of the flanks that are ground.
    pub fn of(self, flanks: impl IntoIterator<Item = FitQuality>) -> f64 {
        let flanks = flanks.into_iter();
        match self {
            Self::Rms => flanks.map(|q| q.rms * q.rms).sum::<f64>().sqrt(),
            Self::ToleranceRatio => flanks.map(|q| q.tolerance_ratio).fold(0.0, f64::max),
        }
    }
}

/// One flank to be decomposed.
#[derive(Clone, Copy, Debug)]
pub struct FlankFit<'a> {
    /// Directions of the flank.
    pub lines: &'a FlankLines,
    /// Its target.
    pub samples: &'a Samples,
    /// Class and splines.
    pub settings: &'a FitSettings,
    /// m of the profile argument w + m z; 0 for cylindrical bodies.
    pub rack_slope: f64,
}

impl FlankFit<'_> {
    /// The decomposition at diagonal ratio K. A class without functions of X (`radial`) is the same at every ratio.
    ///
    /// # Errors
    /// `DirectionAlongPath` for ratio 0 and beyond about 1e6, and those of [`SplineDecomposition::fit`].
    pub fn at_ratio(&self, ratio: f64) -> Result<SplineDecomposition<DiagonalCoordinates>, GeneratingError> {
        self.at_direction(self.lines.work_direction(ratio))
    }

    /// The decomposition at direction t = tan(rho_2).
    ///
    /// # Errors
    /// As [`FlankFit::at_ratio`].
    pub fn at_direction(&self, t: f64) -> Result<SplineDecomposition<DiagonalCoordinates>, GeneratingError> {
        SplineDecomposition::fit(self.samples, self.coordinates(t)?, self.settings)
    }

    /// Residuals of the decomposition at direction t, without its functions.
    ///
    /// # Errors
    /// As [`FlankFit::at_ratio`].
    pub fn quality(&self, t: f64) -> Result<FitQuality, GeneratingError> {
        let coordinates = self.coordinates(t)?;
        let arguments: Vec<Arguments> =
            self.samples.points().iter().map(|&[w, z]| coordinates.arguments(w, z)).collect();
        let kinks = ArgumentKinks::new(self.settings, &coordinates);
        let fit = fit_coefficients(self.samples, &arguments, self.settings, &kinks)?;
        Ok(fit.report.quality())
    }

    fn coordinates(&self, t: f64) -> Result<DiagonalCoordinates, GeneratingError> {
        let t_k = self.lines.t_k;
        if self.settings.class.uses_lines() {
            DiagonalCoordinates::new(t, t_k, self.rack_slope)
        } else {
            DiagonalCoordinates::radial(t_k, self.rack_slope)
        }
    }
}

/// The best diagonal ratio.
#[derive(Clone, Debug, PartialEq)]
pub struct RatioSearch {
    /// K.
    pub ratio: f64,
    /// Objective there.
    pub objective: f64,
    /// The decompositions there.
    pub flanks: Sides<Option<SplineDecomposition<DiagonalCoordinates>>>,
    /// All candidates, ascending.
    pub tried: Vec<Tried>,
}

/// The best direction on one flank.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectionSearch {
    /// rho_2, rad.
    pub direction: f64,
    /// Objective there.
    pub objective: f64,
    /// The decomposition there.
    pub flank: SplineDecomposition<DiagonalCoordinates>,
    /// All candidates, ascending.
    pub tried: Vec<Tried>,
}

/// A quantity of every flank that is given.
fn on_flanks<T: Send>(
    flanks: &Sides<Option<FlankFit<'_>>>,
    of: impl Fn(&FlankFit<'_>) -> Result<T, GeneratingError> + Sync,
) -> Result<Sides<Option<T>>, GeneratingError> {
    let one = |fit: &Option<FlankFit<'_>>| fit.as_ref().map(&of).transpose();
    let (left, right) = rayon::join(|| one(&flanks.left), || one(&flanks.right));
    Ok(Sides { left: left?, right: right? })
}

/// The diagonal ratio, one for all flanks given, at which the objective is least: scan over the candidates, then golden
/// section around the best local minima.
///
/// # Errors
/// `NoFlank`; where no candidate can be fitted, the error of the first.
pub fn search_ratio(
    flanks: &Sides<Option<FlankFit<'_>>>,
    candidates: &Candidates,
    objective: Objective,
) -> Result<RatioSearch, GeneratingError> {
    if flanks.left.is_none() && flanks.right.is_none() {
        return Err(GeneratingError::NoFlank);
    }
    let height =
        |sides: Sides<Option<FitQuality>>| objective.of([sides.left, sides.right].into_iter().flatten());
    let (ratio, tried) = least(candidates, |ratio| {
        on_flanks(flanks, |fit| fit.quality(fit.lines.work_direction(ratio))).map(height)
    })?;
    let flanks = on_flanks(flanks, |fit| fit.at_ratio(ratio))?;
    let objective = height(flanks.map(|_, flank| flank.as_ref().map(|d| d.report.quality())));
    Ok(RatioSearch { ratio, objective, flanks, tried })
}

/// The direction rho_2 [rad] on one flank at which the objective is least.
///
/// # Errors
/// As [`search_ratio`].
pub fn search_direction(
    flank: &FlankFit<'_>,
    candidates: &Candidates,
    objective: Objective,
) -> Result<DirectionSearch, GeneratingError> {
    let height = |quality: FitQuality| objective.of([quality]);
    let (direction, tried) = least(candidates, |rho| flank.quality(rho.tan()).map(height))?;
    let flank = flank.at_direction(direction.tan())?;
    Ok(DirectionSearch { direction, objective: height(flank.report.quality()), flank, tried })
}

/// Whether both flanks can be ground at once without deviation: their exact ratios agree within 1e-9.
pub fn deviation_free(exact_left: f64, exact_right: f64) -> bool {
    (exact_left - exact_right).abs() <= SAME_RATIO
}
