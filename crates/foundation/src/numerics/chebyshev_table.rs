//! Several Chebyshev series of one interval, evaluated together: one recurrence for all, and sums side by side.

use super::chebyshev::{Chebyshev, covers};

/// N series of one interval.
#[derive(Clone, Debug, PartialEq)]
pub struct ChebyshevTable<const N: usize> {
    a: f64,
    b: f64,
    /// Coefficients of T_0, T_1, ... of all series.
    rows: Vec<[f64; N]>,
}

impl<const N: usize> ChebyshevTable<N> {
    /// Series of the interval of the first one. Coefficients at the end are left out that together are below the rounding of every series.
    pub fn new(series: [&Chebyshev; N]) -> Self {
        let (a, b) = series.first().map_or((-1.0, 1.0), |first| first.interval());
        let count = series.iter().map(|s| s.coefficients().len()).max().unwrap_or(0);
        let row = |j: usize| series.map(|s| s.coefficients().get(j).copied().unwrap_or(0.0));
        let mut rows: Vec<[f64; N]> = (0..count).map(row).collect();
        let rounding = series.map(|s| {
            let largest = s.coefficients().iter().fold(0.0, |m: f64, c| m.max(c.abs()));
            0.5 * f64::EPSILON * largest
        });
        let mut left_out = [0.0; N];
        while let Some(last) = rows.last() {
            left_out.iter_mut().zip(last).for_each(|(sum, c)| *sum += c.abs());
            if !left_out.iter().zip(&rounding).all(|(sum, rounding)| sum <= rounding) {
                break;
            }
            rows.pop();
        }
        Self { a, b, rows }
    }

    /// The interval.
    pub fn interval(&self) -> (f64, f64) {
        (self.a, self.b)
    }

    /// Whether `x` lies in the interval, with a margin of 1e-9 of its length for rounding.
    pub fn covers(&self, x: f64) -> bool {
        covers(self.interval(), x)
    }

    /// Values at `x`; outside the interval the polynomials continue.
    pub fn values(&self, x: f64) -> [f64; N] {
        let t = (2.0 * x - (self.a + self.b)) / (self.b - self.a);
        let mut sums = [0.0; N];
        let (mut t0, mut t1) = (1.0, t);
        for row in &self.rows {
            for k in 0..N {
                sums[k] += t0 * row[k];
            }
            (t0, t1) = (t1, 2.0 * t * t1 - t0);
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_together_are_what_each_is_alone() {
        let (a, b) = (-1.5, 2.0);
        let sine = Chebyshev::interpolate(
            a,
            b,
            &Chebyshev::nodes(a, b, 60).iter().map(|x| x.sin()).collect::<Vec<_>>(),
        );
        let slope = sine.derivative();
        let one = Chebyshev::constant(a, b, 3.0);
        let table = ChebyshevTable::new([&sine, &slope, &one]);
        for k in 0..=40 {
            let x = a + (b - a) * f64::from(k) / 40.0;
            let [value, by_slope, constant] = table.values(x);
            let apart = f64::max((value - sine.value(x)).abs(), (by_slope - slope.value(x)).abs());
            assert!(apart < 1e-13, "{x}: {apart:e}");
            assert_eq!(constant, 3.0);
        }
    }

    #[test]
    fn what_is_below_rounding_is_left_out_at_the_end_only() {
        let series = |coefficients: &[f64]| Chebyshev::from_coefficients(0.0, 1.0, coefficients.to_vec());
        let (short, long) = (series(&[1.0, 0.5, 1e-17, 1e-18]), series(&[1e-20, 1e-3, 1e-5]));
        assert_eq!(ChebyshevTable::new([&short]).rows, [[1.0], [0.5]]);
        assert_eq!(ChebyshevTable::new([&short, &long]).rows.len(), 3);
    }

    #[test]
    fn series_of_nothing_are_zero() {
        let nothing = Chebyshev::constant(0.0, 1.0, 0.0);
        assert_eq!(ChebyshevTable::new([&nothing, &nothing]).values(0.3), [0.0, 0.0]);
    }
}
