//! Which axis of the machine a measurement points to: of each axis how far it would have to be off to explain best what was measured, and
//! how much of it that explains, and several axes at once where one is not enough (`docs/mathematics/inspection.md#which-axis`). Values come from the exact contact; the correction does
//! not use them.

use super::ground::Ground;
use super::lines::{MeanLine, uncertainties};
use super::result::{AxesTogether, AxisResult, JointAxis};
use foundation::geometry::{Flank, Sides};
use foundation::numerics::TensorSpline;
use generating_grinding::workflow::{Deviation, ForwardModel};
use nalgebra::{DMatrix, DVector};
use run::RunFailure;
use std::collections::BTreeMap;

/// Points over profile and face width of a pattern, and axes of the machine with a deviation of usual size in their own unit.
const GRID: [usize; 2] = [9, 11];
const AXES: [(Deviation, f64); 9] = [
    (Deviation::RadialFeed(1), 2.0),
    (Deviation::RadialFeed(2), 2.0),
    (Deviation::WorkAngle(1), 3.0),
    (Deviation::WorkAngle(2), 3.0),
    (Deviation::CrossingAngle, 0.002),
    (Deviation::Dressing(0), 0.01),
    (Deviation::Dressing(1), 0.005),
    (Deviation::Dressing(2), 2.0),
    (Deviation::Dressing(3), 20.0),
];
/// An axis is asked again at what was found, until that changes by no more than this share.
const SETTLED: f64 = 1e-3;
const ROUNDS: usize = 4;
/// Axes whose patterns agree to this (cosine of the angle between them) are not distinguished.
const ALIKE: f64 = 0.98;
/// An axis that explains less than this is not named.
const WORTH_NAMING: f64 = 0.1;

/// Points that were measured: place, line, value over its uncertainty and the uncertainty, mm.
struct Points<'a> {
    lines: &'a [MeanLine],
    known: Vec<f64>,
}

