//! Traces have more samples than independent values: means of even runs of them take part in a correction.

/// Means of at most `most` runs of neighbouring samples (abscissa, deviation) in their order; samples without a value are left out.
/// Runs differ by at most one sample, so that all means weigh alike.
pub fn thinned(abscissa: &[f64], f: &[f64], most: usize) -> Vec<(f64, f64)> {
    let known: Vec<(f64, f64)> =
        abscissa.iter().copied().zip(f.iter().copied()).filter(|(_, f)| f.is_finite()).collect();
    let runs = most.min(known.len());
    let from = |run: usize| run * known.len() / runs;
    let mean = |run: &[(f64, f64)]| {
        let count = run.len() as f64;
        (run.iter().map(|s| s.0).sum::<f64>() / count, run.iter().map(|s| s.1).sum::<f64>() / count)
    };
    (0..runs).map(|run| mean(&known[from(run)..from(run + 1)])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_even_and_keep_straight_lines() {
        let x: Vec<f64> = (0..481).map(f64::from).collect();
        let mut f: Vec<f64> = x.iter().map(|x| 3.0 - 0.5 * x).collect();
        f[100] = f64::NAN;
        let means = thinned(&x, &f, 60);
        assert_eq!(means.len(), 60);
        assert!(means.iter().all(|(x, f)| (f - (3.0 - 0.5 * x)).abs() < 1e-12));
        assert!(means.is_sorted_by(|a, b| a.0 < b.0) && means[0].0 == 3.5 && means[59].0 == 476.5);
        assert_eq!(thinned(&x[..5], &f[..5], 60).len(), 5);
        assert!(thinned(&x, &[f64::NAN; 481], 60).is_empty() && thinned(&x, &f, 0).is_empty());
    }
}
