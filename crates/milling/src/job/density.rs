//! `milling.density`: limits of the distances between neighbouring points (`docs/mathematics/milling.md#columns-and-rows`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Limits of distances, mm, any of them: along rows, that is from column to column, and along columns, that is from row to row. A mean is
/// that of one row or column, and every one has to keep it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Density {
    /// Greatest distance along a row.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the distance in mm, or leave it out"))]
    pub row_max: Option<f64>,
    /// Least distance along a row.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the distance in mm, or leave it out"))]
    pub row_min: Option<f64>,
    /// Greatest mean distance along a row.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the distance in mm, or leave it out"))]
    pub row_max_mean: Option<f64>,
    /// Least mean distance along a row.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the distance in mm, or leave it out"))]
    pub row_min_mean: Option<f64>,
    /// Greatest distance along a column.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the distance in mm, or leave it out"))]
    pub column_max: Option<f64>,
    /// Least distance along a column.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the distance in mm, or leave it out"))]
    pub column_min: Option<f64>,
    /// Greatest mean distance along a column.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the distance in mm, or leave it out"))]
    pub column_max_mean: Option<f64>,
    /// Least mean distance along a column.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0, "maximum" = 1000, "x-way-out" = "give the distance in mm, or leave it out"))]
    pub column_min_mean: Option<f64>,
}

/// How many rows and columns there are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GridChoice {
    /// As many as given.
    Counts {
        /// Rows, 2 or more.
        rows: usize,
        /// Columns, 2 or more.
        columns: usize,
    },
    /// As few as keep these limits.
    Limits {
        /// Distances, mm.
        density: Density,
        /// Height of the scallops between rows, um.
        scallop_um: Option<f64>,
        /// Deviation of straight blocks from the row, um.
        chord_um: Option<f64>,
    },
}
