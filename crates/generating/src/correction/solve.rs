//! The correction that removes most of a deviation: bounded least squares over all settings and both flanks at once, with what stays, what
//! the points leave open and how well every setting is known.

use super::{CorrectionError, CorrectionTask, Weighting};
use foundation::inverse::{BoundedLeastSquares, bounded_least_squares};
use foundation::numerics::root_mean_square;
use nalgebra::{DMatrix, DVector};

/// A setting in a correction, in its own unit (mm, rad, 1).
#[derive(Clone, Debug, PartialEq)]
pub struct CorrectedSetting {
    /// Its name.
    pub name: String,
    /// What to add to it; 0 where it was dropped.
    pub value: f64,
    /// Whether its bound holds it.
    pub at_bound: bool,
    /// Standard deviation of the value; known with uncertainties of the points only, infinite where they leave it open.
    pub deviation: Option<f64>,
    /// Whether it was dropped as too small to matter.
    pub dropped: bool,
}

/// A correction and what it leaves. Root mean squares are over all points, unweighted, about the zeros of the traces, mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Correction {
    /// The settings in the order of the task.
    pub settings: Vec<CorrectedSetting>,
    /// What was measured.
    pub rms_before: f64,
    /// What the first-order model predicts afterwards.
    pub rms_after: f64,
    /// What these settings cannot remove, whatever their bounds.
    pub rms_unremovable: f64,
    /// Predicted deviation at every point, mm.
    pub residual: Vec<f64>,
    /// Number of independent unknowns, zeros of traces included, of `unknowns`.
    pub rank: usize,
    /// Settings in use and zeros of traces.
    pub unknowns: usize,
    /// Singular values with columns of unit norm, descending.
    pub singular_values: Vec<f64>,
    /// Settings that can change together without any effect: name and share of the largest in scaled columns.
    pub unseen: Vec<Vec<(String, f64)>>,
    /// Zeros of the traces, mm.
    pub zeros: Vec<f64>,
}

/// Singular values below this share of the first count as zero.
const CUT: f64 = 1e-9;
/// Parts of a direction below this share of its largest are not named.
const PART: f64 = 1e-6;
/// A setting must exceed its standard deviation by this factor.
const SIGNIFICANT: f64 = 2.0;

impl Correction {
    /// The value of a setting by its name.
    pub fn value(&self, name: &str) -> Option<f64> {
        self.settings.iter().find(|s| s.name == name).map(|s| s.value)
    }

    /// The deviations of settings that explain what was measured: the correction with its sign reversed.
    pub fn found_deviations(&self) -> Vec<f64> {
        self.settings.iter().map(|s| -s.value).collect()
    }
}

impl CorrectionTask {
    /// Finds the correction.
    ///
    /// # Errors
    /// [`CorrectionError::TooFewPoints`], [`CorrectionError::SettingWithoutEffect`], [`CorrectionError::InvalidBounds`],
    /// [`CorrectionError::OtherShape`], [`CorrectionError::InvalidNumber`]; [`CorrectionError::Underdetermined`] unless allowed;
    /// [`CorrectionError::NotConverged`].
    pub fn solve(&self) -> Result<Correction, CorrectionError> {
        self.check()?;
        let mut used: Vec<usize> = (0..self.columns.len()).collect();
        loop {
            let found = self.solve_with(&used)?;
            match self.least_worth(&used, &found) {
                Some(place) => {
                    used.remove(place);
                }
                None => return Ok(self.report(&used, &found)),
            }
        }
    }

    /// Least squares of some settings and the zeros of all traces.
    fn solve_with(&self, used: &[usize]) -> Result<BoundedLeastSquares, CorrectionError> {
        let (points, zeros) = (self.deviations.len(), self.zeros());
        let matrix = DMatrix::from_fn(points, used.len() + zeros, |i, k| match used.get(k) {
            Some(&j) => self.columns[j].values[i],
            None => {
                let own = self.traces.as_ref().is_some_and(|traces| traces[i] == k - used.len());
                f64::from(u8::from(own))
            }
        });
        let right = -DVector::from_column_slice(&self.deviations);
        let all = self.step_bounds();
        let mut bounds: Vec<[f64; 2]> = used.iter().map(|&j| all[j]).collect();
        bounds.resize(used.len() + zeros, [f64::NEG_INFINITY, f64::INFINITY]);
        let solve = |right: &DVector<f64>| {
            bounded_least_squares(&matrix, right, self.roots().as_deref(), &bounds, CUT)
        };
        let found = if bounds.is_empty() { None } else { solve(&right) };
        let found = found.ok_or(CorrectionError::NotConverged)?;
        if !found.unseen.is_empty() && !self.allow_underdetermined {
            let unseen = self.named(used, &found).into_iter();
            let unseen =
                unseen.map(|direction| direction.into_iter().map(|(name, _)| name).collect()).collect();
            return Err(CorrectionError::Underdetermined { unseen });
        }
        Ok(found)
    }

