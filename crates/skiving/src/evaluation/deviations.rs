//! Deviations normal to the flank at the contact points, tooth by tooth, from readings of both senses and several revolutions.

use super::assignment::{assigned, clamped_at};
use crate::SkivingError;
use crate::measuring::{FlankTracks, Reading, Sense};
use foundation::geometry::{Flank, Sides};
use std::collections::{BTreeMap, BTreeSet};

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
    /// Standard deviation of each number of a track, from how the revolutions of every tooth differ; `None` with one revolution.
    pub repeatability: Option<Sides<Vec<f64>>>,
    /// Switches that are not there in any revolution, or in one of two senses; the number there is the mean of the track.
    pub missing: Vec<MissingSwitch>,
}

/// A tooth that did not switch on a track.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MissingSwitch {
    /// Flank.
    pub flank: Flank,
    /// Track, from 0.
    pub track: usize,
    /// Tooth.
    pub tooth: usize,
}

impl MeasuredTool {
    /// Teeth that lack a switch, ascending.
    pub fn incomplete(&self) -> Vec<usize> {
        let teeth: BTreeSet<usize> = self.missing.iter().map(|switch| switch.tooth).collect();
        teeth.into_iter().collect()
    }
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
/// As [`measured_tool_near`].
pub fn measured_tool(
    flanks: &Sides<FlankTracks>,
    readings: &[Reading],
    radius_offset: f64,
) -> Result<MeasuredTool, SkivingError> {
    measured_tool_near(flanks, readings, radius_offset, 0.0)
}

/// The same of a tool that is clamped anywhere: its tooth 0 is the one that stands nearest to its nominal place turned by `clocking`, rad,
/// counter-clockwise > 0.
///
/// # Errors
/// [`SkivingError::TriggerCountMismatch`] (also for a track without readings), [`SkivingError::AmbiguousTooth`],
/// [`SkivingError::InvalidNumber`] for a reading that is not finite.
pub fn measured_tool_near(
    flanks: &Sides<FlankTracks>,
    readings: &[Reading],
    radius_offset: f64,
    clocking: f64,
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
    let known = readings.iter().filter(|reading| reading.track < flanks[reading.flank].tracks.len());
    let away = known.map(|reading| reading.angle - flanks[reading.flank].tracks[reading.track].1.turn);
    let clamped = clamped_at(away, teeth, -clocking);
    let mut fewest = usize::MAX;
    let mut missing = Vec::new();
    let mut both = true;
    let mut of_flank = |flank: Flank| {
        let side = usize::from(flank == Flank::Right);
        let (mut rows, mut differences, mut repeated) = (Vec::new(), Vec::new(), Vec::new());
        for (number, (track, pose)) in flanks[flank].tracks.iter().enumerate() {
            let lever = track.contact.lever;
            let mut of_sense = Vec::new();
            for sense in Sense::BOTH {
                let from = (side, number, sense, 0);
                let to = (side, number, sense, usize::MAX);
                let mut seen = vec![Seen::default(); teeth];
                let mut count = 0;
                for angles in turns.range(from..=to).map(|(_, angles)| angles) {
                    let off = assigned(angles, (pose.turn, clamped), teeth, (flank, number))?;
                    seen.iter_mut().zip(off).for_each(|(seen, off)| seen.take(off));
                    count += 1;
                }
                if count > 0 {
                    of_sense.push((seen, count, radius_offset * (lever * sense.sign()).signum()));
                }
            }
            if of_sense.is_empty() {
                return Err(SkivingError::TriggerCountMismatch { flank, track: number, found: 0, teeth });
            }
            fewest = fewest.min(of_sense.iter().map(|(_, count, _)| *count).sum());
            let there = |tooth: usize| of_sense.iter().all(|(seen, ..)| seen[tooth].count > 0);
            let f =
                |(seen, _, offset): &(Vec<Seen>, usize, f64), tooth: usize| offset - lever * seen[tooth].mean;
            let of_tooth = |tooth: usize| {
                of_sense.iter().map(|sense| f(sense, tooth)).sum::<f64>() / of_sense.len() as f64
            };
            let present: Vec<usize> = (0..teeth).filter(|&tooth| there(tooth)).collect();
            if 2 * present.len() < teeth {
                let found = present.len();
                return Err(SkivingError::TriggerCountMismatch { flank, track: number, found, teeth });
            }
            let mean = |of: &dyn Fn(usize) -> f64| {
                present.iter().map(|&tooth| of(tooth)).sum::<f64>() / present.len() as f64
            };
            match of_sense.as_slice() {
                [plus, minus] => differences.push(mean(&|tooth| f(minus, tooth) - f(plus, tooth))),
                _ => both = false,
            }
            repeated.push(repeatability(&of_sense, lever));
            let fill = mean(&of_tooth);
            rows.push((0..teeth).map(|tooth| if there(tooth) { of_tooth(tooth) } else { fill }).collect());
            let absent = (0..teeth).filter(|&tooth| !there(tooth));
            missing.extend(absent.map(|tooth| MissingSwitch { flank, track: number, tooth }));
        }
        Ok((rows, differences, repeated))
    };
    let (left, right) = (of_flank(Flank::Left)?, of_flank(Flank::Right)?);
    let told = |of: Vec<Option<f64>>| of.into_iter().collect::<Option<Vec<f64>>>();
    Ok(MeasuredTool {
        deviations: Deviations { of: Sides { left: left.0, right: right.0 } },
        sense_difference: both.then_some(Sides { left: left.1, right: right.1 }),
        readings_each: fewest,
        repeatability: told(left.2).zip(told(right.2)).map(|(left, right)| Sides { left, right }),
        missing,
    })
}

/// What was read of a tooth in one sense: count, mean, and squares about it.
#[derive(Clone, Copy, Default)]
struct Seen {
    count: usize,
    mean: f64,
    squares: f64,
}

impl Seen {
    fn take(&mut self, off: Option<f64>) {
        let Some(off) = off else { return };
        self.count += 1;
        let step = off - self.mean;
        self.mean += step / self.count as f64;
        self.squares += step * (off - self.mean);
    }
}

/// Standard deviation of a tooth's number on a track, from how its revolutions differ, over all teeth together.
fn repeatability(of_sense: &[(Vec<Seen>, usize, f64)], lever: f64) -> Option<f64> {
    let mut variance = 0.0;
    for (seen, count, _) in of_sense {
        let squares: f64 = seen.iter().map(|tooth| tooth.squares).sum();
        let freedom: usize = seen.iter().map(|tooth| tooth.count.saturating_sub(1)).sum();
        if freedom == 0 {
            return None;
        }
        variance += squares / freedom as f64 / *count as f64;
    }
    Some(lever.abs() * variance.sqrt() / of_sense.len() as f64)
}
