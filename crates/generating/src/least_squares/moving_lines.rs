//! How the residual of a fit changes while its lines move over the flank and its functions always follow best: the
//! linear problem for the parameters of the lines. Knows no law of motion.

use super::super::GeneratingError;
use super::columns::{ArgumentKinks, Scratch};
use super::fit::{CoefficientsFit, RANK_CUT, fit_coefficients};
use super::{Arguments, FitQuality, FitSettings, Samples};
use foundation::inverse::{BandedReduction, RowReduction};
use foundation::numerics::Jet2;

/// A fit whose lines depend on parameters.
pub(in super::super) struct MovingLines {
    arguments: Vec<Arguments>,
    /// X of the kinks.
    kinks: Vec<f64>,
    fit: CoefficientsFit,
}

/// Derivatives of X in the parameters, at every sample and at every kink of the lines; rows one after another.
pub(in super::super) struct LineSlopes {
    /// Number of parameters.
    pub parameters: usize,
    /// At the samples.
    pub samples: Vec<f64>,
    /// At the kinks.
    pub kinks: Vec<Vec<f64>>,
}

impl MovingLines {
    /// The fit where the lines are now.
    ///
    /// # Errors
    /// Those of [`super::fit_functions`].
    pub fn new(
        samples: &Samples,
        arguments: Vec<Arguments>,
        settings: &FitSettings,
        kinks: &ArgumentKinks,
    ) -> Result<Self, GeneratingError> {
        let fit = fit_coefficients(samples, &arguments, settings, kinks)?;
        Ok(Self { arguments, kinks: kinks.x.clone(), fit })
    }

    /// Residuals.
    pub fn quality(&self) -> FitQuality {
        self.fit.report.quality()
    }

    /// Rows [change of the fit in the parameters | residual], each over tolerance and root of the number of samples, with the
    /// functions fitted out: their least squares are the Gauss-Newton step of the parameters (variable projection in the form
    /// of Kaufman). The ends of the splines' interval move with the outermost samples, the knots between the ends
    /// and kinks in proportion. `None` if a number is not finite.
    ///
    /// # Errors
    /// `InvalidSpline`.
    pub fn problem(
        &self,
        samples: &Samples,
        slopes: &LineSlopes,
    ) -> Result<Option<RowReduction>, GeneratingError> {
        let (columns, n) = (&self.fit.columns, slopes.parameters);
        let functions = columns.functions(&self.fit.x)?;
        let (points, values, tolerances) = (samples.points(), samples.values(), samples.tolerances());
        let anchors = self.anchors(slopes);
        let size = (points.len() as f64).sqrt();
        let [band, stretch, border] = columns.band();
        let mut reduction = BandedReduction::new(band, stretch, border + n, points.len());
        let (mut scratch, mut row) = (Scratch::default(), Vec::new());
        for i in columns.sorted(&self.arguments) {
            let (w, x) = (points[i][0], self.arguments[i].x);
            let weight = 1.0 / (tolerances[i] * size);
            columns.row(w, &self.arguments[i], weight, &mut scratch, &mut row);
            let fitted: f64 = row.iter().map(|&(j, a)| a * self.fit.x[j]).sum();
            // d(fit)/dX at fixed w.
            let slope = functions.dressing_jet(w, Jet2 { f: x, fv: 1.0, ..Jet2::default() }).fv;
            let [(below, first), (above, last)] = around(&anchors, x);
            let share = (x - below) / (above - below);
            row.extend((0..n).map(|k| {
                let carried = first[k] * (1.0 - share) + last[k] * share;
                (band + border + k, weight * slope * (slopes.samples[i * n + k] - carried))
            }));
            reduction.push(&row, weight * values[i] - fitted);
        }
        Ok(reduction.finish().beyond(band + border, RANK_CUT))
    }

    /// X and its derivatives at the ends of the interval and at the kinks, ascending.
    fn anchors<'s>(&self, slopes: &'s LineSlopes) -> Vec<(f64, &'s [f64])> {
        let n = slopes.parameters;
        let x = |i: usize| self.arguments[i].x;
        let end = |better: fn(f64, f64) -> bool| {
            let i = (1..self.arguments.len()).fold(0, |best, i| if better(x(i), x(best)) { i } else { best });
            (x(i), &slopes.samples[i * n..(i + 1) * n])
        };
        let (low, high) = (end(|a, b| a < b), end(|a, b| a > b));
        let kinks = self.kinks.iter().zip(&slopes.kinks).map(|(x, row)| (*x, row.as_slice()));
        let mut anchors: Vec<_> = kinks.filter(|(x, _)| *x > low.0 && *x < high.0).collect();
        anchors.extend([low, high]);
        anchors.sort_by(|a, b| a.0.total_cmp(&b.0));
        // Two kinks on one line.
        anchors.dedup_by(|a, b| a.0 == b.0);
        anchors
    }
}

/// The two neighbours among ascending anchors between which x lies.
fn around<'s>(anchors: &[(f64, &'s [f64])], x: f64) -> [(f64, &'s [f64]); 2] {
    let i = anchors.partition_point(|(at, _)| *at <= x).clamp(1, anchors.len() - 1);
    [anchors[i - 1], anchors[i]]
}
