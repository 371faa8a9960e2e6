//! Wear over the workpieces that were cut since the edge was ground: a straight line by weighted least squares.

use super::forecast::forecast;
use super::{Forecast, NoForecast, WearError};
use foundation::inverse::weighted_least_squares;
use nalgebra::{DMatrix, DVector, Matrix2, Vector2};

/// A flank's wear at one measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WearPoint {
    /// Workpieces cut since the edge was ground.
    pub parts: f64,
    /// Material that is missing on the deepest track, mean over the teeth, mm; < 0 where it stands beyond the nominal edge.
    pub wear: f64,
    /// Standard deviation of `wear`, mm.
    pub sigma: f64,
}

/// wear = a + b parts, with what it says about the limit.
#[derive(Clone, Debug, PartialEq)]
pub struct WearTrend {
    /// a: wear of the freshly ground edge, mm.
    pub start: f64,
    /// b: wear per workpiece, mm.
    pub rate: f64,
    /// Variances of a and b and their covariance, from the standard deviations of the points: [[aa, ab], [ab, bb]].
    pub covariance: [[f64; 2]; 2],
    /// Number of measurements.
    pub measurements: usize,
    /// Workpieces at the last measurement.
    pub last_parts: f64,
    /// Sum of the squares of (wear - line)/sigma; to be compared with `degrees_of_freedom`.
    pub chi_square: f64,
    /// Measurements beyond two.
    pub degrees_of_freedom: usize,
    /// Root of the mean square of wear - line, mm.
    pub residual_rms: f64,
    /// How far the last measurement lies off the line through the others, in standard deviations of that distance; `None` where the
    /// others make no line. Above 3 the wear does not grow evenly.
    pub last_off: Option<f64>,
    /// Wear that calls for resharpening, mm.
    pub limit: f64,
    /// When the limit is reached.
    pub forecast: Result<Forecast, NoForecast>,
}

/// Standard deviations from which the last measurement speaks against a straight line.
const BENT: f64 = 3.0;
/// Share of a variance below which the line goes through the last point whatever it is.
const OWN_LINE: f64 = 1e-9;
/// Singular values below this share of the largest are none; counts are scaled to 0..1 before.
const RANK: f64 = 1e-12;

impl WearPoint {
    /// The point of a measurement's means over the teeth, mm, one for each track (> 0 is material beyond the nominal edge).
    pub fn of_track_means(parts: f64, means: &[f64], sigma: f64) -> Self {
        let deepest = means.iter().copied().fold(f64::INFINITY, f64::min);
        Self { parts, wear: -deepest, sigma }
    }

    fn check(&self) -> Result<(), WearError> {
        let number = |field, value: f64, good: bool, allowed| {
            if good { Ok(()) } else { Err(WearError::InvalidNumber { field, value, allowed }) }
        };
        let counted = self.parts.is_finite() && self.parts >= 0.0;
        number("parts", self.parts, counted, ">= 0")?;
        number("wear", self.wear, self.wear.is_finite(), "a finite number")?;
        number("sigma", self.sigma, self.sigma.is_finite() && self.sigma > 0.0, "> 0 mm")
    }
}

