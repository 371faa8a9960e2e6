//! An open surface through a grid of points.

use super::error::MeshError;
use super::triangle_mesh::TriangleMesh;
use nalgebra::Vector3;

/// On which side of a grid the outside lies, given by the steps to the next row and to the next column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PatchSide {
    /// The outward normal is (step to the next row) x (step to the next column).
    RowsTimesColumns,
    /// The outward normal is (step to the next column) x (step to the next row).
    ColumnsTimesRows,
}

/// The surface through `points` (mm), row after row of `columns` points each; vertex `i` of the mesh is point `i`. Each cell is divided
/// along its shorter diagonal.
///
/// # Errors
/// [`MeshError::TooFew`] and [`MeshError::WrongCount`] if the points make no grid of at least two rows and two columns, and those of
/// [`TriangleMesh::check`].
pub fn patch(points: &[Vector3<f64>], columns: usize, side: PatchSide) -> Result<TriangleMesh, MeshError> {
    if columns < 2 {
        return Err(MeshError::TooFew { what: "columns of a patch", least: 2, found: columns });
    }
    let rows = points.len() / columns;
    if rows < 2 {
        return Err(MeshError::TooFew { what: "rows of a patch", least: 2, found: rows });
    }
    if rows * columns != points.len() {
        let what = format!("points of a patch of {columns} columns");
        return Err(MeshError::WrongCount { what, expected: rows * columns, found: points.len() });
    }
    let most = u32::MAX as usize;
    if points.len() > most {
        return Err(MeshError::TooMany { what: "vertices", most, found: points.len() });
    }
    let mut mesh = TriangleMesh { vertices: points.to_vec(), triangles: Vec::new() };
    mesh.triangles.reserve(2 * (rows - 1) * (columns - 1));
    for row in 0..rows - 1 {
        for column in 0..columns - 1 {
            let corner = |r: usize, c: usize| ((row + r) * columns + column + c) as u32;
            mesh.add_cell([corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)]);
        }
    }
    let mesh = if side == PatchSide::RowsTimesColumns { mesh } else { mesh.turned() };
    mesh.check()?;
    Ok(mesh)
}

impl TriangleMesh {
    /// Adds the two triangles of a cell given by its four vertices in order, divided along the shorter diagonal.
    pub(super) fn add_cell(&mut self, [a, b, c, d]: [u32; 4]) {
        let distance =
            |p: u32, q: u32| (self.vertices[p as usize] - self.vertices[q as usize]).norm_squared();
        let halves =
            if distance(a, c) <= distance(b, d) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
        self.triangles.extend(halves);
    }
}
