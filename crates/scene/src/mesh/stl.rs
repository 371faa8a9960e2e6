//! Binary STL: triangles with their normals in single precision, one body a file.

use super::error::MeshError;
use super::triangle_mesh::TriangleMesh;
use nalgebra::Vector3;

/// The text of the header. It must not begin with `solid`: readers would take the file for text.
const HEADER: &[u8] = b"flankwright: binary STL, positions in mm";

/// Length of the header, bytes.
const HEADER_LENGTH: usize = 80;

/// Length of a triangle, bytes: normal, three corners, two bytes without a meaning.
const TRIANGLE_LENGTH: usize = 50;

/// A mesh as binary STL (little endian, mm). Positions are rounded to single precision: 8 nm at 100 mm. Normals are those of the
/// triangles before rounding.
///
/// # Errors
/// Those of [`TriangleMesh::check`]; [`MeshError::TooMany`] for more triangles than can be counted.
pub fn stl(mesh: &TriangleMesh) -> Result<Vec<u8>, MeshError> {
    mesh.check()?;
    let found = mesh.triangles.len();
    let count = u32::try_from(found).map_err(|_| MeshError::TooMany {
        what: "triangles",
        most: u32::MAX as usize,
        found,
    })?;
    let mut bytes = Vec::with_capacity(HEADER_LENGTH + 4 + TRIANGLE_LENGTH * found);
    bytes.extend_from_slice(HEADER);
    bytes.resize(HEADER_LENGTH, b' ');
    bytes.extend_from_slice(&count.to_le_bytes());
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|corner| mesh.vertices[corner as usize]);
        for vector in [(b - a).cross(&(c - a)).normalize(), a, b, c] {
            bytes.extend(little_endian(&vector).as_flattened());
        }
        bytes.extend_from_slice(&[0, 0]);
    }
    Ok(bytes)
}

fn little_endian(vector: &Vector3<f64>) -> [[u8; 4]; 3] {
    [vector.x, vector.y, vector.z].map(|c| (c as f32).to_le_bytes())
}
