//! Profile and helix traces of a flank with the values that an inspection sheet gives them.

use report::charts::{SectionTrace, Topography};

/// Sections at the ends and in the middle, each with its own characteristic values.
pub(super) fn traces(simulated: &Topography, target: &Topography) -> (Vec<SectionTrace>, Vec<SectionTrace>) {
    let thirds = |n: usize| [0, n / 2, n - 1];
    let values = |trace: &mut SectionTrace, crowning: &str, slope: &str| {
        let (c, s) = trace_values(&trace.coordinate_mm, &trace.simulated_um);
        trace.values_um = vec![(crowning.to_string(), c), (slope.to_string(), s)];
    };
    let profiles = thirds(simulated.z_mm().len()).map(|j| {
        let mut trace = SectionTrace::profile(simulated, Some(target), j);
        values(&mut trace, "C_α n", "C_Hα n");
        trace
    });
    let helices = thirds(simulated.w_mm().len()).map(|i| {
        let mut trace = SectionTrace::helix(simulated, Some(target), i);
        values(&mut trace, "C_β n", "C_Hβ n");
        trace
    });
    (profiles.to_vec(), helices.to_vec())
}

/// Crowning and slope of one trace by least squares of {1, x, x^2} over x in [-1, 1]; positive = material removed.
fn trace_values(x: &[f64], f: &[f64]) -> (f64, f64) {
    let (a, b) = (x[0], x[x.len() - 1]);
    let n = x.len() as f64;
    let t: Vec<f64> = x.iter().map(|x| (2.0 * x - a - b) / (b - a)).collect();
    // Orthogonal polynomials on the given abscissae: 1, t - t0, t^2 - p t - q.
    let mean = |g: &dyn Fn(usize) -> f64| (0..t.len()).map(g).sum::<f64>() / n;
    let t0 = mean(&|i| t[i]);
    let l = |i: usize| t[i] - t0;
    let l2 = mean(&|i| l(i) * l(i));
    let p = mean(&|i| t[i] * t[i] * l(i)) / l2;
    let q = mean(&|i| t[i] * t[i]);
    let quadratic = |i: usize| t[i] * t[i] - q - p * l(i);
    let c2 = mean(&|i| f[i] * quadratic(i)) / mean(&|i| quadratic(i) * quadratic(i));
    let c1 = mean(&|i| f[i] * l(i)) / l2 - c2 * p;
    (-c2, -2.0 * c1)
}
