//! How a flank deviates, in figures.

/// A difference of two flanks about its mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DifferenceRow {
    /// Root mean square.
    pub rms_um: f64,
    /// Largest.
    pub largest_um: f64,
    /// f_Ha, C_a, f_Hb, C_b, S of the areal fit; slopes of material.
    pub features_um: [f64; 5],
    /// Share of the points within the tolerance.
    pub within_tolerance: f64,
}

/// Symbols of [`DifferenceRow::features_um`].
pub(super) const FEATURES: [&str; 5] = ["f_Hα", "C_α", "f_Hβ", "C_β", "S"];
