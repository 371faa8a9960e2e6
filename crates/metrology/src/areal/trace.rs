//! A profile or helix trace as a function between its samples.

use super::ArealError;

/// A trace: a profile over lengths of roll at one axial position, or a lead over axial positions at one length of roll.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// Axial position of a profile, length of roll of a lead, mm.
    pub position: f64,
    abscissa: Vec<f64>,
    f: Vec<f64>,
}

/// A trace is asked for its ends to this distance, mm.
const END: f64 = 1e-9;

impl Trace {
    /// From samples in any order; those without a value (NaN) are gaps.
    ///
    /// # Errors
    /// [`ArealError::OtherShape`]; [`ArealError::InvalidNumber`] for places that are not finite; [`ArealError::TooFewPoints`] with fewer
    /// than two samples.
    pub fn new(position: f64, abscissa: &[f64], f: &[f64]) -> Result<Self, ArealError> {
        if abscissa.len() != f.len() {
            let name = "values of a trace";
            return Err(ArealError::OtherShape { name, found: f.len(), wanted: abscissa.len() });
        }
        if let Some(&value) = abscissa.iter().chain([&position]).find(|x| !x.is_finite()) {
            return Err(ArealError::InvalidNumber {
                name: "place of a trace",
                value,
                allowed: "finite numbers",
            });
        }
        let mut samples: Vec<(f64, f64)> =
            abscissa.iter().copied().zip(f.iter().copied()).filter(|(_, f)| f.is_finite()).collect();
        samples.sort_by(|a, b| a.0.total_cmp(&b.0));
        samples.dedup_by(|a, b| a.0 == b.0);
        if samples.len() < 2 {
            return Err(ArealError::TooFewPoints { points: samples.len(), terms: 2 });
        }
        let (abscissa, f) = samples.into_iter().unzip();
        Ok(Self { position, abscissa, f })
    }

    /// Where it begins and ends, mm.
    pub fn range(&self) -> [f64; 2] {
        [self.abscissa[0], self.abscissa[self.abscissa.len() - 1]]
    }

    /// Its value between samples by straight lines, mm; `None` beyond its ends.
    pub fn value(&self, at: f64) -> Option<f64> {
        let [from, to] = self.range();
        if !(at >= from - END && at <= to + END) {
            return None;
        }
        let last = self.abscissa.len() - 1;
        let k = self.abscissa.partition_point(|&x| x <= at).clamp(1, last);
        let (x, f) = (&self.abscissa, &self.f);
        Some(f[k - 1] + (f[k] - f[k - 1]) * (at - x[k - 1]) / (x[k] - x[k - 1]))
    }
}
