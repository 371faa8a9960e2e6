//! B-splines of any degree on clamped knots: equal intervals, with kinks where they are asked for. Knows no fit.

use super::knots::SplineError;

/// A knot this close to a kink (share of the interval) is moved onto it: two knots that nearly coincide would make an
/// ill-conditioned sliver of a piece.
const SAME_KNOT: f64 = 1e-6;

/// The functions B_j of one degree on [low, high]; their sum is 1.
#[derive(Clone, Debug, PartialEq)]
pub struct BSplineBasis {
    degree: usize,
    /// Ascending, the first and last degree + 1 times.
    knots: Vec<f64>,
}

impl BSplineBasis {
    /// Clamped knots with `intervals` equal intervals on [low, high]. At every kink inside the interval the knot is
    /// `degree`-fold, so that the slope may jump there; kinks outside do not concern this interval.
    ///
    /// # Errors
    /// [`SplineError::EmptySpace`], [`SplineError::EmptyInterval`], [`SplineError::KnotNotFinite`].
    pub fn uniform(
        [low, high]: [f64; 2],
        intervals: usize,
        degree: usize,
        kinks: &[f64],
    ) -> Result<Self, SplineError> {
        if intervals == 0 || degree == 0 {
            return Err(SplineError::EmptySpace { intervals, degree });
        }
        let all = [low, high].into_iter().chain(kinks.iter().copied());
        if let Some(index) = all.into_iter().position(|x| !x.is_finite()) {
            return Err(SplineError::KnotNotFinite { axis: 0, index });
        }
        let length = high - low;
        // A step below the rounding of the ends would make knots that coincide.
        if !(length.is_finite() && length / intervals as f64 > 8.0 * f64::EPSILON * low.abs().max(high.abs()))
        {
            return Err(SplineError::EmptyInterval { low, high });
        }
        let near = SAME_KNOT * length;
        let mut kinks: Vec<f64> =
            kinks.iter().copied().filter(|x| low + near < *x && *x < high - near).collect();
        kinks.sort_by(f64::total_cmp);
        kinks.dedup_by(|a, b| *a - *b <= near);
        let mut knots = vec![low; degree + 1];
        let mut coming = kinks.iter().copied().peekable();
        for i in 1..intervals {
            let x = low + length * i as f64 / intervals as f64;
            while let Some(kink) = coming.next_if(|kink| *kink < x - near) {
                knots.extend(std::iter::repeat_n(kink, degree));
            }
            match coming.next_if(|kink| *kink <= x + near) {
                Some(kink) => knots.extend(std::iter::repeat_n(kink, degree)),
                None => knots.push(x),
            }
        }
        for kink in coming {
            knots.extend(std::iter::repeat_n(kink, degree));
        }
        knots.extend(std::iter::repeat_n(high, degree + 1));
        Ok(Self { degree, knots })
    }

    /// Number of functions.
    pub fn count(&self) -> usize {
        self.knots.len() - self.degree - 1
    }

    /// Degree of the pieces.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// [low, high].
    pub fn interval(&self) -> [f64; 2] {
        [self.knots[0], self.knots[self.knots.len() - 1]]
    }

    /// The argument at which function j has its mean weight: sum_j g_j B_j(x) = x.
    pub fn greville(&self, j: usize) -> f64 {
        self.knots[j + 1..=j + self.degree].iter().sum::<f64>() / self.degree as f64
    }

    /// Values at `x` of the functions that do not vanish there, into the first degree + 1 places of `out`; the index of
    /// the first of them. Outside the interval the polynomials of the border pieces continue.
    ///
    /// # Panics
    /// If `out` has fewer than degree + 1 places.
    #[inline]
    pub fn values(&self, x: f64, out: &mut [f64]) -> usize {
        let span = self.span(x);
        self.values_of_degree(span, self.degree, x, out);
        span - self.degree
    }

