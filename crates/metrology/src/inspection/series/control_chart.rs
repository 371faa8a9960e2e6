//! The chart of individual values and moving ranges: what a process without special causes keeps to.

/// Mean of the distance of two normal numbers, in standard deviations (d_2, 1.128379 in tables).
const MEAN_MOVING_RANGE: f64 = std::f64::consts::FRAC_2_SQRT_PI;

/// Limits of individual values and of the distances of neighbouring parts, in the unit of the values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControlLimits {
    /// Mean of the parts: the centre of the chart.
    pub centre: f64,
    /// sigma_MR: standard deviation by the distances of neighbouring parts, which a slow drift does not enlarge.
    pub sigma: f64,
    /// Mean distance of neighbouring parts.
    pub mean_moving_range: f64,
    /// Distance that neighbouring parts exceed only for a special cause.
    pub moving_range_upper: f64,
}

impl ControlLimits {
    /// Of at least two values with their mean.
    pub(super) fn of(values: &[f64], mean: f64) -> Self {
        let steps: f64 = values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum();
        let mean_moving_range = steps / (values.len() - 1) as f64;
        // d_3 of two values: the distance |x_1 - x_2| of unit normals has the variance 2 - 4/pi.
        let spread = (2.0 - 4.0 / std::f64::consts::PI).sqrt();
        Self {
            centre: mean,
            sigma: mean_moving_range / MEAN_MOVING_RANGE,
            mean_moving_range,
            moving_range_upper: mean_moving_range * (1.0 + 3.0 * spread / MEAN_MOVING_RANGE),
        }
    }

    /// Lower limit of individual values.
    pub fn lower(&self) -> f64 {
        self.centre - 3.0 * self.sigma
    }

    /// Upper limit of individual values.
    pub fn upper(&self) -> f64 {
        self.centre + 3.0 * self.sigma
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_are_those_of_the_tables() {
        // Moving ranges 2, 1, 4: mean 7/3. Tables: 3/d_2 = 2.660, D_4 = 3.267.
        let limits = ControlLimits::of(&[1.0, 3.0, 2.0, 6.0], 3.0);
        let mean = 7.0 / 3.0;
        assert!((limits.mean_moving_range - mean).abs() < 1e-15);
        for beside in [limits.upper() - 3.0, 3.0 - limits.lower()] {
            assert!((beside / mean - 2.660).abs() < 1.5e-3, "{limits:?}");
        }
        assert!((limits.moving_range_upper / mean - 3.267).abs() < 5e-4, "{limits:?}");
    }
}
