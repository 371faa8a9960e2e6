//! A profile as measured: points over the length of roll with noise, and the smooth curve that fits them with its uncertainty
//! (`docs/mathematics/modifications.md#profile-as-measured`).

use crate::numerics::{BSpline, BSplineBasis, Jet2};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Fewest points.
pub const LEAST_POINTS: usize = 8;
/// Points for each interval of the curve, at least, and intervals at most.
const POINTS_EACH: usize = 3;
const MOST_INTERVALS: usize = 24;
const DEGREE: usize = 3;

/// A measured profile as a cubic spline; values in mm.
#[derive(Clone, Debug)]
pub struct ProfileTrace {
    spline: BSpline,
    /// Standard deviation of a point about the curve: as stated, where the curve leaves no more, else as the points have it.
    noise: f64,
    /// (B^T B)^-1 of the fit.
    normal: Cholesky<f64, Dyn>,
}

/// Why points make no curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Undetermined;

impl ProfileTrace {
    /// Fits points `(w, f)` by least squares with so few equal intervals as their scatter asks for: the fewest that leave no more than `noise`, the
    /// standard deviation of a point; where it is unknown, those of least generalised cross-validation. mm.
    ///
    /// # Errors
    /// [`Undetermined`] for points that do not determine a curve, all at few lengths of roll say.
    pub fn fit(w: &[f64], f: &[f64], noise: Option<f64>) -> Result<Self, Undetermined> {
        let most = (w.len() / POINTS_EACH).clamp(1, MOST_INTERVALS);
        let mut best: Option<(f64, Self)> = None;
        for intervals in 1..=most {
            // Points that leave an interval empty end the search, not the fit.
            let Some((fit, squares)) = Self::with(w, f, intervals) else { break };
            let free = (w.len() - fit.spline.basis().count()) as f64;
            match noise {
                Some(noise) if squares <= noise * noise * free => {
                    return Ok(Self { noise, ..fit });
                }
                // Nearest to what is stated.
                Some(_) => best = Some((0.0, fit)),
                None => {
                    let score = squares / (free * free);
                    if best.as_ref().is_none_or(|(least, _)| score < *least) {
                        best = Some((score, fit));
                    }
                }
            }
        }
        best.map(|(_, fit)| fit).ok_or(Undetermined)
    }

    /// The fit with so many intervals, and its sum of squares.
    fn with(w: &[f64], f: &[f64], intervals: usize) -> Option<(Self, f64)> {
        let ends = [w.first().copied()?, w.last().copied()?];
        let basis = BSplineBasis::uniform(ends, intervals, DEGREE, &[]).ok()?;
        if w.len() <= basis.count() {
            return None;
        }
        let mut rows = DMatrix::zeros(w.len(), basis.count());
        let mut values = [0.0; DEGREE + 1];
        for (i, w) in w.iter().enumerate() {
            let first = basis.values(*w, &mut values);
            for (j, value) in values.iter().enumerate() {
                rows[(i, first + j)] = *value;
            }
        }
        let right = DVector::from_column_slice(f);
        let normal = Cholesky::new(rows.tr_mul(&rows))?;
        let coefficients = normal.solve(&rows.tr_mul(&right));
        let squares = (&rows * &coefficients - right).norm_squared();
        let spline = BSpline::new(basis, coefficients.as_slice().to_vec()).ok()?;
        let noise = (squares / (w.len() - spline.basis().count()) as f64).sqrt();
        Some((Self { spline, noise, normal }, squares))
    }

    /// Standard deviation of the curve at a length of roll, mm.
    pub fn deviation_at(&self, w: f64) -> f64 {
        let basis = self.spline.basis();
        let mut row = DVector::zeros(basis.count());
        let mut values = [0.0; DEGREE + 1];
        let first = basis.values(w, &mut values);
        values.iter().enumerate().for_each(|(j, value)| row[first + j] = *value);
        self.noise * row.dot(&self.normal.solve(&row)).max(0.0).sqrt()
    }