    /// `[B, B', B'']` at `x` of the functions that do not vanish there, into the first degree + 1 places of `out`; the index of the first of
    /// them. Outside the interval the polynomials of the border pieces continue.
    ///
    /// # Panics
    /// If `out` has fewer than degree + 1 places.
    pub fn jets(&self, x: f64, out: &mut [[f64; 3]]) -> usize {
        let span = self.span(x);
        let mut values = vec![0.0; self.degree + 1];
        out[..=self.degree].fill([0.0; 3]);
        for order in 0..=2.min(self.degree) {
            // Values of the lower degree, then differences up to this one.
            let low = self.degree - order;
            self.values_of_degree(span, low, x, &mut values);
            for degree in low + 1..=self.degree {
                for j in (0..=degree).rev() {
                    let of = |k: usize| {
                        let knot = span + k - degree;
                        values[k - 1] / (self.knots[knot + degree] - self.knots[knot])
                    };
                    let gained = if j > 0 { of(j) } else { 0.0 };
                    let lost = if j < degree { of(j + 1) } else { 0.0 };
                    values[j] = degree as f64 * (gained - lost);
                }
            }
            for (jet, value) in out.iter_mut().zip(&values) {
                jet[order] = *value;
            }
        }
        span - self.degree
    }

    /// Index of the first of the functions that do not vanish at `x`.
    #[inline]
    pub fn first(&self, x: f64) -> usize {
        self.span(x) - self.degree
    }

    /// Index i of the knot with knots[i] <= x < knots[i + 1], at the borders of the first or last piece.
    #[inline]
    fn span(&self, x: f64) -> usize {
        let inner = &self.knots[self.degree + 1..self.knots.len() - self.degree - 1];
        self.degree + inner.partition_point(|knot| *knot <= x)
    }

    /// Recursion of Cox and de Boor on one piece for any degree up to that of the basis.
    #[inline]
    fn values_of_degree(&self, span: usize, degree: usize, x: f64, out: &mut [f64]) {
        out[0] = 1.0;
        for j in 1..=degree {
            let mut saved = 0.0;
            for r in 0..j {
                let (left, right) = (self.knots[span + 1 + r - j], self.knots[span + 1 + r]);
                let share = out[r] / (right - left);
                out[r] = saved + (right - x) * share;
                saved = (x - left) * share;
            }
            out[j] = saved;
        }
    }
}

/// A function of one variable: sum of c_j B_j(x). Outside its interval the border pieces continue.
#[derive(Clone, Debug, PartialEq)]
pub struct BSpline {
    basis: BSplineBasis,
    coefficients: Vec<f64>,
    /// Beginning of every piece.
    starts: Vec<f64>,
    /// Taylor coefficients about the beginning, degree + 1 a piece.
    pieces: Vec<f64>,
}

impl BSpline {
    /// # Errors
    /// [`SplineError::ShapeMismatch`] unless there is one coefficient for every function,
    /// [`SplineError::ValueNotFinite`].
    pub fn new(basis: BSplineBasis, coefficients: Vec<f64>) -> Result<Self, SplineError> {
        if coefficients.len() != basis.count() {
            return Err(SplineError::ShapeMismatch { expected: basis.count(), found: coefficients.len() });
        }
        let degree = basis.degree;
        let (mut starts, mut pieces) = (Vec::new(), Vec::new());
        let mut values = vec![0.0; degree + 1];
        for span in degree..basis.count() {
            let at = basis.knots[span];
            if basis.knots[span + 1] <= at {
                continue;
            }
            starts.push(at);
            let mut local = coefficients[span - degree..=span].to_vec();
            let mut factorial = 1.0;
            for order in 0..=degree {
                let left = degree - order;
                basis.values_of_degree(span, left, at, &mut values);
                let derivative: f64 = local.iter().zip(&values[..=left]).map(|(c, b)| c * b).sum();
                pieces.push(derivative / factorial);
                factorial *= (order + 1) as f64;
                // Coefficients of the next derivative, a spline of one degree less.
                for r in 0..left {
                    let width = basis.knots[span + 1 + r] - basis.knots[span + 1 + r - left];
                    local[r] = left as f64 * (local[r + 1] - local[r]) / width;
                }
                local.truncate(left);
            }
        }
        match coefficients.iter().chain(&pieces).position(|x| !x.is_finite()) {
            Some(index) => Err(SplineError::ValueNotFinite { index: index % coefficients.len() }),
            None => Ok(Self { basis, coefficients, starts, pieces }),
        }
    }

    /// The functions it is a sum of.
    pub fn basis(&self) -> &BSplineBasis {
        &self.basis
    }

    /// c_j.
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// Value at `x`.
    #[inline]
    pub fn value(&self, x: f64) -> f64 {
        let (piece, d) = self.piece(x);
        piece.iter().rev().fold(0.0, |f, c| f * d + c)
    }