impl Points<'_> {
    /// Values over their uncertainties, each line about its mean.
    fn weighed(&self, value: impl Fn(Flank, f64, f64, f64) -> f64) -> Vec<f64> {
        let mut all = Vec::new();
        for (line, known) in self.lines.iter().zip(&self.known) {
            let values: Vec<f64> =
                line.points().map(|(at, measured)| value(at.flank, at.w, at.z, measured)).collect();
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            all.extend(values.iter().map(|value| (value - mean) / known));
        }
        all
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// What an axis that is off leaves, at the measured points.
struct Pattern {
    axis: Deviation,
    /// Deviation that was asked for last, in the axis' unit, and its pattern per unit.
    value: f64,
    per_unit: Vec<f64>,
}

/// What the measured lines say of the axes.
pub(super) struct Asked {
    /// The axes that explain something of the lines, the one that explains most first.
    pub alone: Vec<AxisResult>,
    /// Several that explain clearly more together than the best of them.
    pub together: Option<AxesTogether>,
    /// Those that could not be asked, with the reason: the model finds no contact with them off.
    pub not_asked: BTreeMap<String, String>,
}

/// The axes that explain something of the measured lines; nothing where nothing was measured beyond its uncertainty.
pub(super) fn axes(made: &Ground, lines: &[MeanLine]) -> Asked {
    let points = Points { lines, known: uncertainties(lines) };
    let measured = points.weighed(|_, _, _, measured| measured);
    let total = dot(&measured, &measured);
    let model = ForwardModel::of_run(made.prepared.clone(), made.execution.clone(), GRID);
    let (model, as_planned) = match model.and_then(|model| model.flanks(&[]).map(|flanks| (model, flanks))) {
        Ok(found) => found,
        Err(failure) => {
            let not_asked = AXES.iter().map(|(axis, _)| (axis.name(), why(&failure)));
            return Asked { alone: Vec::new(), together: None, not_asked: not_asked.collect() };
        }
    };
    let dressed = made.execution.dresser.is_some();
    let (mut found, mut not_asked) = (Vec::new(), BTreeMap::new());
    for (axis, usual) in AXES {
        if !dressed && matches!(axis, Deviation::Dressing(_)) {
            continue;
        }
        let mut pattern = Pattern { axis, value: usual, per_unit: Vec::new() };
        for _ in 0..ROUNDS {
            match at_points(&model, &as_planned, (axis, pattern.value), &points) {
                Ok(per_unit) => pattern.per_unit = per_unit,
                // The last pattern stays where there is one.
                Err(failure) => {
                    if pattern.per_unit.is_empty() {
                        not_asked.insert(axis.name(), why(&failure));
                    }
                    break;
                }
            }
            let best = dot(&measured, &pattern.per_unit) / dot(&pattern.per_unit, &pattern.per_unit);
            let settled = (best - pattern.value).abs() <= SETTLED * best.abs();
            // Far below the usual size a pattern is rounding.
            pattern.value = if best.abs() < 1e-3 * usual { 1e-3 * usual } else { best };
            if settled {
                break;
            }
        }
        if !pattern.per_unit.is_empty() {
            found.push(pattern);
        }
    }
    let freedom = measured.len().saturating_sub(lines.len() + 1).max(1) as f64;
    let together = together(&found, &measured, freedom);
    let mut results: Vec<AxisResult> = found
        .iter()
        .map(|of| {
            let size = dot(&of.per_unit, &of.per_unit);
            let left: Vec<f64> = measured.iter().zip(&of.per_unit).map(|(m, p)| m - of.value * p).collect();
            // What no axis explains is uncertainty too.
            let scatter = (dot(&left, &left) / freedom).max(1.0);
            let alike = |other: &&Pattern| {
                other.axis != of.axis
                    && dot(&of.per_unit, &other.per_unit).abs()
                        > ALIKE * (size * dot(&other.per_unit, &other.per_unit)).sqrt()
            };
            AxisResult {
                axis: of.axis.name(),
                value: of.value,
                uncertainty: (scatter / size).sqrt(),
                explains: 1.0 - dot(&left, &left) / total,
                not_told_apart: found.iter().filter(alike).map(|other| other.axis.name()).collect(),
            }
        })
        .filter(|axis| axis.explains > WORTH_NAMING && axis.value.abs() > 2.0 * axis.uncertainty)
        .collect();
    results.sort_by(|a, b| b.explains.total_cmp(&a.explains));
    Asked { alone: results, together, not_asked }
}

/// Axes are named together up to this many.
const MOST_TOGETHER: usize = 4;
/// A further axis has to take away this many times the scatter from the sum of squares: more than four standard uncertainties.
const CLEARLY: f64 = 16.0;

/// A fit of several axes.
struct Joint {
    values: DVector<f64>,
    /// Standard uncertainties where the scatter is 1.
    uncertainty: Vec<f64>,
    /// Sum of the squares that is left.
    left: f64,
}

/// Least squares of the measured values by patterns; `None` where these tell the axes apart no better than two that are
/// [`ALIKE`], or leave one of them within twice its uncertainty.
fn joint(patterns: &[&Pattern], measured: &[f64], freedom: f64) -> Option<Joint> {
    let count = patterns.len();
    let normal = DMatrix::from_fn(count, count, |i, k| dot(&patterns[i].per_unit, &patterns[k].per_unit));
    let right = DVector::from_fn(count, |i, _| dot(&patterns[i].per_unit, measured));
    // Units differ by orders of magnitude.
    let size: Vec<f64> = (0..count).map(|i| normal[(i, i)].sqrt()).collect();
    let scaled = DMatrix::from_fn(count, count, |i, k| normal[(i, k)] / (size[i] * size[k]));
    let inverse = scaled.cholesky()?.inverse();
    let values = DVector::from_fn(count, |i, _| {
        (0..count).map(|k| inverse[(i, k)] * right[k] / (size[i] * size[k])).sum::<f64>()
    });
    let uncertainty: Vec<f64> = (0..count).map(|i| inverse[(i, i)].sqrt() / size[i]).collect();
    let left = (dot(measured, measured) - values.dot(&right)).max(0.0);
    let scatter = (left / freedom).max(1.0).sqrt();
    let told_apart = (0..count).all(|i| inverse[(i, i)] < 1.0 / (1.0 - ALIKE * ALIKE));
    let certain = (0..count).all(|i| values[i].abs() > 2.0 * scatter * uncertainty[i]);
    (told_apart && certain).then_some(Joint { values, uncertainty, left })
}

/// The axes that explain clearly more together than the best alone: one after the other the one that takes most of what is left, as long as
/// it takes clearly more than scatter and leaves another pattern than those found.
fn together(found: &[Pattern], measured: &[f64], freedom: f64) -> Option<AxesTogether> {
    let total = dot(measured, measured);
    let alike = |a: &Pattern, b: &Pattern| {
        let sizes = dot(&a.per_unit, &a.per_unit) * dot(&b.per_unit, &b.per_unit);
        dot(&a.per_unit, &b.per_unit).abs() > ALIKE * sizes.sqrt()
    };
    let mut chosen: Vec<&Pattern> = Vec::new();
    let mut best: Option<Joint> = None;
    while chosen.len() < MOST_TOGETHER {
        let further = found.iter().filter(|axis| !chosen.iter().any(|other| alike(axis, other)));
        let tried = further.filter_map(|axis| {
            let with: Vec<&Pattern> = chosen.iter().copied().chain([axis]).collect();
            Some((axis, joint(&with, measured, freedom)?))
        });
        let Some((axis, fit)) = tried.min_by(|(_, a), (_, b)| a.left.total_cmp(&b.left)) else { break };
        let before = best.as_ref().map_or(total, |best| best.left);
        let scatter = (fit.left / freedom).max(1.0);
        if before - fit.left < CLEARLY * scatter {
            break;
        }
        chosen.push(axis);
        best = Some(fit);
    }
    let fit = best.filter(|_| chosen.len() > 1)?;
    let scatter = (fit.left / freedom).max(1.0).sqrt();
    let axes = chosen.iter().enumerate().map(|(k, of)| JointAxis {
        axis: of.axis.name(),
        value: fit.values[k],
        uncertainty: scatter * fit.uncertainty[k],
    });
    Some(AxesTogether { axes: axes.collect(), explains: 1.0 - fit.left / total })
}

fn why(failure: &RunFailure) -> String {
    match failure {
        RunFailure::BadInput(finding) | RunFailure::NotProducible(finding) => finding.message.to_string(),
    }
}

/// The change by one axis at the measured points, per unit of its deviation, over their uncertainties.
fn at_points(
    model: &ForwardModel,
    as_planned: &Sides<Option<Vec<f64>>>,
    (axis, value): (Deviation, f64),
    points: &Points<'_>,
) -> Result<Vec<f64>, RunFailure> {
    let off = model.flanks(&[(axis, value)])?;
    let splines = Sides::from_fn(|flank: Flank| {
        let (off, good) = (off[flank].as_ref()?, as_planned[flank].as_ref()?);
        let target = model.target()[flank].as_ref()?;
        let change: Vec<f64> = off.iter().zip(good).map(|(off, good)| (off - good) / value).collect();
        let rows: Vec<Vec<f64>> = change.chunks(target.z.len()).map(<[f64]>::to_vec).collect();
        // The grid of the model ascends and its flanks are finite.
        TensorSpline::new(&target.w, &target.z, &rows).ok()
    });
    // A flank that was measured and not ground says nothing of an axis.
    Ok(points.weighed(|flank, w, z, _| splines[flank].as_ref().map_or(0.0, |spline| spline.value(w, z))))
}
