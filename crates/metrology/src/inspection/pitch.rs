//! Pitch deviations of one flank to ISO 1328-1, from the single pitches of all teeth
//! (`docs/mathematics/inspection.md#pitch-run-out-eccentricity`).

use super::InspectionError;
use super::error::usable;
use super::harmonic::Harmonic;
use super::rounding::round_to;
use foundation::geometry::Sides;
use foundation::numerics::extremes;

/// Fewest teeth whose pitch is judged.
const FEWEST: usize = 5;

/// How far the single pitches of a revolution may be from adding up to nothing, mm a tooth.
const CLOSURE: f64 = 0.05e-3;

/// Single pitch deviations of all teeth of a flank, tooth 1 first. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct PitchDeviations {
    single: Vec<f64>,
}

/// What the pitch of a flank comes to. mm; teeth count from 1.
#[derive(Clone, Debug, PartialEq)]
pub struct PitchEvaluation {
    /// fp: largest single pitch deviation.
    pub single: f64,
    /// fu: largest difference of neighbouring pitches.
    pub neighbours: f64,
    /// Rp: greatest less least single pitch deviation.
    pub single_range: f64,
    /// Fp_i: deviations of the teeth against the last one.
    pub cumulative: Vec<f64>,
    /// Fp: total cumulative pitch deviation, the largest of any sector.
    pub total: f64,
    /// Tooth with the least Fp_i.
    pub least_at: usize,
    /// Tooth with the greatest Fp_i.
    pub greatest_at: usize,
    /// k: pitches of a sector.
    pub sector_pitches: usize,
    /// Fpk: largest deviation over a sector of k pitches.
    pub sector: f64,
    /// Sum of the single pitch deviations.
    pub closure: f64,
    /// First harmonic of Fp_i: what an eccentricity leaves on one flank.
    pub first_harmonic: Harmonic,
}

impl PitchDeviations {
    /// From the single pitch deviations of a gear with so many teeth, mm; NaN where nothing was measured.
    ///
    /// # Errors
    /// [`InspectionError::TooFewTeeth`], [`InspectionError::PitchIncomplete`], [`InspectionError::PitchNotClosed`].
    pub fn new(single: Vec<f64>, teeth: usize) -> Result<Self, InspectionError> {
        complete(&single, teeth)?;
        let (sum, allowed) = (single.iter().sum::<f64>(), CLOSURE * teeth as f64);
        if sum.abs() > allowed {
            return Err(InspectionError::PitchNotClosed { sum, allowed });
        }
        Ok(Self { single })
    }

    /// From cumulative deviations Fp_i, mm: they close whatever they are.
    ///
    /// # Errors
    /// [`InspectionError::TooFewTeeth`], [`InspectionError::PitchIncomplete`].
    pub fn from_cumulative(cumulative: &[f64], teeth: usize) -> Result<Self, InspectionError> {
        complete(cumulative, teeth)?;
        let before = cumulative.iter().cycle().skip(teeth - 1);
        Self::new(cumulative.iter().zip(before).map(|(here, before)| here - before).collect(), teeth)
    }

    /// fp_i, mm, tooth 1 first.
    pub fn single(&self) -> &[f64] {
        &self.single
    }

    /// Fp_i: running sums, mm.
    pub fn cumulative(&self) -> Vec<f64> {
        let running = |sum: &mut f64, fp: &f64| {
            *sum += fp;
            Some(*sum)
        };
        self.single.iter().scan(0.0, running).collect()
    }

    /// Rp as a measuring machine prints it: of single pitches rounded to `quantum`, mm.
    pub fn printed_single_range(&self, quantum: f64) -> f64 {
        let [least, greatest] = extremes(self.single.iter().map(|fp| round_to(*fp, quantum)));
        round_to(greatest - least, quantum)
    }

    /// Evaluates the pitch; sectors have `sector` pitches, an eighth of the circumference by default.
    ///
    /// # Errors
    /// [`InspectionError::InvalidNumber`] for a sector without a pitch or of a whole revolution.
    pub fn evaluate(&self, sector: Option<usize>) -> Result<PitchEvaluation, InspectionError> {
        let (fp, z) = (&self.single, self.single.len());
        let k = sector.unwrap_or_else(|| default_sector(z));
        usable("pitches of a sector", k as f64, (1..z).contains(&k), "1 to teeth - 1")?;
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |m: f64, x| m.max(x.abs()));
        let cumulative = self.cumulative();
        let [least, greatest] = extremes(cumulative.iter().copied());
        let tooth_with = |value: f64| 1 + cumulative.iter().position(|x| *x == value).unwrap_or(0);
        let [low, high] = extremes(fp.iter().copied());
        let from = |tooth: usize| fp.iter().cycle().skip(tooth);
        Ok(PitchEvaluation {
            single: largest(&mut fp.iter().copied()),
            neighbours: largest(&mut fp.iter().zip(from(1)).map(|(a, b)| a - b)),
            single_range: high - low,
            total: greatest - least,
            least_at: tooth_with(least),
            greatest_at: tooth_with(greatest),
            sector_pitches: k,
            sector: largest(&mut (0..z).map(|tooth| from(tooth).take(k).sum())),
            closure: fp.iter().sum(),
            first_harmonic: Harmonic::of(&cumulative),
            cumulative,
        })
    }
}

