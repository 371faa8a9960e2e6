//! The measurement repeated with other noise: names and units of what scatters, beside what was predicted.

use super::finding::failure;
use super::measurement::Measurement;
use super::prepare::SkivingBodies;
use super::result::{MonteCarloResult, ScatterResult};
use crate::Setting;
use crate::evaluation::{Quantity, Scatter, repeat};
use crate::job::MonteCarlo;
use foundation::numerics::Progress;
use run::RunFailure;

/// Repeats a measurement.
///
/// # Errors
/// [`RunFailure`] where noise takes a switch to another tooth.
pub(super) fn monte_carlo(
    given: &MonteCarlo,
    bodies: &SkivingBodies,
    measurement: &Measurement,
    progress: &dyn Progress,
) -> Result<MonteCarloResult, RunFailure> {
    let repeated = measurement.repeated(bodies);
    let found =
        repeat(&repeated, given.measurements, given.seed, progress).map_err(|error| failure(&error))?;
    let results = found.iter().map(|scatter| result(bodies, measurement, scatter)).collect();
    Ok(MonteCarloResult { measurements: given.measurements, results })
}

fn result(bodies: &SkivingBodies, measurement: &Measurement, scatter: &Scatter) -> ScatterResult {
    let (name, unit, scale) = named(scatter.quantity);
    ScatterResult {
        name,
        unit,
        mean: scale * scatter.mean,
        sigma: scale * scatter.deviation,
        stated_sigma: stated(bodies, measurement, scatter.quantity).map(|sigma| scale * sigma),
        interval: scatter.interval.map(|x| scale * x),
    }
}

/// Name, unit, and what takes mm or rad to it.
fn named(quantity: Quantity) -> (String, &'static str, f64) {
    let um = |name: String| (name, "um", 1e3);
    let axis = |k: usize| if k == 0 { "x" } else { "y" };
    match quantity {
        Quantity::Deviation(flank, track, tooth) => {
            um(format!("f {flank} track {} tooth {tooth}", track + 1))
        }
        Quantity::TrackMean(flank, track) => um(format!("track mean {flank} {}", track + 1)),
        Quantity::SinglePitch(tooth) => um(format!("f_p tooth {tooth}")),
        Quantity::CumulativePitch(tooth) => um(format!("F_p,k tooth {tooth}")),
        Quantity::LargestSinglePitch => um("f_p,max".into()),
        Quantity::TotalPitch => um("F_p".into()),
        Quantity::Thickness(tooth) => um(format!("thickness tooth {tooth}")),
        Quantity::Eccentricity(k) => um(format!("eccentricity {}", axis(k))),
        Quantity::Wobble(k) => (format!("wobble {}", axis(k)), "urad", 1e6),
        Quantity::Change(setting) => match setting {
            Setting::CentreDistance => um("correction centre distance".into()),
            Setting::ToolShift => um("correction tool shift".into()),
            Setting::CrossedAxesAngle => ("correction crossed-axes angle".into(), "deg", 1f64.to_degrees()),
            Setting::ToolAngle => ("correction tool angle".into(), "deg", 1f64.to_degrees()),
        },
    }
}

/// What the readings' own standard deviation tells before, mm or rad.
fn stated(bodies: &SkivingBodies, measurement: &Measurement, quantity: Quantity) -> Option<f64> {
    let sigma = measurement.deviations(bodies);
    let teeth = bodies.teeth() as f64;
    let mean_square: f64 = {
        let all: Vec<f64> = sigma.iter().flat_map(|(_, of)| of.iter().copied()).collect();
        all.iter().map(|s| s * s).sum::<f64>() / all.len().max(1) as f64
    };
    let per_noise = &measurement.evaluation.mounting.deviation_per_noise;
    let of_mounting = |k: usize| Some(per_noise[k] * mean_square.sqrt()).filter(|s| s.is_finite());
    match quantity {
        Quantity::Deviation(flank, track, _) => Some(sigma[flank][track]),
        Quantity::TrackMean(flank, track) => Some(sigma[flank][track] / teeth.sqrt()),
        Quantity::Eccentricity(k) => of_mounting(k),
        Quantity::Wobble(k) => of_mounting(k + 2),
        _ => None,
    }
}
