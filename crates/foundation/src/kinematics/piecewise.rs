//! Piecewise polynomials up to third degree as data of a motion law, and the ways to make them from points. Knows no axis.

use super::LawError;
use crate::numerics::CubicSpline;

/// Pieces may miss each other by this share of the larger value: rounding by the program that computed the coefficients.
const JOINT: f64 = 1e-9;
/// What is left of a line between two roundings counts as nothing below this share of it.
const ROUNDING: f64 = 1e-9;

/// Polynomials up to third degree between ascending breakpoints, continuous; beyond both ends the tangent there continues.
#[derive(Clone, Debug, PartialEq)]
pub struct PiecewisePolynomial {
    breaks: Vec<f64>,
    /// Per interval, ascending powers of the distance from its lower breakpoint.
    pieces: Vec<[f64; 4]>,
}

impl PiecewisePolynomial {
    /// The pieces `[c_0, c_1, c_2, c_3]` in powers of the distance from the lower of their two breakpoints.
    ///
    /// # Errors
    /// `TooFewPoints`, `LengthMismatch`, `NotAscending`, `NotFinite`, and `Jump` where two pieces do not meet.
    pub fn new(breaks: Vec<f64>, pieces: Vec<[f64; 4]>) -> Result<Self, LawError> {
        check_points(&breaks, 2)?;
        if pieces.len() + 1 != breaks.len() {
            return Err(LawError::LengthMismatch { expected: breaks.len() - 1, found: pieces.len() });
        }
        if let Some(index) = pieces.iter().position(|piece| piece.iter().any(|c| !c.is_finite())) {
            return Err(LawError::NotFinite { index });
        }
        for (k, pair) in pieces.windows(2).enumerate() {
            let end = evaluate(&pair[0], breaks[k + 1] - breaks[k])[0];
            let size = pair[1][0] - end;
            // Written so that an overflowing piece fails.
            let meets = size.abs() <= JOINT * (1.0 + end.abs().max(pair[1][0].abs()));
            if !meets {
                return Err(LawError::Jump { at: breaks[k + 1], size });
            }
        }
        Ok(Self { breaks, pieces })
    }

    /// Straight lines through the points.
    ///
    /// # Errors
    /// `TooFewPoints` below two, `LengthMismatch`, `NotAscending`, `NotFinite`.
    pub fn broken_line(x: &[f64], y: &[f64]) -> Result<Self, LawError> {
        let slopes = secants(x, y, 2)?;
        let pieces = y.iter().zip(&slopes).map(|(&y, &m)| [y, m, 0.0, 0.0]).collect();
        Self::new(x.to_vec(), pieces)
    }

    /// Straight lines through the points whose inner corners are replaced by parabolas over +-`half_length`, tangent to both
    /// lines: C1. At a corner the parabola leaves the broken line by (difference of slopes) half_length/4.
    ///
    /// # Errors
    /// As [`Self::broken_line`], and `RoundingOutOfRange` unless 0 < `half_length` and neighbouring roundings stay apart.
    pub fn rounded_line(x: &[f64], y: &[f64], half_length: f64) -> Result<Self, LawError> {
        let slopes = secants(x, y, 2)?;
        let last = slopes.len() - 1;
        let room = |k: usize| {
            // A piece at either end holds one half rounding, one between two corners holds two.
            let corners = usize::from(k > 0) + usize::from(k < last);
            (x[k + 1] - x[k]) / corners as f64
        };
        let largest = (0..slopes.len()).map(room).fold(f64::INFINITY, f64::min);
        // A rounding that fills its piece exactly may exceed it by rounding of the points.
        let fits = half_length > 0.0 && half_length <= largest * (1.0 + 1e-12);
        if !fits {
            return Err(LawError::RoundingOutOfRange { half_length, largest });
        }
        Self::rounded(x, y, &slopes, |_| half_length)
    }

    /// Straight lines through the points with parabolas at the corners, each over half of the shorter line beside it on both sides:
    /// C1. A corner moves by a quarter of what its lines' middles miss a smooth curve by, at most.
    ///
    /// # Errors
    /// `TooFewPoints` below two, `LengthMismatch`, `NotAscending`, `NotFinite`.
    pub fn rounded_corners(x: &[f64], y: &[f64]) -> Result<Self, LawError> {
        let slopes = secants(x, y, 2)?;
        Self::rounded(x, y, &slopes, |k| 0.5 * (x[k + 1] - x[k]).min(x[k + 2] - x[k + 1]))
    }

