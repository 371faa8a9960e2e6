//! The best value of a parameter whose objective has several minima: a scan, then golden section around the best few.

use super::super::GeneratingError;
use foundation::numerics::golden_section;
use rayon::prelude::*;

/// Local minima of the scan that are refined: kinked targets have one for every relief direction.
const REFINED: usize = 3;
/// Evaluations of a golden section: its bracket shrinks to 4e-7 of the distance of two candidates.
const GOLDEN: usize = 32;

/// Values of a parameter to be tried, ascending.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidates {
    values: Vec<f64>,
    /// Nothing is tried between a negative and a positive value: diagonal ratio 0 is another method.
    signs_apart: bool,
}

/// A tried value and its objective, or why it has none.
#[derive(Clone, Debug, PartialEq)]
pub struct Tried {
    /// Diagonal ratio, or rho_2 in rad.
    pub value: f64,
    /// Objective.
    pub outcome: Result<f64, GeneratingError>,
}

impl Candidates {
    /// Diagonal ratios as listed.
    ///
    /// # Errors
    /// `InvalidScan` for an empty list and numbers that are not finite.
    pub fn ratios(values: &[f64]) -> Result<Self, GeneratingError> {
        Self::checked(values.to_vec(), true)
    }

    /// Diagonal ratios of both signs with least <= |K| <= most, `per_sign` of them each, in constant proportion: directions on
    /// the workpiece follow 1/K.
    ///
    /// # Errors
    /// `InvalidScan` unless 0 < least < most and per_sign >= 2.
    pub fn both_signs([least, most]: [f64; 2], per_sign: usize) -> Result<Self, GeneratingError> {
        if !(least > 0.0 && least < most && most.is_finite() && per_sign >= 2) {
            return Err(GeneratingError::InvalidScan { least, most, count: per_sign });
        }
        let step = (most / least).ln() / (per_sign - 1) as f64;
        let positive = (0..per_sign).map(|i| (least * (step * i as f64).exp()).min(most));
        Self::checked(positive.flat_map(|k| [-k, k]).collect(), true)
    }

    /// The exact ratios of two flanks and `count` values between them: where both exist, the best common ratio is among
    /// these (`docs/mathematics/planning.md#producibility`).
    ///
    /// # Errors
    /// `InvalidScan` for numbers that are not finite or of different sign.
    pub fn between(left: f64, right: f64, count: usize) -> Result<Self, GeneratingError> {
        let same_sign = (left > 0.0 && right > 0.0) || (left < 0.0 && right < 0.0);
        if !same_sign {
            return Err(GeneratingError::InvalidScan { least: left, most: right, count });
        }
        let inside = (0..=count).map(|i| {
            let share = i as f64 / (count + 1) as f64;
            left * (1.0 - share) + right * share
        });
        Self::checked(inside.chain([right]).collect(), true)
    }

    /// Directions rho_2 in rad, `count` of them from `least` to `most`.
    ///
    /// # Errors
    /// `InvalidScan` unless -pi/2 < least < most < pi/2 and count >= 2.
    pub fn directions([least, most]: [f64; 2], count: usize) -> Result<Self, GeneratingError> {
        let quarter = std::f64::consts::FRAC_PI_2;
        if !(-quarter < least && least < most && most < quarter && count >= 2) {
            return Err(GeneratingError::InvalidScan { least, most, count });
        }
        let at = |i: usize| least + (most - least) * i as f64 / (count - 1) as f64;
        Self::checked((0..count).map(at).collect(), false)
    }

    /// The same with further values.
    ///
    /// # Errors
    /// `InvalidScan` for numbers that are not finite.
    pub fn with(mut self, values: &[f64]) -> Result<Self, GeneratingError> {
        self.values.extend_from_slice(values);
        Self::checked(self.values, self.signs_apart)
    }

    fn checked(mut values: Vec<f64>, signs_apart: bool) -> Result<Self, GeneratingError> {
        values.sort_by(f64::total_cmp);
        values.dedup();
        if values.is_empty() || values.iter().any(|x| !x.is_finite()) {
            let end = |x: Option<&f64>| x.copied().unwrap_or(f64::NAN);
            return Err(GeneratingError::InvalidScan {
                least: end(values.first()),
                most: end(values.last()),
                count: values.len(),
            });
        }
        Ok(Self { values, signs_apart })
    }

