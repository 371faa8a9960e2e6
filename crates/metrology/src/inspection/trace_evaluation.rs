//! One trace of a flank to ISO 1328-1: total, form and slope deviation, crowning, relief (`docs/mathematics/inspection.md#one-trace`).

use super::error::usable;
use super::line::Parabola;
use super::{EvaluationRange, InspectionError, Line, Slope, SlopeReference, SlopeRule, TraceSamples};
use foundation::numerics::extremes;

/// What a trace is in a range. mm; against the design if it was subtracted before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceEvaluation {
    /// Evaluation range.
    pub range: EvaluationRange,
    /// Samples that count.
    pub samples: usize,
    /// Samples in the range that were not measured.
    pub undefined: usize,
    /// F: range of the deviations.
    pub total: f64,
    /// f_f: range of the deviations from the line. It may exceed F.
    pub form: f64,
    /// The line by least squares.
    pub line: Line,
    /// f_H.
    pub slope: Slope,
    /// Crowning.
    pub crowning: TraceCrowning,
    /// Mean step of the samples, mm.
    pub step: f64,
}

/// The parabola through a trace. mm
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceCrowning {
    /// C: height of the parabola over the chord of the range, > 0 convex.
    pub height: f64,
    /// Slope of the parabola's chord.
    pub slope: Slope,
    /// Range of the deviations from the parabola.
    pub form: f64,
}

/// A relief at the tip, the root or an end of the face, against the line of the evaluation range. mm
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relief {
    /// Line of the zone above the line of the range at the far end of the zone; < 0 relieved.
    pub amount: f64,
    /// Where the two lines cross; `None` if they are parallel.
    pub start: Option<f64>,
    /// Line through the zone.
    pub line: Line,
}

/// Evaluates a trace in a range.
///
/// # Errors
/// [`InspectionError::TooFewSamples`], [`InspectionError::TraceIncomplete`], [`InspectionError::InvalidNumber`] for a reference
/// length that is not above 0.
pub fn evaluate_trace(
    trace: &TraceSamples,
    range: EvaluationRange,
    rule: SlopeRule,
) -> Result<TraceEvaluation, InspectionError> {
    if let SlopeReference::FaceWidth(length) | SlopeReference::Given(length) = rule.reference {
        usable("reference length of the slope", length, length > 0.0, "> 0 mm")?;
    }
    let within = trace.within(&range)?;
    let (a, f) = (&within.abscissa, &within.deviation);
    let line = Line::through(a, f);
    let u: Vec<f64> = a.iter().map(|a| range.unit(*a)).collect();
    let parabola = Parabola::through(&u, f);
    let [_, p1, p2] = parabola.0;
    let counted = |gradient| rule.slope(gradient, range.length());
    Ok(TraceEvaluation {
        range,
        samples: a.len(),
        undefined: within.undefined,
        total: spread(f.iter().copied()),
        form: spread(a.iter().zip(f).map(|(a, f)| f - line.at(*a))),
        line,
        slope: counted(line.gradient),
        crowning: TraceCrowning {
            height: -p2,
            slope: counted(2.0 * p1 / range.length()),
            form: spread(u.iter().zip(f).map(|(u, f)| f - parabola.at(*u))),
        },
        step: (a[a.len() - 1] - a[0]) / (a.len() - 1) as f64,
    })
}

impl TraceEvaluation {
    /// u(f_H)/sigma for noise that differs from sample to sample.
    pub fn slope_uncertainty_factor(&self) -> f64 {
        self.slope.length / self.line.spread
    }

    /// u(f_H), mm, for noise of standard deviation `sigma`, mm. Samples that the machine has smoothed count as fewer: give the length,
    /// mm, over which the noise of neighbours is alike.
    pub fn slope_uncertainty(&self, sigma: f64, correlation_length: Option<f64>) -> f64 {
        let alike = correlation_length.map_or(1.0, |length| (length / self.step).max(1.0));
        self.slope_uncertainty_factor() * sigma * alike.sqrt()
    }

    /// The relief in a zone of the same trace, from its near end to its far end (root or lower end of the face: far < near).
    ///
    /// # Errors
    /// Those of [`EvaluationRange::new`] and of [`evaluate_trace`].
    pub fn relief(&self, trace: &TraceSamples, [near, far]: [f64; 2]) -> Result<Relief, InspectionError> {
        let within = trace.within(&EvaluationRange::new(near.min(far), near.max(far))?)?;
        let line = Line::through(&within.abscissa, &within.deviation);
        Ok(Relief { amount: line.at(far) - self.line.at(far), start: line.crossing(&self.line), line })
    }
}

