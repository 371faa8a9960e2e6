//! Knots of a spline: ascending abscissae, checked once, and the search for the interval that holds an argument.

/// Why a spline can't be built.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SplineError {
    /// A cubic spline with not-a-knot ends needs four knots in each direction.
    #[error("{count} knots along axis {axis}, at least 4 are needed")]
    TooFewKnots {
        /// 0 for the first variable, 1 for the second.
        axis: usize,
        /// Number of knots given.
        count: usize,
    },
    /// A knot does not lie above the one before it.
    #[error("knot {index} along axis {axis} is not above the knot before it")]
    NotAscending {
        /// 0 for the first variable, 1 for the second.
        axis: usize,
        /// Index of the offending knot.
        index: usize,
    },
    /// A knot is not a finite number.
    #[error("knot {index} along axis {axis} is not a finite number")]
    KnotNotFinite {
        /// 0 for the first variable, 1 for the second.
        axis: usize,
        /// Index of the offending knot.
        index: usize,
    },
    /// The values don't fit the knots.
    #[error("{found} values given for {expected} knots")]
    ShapeMismatch {
        /// Number of values that the knots ask for.
        expected: usize,
        /// Number of values given.
        found: usize,
    },
    /// A value, or a coefficient that follows from the values, is not a finite number.
    #[error("value {index} or a coefficient near it is not a finite number")]
    ValueNotFinite {
        /// Index of the value (row-major, first variable slow), or of the cell whose coefficients overflow.
        index: usize,
    },
    /// An interval that a spline is to span has no length.
    #[error("the spline would span [{low}, {high}], which has no length")]
    EmptyInterval {
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
    },
    /// B-splines need a degree of at least 1 and at least one interval.
    #[error("{intervals} intervals of degree {degree}: at least one interval and degree 1 are needed")]
    EmptySpace {
        /// Number of intervals.
        intervals: usize,
        /// Degree.
        degree: usize,
    },
    /// A least-squares spline is not determined by its points.
    #[error("{points} points don't determine {coefficients} spline coefficients")]
    RankDeficient {
        /// Number of points given.
        points: usize,
        /// Number of coefficients wanted.
        coefficients: usize,
    },
}

/// Ascending, finite abscissae.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Knots {
    values: Vec<f64>,
    /// 1/step when the knots are equidistant: the interval then follows by one multiplication.
    inverse_step: Option<f64>,
}

impl Knots {
    /// At least `least` ascending finite knots; `axis` only names the direction in an error.
    pub(super) fn new(values: &[f64], least: usize, axis: usize) -> Result<Self, SplineError> {
        if values.len() < least {
            return Err(SplineError::TooFewKnots { axis, count: values.len() });
        }
        if let Some(index) = values.iter().position(|x| !x.is_finite()) {
            return Err(SplineError::KnotNotFinite { axis, index });
        }
        if let Some(index) = (1..values.len()).find(|&i| values[i] <= values[i - 1]) {
            return Err(SplineError::NotAscending { axis, index });
        }
        let (first, last) = (values[0], values[values.len() - 1]);
        let step = (last - first) / (values.len() - 1) as f64;
        // A tenth of a step is no risk: the index found from the step is checked against the knots.
        let uniform =
            values.iter().enumerate().all(|(i, x)| (x - first - i as f64 * step).abs() < 0.1 * step);
        Ok(Self { values: values.to_vec(), inverse_step: uniform.then_some(1.0 / step) })
    }

    /// The knots themselves.
    pub(super) fn values(&self) -> &[f64] {
        &self.values
    }

    /// Number of intervals between the knots.
    pub(super) fn intervals(&self) -> usize {
        self.values.len() - 1
    }

    /// Index of the interval whose polynomial holds at `x` (a border interval outside the knots) and x minus
    /// its first knot.
    #[inline]
    pub(super) fn locate(&self, x: f64) -> (usize, f64) {
        let last = self.values.len() - 2;
        let index = match self.inverse_step {
            Some(inverse_step) => {
                let guess = (((x - self.values[0]) * inverse_step) as usize).min(last);
                if x < self.values[guess] {
                    guess.saturating_sub(1)
                } else if x >= self.values[guess + 1] {
                    (guess + 1).min(last)
                } else {
                    guess
                }
            }
            None => self.values[1..=last].partition_point(|knot| *knot <= x),
        };
        (index, x - self.values[index])
    }

    /// The parts of the intervals that lie in a range: index of each and its ends, measured from its first knot. What lies outside
    /// the knots belongs to the border intervals.
    pub(super) fn parts(&self, [from, to]: [f64; 2]) -> impl Iterator<Item = (usize, [f64; 2])> {
        let (first, start) = self.locate(from);
        let (last, end) = self.locate(to);
        (first..=last).map(move |index| {
            let begins = if index == first { start } else { 0.0 };
            let ends = if index == last { end } else { self.values[index + 1] - self.values[index] };
            (index, [begins, ends])
        })
    }
}
