//! Triangles over a list of vertices: what every mesh file holds.

use super::edges::check_closed_edges;
use super::error::MeshError;
use nalgebra::Vector3;

/// Largest size of a coordinate, mm: far beyond any machine, far within single precision.
pub const LARGEST_COORDINATE: f64 = 1e9;

/// A triangle lower than this many units in the last place of its largest coordinate has no area: its corners stand on one line.
const ROUNDING_UNITS: f64 = 8.0;

/// A surface of triangles, mm. The corners run counterclockwise seen from outside the material.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriangleMesh {
    /// The vertices, mm.
    pub vertices: Vec<Vector3<f64>>,
    /// Three vertices of each triangle, from 0.
    pub triangles: Vec<[u32; 3]>,
}

impl TriangleMesh {
    /// Several meshes as one, their vertices side by side; [`TriangleMesh::welded`] unites those that coincide.
    ///
    /// # Errors
    /// [`MeshError::TooMany`] for more vertices than can be numbered.
    pub fn joined(meshes: &[Self]) -> Result<Self, MeshError> {
        let total: usize = meshes.iter().map(|mesh| mesh.vertices.len()).sum();
        let most = u32::MAX as usize;
        if total > most {
            return Err(MeshError::TooMany { what: "vertices", most, found: total });
        }
        let mut whole = Self::default();
        for mesh in meshes {
            let first = whole.vertices.len() as u32;
            whole.vertices.extend_from_slice(&mesh.vertices);
            // A corner out of range must not become a vertex of the next mesh.
            let shift = |corner: u32| {
                if (corner as usize) < mesh.vertices.len() { corner + first } else { u32::MAX }
            };
            let shifted = mesh.triangles.iter().map(|corners| corners.map(shift));
            whole.triangles.extend(shifted);
        }
        Ok(whole)
    }

    /// The same triangles seen from the other side.
    #[must_use]
    pub fn turned(mut self) -> Self {
        for corners in &mut self.triangles {
            corners.swap(1, 2);
        }
        self
    }

    /// The area of all triangles, mm^2. The mesh must have passed [`TriangleMesh::check`]; a corner out of range counts nothing.
    pub fn area(&self) -> f64 {
        self.corners().map(|[a, b, c]| 0.5 * (b - a).cross(&(c - a)).norm()).sum()
    }

    /// The volume enclosed by a closed mesh, mm^3; negative if it is inside out. The mesh must have passed
    /// [`TriangleMesh::check_watertight`]; for an open one it is the volume of the cone to the first vertex.
    pub fn volume(&self) -> f64 {
        // Seen from a vertex instead of the origin, a body far from the origin loses no figures.
        let from = self.vertices.first().copied().unwrap_or_default();
        self.corners().map(|[a, b, c]| (a - from).dot(&(b - from).cross(&(c - from))) / 6.0).sum()
    }

    /// Whether the mesh can be written: something is there, coordinates are finite and at most [`LARGEST_COORDINATE`], corners are
    /// vertices, no triangle is without area.
    ///
    /// # Errors
    /// The first of these that fails.
    pub fn check(&self) -> Result<(), MeshError> {
        if self.triangles.is_empty() {
            return Err(MeshError::TooFew { what: "triangles", least: 1, found: 0 });
        }
        check_points("vertex", &self.vertices)?;
        let vertices = self.vertices.len();
        for (triangle, corners) in self.triangles.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&corner| corner as usize >= vertices) {
                return Err(MeshError::IndexOutOfRange { triangle, vertex, vertices });
            }
            let [a, b, c] = corners.map(|corner| self.vertices[corner as usize]);
            let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
            let largest = a.amax().max(b.amax()).max(c.amax());
            let double_area = (b - a).cross(&(c - a)).norm();
            if double_area <= ROUNDING_UNITS * f64::EPSILON * largest * longest {
                return Err(MeshError::DegenerateTriangle { triangle });
            }
        }
        Ok(())
    }

    /// Whether the mesh is a closed body: [`TriangleMesh::check`], every edge has one triangle on each side with opposite senses, and
    /// the volume is positive. Whether the surface passes through itself is not looked at.
    ///
    /// # Errors
    /// The first of these that fails.
    pub fn check_watertight(&self) -> Result<(), MeshError> {
        self.check()?;
        check_closed_edges(&self.triangles)?;
        if self.volume() > 0.0 { Ok(()) } else { Err(MeshError::NoVolume) }
    }

    /// Corners of the triangles whose vertices are there.
    fn corners(&self) -> impl Iterator<Item = [Vector3<f64>; 3]> + '_ {
        self.triangles.iter().filter_map(|&[a, b, c]| {
            let vertex = |corner: u32| self.vertices.get(corner as usize).copied();
            Some([vertex(a)?, vertex(b)?, vertex(c)?])
        })
    }
}

/// Whether all coordinates are finite and at most [`LARGEST_COORDINATE`].
pub(super) fn check_points(what: &str, points: &[Vector3<f64>]) -> Result<(), MeshError> {
    for (index, point) in points.iter().enumerate() {
        if let Some(&value) = point.iter().find(|c| !c.is_finite() || c.abs() > LARGEST_COORDINATE) {
            let allowed = "finite, at most 1e9 mm in size";
            return Err(MeshError::InvalidNumber { what: what.to_owned(), index, value, allowed });
        }
    }
    Ok(())
}
