//! What the worm left of a workpiece flank: lengths of rays, and which instant cut each of them.

use super::dressed_flank::all_finished;
use super::{RayGrid, RemovalError, Stage, Statistics, Uncut};

/// A finished ray of the workpiece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundRay {
    /// Length left, mm: f_n2 > 0 material left standing.
    pub f: f64,
    /// Feed z_V2 of the cut, mm.
    pub feed: f64,
    /// Workpiece angle phi_2 of the cut, rad, one of those that differ by whole turns.
    pub work_angle: f64,
    /// Length of roll of the worm point that cut it, mm.
    pub worm_roll: f64,
    /// Axial position of the worm point that cut it, mm.
    pub worm_z: f64,
}

/// The rays of one workpiece flank after grinding.
#[derive(Clone, Debug, PartialEq)]
pub struct GroundFlank {
    /// Where the rays stand.
    pub grid: RayGrid,
    /// The rays, row-major `[w][z]`.
    pub rays: Vec<Result<GroundRay, Uncut>>,
    /// Bound of the error of a ray's length, um: residue of the minimum, rounding, and the worm surface's own error.
    pub error_um: f64,
    /// What was looked at.
    pub statistics: Statistics,
}

impl GroundFlank {
    /// The lengths f_n2, mm, row-major `[w][z]`.
    ///
    /// # Errors
    /// [`RemovalError::RayUncut`] when a ray has none.
    pub fn lengths(&self) -> Result<Vec<f64>, RemovalError> {
        all_finished(Stage::Grinding, &self.grid, &self.rays, |ray| ray.f)
    }
}
