//! The straight line and the parabola through the samples of a trace, by least squares over orthogonal polynomials
//! (`docs/mathematics/inspection.md#one-trace`).

/// A line c + k a, kept at the middle of its samples. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Mean abscissa of the samples, mm.
    pub centre: f64,
    /// Value there, mm.
    pub value: f64,
    /// k, mm/mm.
    pub gradient: f64,
    /// sqrt of the sum of squared distances of the samples from the centre, mm.
    pub spread: f64,
}

/// A parabola p0 + p1 u + p2 u^2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Parabola(pub [f64; 3]);

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Line {
    /// Through at least two samples at different abscissae.
    pub(super) fn through(abscissa: &[f64], values: &[f64]) -> Self {
        let centre = mean(abscissa);
        let distance: Vec<f64> = abscissa.iter().map(|a| a - centre).collect();
        let squares = product(&distance, &distance);
        // Both sides without their means: those of distant abscissae are rounded.
        let value = mean(values);
        let gradient = distance.iter().zip(values).map(|(d, f)| d * (f - value)).sum::<f64>() / squares;
        Self { centre, value, gradient, spread: squares.sqrt() }
    }

    /// Value at an abscissa, mm.
    pub fn at(&self, a: f64) -> f64 {
        self.value + self.gradient * (a - self.centre)
    }

    /// Where two lines cross, mm; `None` for parallel lines.
    pub fn crossing(&self, other: &Self) -> Option<f64> {
        let apart = other.at(self.centre) - self.value;
        let a = self.centre + apart / (self.gradient - other.gradient);
        a.is_finite().then_some(a)
    }
}

impl Parabola {
    /// Through at least three samples at different places u.
    pub fn through(u: &[f64], values: &[f64]) -> Self {
        let centre = mean(u);
        let first: Vec<f64> = u.iter().map(|u| u - centre).collect();
        let squares = product(&first, &first);
        // q_2 = (u - shift) q_1 - height, orthogonal to 1 and to q_1 = u - centre.
        let shift = u.iter().zip(&first).map(|(u, q)| u * q * q).sum::<f64>() / squares;
        let height = squares / u.len() as f64;
        let second: Vec<f64> = u.iter().zip(&first).map(|(u, q)| (u - shift) * q - height).collect();
        let c = [
            mean(values),
            product(&first, values) / squares,
            product(&second, values) / product(&second, &second),
        ];
        Self([c[0] - c[1] * centre + c[2] * (shift * centre - height), c[1] - c[2] * (shift + centre), c[2]])
    }

    pub fn at(&self, u: f64) -> f64 {
        self.0[0] + u * (self.0[1] + u * self.0[2])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Places without any symmetry.
    fn places() -> Vec<f64> {
        (0..40).map(|k| -0.9 + 1.7 * (f64::from(k) / 40.0).powf(1.3)).collect()
    }

    #[test]
    fn a_line_and_a_parabola_are_recovered() {
        let u = places();
        let a: Vec<f64> = u.iter().map(|u| 1000.0 + u).collect();
        let line = Line::through(&a, &u.iter().map(|u| 3.0 - 0.5 * u).collect::<Vec<_>>());
        // The abscissae hold thirteen digits of u.
        assert!((line.gradient + 0.5).abs() < 1e-12 && (line.at(1000.0) - 3.0).abs() < 1e-12);
        let p = Parabola::through(&u, &u.iter().map(|u| 2.0 - 0.5 * u + 7.0 * u * u).collect::<Vec<_>>());
        for (got, want) in p.0.iter().zip([2.0, -0.5, 7.0]) {
            assert!((got - want).abs() < 1e-13, "{got} {want}");
        }
        assert!((p.at(0.5) - 3.5).abs() < 1e-13);
    }

    #[test]
    fn what_the_parabola_leaves_is_orthogonal_to_it() {
        let u = places();
        let f: Vec<f64> = u.iter().map(|u| (3.0 * u).sin() + 0.2 * u.exp()).collect();
        let p = Parabola::through(&u, &f);
        let rest: Vec<f64> = u.iter().zip(&f).map(|(u, f)| f - p.at(*u)).collect();
        for power in 0..3 {
            let moment: f64 = u.iter().zip(&rest).map(|(u, r)| u.powi(power) * r).sum();
            assert!(moment.abs() < 1e-12, "{power}: {moment:e}");
        }
    }

    #[test]
    fn lines_cross_or_are_parallel() {
        let line = |gradient: f64, value: f64| Line { centre: 1.0, value, gradient, spread: 1.0 };
        assert_eq!(line(1.0, 0.0).crossing(&line(-1.0, 4.0)), Some(3.0));
        assert_eq!(line(1.0, 0.0).crossing(&line(1.0, 4.0)), None);
        assert_eq!(line(1.0, 0.0).crossing(&line(1.0, 0.0)), None);
    }
}
