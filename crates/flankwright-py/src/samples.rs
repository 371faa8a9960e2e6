//! Rows of numbers in, rows of numbers out, on all cores.

use std::sync::atomic::{AtomicUsize, Ordering};

use numpy::ndarray::{ArrayView2, Axis};
use pyo3::prelude::*;

use crate::failure::Failure;
use crate::watch::on_each;

/// What became of a row; `None` for one that was left out because one before it has failed.
type Row = Option<Result<Vec<f64>, Failure>>;

/// Rows of numbers one after the other, and the failures of those that have none.
type Each = (Vec<f64>, Vec<(usize, Failure)>);

fn rows(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    samples: ArrayView2<'_, f64>,
    stops: bool,
    one: impl Fn(&[f64]) -> Result<Vec<f64>, Failure> + Sync + Send,
) -> PyResult<Vec<Row>> {
    let samples: Vec<Vec<f64>> = samples.axis_iter(Axis(0)).map(|row| row.to_vec()).collect();
    let failed = AtomicUsize::new(usize::MAX);
    on_each(py, progress, "samples", &samples, |k, row| {
        if stops && k > failed.load(Ordering::Relaxed) {
            return None;
        }
        let done = one(row).map_err(|failure| failure.on_sample(k));
        if done.is_err() {
            failed.fetch_min(k, Ordering::Relaxed);
        }
        Some(done)
    })
}

/// Works on every row of `samples`; what they give, one after the other. The first failure in their order ends it and tells its row.
///
/// # Errors
/// That failure, and what [`on_each`] tells.
pub fn of_samples(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    samples: ArrayView2<'_, f64>,
    one: impl Fn(&[f64]) -> Result<Vec<f64>, Failure> + Sync + Send,
) -> PyResult<Vec<f64>> {
    let rows: Result<Vec<Vec<f64>>, Failure> =
        rows(py, progress, samples, true, one)?.into_iter().flatten().collect();
    Ok(rows.map_err(|failure| failure.raised(py))?.concat())
}

/// The same where failures end nothing: rows of `width` numbers, NaN for those that have failed, and their failures by row.
///
/// # Errors
/// What [`on_each`] tells.
pub fn of_each_sample(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    samples: ArrayView2<'_, f64>,
    width: usize,
    one: impl Fn(&[f64]) -> Result<Vec<f64>, Failure> + Sync + Send,
) -> PyResult<Each> {
    let (mut values, mut failures) = (Vec::new(), Vec::new());
    for (k, row) in rows(py, progress, samples, false, one)?.into_iter().flatten().enumerate() {
        match row {
            Ok(row) => values.extend(row),
            Err(failure) => {
                failures.push((k, failure));
                values.resize(values.len() + width, f64::NAN);
            }
        }
    }
    Ok((values, failures))
}
