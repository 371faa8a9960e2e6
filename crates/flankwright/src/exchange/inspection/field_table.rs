//! Measured fields as a table: CSV with the columns w_mm, z_mm, f_um, as targets have them.

use std::path::Path;

use super::Topography;
use crate::exchange::diagnostic::JobError;
use crate::exchange::grid_file::parse_points;
use crate::exchange::source::Source;
use crate::geometry::Flank;

/// Reads a measured field of one flank, a grid or scattered points in the order of the file: w_mm length of roll, z_mm from the middle of
/// the face width, f_um deviation, positive = material.
///
/// # Errors
/// Those of [`crate::exchange::read_points`].
pub fn read_topography(path: &Path, tooth: u32, flank: Flank) -> Result<Topography, JobError> {
    parse_topography(Source::read(path)?, tooth, flank)
}

/// As [`read_topography`], from a text.
///
/// # Errors
/// As [`read_topography`].
pub fn parse_topography(source: Source, tooth: u32, flank: Flank) -> Result<Topography, JobError> {
    let rows = parse_points(source)?;
    let points_mm = rows.iter().map(|[w, z, _]| [*w, *z]).collect();
    Ok(Topography { tooth, flank, points_mm, f_um: rows.iter().map(|[_, _, f]| *f).collect() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_keep_their_order() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("field.csv");
        std::fs::write(&path, "z_mm,w_mm,f_um\n-3,5,1.5\n3,5,-2\n").unwrap();
        let found = read_topography(&path, 4, Flank::Right).unwrap();
        assert_eq!((found.points_mm, found.f_um), (vec![[5.0, -3.0], [5.0, 3.0]], vec![1.5, -2.0]));
        assert!(read_topography(&directory.path().join("none.csv"), 1, Flank::Left).is_err());
    }
}
