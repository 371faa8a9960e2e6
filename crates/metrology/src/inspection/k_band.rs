//! K-bands: limits along a trace between which it has to lie (`docs/mathematics/inspection.md#one-trace`).

use super::error::usable;
use super::{EvaluationRange, InspectionError, TraceSamples};
use foundation::numerics::extremes;

/// Limits over the abscissa, straight between their corners. mm; relative to the design.
#[derive(Clone, Debug, PartialEq)]
pub struct KBand {
    corners: Vec<[f64; 3]>,
}

/// What may be done with a trace before it is judged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BandFit {
    /// Shifted to lie best.
    Free,
    /// Shifted to 0 at this abscissa, mm.
    Fixed(f64),
}

/// How a trace lies in a band. mm
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BandVerdict {
    /// What was added to the trace.
    pub shift: f64,
    /// Least distance to a limit; < 0: by so much it leaves the band.
    pub margin: f64,
    /// First abscissa at which the distance is that small.
    pub worst_at: f64,
}

impl BandVerdict {
    /// Whether the trace lies in the band.
    pub fn passed(&self) -> bool {
        self.margin >= 0.0
    }
}

impl KBand {
    /// From corners at ascending abscissae with lower and upper limits, mm.
    ///
    /// # Errors
    /// [`InspectionError::WrongCount`], [`InspectionError::InvalidNumber`], [`InspectionError::BandCrossed`].
    pub fn new(abscissa: &[f64], lower: &[f64], upper: &[f64]) -> Result<Self, InspectionError> {
        let needed = abscissa.len().max(2);
        for (field, found) in [
            ("upper limits of the band", upper.len()),
            ("lower limits of the band", lower.len()),
            ("corners of the band", abscissa.len()),
        ] {
            if found != needed {
                return Err(InspectionError::WrongCount { field, found, needed });
            }
        }
        let mut corners: Vec<[f64; 3]> = Vec::with_capacity(needed);
        for ((&at, &lower), &upper) in abscissa.iter().zip(lower).zip(upper) {
            let ascends = corners.last().is_none_or(|last| last[0] < at);
            usable("abscissa of the band", at, ascends, "finite, ascending")?;
            for limit in [lower, upper] {
                usable("limit of the band", limit, true, "a finite deviation")?;
            }
            // Straight lines between corners cross only if they do at a corner.
            if lower > upper {
                return Err(InspectionError::BandCrossed { at, lower, upper });
            }
            corners.push([at, lower, upper]);
        }
        Ok(Self { corners })
    }

    /// Corners [abscissa, lower, upper], mm.
    pub fn corners(&self) -> &[[f64; 3]] {
        &self.corners
    }

    /// From the first corner to the last.
    fn range(&self) -> Result<EvaluationRange, InspectionError> {
        EvaluationRange::new(self.corners[0][0], self.corners[self.corners.len() - 1][0])
    }

    /// [lower, upper] at an abscissa, mm; beyond the ends the limits there.
    pub fn limits(&self, a: f64) -> [f64; 2] {
        let after = self.corners.partition_point(|corner| corner[0] < a).clamp(1, self.corners.len() - 1);
        let [p, q] = [self.corners[after - 1], self.corners[after]];
        let share = ((a - p[0]) / (q[0] - p[0])).clamp(0.0, 1.0);
        [1, 2].map(|k| p[k] * (1.0 - share) + q[k] * share)
    }

    /// How the samples of a trace between the band's ends lie in it.
    ///
    /// # Errors
    /// [`InspectionError::TooFewSamples`], [`InspectionError::TraceIncomplete`]; [`InspectionError::InvalidNumber`] for a zero outside
    /// the band.
    pub fn judge(&self, trace: &TraceSamples, fit: BandFit) -> Result<BandVerdict, InspectionError> {
        let range = self.range()?;
        let within = trace.within(&range)?;
        let samples: Vec<[f64; 3]> = within
            .abscissa
            .iter()
            .zip(&within.deviation)
            .map(|(&a, &f)| {
                let [lower, upper] = self.limits(a);
                [a, lower - f, upper - f]
            })
            .collect();
        let least_shift = extremes(samples.iter().map(|s| s[1]))[1];
        let greatest_shift = extremes(samples.iter().map(|s| s[2]))[0];
        let shift = match fit {
            BandFit::Free => (least_shift + greatest_shift) / 2.0,
            BandFit::Fixed(zero) => {
                let slack = range.slack();
                let inside = (range.from() - slack..=range.to() + slack).contains(&zero);
                usable("zero of the trace in the band", zero, inside, "between the ends of the band")?;
                -value_at(&within.abscissa, &within.deviation, zero)
            }
        };
        let margin = (shift - least_shift).min(greatest_shift - shift);
        // Both limits are equally near in the best place: rounding must not choose between them.
        let reached = |s: &&[f64; 3]| (shift - s[1]).min(s[2] - shift) <= margin + 1e-12;
        let worst_at = samples.iter().find(reached).map_or(f64::NAN, |s| s[0]);
        Ok(BandVerdict { shift, margin, worst_at })
    }
}

