//! How safely a process stays inside its limits.

use super::LARGEST;
use crate::inspection::InspectionError;
use crate::inspection::error::usable;
use foundation::numerics::{chi_square_quantile, normal_upper_tail};

/// A standard normal number lies below this with a probability of 95 percent (1.645 in tables).
const NORMAL_95: f64 = 1.644_853_626_951_472_7;
/// It lies between minus this and this with a probability of 95 percent (1.960 in tables).
const NORMAL_95_TWO_SIDED: f64 = 1.959_963_984_540_054;

/// Standard deviations below this are none.
const LEAST: f64 = 1e-100;

/// Limits of a characteristic, in its unit; form and total deviations have an upper one only.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SpecificationLimits {
    lower: Option<f64>,
    upper: Option<f64>,
}

/// Capability indices; `None` where a limit is missing or all parts are equal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Capability {
    /// Cp: width between the limits over 6 s.
    pub cp: Option<f64>,
    /// Cpk: distance of the mean to the nearer limit over 3 s.
    pub cpk: Option<f64>,
    /// With 95 percent certainty Cp lies between these (chi-square).
    pub cp_interval_95: Option<[f64; 2]>,
    /// With 95 percent certainty Cpk is not below this.
    pub cpk_lower_95: Option<f64>,
    /// With 95 percent certainty Cpk lies between these (Bissell's approximation, as the lower bound).
    pub cpk_interval_95: Option<[f64; 2]>,
    /// Share of parts outside the limits if the values follow a normal law, 0 to 1.
    pub outside_share: Option<f64>,
}

impl SpecificationLimits {
    /// Lower and upper limit.
    ///
    /// # Errors
    /// [`InspectionError::InvalidNumber`] for a limit that is not finite, or a lower limit that is not below the upper.
    pub fn new(lower: Option<f64>, upper: Option<f64>) -> Result<Self, InspectionError> {
        if let Some(upper) = upper {
            usable("upper limit", upper, upper.abs() < LARGEST, "a number between -1e12 and 1e12")?;
        }
        if let Some(lower) = lower {
            let below = upper.is_none_or(|upper| lower < upper);
            usable(
                "lower limit",
                lower,
                below && lower.abs() < LARGEST,
                "above -1e12, below the upper limit",
            )?;
        }
        Ok(Self { lower, upper })
    }

    /// Lower limit.
    pub fn lower(&self) -> Option<f64> {
        self.lower
    }

    /// Upper limit.
    pub fn upper(&self) -> Option<f64> {
        self.upper
    }
}

impl Capability {
    /// Of `parts` values with this mean and standard deviation.
    pub(super) fn of(parts: usize, [mean, s]: [f64; 2], limits: &SpecificationLimits) -> Self {
        // So small a deviation is one of rounding.
        if s < LEAST {
            return Self::default();
        }
        let n = parts as f64;
        // Distances of the mean to the limits there are, in standard deviations.
        let distances =
            [limits.lower.map(|lower| (mean - lower) / s), limits.upper.map(|upper| (upper - mean) / s)];
        let inside = distances.iter().flatten();
        let cpk = inside.clone().copied().reduce(f64::min).map(|distance| distance / 3.0);
        let cp = limits.lower.zip(limits.upper).map(|(lower, upper)| (upper - lower) / (6.0 * s));
        let error = |cpk: f64| (1.0 / (9.0 * n) + cpk * cpk / (2.0 * (n - 1.0))).sqrt();
        let share = |probability| (chi_square_quantile(probability, n - 1.0) / (n - 1.0)).sqrt();
        Self {
            cp,
            cpk,
            cp_interval_95: cp.map(|cp| [0.025, 0.975].map(|probability| cp * share(probability))),
            cpk_lower_95: cpk.map(|cpk| cpk - NORMAL_95 * error(cpk)),
            cpk_interval_95: cpk
                .map(|cpk| [-1.0, 1.0].map(|sign| cpk + sign * NORMAL_95_TWO_SIDED * error(cpk))),
            outside_share: cpk.map(|_| inside.map(|distance| normal_upper_tail(*distance)).sum()),
        }
    }

    /// The same without bounds, which hold for the deviation of all parts only.
    pub(super) fn without_bounds(self) -> Self {
        Self { cp_interval_95: None, cpk_lower_95: None, cpk_interval_95: None, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_limit_gives_its_side_only() {
        let of =
            |lower, upper| Capability::of(50, [1.0, 0.5], &SpecificationLimits::new(lower, upper).unwrap());
        let both = of(Some(-2.0), Some(3.0));
        assert_eq!((both.cp, both.cpk), (Some(5.0 / 3.0), Some(4.0 / 3.0)));
        let (low, high) = (of(Some(-2.0), None), of(None, Some(3.0)));
        assert_eq!((low.cp, low.cpk, high.cpk), (None, Some(2.0), Some(4.0 / 3.0)));
        let share = low.outside_share.unwrap() + high.outside_share.unwrap();
        assert!((both.outside_share.unwrap() - share).abs() < 1e-18 && share > 3e-5);
        // 4/3 - 1.645 sqrt(1/450 + 16/9/98)
        assert!((both.cpk_lower_95.unwrap() - 1.098_615_5).abs() < 1e-6, "{both:?}");
        assert!((normal_upper_tail(NORMAL_95) - 0.05).abs() < 1e-16);
        assert_eq!(of(None, None), Capability::default());
        // chi-square of 49: 31.5549 and 70.2224 in tables.
        let [low, high] = both.cp_interval_95.unwrap();
        let table = [31.5549f64, 70.2224].map(|chi| 5.0 / 3.0 * (chi / 49.0).sqrt());
        assert!((low - table[0]).abs() < 1e-5 && (high - table[1]).abs() < 1e-5, "{both:?}");
        // 4/3 -+ 1.96 sqrt(1/450 + 16/9/98)
        let [low, high] = both.cpk_interval_95.unwrap();
        assert!((low - 1.053_646).abs() < 1e-4 && (low + high - 8.0 / 3.0).abs() < 1e-12, "{both:?}");
    }

    #[test]
    fn limits_in_the_wrong_order_are_refused() {
        for (lower, upper) in [(1.0, 1.0), (2.0, 1.0), (f64::NAN, 1.0), (0.0, f64::INFINITY)] {
            let error = SpecificationLimits::new(Some(lower), Some(upper)).unwrap_err();
            assert_eq!(error.code(), "invalid-number");
        }
    }
}
