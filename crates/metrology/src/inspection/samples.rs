//! The samples of one trace, and those of them that lie in a range (`docs/mathematics/inspection.md#one-trace`).

use super::error::usable;
use super::{EvaluationRange, InspectionError};
use foundation::numerics::equidistant;

/// Fewest samples that a line is laid through.
const FEWEST: usize = 10;

/// Largest part of a range that may be without samples.
const LARGEST_GAP: f64 = 0.1;

/// Samples of a trace over its abscissa. mm; a deviation that was not measured is NaN and keeps its place.
#[derive(Clone, Debug, PartialEq)]
pub struct TraceSamples {
    abscissa: Vec<f64>,
    deviation: Vec<f64>,
}

/// The defined samples of a trace in a range.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SamplesWithin {
    pub abscissa: Vec<f64>,
    pub deviation: Vec<f64>,
    /// Samples in the range that were not measured.
    pub undefined: usize,
}

impl TraceSamples {
    /// Samples at ascending abscissae.
    ///
    /// # Errors
    /// [`InspectionError::WrongCount`] for lists of different lengths or fewer than two samples,
    /// [`InspectionError::InvalidNumber`] for abscissae that do not ascend or infinite values.
    pub fn new(abscissa: Vec<f64>, deviation: Vec<f64>) -> Result<Self, InspectionError> {
        let (field, needed) = ("deviations of the trace", abscissa.len().max(2));
        if deviation.len() != needed {
            return Err(InspectionError::WrongCount { field, found: deviation.len(), needed });
        }
        for (k, &a) in abscissa.iter().enumerate() {
            usable("abscissa of the trace", a, k == 0 || abscissa[k - 1] < a, "finite, ascending")?;
        }
        if let Some(&value) = deviation.iter().find(|f| f.is_infinite()) {
            let allowed = "finite, or NaN where nothing was measured";
            return Err(InspectionError::InvalidNumber { field, value, allowed });
        }
        Ok(Self { abscissa, deviation })
    }

    /// Samples in equal steps from the first abscissa to the last.
    ///
    /// # Errors
    /// Those of [`TraceSamples::new`].
    pub fn uniform(span: [f64; 2], deviation: Vec<f64>) -> Result<Self, InspectionError> {
        Self::new(equidistant(span, deviation.len().max(2)), deviation)
    }

    /// Abscissae: length of roll of a profile, axial position of a helix, mm.
    pub fn abscissa(&self) -> &[f64] {
        &self.abscissa
    }

    /// Deviations, mm, > 0 material; NaN: not measured.
    pub fn deviation(&self) -> &[f64] {
        &self.deviation
    }

    /// The same trace against a design: what the drawing wants at each abscissa, mm, is subtracted.
    pub fn against(&self, design: impl Fn(f64) -> f64) -> Self {
        let deviation = self.abscissa.iter().zip(&self.deviation).map(|(a, f)| f - design(*a)).collect();
        Self { abscissa: self.abscissa.clone(), deviation }
    }

    /// The defined samples in a range.
    ///
    /// # Errors
    /// [`InspectionError::TooFewSamples`], [`InspectionError::TraceIncomplete`].
    pub(super) fn within(&self, range: &EvaluationRange) -> Result<SamplesWithin, InspectionError> {
        let (from, to) = (range.from(), range.to());
        let slack = range.slack();
        let inside = self.abscissa.iter().zip(&self.deviation);
        let inside = inside.filter(|(a, _)| (from - slack..=to + slack).contains(*a));
        let (mut abscissa, mut deviation, mut undefined) = (Vec::new(), Vec::new(), 0);
        for (&a, &f) in inside {
            if f.is_nan() {
                undefined += 1;
            } else {
                abscissa.push(a);
                deviation.push(f);
            }
        }
        if abscissa.len() < FEWEST {
            return Err(InspectionError::TooFewSamples { found: abscissa.len(), needed: FEWEST, from, to });
        }
        let incomplete = |[gap_from, gap_to]: [f64; 2]| {
            Err(InspectionError::TraceIncomplete { from, to, gap_from, gap_to })
        };
        if let Some(outside) = self.not_reached(range) {
            return incomplete(outside);
        }
        let ends = [&[from], abscissa.as_slice(), &[to]].concat();
        let gaps = ends.windows(2).map(|pair| [pair[0], pair[1]]);
        let largest = gaps.max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
        match largest.filter(|gap| gap[1] - gap[0] > LARGEST_GAP * range.length()) {
            Some(gap) => incomplete(gap),
            None => Ok(SamplesWithin { abscissa, deviation, undefined }),
        }
    }

    /// The part of a range that the trace does not reach, if it is longer than the step there.
    fn not_reached(&self, range: &EvaluationRange) -> Option<[f64; 2]> {
        let (a, n) = (&self.abscissa, self.abscissa.len());
        let (before, after) = ([range.from(), a[0]], [a[n - 1], range.to()]);
        let longer = |gap: [f64; 2], step: f64| gap[1] - gap[0] > step + range.slack();
        let at_begin = longer(before, a[1] - a[0]).then_some(before);
        at_begin.or_else(|| longer(after, a[n - 1] - a[n - 2]).then_some(after))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn codes(span: [f64; 2], f: Vec<f64>, range: [f64; 2]) -> &'static str {
        let samples = TraceSamples::uniform(span, f);
        let range = EvaluationRange::new(range[0], range[1]).unwrap();
        match samples.and_then(|samples| samples.within(&range)) {
            Ok(_) => "good",
            Err(error) => error.code(),
        }
    }

    #[test]
    fn samples_at_the_ends_of_the_range_belong_to_it() {
        let samples = TraceSamples::uniform([0.0, 3.0], (0..31).map(f64::from).collect()).unwrap();
        let within = samples.within(&EvaluationRange::new(0.3, 2.7).unwrap()).unwrap();
        assert_eq!((within.deviation.len(), within.deviation[0], within.deviation[24]), (25, 3.0, 27.0));
    }

    #[test]
    fn what_the_trace_does_not_hold_is_told() {
        let ones = |n: usize| vec![1.0; n];
        assert_eq!(codes([0.0, 10.0], ones(101), [1.0, 9.0]), "good");
        assert_eq!(codes([0.0, 10.0], ones(11), [2.0, 8.0]), "too-few-samples");
        // Up to one step beyond the trace, but no farther.
        assert_eq!(codes([0.0, 10.0], ones(101), [-0.1, 10.1]), "good");
        assert_eq!(codes([0.0, 10.0], ones(101), [-0.2, 9.0]), "trace-incomplete");
        assert_eq!(codes([0.0, 10.0], ones(101), [1.0, 10.2]), "trace-incomplete");
        let mut holed = ones(101);
        holed[50..59].fill(f64::NAN); // 1.0 of 10 mm between the neighbours
        assert_eq!(codes([0.0, 10.0], holed.clone(), [0.0, 10.0]), "good");
        holed[59] = f64::NAN;
        assert_eq!(codes([0.0, 10.0], holed, [0.0, 10.0]), "trace-incomplete");
        assert_eq!(codes([0.0, 10.0], vec![f64::NAN; 101], [0.0, 10.0]), "too-few-samples");
        assert_eq!(codes([0.0, 10.0], vec![f64::INFINITY; 101], [0.0, 10.0]), "invalid-number");
        assert_eq!(codes([5.0, 1.0], ones(101), [0.0, 10.0]), "invalid-number");
        assert_eq!(codes([0.0, 10.0], ones(1), [0.0, 10.0]), "wrong-count");
        assert_eq!(codes([0.0, 10.0], Vec::new(), [0.0, 10.0]), "wrong-count");
    }
}