    /// f, f', f'' over the length of roll; beyond the points it goes on straight.
    #[inline]
    fn over_roll(&self, w: f64) -> [f64; 3] {
        let [from, to] = self.spline.basis().interval();
        let inside = w.clamp(from, to);
        let [f, f1, f2] = self.spline.jet(inside);
        if inside == w { [f, f1, f2] } else { [f + f1 * (w - inside), f1, 0.0] }
    }

    pub(super) fn jet(&self, w: f64) -> Jet2 {
        let [f, fu, fuu] = self.over_roll(w);
        Jet2 { f, fu, fuu, ..Jet2::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::equidistant;

    fn intervals(fit: &ProfileTrace) -> usize {
        fit.spline.basis().count() - DEGREE
    }

    /// Normal deviates by the sum of twelve uniform ones of a linear congruence: enough for scatter of known size.
    fn scatter(count: usize, seed: u64) -> Vec<f64> {
        let mut state = seed;
        let mut uniform = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        (0..count).map(|_| (0..12).map(|_| uniform()).sum::<f64>() - 6.0).collect()
    }

    fn relief(w: f64) -> f64 {
        -4e-3 * ((w - 20.0) / 10.0).powi(2) - if w > 26.0 { 6e-3 * ((w - 26.0) / 4.0).powi(2) } else { 0.0 }
    }

    #[test]
    fn a_curve_without_noise_is_met() {
        let w = equidistant([10.0, 30.0], 60);
        let f: Vec<f64> = w.iter().map(|w| -4e-3 * ((w - 20.0) / 10.0).powi(2)).collect();
        let fit = ProfileTrace::fit(&w, &f, Some(1e-6)).unwrap();
        assert_eq!(intervals(&fit), 1);
        for w in [10.0, 13.3, 27.1, 30.0] {
            let [f, f1, f2] = fit.over_roll(w);
            assert!((f + 4e-3 * ((w - 20.0) / 10.0).powi(2)).abs() < 1e-12, "{w}");
            assert!((f1 + 8e-5 * (w - 20.0)).abs() < 1e-11 && (f2 + 8e-5).abs() < 1e-11, "{w}");
        }
        // Straight beyond the points.
        let [end, slope, _] = fit.over_roll(30.0);
        assert_eq!(fit.over_roll(32.0), [end + 2.0 * slope, slope, 0.0]);
    }

    /// Over many draws the curve scatters about the truth as it says, with and without knowledge of the noise.
    #[test]
    fn its_uncertainty_is_that_of_many_measurements() {
        let w = equidistant([10.0, 30.0], 120);
        let noise = 0.3e-3;
        for known in [Some(noise), None] {
            let (mut squares, mut said) = (0.0, 0.0);
            const DRAWS: u64 = 200;
            for seed in 0..DRAWS {
                let draw = scatter(w.len(), seed + 1);
                let f: Vec<f64> = w.iter().zip(&draw).map(|(w, e)| relief(*w) + noise * e).collect();
                let fit = ProfileTrace::fit(&w, &f, known).unwrap();
                squares += (fit.over_roll(18.0)[0] - relief(18.0)).powi(2);
                said += fit.deviation_at(18.0).powi(2);
            }
            // Of 200 draws a standard deviation is known to 5 %; four times that, and what smoothing leaves.
            let ratio = (squares / said).sqrt();
            assert!((0.8..1.3).contains(&ratio), "{known:?}: {ratio}");
        }
    }

    #[test]
    fn the_noise_is_found_where_it_is_not_stated() {
        let w = equidistant([10.0, 30.0], 120);
        let draw = scatter(w.len(), 7);
        let f: Vec<f64> = w.iter().zip(&draw).map(|(w, e)| relief(*w) + 0.3e-3 * e).collect();
        let fit = ProfileTrace::fit(&w, &f, None).unwrap();
        assert!((fit.noise / 0.3e-3 - 1.0).abs() < 0.2, "{}", fit.noise);
        assert!((2..=24).contains(&intervals(&fit)), "{}", intervals(&fit));
    }

    #[test]
    fn points_at_few_places_determine_nothing() {
        let w = [10.0, 10.0, 10.0, 10.0, 30.0, 30.0, 30.0, 30.0];
        assert_eq!(ProfileTrace::fit(&w, &[0.0; 8], None).unwrap_err(), Undetermined);
    }
}
