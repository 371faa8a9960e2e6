//! A trace on a few places such that what lies between them counts too. Knows neither gears nor targets.

use metrology::areal::Trace as ArealTrace;
use nalgebra::{Matrix3, Vector3};

/// A trace on some places, each the value there of the parabola through the samples around it: what lies between the places counts too.
/// Where there are too few, it runs straight between its samples, and as far as one step beyond them. `None` for a trace that is none.
pub(super) fn averaged(
    position: f64,
    abscissa: &[f64],
    f: &[f64],
    places: &[f64],
    spacing: f64,
) -> Option<ArealTrace> {
    let samples: Vec<(f64, f64)> =
        abscissa.iter().copied().zip(f.iter().copied()).filter(|(_, f)| f.is_finite()).collect();
    let (first, last) = (samples.first()?.0, samples.last()?.0);
    let step = (abscissa.last()? - abscissa.first()?) / (abscissa.len().max(2) - 1) as f64;
    let reach = step * (1.0 + 1e-6);
    let value = |x: f64| {
        let from = samples.partition_point(|(a, _)| *a < x - spacing);
        let to = samples.partition_point(|(a, _)| *a <= x + spacing);
        parabola(&samples[from..to], x).or_else(|| {
            let k = samples.partition_point(|(a, _)| *a <= x).clamp(1, samples.len() - 1);
            let ((a, f), (b, g)) = (samples[k - 1], samples[k]);
            Some(f + (g - f) * (x - a) / (b - a))
        })
    };
    if samples.len() < 2 {
        return None;
    }
    let within = places.iter().copied().filter(|x| *x >= first - reach && *x <= last + reach);
    let (places, values): (Vec<f64>, Vec<f64>) = within.filter_map(|x| Some((x, value(x)?))).unzip();
    ArealTrace::new(position, &places, &values).ok()
}

/// Fewest samples of a parabola: with fewer it would run through their noise.
const FEWEST: usize = 6;

/// The value at x of the least-squares parabola through samples on both sides of x, or beside the end of a trace; `None` with too few.
fn parabola(samples: &[(f64, f64)], x: f64) -> Option<f64> {
    if samples.len() < FEWEST {
        return None;
    }
    let half = samples.iter().map(|(a, _)| (a - x).abs()).fold(0.0, f64::max);
    let rows = samples.iter().map(|(a, f)| (Vector3::new(1.0, (a - x) / half, ((a - x) / half).powi(2)), *f));
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for (row, f) in rows {
        matrix += row * row.transpose();
        right += row * f;
    }
    Some(matrix.cholesky()?.solve(&right)[0])
}