    /// The directions that nothing sees, by the names of their settings.
    fn named(&self, used: &[usize], found: &BoundedLeastSquares) -> Vec<Vec<(String, f64)>> {
        let norm = |j: usize| self.columns[j].values.iter().map(|x| x * x).sum::<f64>().sqrt();
        found
            .unseen
            .iter()
            .map(|direction| {
                let shares: Vec<f64> =
                    used.iter().enumerate().map(|(k, &j)| direction[k] * norm(j)).collect();
                let largest = shares.iter().fold(0.0_f64, |m, s| m.max(s.abs()));
                let parts = used.iter().zip(shares).filter(|(_, s)| s.abs() > PART * largest);
                parts.map(|(&j, s)| (self.columns[j].name.clone(), s / largest)).collect()
            })
            .collect()
    }

    fn deviation(&self, found: &BoundedLeastSquares, k: usize) -> Option<f64> {
        matches!(self.weighting, Weighting::Uncertainties(_)).then(|| found.variances[k].sqrt())
    }

    /// The place of the setting that is most of all too small to matter. With one setting left it stays.
    fn least_worth(&self, used: &[usize], found: &BoundedLeastSquares) -> Option<usize> {
        let resolutions = self.resolutions.as_ref().filter(|_| used.len() > 1)?;
        let worth = |k: usize| {
            let spread = self.deviation(found, k).filter(|d| d.is_finite()).unwrap_or(0.0);
            let least = resolutions[used[k]].max(SIGNIFICANT * spread);
            if least > 0.0 { found.x[k].abs() / least } else { f64::INFINITY }
        };
        let candidates = (0..used.len()).filter(|&k| found.at_bound[k] == 0);
        candidates.min_by(|&a, &b| worth(a).total_cmp(&worth(b))).filter(|&k| worth(k) < 1.0)
    }

    fn report(&self, used: &[usize], found: &BoundedLeastSquares) -> Correction {
        let settings = self.columns.iter().enumerate().map(|(j, column)| {
            let place = used.iter().position(|&u| u == j);
            CorrectedSetting {
                name: column.name.clone(),
                value: place.map_or(0.0, |k| found.x[k]),
                at_bound: place.is_some_and(|k| found.at_bound[k] != 0),
                deviation: place.and_then(|k| self.deviation(found, k)),
                dropped: place.is_none(),
            }
        });
        Correction {
            settings: settings.collect(),
            rms_before: root_mean_square(&self.about_zeros()),
            rms_after: root_mean_square(found.residual.as_slice()),
            rms_unremovable: root_mean_square(found.unremovable.as_slice()),
            residual: found.residual.iter().copied().collect(),
            rank: found.rank.rank,
            unknowns: used.len() + self.zeros(),
            singular_values: found.rank.singular_values.clone(),
            unseen: self.named(used, found),
            zeros: found.x.iter().skip(used.len()).copied().collect(),
        }
    }

    /// The deviations about the weighted means of their traces.
    fn about_zeros(&self) -> Vec<f64> {
        let Some(traces) = &self.traces else { return self.deviations.clone() };
        let roots = self.roots();
        let weight = |i: usize| roots.as_ref().map_or(1.0, |r| r[i] * r[i]);
        let mut sums = vec![[0.0; 2]; self.zeros()];
        for (i, &trace) in traces.iter().enumerate() {
            sums[trace][0] += weight(i) * self.deviations[i];
            sums[trace][1] += weight(i);
        }
        let mean = |trace: usize| sums[trace][0] / sums[trace][1];
        self.deviations.iter().zip(traces).map(|(d, &trace)| d - mean(trace)).collect()
    }
}
