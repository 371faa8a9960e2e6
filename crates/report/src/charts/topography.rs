//! A flank topography as the charts take it: values on a rectangular (w, z) grid, checked once.

use serde::Serialize;

use super::error::{ChartError, check_ascending, check_count, check_length, check_values};

/// Values over length of roll and face width, checked to be finite and complete.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Topography {
    w_mm: Vec<f64>,
    z_mm: Vec<f64>,
    f_um: Vec<Vec<f64>>,
}

impl Topography {
    /// `w_mm`: length of roll, ascending, mm; `z_mm`: face width, ascending, mm; `f_um[profile][helix]`: normal
    /// value in um, positive = material left standing.
    ///
    /// # Errors
    /// [`ChartError`] for fewer than 2 x 2 points, lists of different length, unsorted coordinates, or a value
    /// that is not finite (its index counts row by row).
    pub fn new(w_mm: Vec<f64>, z_mm: Vec<f64>, f_um: Vec<Vec<f64>>) -> Result<Self, ChartError> {
        for (name, values) in [("topography w", &w_mm), ("topography z", &z_mm)] {
            check_count(name, values.len(), 2)?;
            check_values(name, values)?;
            check_ascending(name, values)?;
        }
        check_length("topography rows", w_mm.len(), f_um.len())?;
        for (i, row) in f_um.iter().enumerate() {
            check_length("topography columns", z_mm.len(), row.len())?;
            check_values("topography f", row).map_err(|error| match error {
                ChartError::InvalidNumber { quantity, index, value } => {
                    ChartError::InvalidNumber { quantity, index: i * z_mm.len() + index, value }
                }
                other => other,
            })?;
        }
        Ok(Self { w_mm, z_mm, f_um })
    }

    /// As [`Topography::new`] from a flat row-major list, `values[profile * z.len() + helix]`.
    ///
    /// # Errors
    /// As [`Topography::new`].
    pub fn from_row_major(w_mm: Vec<f64>, z_mm: Vec<f64>, values: &[f64]) -> Result<Self, ChartError> {
        check_count("topography z", z_mm.len(), 2)?;
        check_length("topography f", w_mm.len() * z_mm.len(), values.len())?;
        let rows = values.chunks(z_mm.len()).map(<[f64]>::to_vec).collect();
        Self::new(w_mm, z_mm, rows)
    }

    /// Length of roll of the rows, mm.
    pub fn w_mm(&self) -> &[f64] {
        &self.w_mm
    }

    /// Face-width position of the columns, mm.
    pub fn z_mm(&self) -> &[f64] {
        &self.z_mm
    }

    /// Values `[profile][helix]`, um.
    pub fn f_um(&self) -> &[Vec<f64>] {
        &self.f_um
    }

    /// The same with the other sign.
    pub fn negated(&self) -> Self {
        let f_um = self.f_um.iter().map(|row| row.iter().map(|f| -f).collect()).collect();
        Self { w_mm: self.w_mm.clone(), z_mm: self.z_mm.clone(), f_um }
    }

    /// Smallest and largest value, um.
    pub fn range_um(&self) -> (f64, f64) {
        self.f_um
            .iter()
            .flatten()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &f| (lo.min(f), hi.max(f)))
    }

    /// `self - other` on the common grid, um.
    ///
    /// # Errors
    /// [`ChartError::LengthMismatch`] if the grids have different numbers of points.
    pub fn minus(&self, other: &Topography) -> Result<Topography, ChartError> {
        check_length("topography rows", self.w_mm.len(), other.w_mm.len())?;
        check_length("topography columns", self.z_mm.len(), other.z_mm.len())?;
        let f_um = self
            .f_um
            .iter()
            .zip(&other.f_um)
            .map(|(a, b)| a.iter().zip(b).map(|(x, y)| x - y).collect())
            .collect();
        Ok(Topography { w_mm: self.w_mm.clone(), z_mm: self.z_mm.clone(), f_um })
    }

    /// The values over w at helix index `j`.
    pub fn profile(&self, j: usize) -> Vec<f64> {
        self.f_um.iter().map(|row| row[j]).collect()
    }
}

/// A topography and the name that stands over its picture, for example "Left flank".
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NamedTopography {
    /// Heading of the panel.
    pub name: String,
    /// The values.
    pub topography: Topography,
}

impl NamedTopography {
    /// Pairs a name with its topography.
    pub fn new(name: impl Into<String>, topography: Topography) -> Self {
        Self { name: name.into(), topography }
    }
}

/// Smallest and largest value over all panels.
pub fn common_range(panels: &[NamedTopography]) -> (f64, f64) {
    panels
        .iter()
        .map(|panel| panel.topography.range_um())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), (a, b)| (lo.min(a), hi.max(b)))
}
