//! What deviations of the dressing axes do to the worm's profile: each by itself, all at once, drawn at random
//! (`docs/mathematics/dressing.md#axes-and-their-deviations`).

use super::bodies::Bodies;
use super::crowning::Task;
use crate::job::{AxisDeviations, Distribution};
use crate::workflow::explore::Refused;
use dressing::{AXIS_NAMES, DressingError, Spread, Spreads, influence, spread_of_profile};
use foundation::geometry::Flank;
use foundation::numerics::{Silent, equidistant};
use generating::GeneratingError;
use schemars::JsonSchema;
use serde::Serialize;

/// The change that one axis makes.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AxisInfluence {
    /// Name of the axis, or `all`.
    pub axis: &'static str,
    /// Its deviation in degrees or mm; absent where all axes deviate.
    pub deviation: Option<f64>,
    /// Unit of `deviation`.
    pub unit: &'static str,
    /// Normal change of the modification over `w_mm` of the curve.
    pub f_n_um: Vec<f64>,
    /// Change at the start of the worm's profile, which grinds the tip of the gear.
    pub tip_um: f64,
    /// Change in the middle.
    pub middle_um: f64,
    /// Change at the end, which grinds the root of the gear.
    pub root_um: f64,
    /// Largest distance from the change by the first derivatives.
    pub beyond_first_order_um: f64,
}

/// Quantiles of random deviations at one level.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DeviationQuantile {
    /// Share of the draws that lie below.
    pub level: f64,
    /// Largest absolute change over the profile.
    pub largest_um: f64,
    /// Slope over the profile, end minus start.
    pub slope_um: f64,
    /// Height of the mean parabola over its chord.
    pub crowning_um: f64,
}

/// The deviations of one set of bodies.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DeviationCurve {
    /// What tells the bodies from the others; empty where nothing is compared.
    pub bodies: String,
    /// Lengths of roll on the worm.
    pub w_mm: Vec<f64>,
    /// The axes that deviate, and all at once.
    pub axes: Vec<AxisInfluence>,
    /// Distribution of the draws.
    pub distribution: &'static str,
    /// Number of draws.
    pub samples: usize,
    /// Their seed.
    pub seed: u64,
    /// Quantiles in ascending order.
    pub quantiles: Vec<DeviationQuantile>,
    /// Why there is no curve.
    pub refused: Option<Refused>,
}

impl DeviationCurve {
    /// The figures of the curve in one line.
    pub fn summary(&self) -> String {
        if let Some(refused) = &self.refused {
            return format!("{}: {}", refused.code, refused.text);
        }
        let largest = |axis: &AxisInfluence| axis.f_n_um.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
        let each: Vec<String> =
            self.axes.iter().map(|axis| format!("{} {:.3}", axis.axis, largest(axis))).collect();
        let high = self.quantiles.iter().find(|q| q.level == HIGH).map_or(f64::NAN, |q| q.largest_um);
        format!(
            "largest change um: {}; {} % of {} draws stay below {high:.3} um",
            each.join(", "),
            100.0 * HIGH,
            self.samples
        )
    }
}

/// Points over the profile.
const POINTS: usize = 25;
/// Levels of the quantiles; of them the one that the summary names.
const LEVELS: [f64; 5] = [0.01, 0.05, 0.5, HIGH, 0.99];
const HIGH: f64 = 0.95;

/// The deviations of one set of bodies, from the nominal kinematics.
pub fn curve(bodies: &Bodies, flank: Flank, given: &AxisDeviations) -> DeviationCurve {
    let mut curve = DeviationCurve {
        bodies: bodies.name.clone(),
        w_mm: Vec::new(),
        axes: Vec::new(),
        distribution: given.distribution.name(),
        samples: given.samples,
        seed: given.seed,
        quantiles: Vec::new(),
        refused: None,
    };
    let made = Task::new(bodies, flank).and_then(|(task, _)| {
        fill(&task, given, &mut curve).map_err(|error| Refused::from(&GeneratingError::from(error)))
    });
    curve.refused = made.err();
    curve
}

fn fill(task: &Task<'_>, given: &AxisDeviations, curve: &mut DeviationCurve) -> Result<(), DressingError> {
    let range = task.tool.flanks[task.flank].range;
    let w = equidistant([range.w_nf, range.w_na], POINTS);
    let all = given.values();
    let mut push = |axis, deviation: [f64; 4], shown: Option<f64>, unit| {
        let found = influence(task.tool, task.flank, [0.0; 4], deviation, &w)?;
        let beyond = (0..POINTS).map(|i| {
            let linear: f64 = found.first_order.iter().map(|f| f[i]).sum();
            (found.exact[i] - linear).abs()
        });
        let beyond = beyond.fold(0.0, f64::max);
        let um = |i: usize| found.exact[i] * 1e3;
        curve.axes.push(AxisInfluence {
            axis,
            deviation: shown,
            unit,
            tip_um: um(0),
            middle_um: um(POINTS / 2),
            root_um: um(POINTS - 1),
            f_n_um: (0..POINTS).map(um).collect(),
            beyond_first_order_um: beyond * 1e3,
        });
        Ok::<_, DressingError>(())
    };
    for j in (0..4).filter(|&j| all[j] != 0.0) {
        let mut one = [0.0; 4];
        one[j] = all[j];
        let (shown, unit) = if j < 2 { (all[j].to_degrees(), "deg") } else { (all[j], "mm") };
        push(AXIS_NAMES[j], one, Some(shown), unit)?;
    }
    push("all", all, None, "")?;
    curve.w_mm = w;
    let axes = all.map(|size| match given.distribution {
        Distribution::Normal => Spread::Normal(size),
        Distribution::Uniform => Spread::Uniform(size),
    });
    let spreads = Spreads { axes, samples: given.samples, seed: given.seed };
    let found = spread_of_profile(task.tool, [0.0; 4], &spreads, &LEVELS, &Silent)?;
    let quantiles = &found.quantiles[task.flank];
    curve.quantiles = (0..LEVELS.len())
        .map(|k| DeviationQuantile {
            level: LEVELS[k],
            largest_um: quantiles.largest[k] * 1e3,
            slope_um: quantiles.slope[k] * 1e3,
            crowning_um: quantiles.crowning[k] * 1e3,
        })
        .collect();
    Ok(())
}