    /// `half(k)`: half length of the rounding at the corner between the lines k and k + 1.
    fn rounded(x: &[f64], y: &[f64], slopes: &[f64], half: impl Fn(usize) -> f64) -> Result<Self, LawError> {
        let last = slopes.len() - 1;
        let (mut breaks, mut pieces) = (Vec::new(), Vec::new());
        let mut from = x[0];
        for (k, &m) in slopes.iter().enumerate() {
            let half_length = if k < last { half(k) } else { 0.0 };
            let to = x[k + 1] - half_length;
            // Roundings that fill a line leave nothing of it but rounding errors.
            if to - from > ROUNDING * (x[k + 1] - x[k]) {
                breaks.push(from);
                pieces.push([y[k] + m * (from - x[k]), m, 0.0, 0.0]);
            }
            if k < last {
                let start = to.max(from);
                breaks.push(start);
                let bend = (slopes[k + 1] - m) / (4.0 * half_length);
                pieces.push([y[k] + m * (start - x[k]), m, bend, 0.0]);
                from = x[k + 1] + half_length;
            }
        }
        breaks.push(x[x.len() - 1].max(from));
        Self::new(breaks, pieces)
    }

    /// Monotone cubic interpolation: the parabola through each three neighbours gives the slopes, limited as Fritsch and Carlson
    /// ask for, so that the law rises and falls with its points and nowhere else. C1.
    ///
    /// # Errors
    /// `TooFewPoints` below two, `LengthMismatch`, `NotAscending`, `NotFinite`.
    pub fn monotone(x: &[f64], y: &[f64]) -> Result<Self, LawError> {
        let m = secants(x, y, 2)?;
        let h: Vec<f64> = x.windows(2).map(|p| p[1] - p[0]).collect();
        let n = x.len();
        let slopes: Vec<f64> = (0..n)
            .map(|i| match i {
                _ if n == 2 => m[0],
                0 => m[0] + (m[0] - m[1]) * h[0] / (h[0] + h[1]),
                i if i == n - 1 => m[i - 1] + (m[i - 1] - m[i - 2]) * h[i - 1] / (h[i - 1] + h[i - 2]),
                i => (h[i] * m[i - 1] + h[i - 1] * m[i]) / (h[i - 1] + h[i]),
            })
            .collect();
        Self::monotone_with_slopes(x, y, &slopes)
    }

    /// Cubic interpolation of values and slopes; a slope that would break monotony between its neighbours is reduced to the limit
    /// of Fritsch and Carlson. C1.
    ///
    /// # Errors
    /// `TooFewPoints` below two, `LengthMismatch`, `NotAscending`, `NotFinite`.
    pub fn monotone_with_slopes(x: &[f64], y: &[f64], slopes: &[f64]) -> Result<Self, LawError> {
        let m = secants(x, y, 2)?;
        if slopes.len() != x.len() {
            return Err(LawError::LengthMismatch { expected: x.len(), found: slopes.len() });
        }
        let mut s = slopes.to_vec();
        for (i, &m) in m.iter().enumerate() {
            if m == 0.0 {
                (s[i], s[i + 1]) = (0.0, 0.0);
                continue;
            }
            for slope in &mut s[i..=i + 1] {
                if *slope * m < 0.0 {
                    *slope = 0.0;
                }
            }
            let size = (s[i] / m).hypot(s[i + 1] / m);
            if size > 3.0 {
                s[i] *= 3.0 / size;
                s[i + 1] *= 3.0 / size;
            }
        }
        let pieces = m
            .iter()
            .enumerate()
            .map(|(i, &m)| {
                let h = x[i + 1] - x[i];
                let excess = (s[i] + s[i + 1] - 2.0 * m) / h;
                [y[i], s[i], (m - s[i]) / h - excess, excess / h]
            })
            .collect();
        Self::new(x.to_vec(), pieces)
    }

    /// The interpolating cubic spline (C2, not-a-knot ends) through at least four points.
    ///
    /// # Errors
    /// `Spline` with what is wrong with the points.
    pub fn spline(x: &[f64], y: &[f64]) -> Result<Self, LawError> {
        let spline = CubicSpline::new(x, y)?;
        let pieces = x[..x.len() - 1]
            .iter()
            .map(|&knot| {
                let [f, f1, f2, f3] = spline.derivatives(knot);
                [f, f1, f2 / 2.0, f3 / 6.0]
            })
            .collect();
        Self::new(x.to_vec(), pieces)
    }

    /// `[f, f', f'']` at x; at a breakpoint that of the piece above it.
    pub fn jet(&self, x: f64) -> [f64; 3] {
        let (first, last) = (self.breaks[0], self.breaks[self.breaks.len() - 1]);
        let k = self.breaks[1..self.breaks.len() - 1].partition_point(|&b| b <= x);
        let inside = x.clamp(first, last);
        let [f, f1, f2] = evaluate(&self.pieces[k], inside - self.breaks[k]);
        if x < first || x > last { [f + f1 * (x - inside), f1, 0.0] } else { [f, f1, f2] }
    }