    /// Value, first and second derivative at `x`; at a kink those of the piece that begins there.
    #[inline]
    pub fn jet(&self, x: f64) -> [f64; 3] {
        let (piece, d) = self.piece(x);
        let [f, f1, f2] =
            piece.iter().rev().fold([0.0; 3], |[f, f1, f2], c| [f * d + c, f1 * d + f, f2 * d + f1]);
        [f, f1, 2.0 * f2]
    }

    /// The polynomials of a cubic: their ends, ascending, and `[c_0, c_1, c_2, c_3]` in powers of the distance from the lower end; `None`
    /// for another degree.
    pub fn cubic_pieces(&self) -> Option<(Vec<f64>, Vec<[f64; 4]>)> {
        let (pieces, rest) = self.pieces.as_chunks();
        if self.basis.degree != 3 || !rest.is_empty() {
            return None;
        }
        let mut ends = self.starts.clone();
        ends.push(self.basis.interval()[1]);
        Some((ends, pieces.to_vec()))
    }

    /// A bound of the second derivative on [a, b], which may reach beyond the interval.
    pub fn largest_bend(&self, [a, b]: [f64; 2]) -> f64 {
        let count = self.basis.degree + 1;
        let ends = self.starts[1..].iter().copied().chain([f64::INFINITY]);
        let bend = |(i, end): (usize, f64)| {
            let first = if i == 0 { f64::NEG_INFINITY } else { self.starts[i] };
            let (from, to) = (first.max(a), end.min(b));
            if from > to {
                return 0.0;
            }
            let reach = (from - self.starts[i]).abs().max((to - self.starts[i]).abs());
            let piece = &self.pieces[i * count..(i + 1) * count];
            // Horner's rule for the second derivative with all signs equal.
            (2..count).rev().fold(0.0, |sum, k| sum * reach + (k * (k - 1)) as f64 * piece[k].abs())
        };
        ends.enumerate().map(bend).fold(0.0, f64::max)
    }

    #[inline]
    fn piece(&self, x: f64) -> (&[f64], f64) {
        let i = self.starts[1..].partition_point(|start| *start <= x);
        let count = self.basis.degree + 1;
        (&self.pieces[i * count..(i + 1) * count], x - self.starts[i])
    }

