//! How much the results of a measurement scatter: the same tool measured again and again with other noise, each time evaluated whole.

use super::{Evaluation, MeasuredTool, ProfileOptions, correction, evaluate_measured, measured_tool_near};
use crate::measuring::{BarrierData, FlankTracks, Noise, Sense, Switches, readings};
use crate::{Setting, SettingFit, SettingLimits, SkivingError};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::Progress;
use rayon::prelude::*;

/// A measurement that can be repeated.
#[derive(Clone, Copy, Debug)]
pub struct Repeated<'a> {
    /// Tracks and poses.
    pub flanks: &'a Sides<FlankTracks>,
    /// Where the tool switches without noise.
    pub switches: &'a Switches,
    /// Light barrier, spindle, encoder.
    pub data: &'a BarrierData,
    /// Senses of the spindle.
    pub senses: &'a [Sense],
    /// Revolutions in each sense.
    pub revolutions: usize,
    /// r_L - r_eff, mm; see [`measured_tool_near`].
    pub radius_offset: f64,
    /// How the tool is clamped, rad, so that its teeth keep their numbers; see [`measured_tool_near`].
    pub clocking: f64,
    /// What the tool is judged by.
    pub options: &'a ProfileOptions,
    /// Settings that the correction may change, and how far.
    pub settings: (&'a [Setting], &'a SettingLimits),
}

/// A result of an evaluation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// f_z at a flank, track and tooth, mm.
    Deviation(Flank, usize, usize),
    /// f_r averaged over the teeth of a track, mm.
    TrackMean(Flank, usize),
    /// f_p of a tooth, mm.
    SinglePitch(usize),
    /// F_p,k of a tooth, mm.
    CumulativePitch(usize),
    /// f_p,max, mm.
    LargestSinglePitch,
    /// F_p, mm.
    TotalPitch,
    /// Deviation of a tooth's thickness, mm.
    Thickness(usize),
    /// e_x, e_y, mm.
    Eccentricity(usize),
    /// om_x, om_y, rad.
    Wobble(usize),
    /// Change of a setting, mm or rad.
    Change(Setting),
}

/// How a result scatters, in the unit of the quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scatter {
    /// What.
    pub quantity: Quantity,
    /// Mean of all repetitions.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// Between these lie 95 % of the repetitions.
    pub interval: [f64; 2],
}

/// Repeats a measurement; the random numbers of repetition k begin at `seed` + k.
///
/// # Errors
/// Those of [`measured_tool_near`], [`evaluate`] and [`correction`].
pub fn repeat(
    measurement: &Repeated<'_>,
    count: usize,
    seed: u64,
    progress: &dyn Progress,
) -> Result<Vec<Scatter>, SkivingError> {
    progress.start("Monte Carlo", count as u64);
    let once = |k: usize| {
        let found = measurement.once(seed.wrapping_add(k as u64));
        progress.advance(1);
        found
    };
    let runs = (0..count).into_par_iter().map(once).collect::<Result<Vec<_>, SkivingError>>()?;
    progress.finish();
    let Some(first) = runs.first() else { return Ok(Vec::new()) };
    let scatter = |(n, quantity): (usize, Quantity)| {
        let mut values: Vec<f64> = runs.iter().map(|run| run[n].1).collect();
        values.sort_by(f64::total_cmp);
        let mean = values.iter().sum::<f64>() / count as f64;
        let squares: f64 = values.iter().map(|x| (x - mean).powi(2)).sum();
        let at = |share: f64| values[((count - 1) as f64 * share).round() as usize];
        Scatter {
            quantity,
            mean,
            deviation: (squares / (count.max(2) - 1) as f64).sqrt(),
            interval: [at(0.025), at(0.975)],
        }
    };
    Ok(first.iter().map(|(quantity, _)| *quantity).enumerate().map(scatter).collect())
}

impl Repeated<'_> {
    /// The tool as it is measured with the noise that begins at `seed`.
    ///
    /// # Errors
    /// Those of [`measured_tool_near`].
    pub fn measured(&self, seed: u64) -> Result<MeasuredTool, SkivingError> {
        let mut noise = Noise::new(seed);
        let seen = readings(self.flanks, self.switches, self.data, self.senses, self.revolutions, &mut noise);
        measured_tool_near(self.flanks, &seen, self.radius_offset, self.clocking)
    }

    fn once(&self, seed: u64) -> Result<Vec<(Quantity, f64)>, SkivingError> {
        let measured = self.measured(seed)?;
        let found = evaluate_measured(self.flanks, &measured, self.options)?;
        let fit = correction(self.flanks, &found, self.settings)?;
        Ok(results(&found, self.settings.0, &fit))
    }
}

/// All results of an evaluation in one order.
fn results(found: &Evaluation, free: &[Setting], fit: &SettingFit) -> Vec<(Quantity, f64)> {
    let mut list: Vec<(Quantity, f64)> = found
        .clocked
        .iter()
        .map(|(flank, track, tooth, f)| (Quantity::Deviation(flank, track, tooth), f))
        .collect();
    for (flank, means) in found.profile.track_means.iter() {
        list.extend(means.iter().enumerate().map(|(track, f)| (Quantity::TrackMean(flank, track), *f)));
    }
    let pitch = &found.pitch;
    let of_teeth = |quantity: fn(usize) -> Quantity, values: &[f64]| -> Vec<(Quantity, f64)> {
        values.iter().enumerate().map(|(tooth, value)| (quantity(tooth), *value)).collect()
    };
    list.extend(of_teeth(Quantity::SinglePitch, &pitch.single));
    list.extend(of_teeth(Quantity::CumulativePitch, &pitch.cumulative));
    list.extend(of_teeth(Quantity::Thickness, &pitch.thickness));
    list.push((Quantity::LargestSinglePitch, pitch.largest_single));
    list.push((Quantity::TotalPitch, pitch.total));
    list.extend(of_teeth(Quantity::Eccentricity, &found.mounting.eccentricity));
    list.extend(of_teeth(Quantity::Wobble, &found.mounting.wobble));
    list.extend(free.iter().map(|setting| (Quantity::Change(*setting), fit.change[*setting as usize])));
    list
}
