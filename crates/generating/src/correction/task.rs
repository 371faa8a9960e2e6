//! What is to be corrected, by which settings and within which bounds.

use super::{Column, CorrectionError};

/// What the deviations weigh.
#[derive(Clone, Debug, PartialEq)]
pub enum Weighting {
    /// All alike.
    Even,
    /// By the tolerance of every point, mm.
    Tolerances(Vec<f64>),
    /// By the standard uncertainty of every point, mm: settings get standard deviations of their own.
    Uncertainties(Vec<f64>),
}

/// Deviations at points of both flanks and the settings that may be turned.
#[derive(Clone, Debug, PartialEq)]
pub struct CorrectionTask {
    /// Measured minus target at every point, normal, mm, > 0 material left.
    pub deviations: Vec<f64>,
    /// Effects of the settings at the same points.
    pub columns: Vec<Column>,
    /// Trace of every point, 0, 1, ..., where every trace has its own zero; `None` for absolute deviations.
    pub traces: Option<Vec<usize>>,
    /// Weights.
    pub weighting: Weighting,
    /// [lowest, highest] of the SUM of all corrections of each setting so far and now.
    pub bounds: Vec<[f64; 2]>,
    /// Sum of the corrections so far.
    pub applied: Vec<f64>,
    /// Resolution of each setting: what is smaller, or below two standard deviations, is dropped. `None`: nothing is dropped.
    pub resolutions: Option<Vec<f64>>,
    /// Whether the shortest correction will do where the points leave settings open.
    pub allow_underdetermined: bool,
}

impl CorrectionTask {
    /// Without bounds, zeros of traces, earlier corrections and dropping; all points alike.
    pub fn new(deviations: Vec<f64>, columns: Vec<Column>) -> Self {
        let settings = columns.len();
        Self {
            deviations,
            columns,
            traces: None,
            weighting: Weighting::Even,
            bounds: vec![[f64::NEG_INFINITY, f64::INFINITY]; settings],
            applied: vec![0.0; settings],
            resolutions: None,
            allow_underdetermined: false,
        }
    }

    /// Number of traces with a zero of their own.
    pub(super) fn zeros(&self) -> usize {
        self.traces.iter().flatten().max().map_or(0, |last| last + 1)
    }

    /// Square roots of the weights.
    pub(super) fn roots(&self) -> Option<Vec<f64>> {
        match &self.weighting {
            Weighting::Even => None,
            Weighting::Tolerances(sizes) | Weighting::Uncertainties(sizes) => {
                Some(sizes.iter().map(|s| 1.0 / s).collect())
            }
        }
    }

    /// Bounds of this step.
    pub(super) fn step_bounds(&self) -> Vec<[f64; 2]> {
        self.bounds.iter().zip(&self.applied).map(|(bound, applied)| bound.map(|x| x - applied)).collect()
    }

    /// # Errors
    /// As [`CorrectionTask::solve`], those of the input.
    pub(super) fn check(&self) -> Result<(), CorrectionError> {
        let (points, settings) = (self.deviations.len(), self.columns.len());
        if points == 0 {
            return Err(CorrectionError::TooFewPoints);
        }
        let same = |name, found, wanted| {
            if found == wanted { Ok(()) } else { Err(CorrectionError::OtherShape { name, found, wanted }) }
        };
        if settings == 0 {
            return same("settings", 0, 1);
        }
        same("bounds", self.bounds.len(), settings)?;
        same("corrections so far", self.applied.len(), settings)?;
        same("resolutions", self.resolutions.as_ref().map_or(settings, Vec::len), settings)?;
        same("traces of points", self.traces.as_ref().map_or(points, Vec::len), points)?;
        let finite = |name, values: &[f64]| match values.iter().find(|x| !x.is_finite()) {
            None => Ok(()),
            Some(&value) => Err(CorrectionError::InvalidNumber { name, value, allowed: "finite numbers" }),
        };
        finite("deviation", &self.deviations)?;
        finite("correction so far", &self.applied)?;
        for column in &self.columns {
            same("effects of a setting", column.values.len(), points)?;
            finite("effect of a setting", &column.values)?;
            if column.values.iter().all(|x| *x == 0.0) {
                return Err(CorrectionError::SettingWithoutEffect { setting: column.name.clone() });
            }
        }
        if let Weighting::Tolerances(sizes) | Weighting::Uncertainties(sizes) = &self.weighting {
            same("weights", sizes.len(), points)?;
            if let Some(&value) = sizes.iter().find(|s| !(s.is_finite() && **s > 0.0)) {
                let (name, allowed) = ("tolerance or uncertainty of a point", "finite numbers above 0");
                return Err(CorrectionError::InvalidNumber { name, value, allowed });
            }
        }
        for (column, &[low, high]) in self.columns.iter().zip(&self.bounds) {
            // Written so that NaN fails.
            if !(low <= high && low < f64::INFINITY && high > f64::NEG_INFINITY) {
                return Err(CorrectionError::InvalidBounds { setting: column.name.clone(), low, high });
            }
        }
        // A number per trace must not be of any size.
        same("traces", self.zeros().min(points + 1), self.zeros()).and_then(|()| {
            let used = |k: usize| self.traces.iter().flatten().any(|trace| *trace == k);
            same("traces with points", (0..self.zeros()).filter(|k| used(*k)).count(), self.zeros())
        })
    }
}