impl WearTrend {
    /// The line through measurements in any order; the last one is that with the most workpieces.
    ///
    /// # Errors
    /// [`WearError::TooFewMeasurements`] without two different counts of workpieces, [`WearError::InvalidNumber`].
    pub fn fit(points: &[WearPoint], limit: f64) -> Result<Self, WearError> {
        if !(limit.is_finite() && limit > 0.0) {
            return Err(WearError::InvalidNumber { field: "wear_limit", value: limit, allowed: "> 0 mm" });
        }
        points.iter().try_for_each(WearPoint::check)?;
        let mut points = points.to_vec();
        points.sort_by(|p, q| p.parts.total_cmp(&q.parts));
        let counts = 1 + points.windows(2).filter(|two| two[0].parts < two[1].parts).count();
        let (Some(last), true) = (points.last().copied(), counts >= 2) else {
            return Err(WearError::TooFewMeasurements { counts: counts.min(points.len()) });
        };
        let line = Line::through(&points, last.parts)
            .ok_or(WearError::TooFewMeasurements { counts: counts.min(points.len()) })?;
        let off: Vec<f64> = points.iter().map(|p| p.wear - line.at(p.parts)).collect();
        let chi_square = off.iter().zip(&points).map(|(r, p)| (r / p.sigma).powi(2)).sum();
        let squares: f64 = off.iter().map(|r| r * r).sum();
        // Of a point that took part in the fit the residual has the variance sigma^2 - var(line).
        let left = last.sigma * last.sigma - line.variance(last.parts);
        let last_off = (left > OWN_LINE * last.sigma * last.sigma)
            .then(|| (last.wear - line.at(last.parts)) / left.sqrt());
        Ok(Self {
            start: line.values[0],
            rate: line.values[1],
            covariance: [0, 1].map(|i| [0, 1].map(|j| line.covariance[(i, j)])),
            measurements: points.len(),
            last_parts: last.parts,
            chi_square,
            degrees_of_freedom: points.len() - 2,
            residual_rms: (squares / points.len() as f64).sqrt(),
            last_off,
            limit,
            forecast: forecast(&line.values, &line.covariance, limit, last.parts),
        })
    }

    /// Wear that the line says, mm.
    pub fn wear_at(&self, parts: f64) -> f64 {
        self.start + self.rate * parts
    }

    /// Whether the last measurement speaks against even wear, and so against the forecast.
    pub fn is_bent(&self) -> bool {
        self.last_off.is_some_and(|off| off.abs() > BENT)
    }
}

struct Line {
    values: Vector2<f64>,
    covariance: Matrix2<f64>,
}

impl Line {
    /// Least squares with counts in units of `unit`, so that both columns are of the same size.
    fn through(points: &[WearPoint], unit: f64) -> Option<Self> {
        let rows =
            DMatrix::from_fn(points.len(), 2, |i, j| if j == 0 { 1.0 } else { points[i].parts / unit });
        let wear = DVector::from_iterator(points.len(), points.iter().map(|p| p.wear));
        let weights: Vec<f64> = points.iter().map(|p| 1.0 / p.sigma).collect();
        let solved = weighted_least_squares(&rows, &wear, Some(&weights), RANK)?;
        let mut normal = Matrix2::zeros();
        for (i, weight) in weights.iter().enumerate() {
            let row = Vector2::new(rows[(i, 0)], rows[(i, 1)]) * *weight;
            normal += row * row.transpose();
        }
        let scale = Matrix2::new(1.0, 0.0, 0.0, 1.0 / unit);
        let covariance = scale * normal.try_inverse()? * scale;
        (solved.rank.rank == 2)
            .then(|| Self { values: scale * Vector2::new(solved.x[0], solved.x[1]), covariance })
    }

    fn at(&self, parts: f64) -> f64 {
        self.values[0] + self.values[1] * parts
    }