/// Greatest less least.
fn spread(values: impl Iterator<Item = f64>) -> f64 {
    let [least, greatest] = extremes(values);
    greatest - least
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::geometry::Flank;

    fn trace(n: usize, f: impl Fn(f64) -> f64) -> TraceSamples {
        let a = foundation::numerics::equidistant([0.0, 10.0], n);
        TraceSamples::new(a.clone(), a.into_iter().map(f).collect()).unwrap()
    }

    fn of(trace: &TraceSamples, range: [f64; 2]) -> TraceEvaluation {
        let rule =
            SlopeRule { reference: SlopeReference::FaceWidth(20.0), ..SlopeRule::profile(Flank::Left) };
        evaluate_trace(trace, EvaluationRange::new(range[0], range[1]).unwrap(), rule).unwrap()
    }

    fn near(got: f64, want: f64) {
        assert!((got - want).abs() < 1e-14, "{got} {want}");
    }

    #[test]
    fn slope_and_crowning_are_recovered() {
        let range = EvaluationRange::new(1.0, 9.0).unwrap();
        let e = of(&trace(101, |a| 0.004 * (1.0 - range.unit(a).powi(2)) + 1e-3 * a), [1.0, 9.0]);
        near(e.slope.material(), 0.02);
        near(e.crowning.slope.material(), 0.02);
        near(e.crowning.height, 0.004);
        near(e.crowning.form, 0.0);
        assert!(e.total > e.form && e.form > 0.003 && (e.samples, e.undefined) == (81, 0));
        near(e.step, 0.1);
    }

    #[test]
    fn a_step_has_more_form_than_total_deviation() {
        // The line of least squares, not the band of least width: f_f > F is no fault.
        let e = of(&trace(101, |a| f64::from(u8::from(a > 0.05 && a < 3.25))), [0.0, 10.0]);
        assert!(e.form > 1.3 * e.total, "{} {}", e.form, e.total);
    }

    #[test]
    fn the_design_is_subtracted_first() {
        let made = |a: f64| 2e-3 * (0.3 * a).sin();
        let plain = of(&trace(101, made), [1.0, 9.0]);
        let against = of(&trace(101, |a| made(a) - 0.02 * a * a).against(|a| -0.02 * a * a), [1.0, 9.0]);
        near(plain.form, against.form);
        near(plain.slope.material(), against.slope.material());
    }

    #[test]
    fn reliefs_of_tip_and_root_are_read_at_their_far_ends() {
        let trace = trace(201, |a| 1e-3 * a - 4e-3 * (a - 7.0).max(0.0) - 2e-3 * (2.0 - a).max(0.0));
        let e = of(&trace, [2.0, 7.0]);
        let [tip, root] = [[7.0, 9.5], [2.0, 0.5]].map(|zone| e.relief(&trace, zone).unwrap());
        for (relief, amount, start) in [(tip, -0.010, 7.0), (root, -0.003, 2.0)] {
            near(relief.amount, amount);
            assert!((relief.start.unwrap() - start).abs() < 1e-12);
        }
        near(tip.line.gradient, -3e-3);
        assert_eq!(e.relief(&trace, [7.0, 7.0]).unwrap_err().code(), "empty-range");
        assert_eq!(e.relief(&trace, [9.8, 10.0]).unwrap_err().code(), "too-few-samples");
    }

    #[test]
    fn the_uncertainty_of_a_slope_is_what_noise_makes_of_it() {
        // The variance of a linear function of independent samples, sample by sample.
        let (n, range) = (81, [1.0, 9.0]);
        let plain = of(&trace(101, |_| 0.0), range);
        let variance: f64 = (0..n)
            .map(|k| 1.0 + 0.1 * f64::from(k))
            .map(|at| of(&trace(101, |a| f64::from(u8::from((a - at).abs() < 1e-6))), range).slope.material())
            .map(|effect| effect * effect)
            .sum();
        assert!((plain.slope_uncertainty_factor() - variance.sqrt()).abs() < 1e-12);
        near(plain.slope_uncertainty(2e-3, Some(0.9)), 3.0 * plain.slope_uncertainty(2e-3, None));
    }

    #[test]
    fn a_reference_length_of_nothing_is_refused() {
        let rule = SlopeRule { reference: SlopeReference::FaceWidth(0.0), ..SlopeRule::profile(Flank::Left) };
        let range = EvaluationRange::new(1.0, 9.0).unwrap();
        let error = evaluate_trace(&trace(101, |_| 0.0), range, rule).unwrap_err();
        assert_eq!(error.code(), "invalid-number");
    }
}
