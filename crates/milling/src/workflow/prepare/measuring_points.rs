//! The points of a bevel gear's measuring grid with their normals, as measuring machines take them.

use super::wanted_bevel::wanted_bevel;
use crate::job::LoadedMillingJob;
use foundation::geometry::Flank;
use nalgebra::Vector3;
use run::RunFailure;

/// A point of the wanted flank in the space about +y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuringPoint {
    /// Flank of the space.
    pub flank: Flank,
    /// Row, from 1 at the root.
    pub row: usize,
    /// Column, from 1 at the toe.
    pub column: usize,
    /// Length of roll in the middle of the face, mm.
    pub roll: f64,
    /// Position along the pitch cone from the middle of the face, mm.
    pub position: f64,
    /// The point, mm.
    pub point: Vector3<f64>,
    /// The normal out of the material.
    pub normal: Vector3<f64>,
}

/// All points of the job's grid, row by row; none without a grid.
///
/// # Errors
/// [`RunFailure`] with a finding on the key concerned.
pub(super) fn measuring_points(loaded: &LoadedMillingJob) -> Result<Vec<MeasuringPoint>, RunFailure> {
    let job = &loaded.job;
    let (Some(grid), Some(bevel)) = (&job.measuring_grid, &job.bevel) else { return Ok(Vec::new()) };
    let (_, flanks) = wanted_bevel(loaded, bevel)?;
    let mut points = Vec::new();
    for (flank, wanted) in flanks.iter().filter(|(flank, _)| job.flanks().contains(flank)) {
        let [rolls, positions] = wanted.places(grid);
        for (i, &roll) in rolls.iter().enumerate() {
            for (j, &position) in positions.iter().enumerate() {
                let at = wanted.target(roll, position);
                let (point, normal) = (at.point, at.normal);
                points.push(MeasuringPoint {
                    flank,
                    row: i + 1,
                    column: j + 1,
                    roll,
                    position,
                    point,
                    normal,
                });
            }
        }
    }
    Ok(points)
}