/// Linear interpolation between samples.
fn value_at(abscissa: &[f64], values: &[f64], a: f64) -> f64 {
    let after = abscissa.partition_point(|x| *x < a).clamp(1, abscissa.len() - 1);
    let share = ((a - abscissa[after - 1]) / (abscissa[after] - abscissa[after - 1])).clamp(0.0, 1.0);
    values[after - 1] * (1.0 - share) + values[after] * share
}

#[cfg(test)]
mod tests {
    use super::*;

    fn band() -> KBand {
        KBand::new(&[0.0, 6.0, 10.0], &[-2.0, -2.0, -10.0], &[2.0, 2.0, -2.0]).unwrap()
    }

    fn trace(f: impl Fn(f64) -> f64) -> TraceSamples {
        let a: Vec<f64> = (-5..=105).map(|k| 0.1 * f64::from(k)).collect();
        TraceSamples::new(a.clone(), a.into_iter().map(f).collect()).unwrap()
    }

    #[test]
    fn limits_are_straight_between_corners() {
        for (a, limits) in [(0.0, [-2.0, 2.0]), (3.0, [-2.0, 2.0]), (8.0, [-6.0, 0.0]), (11.0, [-10.0, -2.0])]
        {
            assert_eq!(band().limits(a), limits);
        }
    }

    #[test]
    fn a_free_trace_lies_as_far_from_one_limit_as_from_the_other() {
        let relief = |a: f64| -2.0 * (a - 6.0).max(0.0);
        let trace = trace(|a| 5.0 + relief(a) + if (a - 4.0).abs() < 0.01 { 1.0 } else { 0.0 });
        let verdict = band().judge(&trace, BandFit::Free).unwrap();
        // The band after a shift by -5: upper limit 1 off at the spike, lower limit 2 off elsewhere, at the tip -8 between -10 and -2.
        assert!((verdict.shift + 5.5).abs() < 1e-12 && (verdict.margin - 1.5).abs() < 1e-12);
        assert!(verdict.passed() && verdict.worst_at == 0.0);
        // What lies beyond the band does not count.
        let verdict = band().judge(&trace, BandFit::Fixed(3.0)).unwrap();
        assert!((verdict.shift + 5.0).abs() < 1e-12 && (verdict.margin - 1.0).abs() < 1e-12);
        assert!((verdict.worst_at - 4.0).abs() < 1e-12);
    }

    #[test]
    fn a_trace_taller_than_the_band_fails_by_half_the_excess() {
        let verdict = band().judge(&trace(|a| if a < 5.0 { 3.0 } else { -3.0 }), BandFit::Free).unwrap();
        assert!(!verdict.passed());
        assert!((verdict.margin + 1.0).abs() < 1e-12, "{verdict:?}");
    }

    #[test]
    fn bad_bands_are_refused() {
        let code = |a: &[f64], l: &[f64], u: &[f64]| KBand::new(a, l, u).unwrap_err().code();
        assert_eq!(code(&[0.0, 1.0], &[0.0, 3.0], &[1.0, 2.0]), "band-crossed");
        assert_eq!(code(&[0.0, 0.0], &[0.0, 0.0], &[1.0, 1.0]), "invalid-number");
        assert_eq!(code(&[0.0, 1.0], &[0.0, f64::NAN], &[1.0, 1.0]), "invalid-number");
        assert_eq!(code(&[0.0, 1.0], &[0.0], &[1.0, 1.0]), "wrong-count");
        assert_eq!(code(&[0.0], &[0.0], &[1.0]), "wrong-count");
        let outside = band().judge(&trace(|_| 0.0), BandFit::Fixed(11.0));
        assert_eq!(outside.unwrap_err().code(), "invalid-number");
        let long = KBand::new(&[0.0, 30.0], &[-1.0, -1.0], &[1.0, 1.0]).unwrap();
        assert_eq!(long.judge(&trace(|_| 0.0), BandFit::Free).unwrap_err().code(), "trace-incomplete");
    }
}
