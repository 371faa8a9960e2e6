//! The count of workpieces at which a line of wear reaches its limit, with what is uncertain about it.
//!
//! N = (limit - a)/b. To the first order its variance is (var a + 2 N cov + N^2 var b)/b^2. The interval is Fieller's: all N for which
//! limit - a - b N lies within 1.96 of its standard deviations of 0; it is exact for normally distributed wear, and has no upper end
//! once the rate itself cannot be distinguished from 0.

use finding::Finding;
use nalgebra::{Matrix2, Vector2};
use thiserror::Error;

/// When the limit is reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forecast {
    /// Workpieces since grinding at which the wear reaches its limit.
    pub parts: f64,
    /// Standard deviation of `parts`, to the first order.
    pub deviation: f64,
    /// Interval that holds the true count in 95 of 100 cases.
    pub interval: [f64; 2],
    /// `parts` less those of the last measurement; < 0 where the limit has been passed.
    pub remaining: f64,
}

/// Why there is no forecast.
#[derive(Clone, Copy, Debug, PartialEq, Error, Finding)]
pub enum NoForecast {
    /// The wear does not grow.
    #[error("the wear does not grow with the workpieces ({rate:e} mm each)")]
    #[finding(code = "wear-not-growing")]
    #[way_out("measure again after further workpieces")]
    NotGrowing {
        /// Wear per workpiece, mm.
        rate: f64,
    },
    /// The wear grows less than its measurements are uncertain.
    #[error(
        "the wear grows by {rate:e} mm a workpiece, uncertain by {deviation:e} mm: it may not grow at all"
    )]
    #[finding(code = "wear-within-noise")]
    #[way_out("measure again after further workpieces")]
    WithinNoise {
        /// Wear per workpiece, mm.
        rate: f64,
        /// Standard deviation of that, mm.
        deviation: f64,
    },
}

/// Standard deviations of a normal distribution that leave out 1 of 20.
const NINETY_FIVE: f64 = 1.959_963_984_540_054;

/// The forecast of wear = a + b parts with its covariance.
pub(super) fn forecast(
    line: &Vector2<f64>,
    covariance: &Matrix2<f64>,
    limit: f64,
    last: f64,
) -> Result<Forecast, NoForecast> {
    let rate = line[1];
    if rate <= 0.0 {
        return Err(NoForecast::NotGrowing { rate });
    }
    let [aa, ab, bb] = [covariance[(0, 0)], covariance[(0, 1)], covariance[(1, 1)]];
    let square = NINETY_FIVE * NINETY_FIVE;
    // (limit - a - b N)^2 <= z^2 (aa + 2 ab N + bb N^2) as A N^2 - 2 B N + C <= 0.
    let to_go = limit - line[0];
    let (leading, half, rest) =
        (rate * rate - square * bb, rate * to_go + square * ab, to_go * to_go - square * aa);
    if leading <= 0.0 {
        return Err(NoForecast::WithinNoise { rate, deviation: bb.sqrt() });
    }
    let parts = to_go / rate;
    let variance = (aa + 2.0 * parts * ab + parts * parts * bb) / (rate * rate);
    // Never negative: N itself meets the inequality.
    let root = (half * half - leading * rest).max(0.0).sqrt();
    Ok(Forecast {
        parts,
        deviation: variance.max(0.0).sqrt(),
        interval: [(half - root) / leading, (half + root) / leading],
        remaining: parts - last,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_interval_ends_where_the_line_is_uncertain_by_its_distance() {
        let line = Vector2::new(1e-3, 2e-6);
        let covariance = Matrix2::new(1e-8, -4e-12, -4e-12, 4e-15);
        let found = forecast(&line, &covariance, 0.01, 3000.0).unwrap();
        assert!((found.parts - 4500.0).abs() < 1e-9 && (found.remaining - 1500.0).abs() < 1e-9);
        for (end, side) in found.interval.into_iter().zip([1.0, -1.0]) {
            let row = Vector2::new(1.0, end);
            let off = (0.01 - line.dot(&row)) / row.dot(&(covariance * row)).sqrt();
            assert!((off - side * NINETY_FIVE).abs() < 1e-9, "{off}");
        }
        // The limit has been passed.
        assert!(forecast(&line, &covariance, 0.005, 3000.0).unwrap().remaining < 0.0);
    }

    #[test]
    fn no_growth_no_forecast() {
        let of = |rate: f64, deviation: f64| {
            let covariance = Matrix2::new(1e-8, 0.0, 0.0, deviation * deviation);
            let reason = forecast(&Vector2::new(1e-3, rate), &covariance, 0.01, 0.0).unwrap_err();
            assert!(!reason.way_out().is_empty() && !reason.to_string().is_empty());
            reason.code()
        };
        assert_eq!(of(0.0, 1e-7), "wear-not-growing");
        assert_eq!(of(-1e-6, 1e-7), "wear-not-growing");
        assert_eq!(of(1.9e-7, 1e-7), "wear-within-noise");
    }
}