    /// The spline plus a + b x: exact, for splines reproduce straight lines.
    ///
    /// # Errors
    /// [`SplineError::ValueNotFinite`].
    pub fn plus_line(self, a: f64, b: f64) -> Result<Self, SplineError> {
        let coefficients =
            self.coefficients.iter().enumerate().map(|(j, c)| c + a + b * self.basis.greville(j)).collect();
        Self::new(self.basis, coefficients)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_second_derivative_exceeds_its_bound() {
        let spline = spline(5, &[]);
        let at = |from: f64, to: f64| {
            let x = (0..=400).map(|i| from + (to - from) * f64::from(i) / 400.0);
            x.map(|x| spline.jet(x)[2].abs()).fold(0.0, f64::max)
        };
        for (from, to) in [(-2.0, 5.0), (-3.0, 0.2), (1.1, 1.2), (4.0, 6.0)] {
            let (most, bound) = (at(from, to), spline.largest_bend([from, to]));
            assert!(most <= bound * (1.0 + 1e-12) && bound < 100.0 * most + 1e-9, "{most} {bound}");
        }
    }

    #[test]
    fn jets_of_the_basis_and_cubic_pieces_are_those_of_the_spline() {
        let close = |a: f64, b: f64| (a - b).abs() < 1e-11 * (1.0 + b.abs());
        for degree in 1..=5 {
            let spline = spline(degree, &[0.3]);
            for x in [-3.0, -2.0, -0.4, 0.3, 1.7, 4.99, 5.5] {
                let mut jets = vec![[f64::NAN; 3]; degree + 1];
                let first = spline.basis().jets(x, &mut jets);
                let own = &spline.coefficients()[first..];
                let sum = |k: usize| jets.iter().zip(own).map(|(jet, c)| jet[k] * c).sum::<f64>();
                let wanted = spline.jet(x);
                assert!((0..3).all(|k| close(sum(k), wanted[k])), "degree {degree} at {x}");
            }
            let Some((ends, pieces)) = spline.cubic_pieces() else {
                assert_ne!(degree, 3);
                continue;
            };
            assert_eq!((ends.len(), ends[0], ends[pieces.len()]), (pieces.len() + 1, -2.0, 5.0));
            for (k, [a, b, c, d]) in pieces.iter().enumerate() {
                let t = 0.37 * (ends[k + 1] - ends[k]);
                assert!(close(a + t * (b + t * (c + t * d)), spline.value(ends[k] + t)));
            }
        }
    }

    fn spline(degree: usize, kinks: &[f64]) -> BSpline {
        let basis = BSplineBasis::uniform([-2.0, 5.0], 6, degree, kinks).unwrap();
        let coefficients = (0..basis.count()).map(|j| (1.7 * j as f64).sin()).collect();
        BSpline::new(basis, coefficients).unwrap()
    }

    #[test]
    fn pieces_are_the_sum_of_the_basis_inside_and_outside() {
        for degree in 1..=7 {
            let spline = spline(degree, &[0.3, 1.5]);
            let mut values = vec![0.0; degree + 1];
            for i in 0..=90 {
                let x = -2.5 + 8.0 * f64::from(i) / 90.0;
                let first = spline.basis().values(x, &mut values);
                let sum: f64 = values.iter().zip(&spline.coefficients()[first..]).map(|(b, c)| b * c).sum();
                let size: f64 = values.iter().map(|b| b.abs()).sum();
                assert!((spline.value(x) - sum).abs() < 1e-13 * size, "degree {degree}, x = {x}");
                assert!((values.iter().sum::<f64>() - 1.0).abs() < 1e-13 * size);
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_values() {
        for degree in 1..=5 {
            let spline = spline(degree, &[]);
            for x in [-1.9, -0.4, 0.71, 2.2, 4.9] {
                let h = 1e-4;
                let [f, f1, f2] = spline.jet(x);
                let (a, b) = (spline.value(x + h), spline.value(x - h));
                assert!((f1 - (a - b) / (2.0 * h)).abs() < 1e-6, "{degree} {x}");
                assert!((f2 - (a - 2.0 * f + b) / (h * h)).abs() < 1e-5, "{degree} {x}");
            }
        }
    }

    #[test]
    fn a_kink_lets_the_slope_jump_and_nothing_else() {
        // 1/3 is a knot of [-2, 5] in six parts; 1.5 is none.
        for kink in [-2.0 + 7.0 / 3.0, 1.5] {
            let spline = spline(3, &[kink, -7.0]);
            let h = 1e-9;
            assert!((spline.value(kink - h) - spline.value(kink + h)).abs() < 1e-8);
            assert!((spline.jet(kink - h)[1] - spline.jet(kink + h)[1]).abs() > 0.1);
            let other = -2.0 + 7.0 / 6.0;
            assert!((spline.jet(other - h)[2] - spline.jet(other + h)[2]).abs() < 1e-6);
        }
    }

    #[test]
    fn straight_lines_are_added_exactly() {
        let before = spline(3, &[1.5]);
        let after = before.clone().plus_line(0.25, -2.0).unwrap();
        for x in [-3.0, -2.0, 0.1, 1.5, 4.0, 5.0, 6.0] {
            assert!((after.value(x) - before.value(x) - 0.25 + 2.0 * x).abs() < 1e-12);
        }
    }

    #[test]
    fn bad_spaces_are_refused() {
        let make = |range, n, k| BSplineBasis::uniform(range, n, k, &[]).map(|b| b.count());
        assert_eq!(make([0.0, 1.0], 4, 3), Ok(7));
        assert_eq!(make([0.0, 1.0], 0, 3), Err(SplineError::EmptySpace { intervals: 0, degree: 3 }));
        assert_eq!(make([0.0, 1.0], 4, 0), Err(SplineError::EmptySpace { intervals: 4, degree: 0 }));
        assert_eq!(make([1.0, 1.0], 4, 3), Err(SplineError::EmptyInterval { low: 1.0, high: 1.0 }));
        assert!(matches!(make([f64::NAN, 1.0], 4, 3), Err(SplineError::KnotNotFinite { .. })));
        assert!(matches!(make([-1e308, 1e308], 4, 3), Err(SplineError::EmptyInterval { .. })));
        let basis = BSplineBasis::uniform([0.0, 1.0], 2, 1, &[]).unwrap();
        assert!(matches!(BSpline::new(basis.clone(), vec![0.0]), Err(SplineError::ShapeMismatch { .. })));
        assert!(matches!(
            BSpline::new(basis, vec![0.0, f64::NAN, 0.0]),
            Err(SplineError::ValueNotFinite { .. })
        ));
    }
}