    fn variance(&self, parts: f64) -> f64 {
        let row = Vector2::new(1.0, parts);
        row.dot(&(self.covariance * row))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measuring::Noise;

    const LIMIT: f64 = 0.012;
    const TRUE: [f64; 2] = [1e-3, 2e-6];
    const COUNTS: [(f64, f64); 5] =
        [(0.0, 2e-4), (700.0, 1e-4), (1500.0, 2e-4), (1500.0, 3e-4), (2600.0, 2e-4)];

    fn points(mut error: impl FnMut() -> f64) -> Vec<WearPoint> {
        let point =
            |(parts, sigma)| WearPoint { parts, wear: TRUE[0] + TRUE[1] * parts + sigma * error(), sigma };
        COUNTS.into_iter().map(point).collect()
    }

    #[test]
    fn a_line_is_found_again() {
        let mut points = points(|| 0.0);
        points.swap(0, 4);
        let trend = WearTrend::fit(&points, LIMIT).unwrap();
        assert!((trend.start - TRUE[0]).abs() < 1e-15 && (trend.rate - TRUE[1]).abs() < 1e-18, "{trend:?}");
        assert_eq!((trend.measurements, trend.degrees_of_freedom, trend.last_parts), (5, 3, 2600.0));
        assert!(trend.residual_rms < 1e-15 && trend.chi_square < 1e-20 && !trend.is_bent());
        let forecast = trend.forecast.unwrap();
        assert!((forecast.parts - 5500.0).abs() < 1e-6 && (forecast.remaining - 2900.0).abs() < 1e-6);
    }

    /// What is stated about start, rate and forecast is what many draws show; the interval holds the truth in 95 of 100.
    #[test]
    fn stated_deviations_are_those_of_many_draws() {
        const DRAWS: usize = 20_000;
        let mut noise = Noise::new(11);
        let exact = WearTrend::fit(&points(|| 0.0), LIMIT).unwrap();
        let truth = exact.forecast.as_ref().unwrap().parts;
        let (mut squares, mut held, mut chi, mut off) = ([0.0; 3], 0, 0.0, 0.0);
        for _ in 0..DRAWS {
            let trend = WearTrend::fit(&points(|| noise.normal()), LIMIT).unwrap();
            let forecast = trend.forecast.as_ref().unwrap();
            let errors = [trend.start - TRUE[0], trend.rate - TRUE[1], forecast.parts - truth];
            squares.iter_mut().zip(errors).for_each(|(sum, e)| *sum += e * e);
            let [from, to] = forecast.interval;
            held += usize::from(from <= truth && truth <= to);
            chi += trend.chi_square;
            off += trend.last_off.unwrap().powi(2);
        }
        let count = DRAWS as f64;
        let stated = [
            exact.covariance[0][0].sqrt(),
            exact.covariance[1][1].sqrt(),
            exact.forecast.as_ref().unwrap().deviation,
        ];
        for (square, stated) in squares.iter().zip(stated) {
            let ratio = (square / count).sqrt() / stated;
            // Twenty thousand draws tell a standard deviation to half a per cent; the forecast is the first order only.
            assert!((ratio - 1.0).abs() < 0.03, "{ratio}");
        }
        let share = held as f64 / count;
        assert!((share - 0.95).abs() < 0.005, "{share}");
        assert!(
            (chi / count - 3.0).abs() < 0.06 && (off / count - 1.0).abs() < 0.03,
            "{} {}",
            chi / count,
            off / count
        );
    }

    #[test]
    fn wear_that_turns_upwards_is_told() {
        let mut bent = points(|| 0.0);
        bent[4].wear += 2e-3;
        let trend = WearTrend::fit(&bent, LIMIT).unwrap();
        assert!(trend.is_bent() && trend.last_off.unwrap() > 3.0, "{trend:?}");
        // Two points make a line whatever they are.
        let two = WearTrend::fit(&bent[3..], LIMIT).unwrap();
        assert_eq!((two.last_off, two.degrees_of_freedom), (None, 0));
    }

    #[test]
    fn what_makes_no_line_is_refused() {
        let points = points(|| 0.0);
        let code = |points: &[WearPoint], limit| {
            let error = WearTrend::fit(points, limit).unwrap_err();
            assert!(!error.way_out().is_empty() && !error.to_string().is_empty());
            (error.code(), error)
        };
        assert_eq!(code(&[], LIMIT).1, WearError::TooFewMeasurements { counts: 0 });
        assert_eq!(code(&points[..1], LIMIT).1, WearError::TooFewMeasurements { counts: 1 });
        assert_eq!(code(&points[2..4], LIMIT).1, WearError::TooFewMeasurements { counts: 1 });
        assert_eq!(code(&points, 0.0).0, "invalid-number");
        for wrong in [
            WearPoint { parts: -1.0, ..points[0] },
            WearPoint { wear: f64::NAN, ..points[0] },
            WearPoint { sigma: 0.0, ..points[0] },
        ] {
            assert_eq!(code(&[points[1], wrong], LIMIT).0, "invalid-number");
        }
    }

    #[test]
    fn the_deepest_track_counts() {
        let point = WearPoint::of_track_means(10.0, &[1e-3, -2e-3, -1e-3], 1e-4);
        assert_eq!((point.wear, point.parts), (2e-3, 10.0));
        assert!(WearTrend::fit(&[WearPoint::of_track_means(0.0, &[], 1e-4), point], LIMIT).is_err());
    }
}
