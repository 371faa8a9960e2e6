//! Products of Legendre polynomials P_p(u) P_q(v) up to a total degree.

/// Total degree of an areal fit. Features depend on it a little on coarse grids, where cubic terms are not orthogonal to the
/// slopes: it belongs to every feature that is reported.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ArealDegree {
    /// Six terms.
    #[default]
    Second,
    /// Ten terms.
    Third,
}

/// P_p(u) P_q(v).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Term {
    /// Degree over the lengths of roll.
    pub p: usize,
    /// Degree over the axial positions.
    pub q: usize,
}

impl ArealDegree {
    /// The degree as a number.
    pub fn order(self) -> usize {
        match self {
            Self::Second => 2,
            Self::Third => 3,
        }
    }

    /// The terms: by total degree, then from the length of roll to the axial position.
    pub fn terms(self) -> Vec<Term> {
        (0..=self.order()).flat_map(|n| (0..=n).map(move |q| Term { p: n - q, q })).collect()
    }

    /// Values of P_0..=P_N at x.
    pub(super) fn legendre(self, x: f64) -> Vec<f64> {
        let mut values = vec![1.0, x];
        for m in 1..self.order() {
            let n = m as f64;
            values.push(((2.0 * n + 1.0) * x * values[m] - n * values[m - 1]) / (n + 1.0));
        }
        values
    }
}

impl Term {
    /// Its place among the terms of any degree that has it.
    pub fn place(self) -> usize {
        let n = self.p + self.q;
        n * (n + 1) / 2 + self.q
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terms_stand_at_their_places() {
        for degree in [ArealDegree::Second, ArealDegree::Third] {
            for (k, term) in degree.terms().into_iter().enumerate() {
                assert_eq!(term.place(), k);
            }
        }
        let x = 0.3;
        assert_eq!(ArealDegree::Third.legendre(x)[2], 1.5 * x * x - 0.5);
        assert!((ArealDegree::Third.legendre(x)[3] - (2.5 * x * x * x - 1.5 * x)).abs() < 1e-16);
    }
}