    /// The breakpoints, ascending.
    pub fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    /// The polynomials between the breakpoints, `[c_0, c_1, c_2, c_3]` in powers of the distance from the lower one.
    pub fn pieces(&self) -> &[[f64; 4]] {
        &self.pieces
    }

    /// The law plus a constant.
    pub(super) fn raised(&self, by: f64) -> Self {
        let raise = |piece: &[f64; 4]| [piece[0] + by, piece[1], piece[2], piece[3]];
        Self { breaks: self.breaks.clone(), pieces: self.pieces.iter().map(raise).collect() }
    }

    /// The law times a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        let pieces = self.pieces.iter().map(|piece| piece.map(|c| c * factor)).collect();
        Self { breaks: self.breaks.clone(), pieces }
    }
}

fn evaluate([a, b, c, d]: &[f64; 4], t: f64) -> [f64; 3] {
    [a + t * (b + t * (c + t * d)), b + t * (2.0 * c + t * 3.0 * d), 2.0 * c + 6.0 * d * t]
}

fn check_points(x: &[f64], least: usize) -> Result<(), LawError> {
    if x.len() < least {
        return Err(LawError::TooFewPoints { points: x.len(), least });
    }
    if let Some(index) = x.iter().position(|x| !x.is_finite()) {
        return Err(LawError::NotFinite { index });
    }
    match x.windows(2).position(|p| p[1] <= p[0]) {
        Some(before) => Err(LawError::NotAscending { index: before + 1 }),
        None => Ok(()),
    }
}

