//! Errors of the data of a chart.

use finding::Finding;
use thiserror::Error;

/// Largest magnitude that a chart accepts; anything above is a fault of the caller, not a quantity of gears.
pub const LARGEST: f64 = 1e12;

/// Ranges below this are constant for a chart: nothing in metrology is as small, and reciprocals stay finite.
pub const LEAST_SPAN: f64 = 1e-100;

/// Data that can't be drawn. A chart is either right or refused, never a broken picture.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum ChartError {
    /// A value that is not finite or beyond any physical size.
    #[error("{quantity}: value {value} at index {index} is not a finite number within ±1e12")]
    #[finding(code = "invalid-number")]
    #[way_out("Leave undefined points out or report the failure that made them.")]
    InvalidNumber {
        /// The quantity or series that holds the value.
        quantity: String,
        /// Its position in the series; row-major in a topography.
        index: usize,
        /// The value itself.
        value: f64,
    },
    /// Nothing to draw, or fewer points than a line or a net needs.
    #[error("{quantity}: {actual} values, at least {least} are needed")]
    #[finding(code = "too-few-values")]
    #[way_out("Leave the chart out or compute it on more points.")]
    TooFewValues {
        /// The quantity or series.
        quantity: String,
        /// How many values were given.
        actual: usize,
        /// How many are needed.
        least: usize,
    },
    /// Two lists that belong together differ in length.
    #[error("{quantity}: {actual} values where {expected} are expected")]
    #[finding(code = "length-mismatch")]
    #[way_out("Give every list of a chart the same number of points.")]
    LengthMismatch {
        /// The list of the wrong length.
        quantity: String,
        /// Length of the list that it belongs to.
        expected: usize,
        /// Its own length.
        actual: usize,
    },
    /// Coordinates of a grid that don't increase.
    #[error("{quantity}: the coordinate at index {index} is not greater than the one before")]
    #[finding(code = "not-ascending")]
    #[way_out("Sort the coordinates and remove duplicates.")]
    NotAscending {
        /// The coordinate.
        quantity: String,
        /// Index of the first value that doesn't exceed its predecessor.
        index: usize,
    },
}

/// All values finite and of a physical size.
pub fn check_values(quantity: &str, values: &[f64]) -> Result<(), ChartError> {
    match values.iter().position(|v| !(-LARGEST..=LARGEST).contains(v)) {
        None => Ok(()),
        Some(index) => {
            Err(ChartError::InvalidNumber { quantity: quantity.to_owned(), index, value: values[index] })
        }
    }
}

/// At least `least` values.
pub fn check_count(quantity: &str, actual: usize, least: usize) -> Result<(), ChartError> {
    if actual >= least {
        return Ok(());
    }
    Err(ChartError::TooFewValues { quantity: quantity.to_owned(), actual, least })
}

/// Two lists of equal length.
pub fn check_length(quantity: &str, expected: usize, actual: usize) -> Result<(), ChartError> {
    if actual == expected {
        return Ok(());
    }
    Err(ChartError::LengthMismatch { quantity: quantity.to_owned(), expected, actual })
}

/// Strictly increasing coordinates.
pub fn check_ascending(quantity: &str, values: &[f64]) -> Result<(), ChartError> {
    match values.windows(2).position(|pair| pair[1] <= pair[0]) {
        None => Ok(()),
        Some(before) => Err(ChartError::NotAscending { quantity: quantity.to_owned(), index: before + 1 }),
    }
}
