//! The fit itself, on samples whose arguments are known.

use super::super::GeneratingError;
use super::columns::{ArgumentKinks, Columns, Scratch};
use super::{Arguments, FitNorm, FitQuality, FitSettings, Samples, WormFunctions};
use foundation::inverse::{BandedReduction, minimise_largest_residual};

/// Singular values below this share of the largest are dropped (`docs/mathematics/planning.md#producibility`): the gauge leaves some that
/// are zero up to rounding, which stays below 1e-13 for thousands of columns; the least true ones of sensible fits are above 1e-8.
pub(super) const RANK_CUT: f64 = 1e-11;

/// Outcome of the fit with the least largest |f - fit|/tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MinimaxReport {
    /// Residuals of that fit.
    pub quality: FitQuality,
    /// No fit in the class has a smaller `tolerance_ratio`: quality.tolerance_ratio - bound is the proven gap.
    pub bound: f64,
}

/// What a fit came to.
#[derive(Clone, Debug, PartialEq)]
pub struct FitReport {
    /// Samples.
    pub points: usize,
    /// Coefficients.
    pub coefficients: usize,
    /// Rank of the matrix.
    pub rank: usize,
    /// Combinations of coefficients that add up to zero for any samples. Where coefficients - rank is larger, the
    /// samples leave functions undetermined in places; those take the values of least norm.
    pub ambiguity: usize,
    /// Residuals of the least-squares fit.
    pub least_squares: FitQuality,
    /// The fit with least largest residual, if that norm was asked for.
    pub minimax: Option<MinimaxReport>,
}

impl FitReport {
    /// Residuals of the functions handed out.
    pub fn quality(&self) -> FitQuality {
        self.minimax.map_or(self.least_squares, |m| m.quality)
    }
}

/// Functions of minimum norm and their report.
#[derive(Clone, Debug, PartialEq)]
pub struct FunctionsFit {
    /// The functions.
    pub functions: WormFunctions,
    /// How well they meet the samples.
    pub report: FitReport,
}

/// Fits the functions of the class to samples at given arguments, one for every sample.
///
/// # Errors
/// `TooFewPoints`, `NoExtent`, `CoordinateNotFinite`, `InvalidSpline`, `FitNotSolved`.
pub fn fit_functions(
    samples: &Samples,
    arguments: &[Arguments],
    settings: &FitSettings,
    kinks: &ArgumentKinks,
) -> Result<FunctionsFit, GeneratingError> {
    let fit = fit_coefficients(samples, arguments, settings, kinks)?;
    Ok(FunctionsFit { functions: fit.columns.functions(&fit.x)?, report: fit.report })
}

/// Coefficients of minimum norm.
pub(super) struct CoefficientsFit {
    pub columns: Columns,
    pub x: Vec<f64>,
    pub report: FitReport,
}

/// [`fit_functions`] without the functions: all that a search asks for at most of its places.
pub(super) fn fit_coefficients(
    samples: &Samples,
    arguments: &[Arguments],
    settings: &FitSettings,
    kinks: &ArgumentKinks,
) -> Result<CoefficientsFit, GeneratingError> {
    if arguments.len() != samples.count() {
        return Err(GeneratingError::TooFewPoints { points: arguments.len(), needed: samples.count() });
    }
    let bad = arguments.iter().position(|a| ![a.x, a.profile, a.path].iter().all(|x| x.is_finite()));
    if let Some(i) = bad {
        let [w, z] = samples.points()[i];
        return Err(GeneratingError::CoordinateNotFinite { w, z });
    }
    let columns = Columns::new(samples, arguments, settings, kinks)?;
    let (points, values, tolerances) = (samples.points(), samples.values(), samples.tolerances());
    let count = samples.count();
    let unsolved = || GeneratingError::FitNotSolved { coefficients: columns.count() };

    let (mut scratch, mut row) = (Scratch::default(), Vec::new());
    let [band, stretch, border] = columns.band();
    let mut reduction = BandedReduction::new(band, stretch, border, count);
    for i in columns.sorted(arguments) {
        let weight = 1.0 / tolerances[i];
        columns.row(points[i][0], &arguments[i], weight, &mut scratch, &mut row);
        reduction.push(&row, weight * values[i]);
    }
    let reduction = reduction.finish();
    let mut quality = |x: &[f64]| {
        FitQuality::of((0..count).map(|i| {
            columns.row(points[i][0], &arguments[i], 1.0, &mut scratch, &mut row);
            (values[i] - row.iter().map(|&(j, a)| a * x[j]).sum::<f64>(), tolerances[i])
        }))
    };
    // Amounts near the largest numbers there are.
    let checked = |quality: FitQuality| if quality.rms.is_finite() { Ok(quality) } else { Err(unsolved()) };
    let (x, rank, least_squares, minimax) = match settings.norm {
        FitNorm::LeastSquares => {
            let (x, rank) = reduction.shortest(RANK_CUT).ok_or_else(unsolved)?;
            let least_squares = checked(quality(&x))?;
            (x, rank, least_squares, None)
        }
        FitNorm::Largest => {
            let solved = reduction.solve(RANK_CUT).ok_or_else(unsolved)?;
            let least_squares = checked(quality(&solved.x))?;
            let mut scratch = Scratch::default();
            let mut weighted = |i: usize, row: &mut Vec<(usize, f64)>| {
                let weight = 1.0 / tolerances[i];
                columns.row(points[i][0], &arguments[i], weight, &mut scratch, row);
                weight * values[i]
            };
            let best = minimise_largest_residual(&solved, count, &mut weighted).ok_or_else(unsolved)?;
            let minimax = MinimaxReport { quality: quality(&best.x), bound: best.bound };
            (best.x, solved.rank.rank, least_squares, Some(minimax))
        }
    };
    let report = FitReport {
        points: count,
        coefficients: columns.count(),
        rank,
        ambiguity: settings.class.ambiguity(settings.degree),
        least_squares,
        minimax,
    };
    Ok(CoefficientsFit { columns, x, report })
}