/// Slopes between neighbouring points, after a check of the points.
fn secants(x: &[f64], y: &[f64], least: usize) -> Result<Vec<f64>, LawError> {
    check_points(x, least)?;
    if y.len() != x.len() {
        return Err(LawError::LengthMismatch { expected: x.len(), found: y.len() });
    }
    let slopes: Vec<f64> = (1..x.len()).map(|i| (y[i] - y[i - 1]) / (x[i] - x[i - 1])).collect();
    match slopes.iter().position(|m| !m.is_finite()) {
        Some(index) => Err(LawError::NotFinite { index }),
        None => Ok(slopes),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const X: [f64; 6] = [-2.0, -0.5, 0.0, 1.5, 2.0, 4.0];
    const Y: [f64; 6] = [-3.0, -2.5, 0.0, 0.2, 0.2, 5.0];

    fn laws() -> Vec<PiecewisePolynomial> {
        vec![
            PiecewisePolynomial::broken_line(&X, &Y).unwrap(),
            PiecewisePolynomial::rounded_line(&X, &Y, 0.25).unwrap(),
            PiecewisePolynomial::monotone(&X, &Y).unwrap(),
            PiecewisePolynomial::spline(&X, &Y).unwrap(),
        ]
    }

    #[test]
    fn corners_of_lines_of_any_length_are_rounded() {
        // Nodes of a parabola at uneven distances: the rounded line is smooth and misses it by no more than its chords.
        let x = [-3.0, -2.5, -1.0, -0.9, 0.0, 2.0, 2.25];
        let y = x.map(|x| 0.3 * x * x);
        let law = PiecewisePolynomial::rounded_corners(&x, &y).unwrap();
        let mut before = law.jet(-3.0);
        for k in 1..=5250 {
            let at = -3.0 + 1e-3 * f64::from(k);
            let now = law.jet(at);
            assert!((now[0] - 0.3 * at * at).abs() < 0.3 * 2.0 * 2.0 / 4.0 + 1e-12);
            assert!((now[1] - before[1]).abs() < 0.02, "a kink at {at}");
            before = now;
        }
        // Two lines: one corner over half of the shorter.
        let law = PiecewisePolynomial::rounded_corners(&[0.0, 1.0, 5.0], &[0.0, 1.0, 1.0]).unwrap();
        assert_eq!((law.jet(0.4)[0], law.jet(1.6)[0]), (0.4, 1.0));
        assert!((law.jet(1.0)[0] - 0.875).abs() < 1e-15);
    }

    #[test]
    fn derivatives_are_those_of_the_value() {
        for law in laws() {
            for k in 0..100 {
                // Incommensurable with the breakpoints, beyond both ends too.
                let x = -3.0 + 0.0817 * f64::from(k);
                let h = 1e-5;
                let f = |x: f64| law.jet(x);
                let near = |b: &f64| (b - x).abs() < 2.0 * h;
                if law.breaks().iter().any(near) {
                    continue;
                }
                let first = (f(x + h)[0] - f(x - h)[0]) / (2.0 * h);
                let second = (f(x + h)[1] - f(x - h)[1]) / (2.0 * h);
                assert!((f(x)[1] - first).abs() < 1e-8 && (f(x)[2] - second).abs() < 1e-8, "{x}");
            }
        }
    }

    #[test]
    fn laws_are_as_smooth_as_they_say_and_straight_beyond_their_ends() {
        for (k, law) in laws().iter().enumerate() {
            let smooth = [0, 1, 1, 2][k];
            let breaks = law.breaks();
            for &b in &breaks[1..breaks.len() - 1] {
                let (below, above) = (law.jet(b - 1e-9), law.jet(b + 1e-9));
                for order in 0..=smooth {
                    assert!((below[order] - above[order]).abs() < 1e-6, "law {k} at {b}, order {order}");
                }
            }
            for (end, out) in [(X[0], -50.0), (X[5], 50.0)] {
                let ([f, slope, _], [g, same, bend]) = (law.jet(end), law.jet(end + out));
                assert!((g - f - slope * out).abs() < 1e-12 && same == slope && bend == 0.0, "law {k}");
            }
        }
    }

    #[test]
    fn interpolation_meets_the_points_and_monotone_laws_follow_them() {
        let [line, rounded, monotone, spline] = laws().try_into().unwrap();
        for (i, (&x, &y)) in X.iter().zip(&Y).enumerate() {
            for law in [&line, &monotone, &spline] {
                assert!((law.jet(x)[0] - y).abs() < 1e-14);
            }
            let inner = i > 0 && i < 5;
            let slope = |i: usize| (Y[i + 1] - Y[i]) / (X[i + 1] - X[i]);
            let lifted = if inner { (slope(i) - slope(i - 1)) * 0.25 / 4.0 } else { 0.0 };
            assert!((rounded.jet(x)[0] - y - lifted).abs() < 1e-14);
        }
        for k in 0..=600 {
            let x = -2.0 + 0.01 * f64::from(k);
            assert!(monotone.jet(x)[1] >= -1e-14, "falls at {x}");
        }
        assert_eq!(monotone.jet(1.7), [0.2, 0.0, 0.0]);
        assert!((0..=600).any(|k| spline.jet(-2.0 + 0.01 * f64::from(k))[1] < -0.01), "a spline overshoots");
    }

    #[test]
    fn limited_slopes_keep_monotony_and_good_slopes_stay() {
        let law =
            PiecewisePolynomial::monotone_with_slopes(&[0.0, 1.0, 2.0], &[0.0, 1.0, 2.0], &[9.0, -1.0, 1.0])
                .unwrap();
        assert_eq!(law.jet(0.0)[1], 3.0);
        assert_eq!(law.jet(1.0)[1], 0.0);
        let cube = |x: f64| [x.powi(3) + x, 3.0 * x * x + 1.0];
        let x = [0.0, 0.5, 1.5];
        let y: Vec<f64> = x.iter().map(|&x| cube(x)[0]).collect();
        let s: Vec<f64> = x.iter().map(|&x| cube(x)[1]).collect();
        let law = PiecewisePolynomial::monotone_with_slopes(&x, &y, &s).unwrap();
        assert!((law.jet(1.1)[0] - cube(1.1)[0]).abs() < 1e-14, "a cubic is reproduced");
    }

    #[test]
    fn bad_points_are_refused() {
        type Law = PiecewisePolynomial;
        let code = |law: Result<Law, LawError>| {
            let error = law.unwrap_err();
            assert!(!error.way_out().is_empty() && !error.to_string().is_empty());
            error.code()
        };
        assert_eq!(code(Law::broken_line(&[0.0], &[1.0])), "law-too-few-points");
        assert_eq!(code(Law::monotone(&[0.0, 1.0], &[1.0])), "law-length-mismatch");
        assert_eq!(code(Law::broken_line(&[0.0, 0.0], &[1.0, 2.0])), "law-not-ascending");
        assert_eq!(code(Law::monotone(&[0.0, f64::NAN], &[1.0, 2.0])), "law-not-finite");
        assert_eq!(code(Law::monotone(&[0.0, 1.0], &[1.0, f64::INFINITY])), "law-not-finite");
        assert_eq!(code(Law::monotone_with_slopes(&[0.0, 1.0], &[0.0, 1.0], &[1.0])), "law-length-mismatch");
        assert_eq!(code(Law::new(vec![0.0, 1.0], vec![])), "law-length-mismatch");
        assert_eq!(code(Law::new(vec![0.0, 1.0], vec![[f64::NAN; 4]])), "law-not-finite");
        let jump = vec![[0.0, 1.0, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0]];
        assert_eq!(code(Law::new(vec![0.0, 1.0, 2.0], jump)), "law-jumps");
        assert_eq!(code(Law::spline(&[0.0, 1.0], &[0.0, 1.0])), "law-spline");
        for h in [0.0, -1.0, f64::NAN, 0.26] {
            assert_eq!(code(Law::rounded_line(&X, &Y, h)), "law-rounding-out-of-range");
        }
    }
}
