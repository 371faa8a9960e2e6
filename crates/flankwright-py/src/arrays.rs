//! Numbers of the library as arrays of NumPy.

use numpy::ndarray::{Array, Dimension, StrideShape};
use numpy::{IntoPyArray, PyArray};
use pyo3::prelude::*;

use crate::failure::Failure;

/// Values in row-major order as an array of a shape; NumPy takes them over as they lie.
///
/// # Errors
/// Another number of values: a fault of the program.
pub fn shaped<D: Dimension>(
    py: Python<'_>,
    shape: impl Into<StrideShape<D>>,
    values: Vec<f64>,
) -> PyResult<Bound<'_, PyArray<f64, D>>> {
    let array = Array::from_shape_vec(shape, values);
    Ok(array.map_err(|error| Failure::internal(error.to_string()).raised(py))?.into_pyarray(py))
}
