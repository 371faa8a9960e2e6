//! Rows of numbers in, rows of numbers out, on all cores.

use numpy::ndarray::{ArrayView2, Axis};
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::failure::Failure;
use crate::watch::watched;

/// Works on every row of `samples`; what they give, one after the other. The first failure in their order ends it and tells its row.
///
/// # Errors
/// That failure, and what [`watched`] tells.
pub fn of_samples(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    samples: ArrayView2<'_, f64>,
    one: impl Fn(&[f64]) -> Result<Vec<f64>, Failure> + Sync + Send,
) -> PyResult<Vec<f64>> {
    let rows: Vec<Vec<f64>> = samples.axis_iter(Axis(0)).map(|row| row.to_vec()).collect();
    let values = watched(py, progress, |progress| -> Result<Vec<Vec<f64>>, Failure> {
        progress.start("samples", rows.len() as u64);
        let told = |(k, row): (usize, &Vec<f64>)| {
            let done = one(row).map_err(|failure| failure.on_sample(k));
            progress.advance(1);
            done
        };
        rows.par_iter().enumerate().map(told).collect()
    })?;
    Ok(values.map_err(|failure| failure.raised(py))?.concat())
}