    /// The values, ascending.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    fn neighbours(&self, i: usize) -> [usize; 2] {
        let joined =
            |j: usize| j < self.values.len() && !(self.signs_apart && self.values[i] * self.values[j] <= 0.0);
        [
            i.checked_sub(1).filter(|&j| joined(j)).unwrap_or(i),
            Some(i + 1).filter(|&j| joined(j)).unwrap_or(i),
        ]
    }
}

/// The value with the least objective, and all candidates with theirs. Parallel over candidates and minima, collected in
/// order: the result does not depend on the number of threads.
///
/// # Errors
/// Where no candidate has an objective, the error of the first.
pub(super) fn least<F>(candidates: &Candidates, objective: F) -> Result<(f64, Vec<Tried>), GeneratingError>
where
    F: Fn(f64) -> Result<f64, GeneratingError> + Sync,
{
    let tried: Vec<Tried> =
        candidates.values.par_iter().map(|&value| Tried { value, outcome: objective(value) }).collect();
    let height = |i: usize| tried[i].outcome.as_ref().map_or(f64::INFINITY, |&y| y);
    let mut minima: Vec<usize> = (0..tried.len())
        .filter(|&i| {
            let [before, after] = candidates.neighbours(i);
            height(i).is_finite() && height(i) <= height(before) && height(i) <= height(after)
        })
        .collect();
    minima.sort_by(|&i, &j| height(i).total_cmp(&height(j)));
    minima.truncate(REFINED);
    let refined: Vec<(f64, f64)> = minima
        .par_iter()
        .map(|&i| {
            let [from, to] = candidates.neighbours(i).map(|j| tried[j].value);
            let at = |x: f64| objective(x).unwrap_or(f64::INFINITY);
            let x = golden_section(from, to, GOLDEN, at);
            let y = at(x);
            if y < height(i) { (x, y) } else { (tried[i].value, height(i)) }
        })
        .collect();
    match refined.into_iter().min_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((best, _)) => Ok((best, tried)),
        None => {
            let first = tried.into_iter().find_map(|t| t.outcome.err());
            Err(first.unwrap_or(GeneratingError::InvalidScan { least: f64::NAN, most: f64::NAN, count: 0 }))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lowest_of_several_minima_is_refined() {
        // Minima near 0.7 and 1.9; the second is lower and narrow.
        let f = |x: f64| Ok((x - 0.7).abs().min(8.0 * (x - 1.9).abs() - 0.3));
        let candidates = Candidates::both_signs([0.1, 3.0], 40).unwrap();
        let (best, tried) = least(&candidates, f).unwrap();
        assert!((best - 1.9).abs() < 1e-6, "{best}");
        assert_eq!(tried.len(), 80);
    }

    #[test]
    fn nothing_is_tried_between_the_signs() {
        let f = |x: f64| {
            assert!(x.abs() >= 0.5, "{x}");
            Ok(x * x)
        };
        let (best, _) = least(&Candidates::both_signs([0.5, 2.0], 5).unwrap(), f).unwrap();
        assert_eq!(best.abs(), 0.5);
    }

    #[test]
    fn impossible_scans_are_refused() {
        for range in [[0.0, 1.0], [1.0, 1.0], [2.0, 1.0], [f64::NAN, 1.0], [1.0, f64::INFINITY]] {
            assert!(matches!(Candidates::both_signs(range, 5), Err(GeneratingError::InvalidScan { .. })));
        }
        assert!(Candidates::ratios(&[]).is_err() && Candidates::ratios(&[1.0, f64::NAN]).is_err());
        assert!(Candidates::between(-1.0, 1.0, 3).is_err());
        assert_eq!(Candidates::between(2.0, 1.0, 1).unwrap().values(), [1.0, 1.5, 2.0]);
        assert!(Candidates::directions([-2.0, 1.0], 9).is_err());
    }
}
