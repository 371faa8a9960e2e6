//! The measured flanks of a round with their topographies, and how a flank deviates in figures. um, normal to the flank, positive =
//! material left.

use crate::workflow::{DifferenceResult, MeasuredFlankResult, RoundResult};
use foundation::geometry::Flank;
use report::charts::{ChartError, Topography};

/// Flanks that were measured.
pub(super) fn flanks(round: &RoundResult) -> impl Iterator<Item = (Flank, &MeasuredFlankResult)> {
    Flank::BOTH.into_iter().filter_map(|flank| Some((flank, round.flanks.get(flank.name())?)))
}

/// One of the topographies of a flank.
pub(super) fn topography(of: &MeasuredFlankResult, rows: &[Vec<f64>]) -> Result<Topography, ChartError> {
    Topography::new(of.w_mm.clone(), of.z_mm.clone(), rows.to_vec())
}

/// What was measured, mean over the teeth; `None` where it does not cover the grid.
pub(super) fn measured(of: &MeasuredFlankResult) -> Result<Option<Topography>, ChartError> {
    let whole: Option<Vec<Vec<f64>>> =
        of.measured_um.iter().map(|row| row.iter().copied().collect()).collect();
    whole.map(|rows| topography(of, &rows)).transpose()
}

/// Symbols of [`features_um`].
pub(super) const FEATURES: [&str; 5] = ["f_Hα", "C_α", "f_Hβ", "C_β", "S"];

/// Features of the areal fit; slopes of material.
pub(super) fn features_um(of: &DifferenceResult) -> [f64; 5] {
    [of.profile_slope_um, of.profile_crowning_um, of.helix_slope_um, of.helix_crowning_um, of.twist_um]
}
