//! A flank topography: normal deviations on a grid of length of roll and face width.

use foundation::numerics::root_mean_square;

/// f_n over `w` x `z`, row-major `[w][z]`, mm; > 0 material left.
#[derive(Clone, Debug, PartialEq)]
pub struct Topography {
    /// Lengths of roll, ascending, mm.
    pub w: Vec<f64>,
    /// Axial positions, ascending, mm.
    pub z: Vec<f64>,
    /// Deviations normal to the flank, mm.
    pub f: Vec<f64>,
}

impl Topography {
    /// From a grid; `None` if the shape does not fit or a side has fewer than two points.
    pub fn new(w: Vec<f64>, z: Vec<f64>, f: Vec<f64>) -> Option<Self> {
        (w.len() >= 2 && z.len() >= 2 && f.len() == w.len() * z.len()).then_some(Self { w, z, f })
    }

    /// Value at profile point i, helix point j.
    pub fn at(&self, i: usize, j: usize) -> f64 {
        self.f[i * self.z.len() + j]
    }

    /// Pointwise difference to another topography on the same grid.
    pub fn minus(&self, other: &Self) -> Self {
        Self { f: self.f.iter().zip(&other.f).map(|(a, b)| a - b).collect(), ..self.clone() }
    }

    /// Pointwise sum with another topography on the same grid.
    pub fn plus(&self, other: &Self) -> Self {
        Self { f: self.f.iter().zip(&other.f).map(|(a, b)| a + b).collect(), ..self.clone() }
    }

    /// Largest absolute value, mm; NaN if a value is.
    pub fn largest(&self) -> f64 {
        self.f.iter().fold(0.0, |m: f64, f| if f.is_nan() || m.is_nan() { f64::NAN } else { m.max(f.abs()) })
    }

    /// Root mean square, mm.
    pub fn rms(&self) -> f64 {
        root_mean_square(&self.f)
    }

    /// Values in micrometres as rows over the profile.
    pub fn rows_um(&self) -> Vec<Vec<f64>> {
        self.f.chunks(self.z.len()).map(|row| row.iter().map(|f| f * 1e3).collect()).collect()
    }
}
