//! Deviations normal to the flank at the contact points, tooth by tooth, from readings of both senses and several revolutions.

use super::assignment::assigned;
use crate::geometry::{Flank, Sides};
use crate::process::skiving::SkivingError;
use crate::process::skiving::measuring::{FlankTracks, Reading, Sense};
use std::collections::BTreeMap;

/// A number for every flank, track and tooth.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviations {
    /// [track][tooth] of each flank.
    pub of: Sides<Vec<Vec<f64>>>,
}

/// What a measurement gives. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredTool {
    /// f: > 0 is material beyond the nominal edge.
    pub deviations: Deviations,
    /// Mean over the teeth of f(-) - f(+) of every track, where both senses were measured: delay and hysteresis of the barrier.
    pub sense_difference: Option<Sides<Vec<f64>>>,
    /// Readings that went into each number.
    pub readings_each: usize,
}

impl Deviations {
    /// Number of teeth.
    pub fn teeth(&self) -> usize {
        self.of.left.first().map_or(0, Vec::len)
    }

    /// Flank, track, tooth and number, the left flank first.
    pub fn iter(&self) -> impl Iterator<Item = (Flank, usize, usize, f64)> + '_ {
        [Flank::Left, Flank::Right].into_iter().flat_map(move |flank| {
            self.of[flank].iter().enumerate().flat_map(move |(track, teeth)| {
                teeth.iter().enumerate().map(move |(tooth, f)| (flank, track, tooth, *f))
            })
        })
    }

    /// A number of each number and its place.
    pub fn map(&self, of: impl Fn(Flank, usize, usize, f64) -> f64) -> Self {
        let flank = |flank: Flank| {
            let teeth = |(track, row): (usize, &Vec<f64>)| {
                row.iter().enumerate().map(|(tooth, f)| of(flank, track, tooth, *f)).collect()
            };
            self.of[flank].iter().enumerate().map(teeth).collect()
        };
        Self { of: Sides { left: flank(Flank::Left), right: flank(Flank::Right) } }
    }

    /// Mean of all.
    pub fn mean(&self) -> f64 {
        let (sum, count) = self.iter().fold((0.0, 0.0), |(sum, count), (.., f)| (sum + f, count + 1.0));
        sum / count
    }
}

/// Deviations of a measured tool. `radius_offset` is r_L - r_eff of the positive lever in the positive sense, mm, where calibration
/// knows it; it has the opposite sign where the flank leaves the beam.
///
/// # Errors
/// [`SkivingError::TriggerCountMismatch`] (also for a track without readings), [`SkivingError::AmbiguousTooth`],
/// [`SkivingError::InvalidNumber`] for a reading that is not finite.
pub fn measured_tool(
    flanks: &Sides<FlankTracks>,
    readings: &[Reading],
    radius_offset: f64,
) -> Result<MeasuredTool, SkivingError> {
    let teeth = flanks.left.edge.pair().tool().teeth() as usize;
    let mut turns: BTreeMap<(usize, usize, Sense, usize), Vec<f64>> = BTreeMap::new();
    for reading in readings {
        if !reading.angle.is_finite() {
            let (field, value) = ("angle", reading.angle);
            return Err(SkivingError::InvalidNumber { field, value, allowed: "a finite angle" });
        }
        let flank = usize::from(reading.flank == Flank::Right);
        turns
            .entry((flank, reading.track, reading.sense, reading.revolution))
            .or_default()
            .push(reading.angle);
    }
    let mut fewest = usize::MAX;
    let mut both = true;
    let mut of_flank = |flank: Flank| {
        let side = usize::from(flank == Flank::Right);
        let mut rows = Vec::new();
        let mut differences = Vec::new();
        for (number, (track, pose)) in flanks[flank].tracks.iter().enumerate() {
            let lever = track.contact.lever;
            let mut of_sense = Vec::new();
            for sense in Sense::BOTH {
                let from = (side, number, sense, 0);
                let to = (side, number, sense, usize::MAX);
                let mut sums = vec![0.0; teeth];
                let mut count = 0;
                for angles in turns.range(from..=to).map(|(_, angles)| angles) {
                    let off = assigned(angles, pose.turn, teeth, (flank, number))?;
                    sums.iter_mut().zip(off).for_each(|(sum, off)| *sum += off);
                    count += 1;
                }
                if count > 0 {
                    let offset = radius_offset * (lever * sense.sign()).signum();
                    let mean: Vec<f64> =
                        sums.iter().map(|sum| offset - lever * sum / f64::from(count)).collect();
                    of_sense.push((mean, count as usize));
                }
            }
            if of_sense.is_empty() {
                return Err(SkivingError::TriggerCountMismatch { flank, track: number, found: 0, teeth });
            }
            fewest = fewest.min(of_sense.iter().map(|(_, count)| count).sum());
            let mean = |values: [&[f64]; 2]| -> Vec<f64> {
                values[0].iter().zip(values[1]).map(|(a, b)| 0.5 * (a + b)).collect()
            };
            match of_sense.as_slice() {
                [(plus, _), (minus, _)] => {
                    let sum: f64 = minus.iter().zip(plus).map(|(b, a)| b - a).sum();
                    differences.push(sum / teeth as f64);
                    rows.push(mean([plus, minus]));
                }
                _ => {
                    both = false;
                    rows.push(of_sense.remove(0).0);
                }
            }
        }
        Ok((rows, differences))
    };
    let (left, right) = (of_flank(Flank::Left)?, of_flank(Flank::Right)?);
    Ok(MeasuredTool {
        deviations: Deviations { of: Sides { left: left.0, right: right.0 } },
        sense_difference: both.then_some(Sides { left: left.1, right: right.1 }),
        readings_each: fewest,
    })
}