/// Rs: how much the tooth thickness differs over the teeth, mm, from Fp_i of both flanks (of one length).
pub fn thickness_variation(cumulative: &Sides<Vec<f64>>) -> f64 {
    let [least, greatest] = extremes(cumulative.left.iter().zip(&cumulative.right).map(|(l, r)| l - r));
    greatest - least
}

/// Pitches in an eighth of the circumference, at least 2.
pub fn default_sector(teeth: usize) -> usize {
    ((teeth + 4) / 8).max(2)
}

/// A value of every tooth of a gear with enough of them.
pub(super) fn complete(values: &[f64], teeth: usize) -> Result<(), InspectionError> {
    if teeth < FEWEST {
        return Err(InspectionError::TooFewTeeth { found: teeth, needed: FEWEST });
    }
    let found = values.iter().filter(|x| x.is_finite()).count();
    if found != teeth || values.len() != teeth {
        return Err(InspectionError::PitchIncomplete { found, teeth });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use foundation::numerics::wrapped_angle;
    use std::f64::consts::TAU;

    #[test]
    fn all_quantities_of_a_small_wheel() {
        let deviations = PitchDeviations::new(vec![3.0, -1.0, 2.0, -5.0, 0.0, 1.0], 6).unwrap();
        let pitch = deviations.evaluate(None).unwrap();
        assert_eq!(pitch.cumulative, [3.0, 2.0, 4.0, -1.0, -1.0, 0.0]);
        assert_eq!((pitch.single, pitch.neighbours, pitch.single_range), (5.0, 7.0, 8.0));
        assert_eq!((pitch.total, pitch.least_at, pitch.greatest_at), (5.0, 4, 3));
        // Sectors of two pitches: 2 1 -3 -5 1 and, over the end of the list, 4.
        assert_eq!((pitch.sector_pitches, pitch.sector, pitch.closure), (2, 5.0, 0.0));
        assert_eq!(deviations.evaluate(Some(5)).unwrap().sector, 5.0);
        assert_eq!(PitchDeviations::from_cumulative(&pitch.cumulative, 6).unwrap(), deviations);
        let both = Sides { left: pitch.cumulative, right: vec![1.0, 2.0, 3.0, 4.0, 0.0, 0.0] };
        assert_eq!(thickness_variation(&both), 7.0);
    }

    #[test]
    fn no_sector_deviates_more_than_the_total() {
        let single: Vec<f64> =
            (0..37).map(|k| (f64::from(k) * 2.3).sin() - (f64::from(k + 1) * 2.3).sin()).collect();
        let closing = single.iter().sum::<f64>() / 37.0;
        let deviations = PitchDeviations::new(single.iter().map(|x| x - closing).collect(), 37).unwrap();
        let of = |k| deviations.evaluate(Some(k)).unwrap();
        let largest = (1..37).map(|k| of(k).sector).fold(0.0, f64::max);
        assert!((largest - of(2).total).abs() < 1e-12, "{largest} {}", of(2).total);
        // A sector and the rest of the revolution close.
        assert!((of(5).sector - of(32).sector).abs() < 1e-12);
    }

    #[test]
    fn the_first_harmonic_is_found() {
        let cumulative: Vec<f64> = (1..=23)
            .map(|i| {
                4.0 * (TAU * f64::from(i) / 23.0 - 2.0).cos() + 0.3 * (TAU * 5.0 * f64::from(i) / 23.0).sin()
            })
            .collect();
        let deviations = PitchDeviations::from_cumulative(&cumulative, 23).unwrap();
        let harmonic = deviations.evaluate(None).unwrap().first_harmonic;
        assert!((harmonic.amplitude() - 4.0).abs() < 1e-12);
        assert!(wrapped_angle(harmonic.phase() - 2.0).abs() < 1e-12);
    }

    #[test]
    fn sectors_are_an_eighth_of_the_circumference() {
        assert_eq!([5, 7, 19, 20, 51, 52, 100].map(default_sector), [2, 2, 2, 3, 6, 7, 13]);
    }

    #[test]
    fn printed_ranges_are_those_of_printed_pitches() {
        let deviations = PitchDeviations::new(vec![0.96e-3, -0.86e-3, -0.1e-3, 0.0, 0.0], 5).unwrap();
        assert!((deviations.printed_single_range(0.1e-3) - 1.9e-3).abs() < 1e-15);
        assert!((deviations.evaluate(None).unwrap().single_range - 1.82e-3).abs() < 1e-15);
    }

    #[test]
    fn bad_tables_are_refused() {
        let code = |fp: &[f64], teeth| PitchDeviations::new(fp.to_vec(), teeth).unwrap_err().code();
        assert_eq!(code(&[0.0; 4], 4), "too-few-teeth");
        assert_eq!(code(&[0.0; 7], 8), "pitch-incomplete");
        assert_eq!(code(&[0.0; 9], 8), "pitch-incomplete");
        assert_eq!(code(&[0.0, 0.0, f64::NAN, 0.0, 0.0], 5), "pitch-incomplete");
        assert_eq!(code(&[1e-4; 6], 6), "pitch-not-closed");
        assert_eq!(code(&[], 0), "too-few-teeth");
        assert!(PitchDeviations::new(vec![0.04e-3; 6], 6).is_ok());
        assert_eq!(PitchDeviations::from_cumulative(&[0.0; 4], 5).unwrap_err().code(), "pitch-incomplete");
        let good = PitchDeviations::new(vec![0.0; 6], 6).unwrap();
        for k in [0, 6] {
            assert_eq!(good.evaluate(Some(k)).unwrap_err().code(), "invalid-number");
        }
    }
}
